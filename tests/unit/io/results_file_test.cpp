// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <set>

#include "misfits.hpp"
#include "renew_checksum.hpp"
#include "results/hdf5_file.hpp"
#include "whole_report.hpp"

namespace glissade {
namespace {

using test::bytes_of;
using test::states;
using test::with_everything;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(results_file, two_writes_give_the_same_bytes) {
  const TemporaryFolder folder;
  const std::string first = bytes_of(with_everything(), folder, "a.h5");
  ::sleep(1);  // a time stamp has whole seconds
  EXPECT_EQ(first, bytes_of(with_everything(), folder, "b.h5"));
}

void expect_same_cases(const CaseSet& a, const CaseSet& b) {
  EXPECT_EQ(a.axes, b.axes);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.orientations, b.orientations);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Case &x = a.cases[i], &y = b.cases[i];
    for (const Parameter& p : parameters()) EXPECT_EQ(value_of(p, x), value_of(p, y)) << p.key;
    EXPECT_EQ(x.support, y.support);
    EXPECT_EQ(x.vertical, y.vertical);
    EXPECT_EQ(x.friction_value, y.friction_value);
    EXPECT_EQ(x.orientation, y.orientation);
    EXPECT_EQ(x.neighbour_slope, y.neighbour_slope);
  }
}

void expect_same_histories(const HistoryTable& a, const HistoryTable& b) {
  EXPECT_EQ(a.records, b.records);
  EXPECT_EQ(a.cases, b.cases);
  EXPECT_EQ(a.levels, b.levels);
  EXPECT_EQ(a.thresholds, b.thresholds);
  for_each_history_field([&](auto field) {
    const auto &x = a.fields.*field.of, &y = b.fields.*field.of;
    ASSERT_EQ(x.size(), y.size()) << field.name;
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_TRUE(same_bits(static_cast<double>(x[i]), static_cast<double>(y[i]))) << field.name;
  });
}

TEST(results_file, come_back_to_the_last_bit_with_every_analysis) {
  const TemporaryFolder folder;
  for (const Results& written : test::whole_results()) {
    const std::string bytes = bytes_of(written, folder, "a.h5");
    const Results read = read_results(folder.path() / "a.h5");
    // Whatever is written is read; what follows checks what is written.
    EXPECT_EQ(bytes, bytes_of(read, folder, "b.h5"));
    expect_same_cases(read.cases, written.cases);
    expect_same_histories(read.histories, written.histories);
    EXPECT_EQ(read.study_data_files, written.study_data_files);
    const WholeReport a = report_of(read), b = report_of(written);
    EXPECT_EQ(a.tables, b.tables);
    EXPECT_EQ(a.page, b.page);
    EXPECT_EQ(a.summary, b.summary);
  }
}

/// Whether an analysis is in any of the results that are tested above.
TEST(results_file, are_tested_with_every_analysis) {
  std::set<std::string> tables;
  for (const Results& results : test::whole_results()) {
    for (const Table& table : csv_tables(results)) tables.insert(table.name);
  }
  EXPECT_THAT(tables, testing::IsSupersetOf(
                          {"clearances", "base_shear", "fragility", "standards", "impact", "shape",
                           "hazard", "chart", "tipping", "verdict", "sensitivity", "sampling_error",
                           "model_uncertainty", "sampling_target", "rare", "intensity_measures"}));
}

TEST(results_file, have_the_numbers_of_the_tables) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  for (const Results& results : test::whole_results()) {
    const std::vector<DataTable> tables = data_tables(results);
    write_results(file, results, tables);
    const Hdf5Reader root(file);
    for (const DataTable& table : tables) {
      for (const DataColumn& column : table.columns) {
        EXPECT_NE(column.description, "") << table.name.text() << ", " << column.name;
        std::visit(
            [&]<class Values>(const Values& values) {
              Values stored;
              Dims dims(1);
              root.group("tables").group(table.name).array(column.name, {}, dims, stored);
              ASSERT_EQ(stored.size(), values.size());
              for (std::size_t i = 0; i < values.size(); ++i)
                EXPECT_TRUE(stored[i] == values[i] ||
                            (stored[i] != stored[i] && values[i] != values[i]))
                    << table.name.text() << ", " << column.name;
            },
            column.values);
      }
    }
  }
}

// alpha = 0 is a wall.
TEST(results_file, tells_one_mass_from_a_cantilever) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  Results results = with_everything();
  const auto alpha_of = [&](BuildingModel::Kind kind) {
    results.building.kind = kind;
    write_results(file, results);
    std::vector<double> stored;
    Dims dims(1);
    Hdf5Reader(file).group("cases").array("building.alpha", {}, dims, stored);
    EXPECT_EQ(stored.size(), results.cases.size());
    return stored;
  };
  EXPECT_THAT(alpha_of(BuildingModel::Kind::one_mass), testing::Each(testing::IsNan()));
  EXPECT_THAT(alpha_of(BuildingModel::Kind::cantilever), testing::Each(0.0));
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(results_file, head_suites_and_records_come_back) {
  const TemporaryFolder folder;
  Results written = with_everything();
  written.suites.push_back(
      {"other", "of one", "ASCE 7-10, S_S 1 g", {{1.0}, {{0.5}}, {0.5}, {0.4}, 0.0}});
  const std::vector<double> sa_g = written.records[0].sa_g;
  written.records[0] = {0,   "a",  "event", "station", 6.9,  8.5,   380.0, 2.5, 1.7,  0.5, 0.4,
                        0.3, 12.5, 0.005,   7671,      true, false, 1,     1.5, sa_g, sa_g};
  written.records[0].processing = "trimmed";
  SuiteSpectra& by_clause = written.suites[1].spectra;
  by_clause.rule = ScalingRule::asce7_16;
  by_clause.range = {0.1, 1.25};
  by_clause.mean_ratio = 1.0625;
  written.records[4].suite = 1;
  written.suites[0].spectra.records_g.pop_back();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");
  EXPECT_EQ(read.study_name, written.study_name);
  EXPECT_EQ(read.study_description, written.study_description);
  EXPECT_EQ(read.study_text, written.study_text);
  EXPECT_EQ(read.program_version, written.program_version);
  EXPECT_EQ(read.plan_hash, written.plan_hash);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.measure, written.measure);
  EXPECT_EQ(read.intensity_label, written.intensity_label);
  EXPECT_EQ(read.displacement, written.displacement);
  EXPECT_EQ(read.model.kernel, written.model.kernel);
  EXPECT_EQ(read.model.building, written.model.building);
  EXPECT_EQ(read.model.friction, written.model.friction);
  EXPECT_EQ(read.model.displacement, written.model.displacement);
  EXPECT_EQ(read.levels, written.levels);
  EXPECT_EQ(read.thresholds_m, written.thresholds_m);
  EXPECT_EQ(read.notes, written.notes);
  EXPECT_EQ(read.warnings_of_run, written.warnings_of_run);
  EXPECT_EQ(read.notes_of_run, written.notes_of_run);
  EXPECT_EQ(read.suites[1].target, "ASCE 7-10, S_S 1 g");
  ASSERT_EQ(read.records.size(), 5u);
  const RecordSummary& record = read.records[0];
  EXPECT_EQ(record.id + record.event + record.station, "aeventstation");
  EXPECT_EQ(record.magnitude, 6.9);
  EXPECT_EQ(record.distance_km, 8.5);
  EXPECT_EQ(record.vs30_mps, 380.0);
  EXPECT_EQ(record.suite_scale, 2.5);
  EXPECT_EQ(record.factor_at_unit_level, 1.7);
  EXPECT_EQ(record.pga_g, 0.5);
  EXPECT_EQ(record.pgv_mps, 0.4);
  EXPECT_EQ(record.pgd_m, 0.3);
  EXPECT_EQ(record.duration_s, 12.5);
  EXPECT_EQ(record.dt_s, 0.005);
  EXPECT_EQ(record.samples, 7671u);
  EXPECT_TRUE(record.has_second);
  EXPECT_FALSE(record.has_vertical);
  EXPECT_EQ(record.stronger, 1u);
  EXPECT_EQ(record.arias_mps, 1.5);
  EXPECT_EQ(record.roof_velocity_mps, sa_g);
  EXPECT_EQ(record.processing, "trimmed");
  EXPECT_EQ(read.suites[0].spectra.rule, ScalingRule::walters_2012);
  EXPECT_EQ(read.suites[1].spectra.rule, ScalingRule::asce7_16);
  EXPECT_EQ(read.suites[1].spectra.range.to_s, 1.25);
  EXPECT_EQ(read.suites[1].spectra.mean_ratio, 1.0625);
  EXPECT_EQ(read.records[4].suite, 1u);
  ASSERT_EQ(read.suites.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.suites[i].name, written.suites[i].name);
    EXPECT_EQ(read.suites[i].description, written.suites[i].description);
    const SuiteSpectra &a = read.suites[i].spectra, &b = written.suites[i].spectra;
    EXPECT_EQ(a.periods_s, b.periods_s);
    EXPECT_EQ(a.records_g, b.records_g);
    EXPECT_EQ(a.average_g, b.average_g);
    EXPECT_EQ(a.target_g, b.target_g);
    EXPECT_EQ(a.reference_level, b.reference_level);
    EXPECT_PRED2(same_number, a.to_target.lowest.ratio, b.to_target.lowest.ratio);
    EXPECT_PRED2(same_number, a.to_target.lowest.period_s, b.to_target.lowest.period_s);
    EXPECT_PRED2(same_number, a.to_target.highest.ratio, b.to_target.highest.ratio);
    EXPECT_PRED2(same_number, a.to_target.highest.period_s, b.to_target.highest.period_s);
  }
}

TEST(results_file, holds_study_files_of_any_length) {
  const TemporaryFolder folder;
  Results results = with_everything();
  results.study_text += "#" + std::string(300000, 'x') + "end";
  write_results(folder.path() / "a.h5", results);
  EXPECT_EQ(read_results(folder.path() / "a.h5").study_text, results.study_text);
}

// What a user reads of a file that is not whole, to distinguish a cut one from one with other
// bytes.
constexpr auto no_checksum = "does not end with a checksum", damaged = "is damaged";

TEST(results_file, cut_damaged_and_foreign_files_are_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& content) {
    const auto file = folder.write("x.h5", content);
    return message_of([&] { read_results(file); });
  };
  const std::string whole = bytes_of(with_everything(), folder, "a.h5");
  EXPECT_EQ(refusal(whole), "");
  std::vector<std::string> without_checksum = {// the first as a file that HDF5 has written over
                                               whole.substr(0, whole.rfind("\nglissade checksum ")),
                                               whole + "\n", "im,num_gms,num_exceed\n"};
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1})
    without_checksum.push_back(whole.substr(0, length));
  for (const std::string& content : without_checksum)
    EXPECT_THAT(refusal(content), states(no_checksum)) << content.size();
  std::string other = whole;
  const std::size_t at = other.find("glissade results");
  ASSERT_NE(at, std::string::npos);
  other[at] = 'G';
  EXPECT_THAT(refusal(other), states(damaged));
  expect_refusals([&](const std::string& name) { read_results(folder.path() / name); },
                  {{"none.h5", "none.h5", {"no such file"}}, {".", ".", {"no regular file"}}});
}

TEST(results_file, a_flipped_bit_anywhere_is_found_by_the_checksum) {
  const TemporaryFolder folder;
  const std::string whole = bytes_of(with_everything(), folder, "a.h5");
  const std::size_t end = whole.rfind("\nglissade checksum ");
  ASSERT_LT(end, whole.size());
  for (std::size_t at = 0; at < whole.size(); at += at < end ? 101 : 1) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
    const auto file = folder.write("x.h5", flipped);
    const std::string message = message_of([&] { read_results(file); });
    const bool of_its_words = at >= end && at < whole.size() - 17;
    EXPECT_THAT(message, states(of_its_words ? no_checksum : damaged)) << at;
  }
}

/// A good file in which one dataset has been replaced by what `put` makes.
template <class Put>
std::filesystem::path file_with(const TemporaryFolder& folder, const std::string& dataset,
                                const Put& put) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, with_everything());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_GE(H5Ldelete(file, dataset.c_str(), H5P_DEFAULT), 0) << dataset;
  put(file);
  EXPECT_GE(H5Fclose(file), 0);
  test::renew_checksum(path);
  return path;
}

/// Numbers with these sides, no value of which is stored.
void put_numbers(hid_t file, const std::string& dataset, const std::vector<hsize_t>& sides,
                 hid_t properties = H5P_DEFAULT) {
  const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
  const hid_t set = H5Dcreate2(file, dataset.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT,
                               properties, H5P_DEFAULT);
  EXPECT_GE(set, 0) << dataset;
  H5Dclose(set);
  H5Sclose(space);
}

TEST(results_file, what_is_stored_outside_the_file_or_compressed_in_another_way_is_refused) {
  const TemporaryFolder folder;
  const std::string pga = "records/pga_g";
  const auto refusal = [&](const auto& put) {
    const auto file = file_with(folder, pga, put);
    return message_of([&] { read_results(file); });
  };
  const auto refusal_of = [&](hid_t properties) {
    const std::string message = refusal([&](hid_t file) {
      put_numbers(file, pga, {with_everything().records.size()}, properties);
    });
    H5Pclose(properties);
    return message;
  };
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, "/etc/hostname", 0, H5F_UNLIMITED);
  EXPECT_THAT(refusal_of(external), states("pga_g", "not stored in the file"));
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t one = 1;
  H5Pset_chunk(chunked, 1, &one);
  H5Pset_deflate(chunked, 1);
  EXPECT_THAT(refusal_of(chunked), states("pga_g", "cut in another way"));
  const auto link = [&](hid_t file) {
    EXPECT_GE(H5Lcreate_external("other.h5", "/records/pga_g", file, pga.c_str(), H5P_DEFAULT,
                                 H5P_DEFAULT),
              0);
  };
  EXPECT_THAT(refusal(link), states("pga_g", "link"));
}

TEST(results_file, datasets_that_claim_more_than_the_file_can_hold_are_refused) {
  const TemporaryFolder folder;
  constexpr hsize_t huge = hsize_t{1} << 40;
  const auto refuses = [&](const std::string& dataset, const std::vector<hsize_t>& sides) {
    const auto file =
        file_with(folder, dataset, [&](hid_t open) { put_numbers(open, dataset, sides); });
    EXPECT_THAT(message_of([&] { read_results(file); }),
                states(dataset.substr(dataset.rfind('/') + 1), "larger"));
  };
  refuses("records/pga_g", {huge});
  refuses("suites/spectra_0/srss_g", {huge, 0});     // rows of nothing
  refuses("suites/spectra_0/srss_g", {huge, huge});  // 2^80 wraps round to 0
  refuses("histories/capacity_g", {1 << 16, 1 << 16, huge});
  refuses("histories/uplift", {huge, 0, huge});
}

TEST(results_file, parts_that_are_not_of_the_study_are_refused) {
  const auto refusal = [](void (*spoil)(Results&)) {
    Results results = with_everything();
    spoil(results);
    return misfit_in(results);
  };
  EXPECT_EQ(refusal([](Results&) {}), "");
  // Cases.
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = 0; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = 3; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = 16; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = std::size_t{1} << 63; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.cases[7].orientation.ground_azimuth_deg = 360.0; }),
            "ground_azimuth_deg");
  EXPECT_THAT(
      refusal([](Results& r) { r.cases.cases[0].orientation.ground_azimuth_deg = std::nan(""); }),
      states("numbers of ground_azimuth_deg"));
  EXPECT_EQ(refusal([](Results& r) { r.cases.cases[3].orientation.across_sign = 0; }),
            "across_sign");
  EXPECT_THAT(refusal([](Results& r) { r.cases.cases[3].friction = std::nan(""); }),
              states("numbers of friction.mu"));
  // Histories: a field that is missing, or has numbers that no history has.
  for_each_history_field([&](auto field) {
    Results results = with_everything();
    auto& values = results.histories.fields.*field.of;
    if (values.empty()) return;
    values.back() = static_cast<std::remove_cvref_t<decltype(values.back())>>(2);
    const bool is_possible = sizeof(values.back()) > 1 && std::string(field.name) != "capacity";
    EXPECT_EQ(misfit_in(results), is_possible ? "" : field.name);
    if constexpr (sizeof(values.back()) > 1) {
      const bool may_be_nan = std::string(field.name).starts_with("crossing");
      values.back() = may_be_nan ? -1.0 : std::nan("");
      EXPECT_EQ(misfit_in(results), field.name);
    }
    values.clear();
    EXPECT_EQ(misfit_in(results), field.name);
  });
  // Records and suites.
  EXPECT_EQ(refusal([](Results& r) { r.records[1].suite = 7; }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.records[0].suite = 1; }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.records[1].stronger = 2; }), "stronger");
  EXPECT_EQ(refusal([](Results& r) { r.suites.push_back(r.suites[0]); }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.suites.clear(); }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.target_g.clear(); }), "target_g");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.records_g.pop_back(); }), "srss_g");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.average_g.pop_back(); }), "spectra");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.target_g = {1.0}; }), "spectra");
  EXPECT_EQ(refusal([](Results& r) { r.notes_of_run = 300; }), "remarks_of_run");
}

TEST(results_file, with_another_study_is_refused) {
  const auto refusal = [](const std::string& what, const std::string& by) {
    Results results = with_everything();
    const std::size_t at = results.study_text.find(what);
    results.study_text.replace(at, what.size(), by);
    return misfit_in(results);
  };
  EXPECT_EQ(refusal("[impact]\n", ""), "crossing_time_s");
  EXPECT_EQ(refusal("samples = 8", "samples = 10"), "samples");
  EXPECT_THAT(refusal("levels = [0.5, 1.0, 1.5]", "levels = [0.5]"), states("peak_displacement_m"));
  EXPECT_THAT(refusal("[shape]", "shape ="), states("study"));
  EXPECT_THAT(refusal("curve.csv", "../../etc/passwd"), states("etc/passwd", "with the study"));
}

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(results_file, a_write_that_fails_leaves_the_old_file_and_nothing_else) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.h5", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 4096;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = message_of([&] { write_results(file, with_everything()); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, states("a.h5", "too large"));
  EXPECT_EQ(read_text_file(file), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
  EXPECT_THAT(message_of([&] { write_results("/dev/full", with_everything()); }),
              states("/dev/full"));
}

TEST(results_file, leaves_hdf5s_own_error_printing_silent) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  message_of([&] { read_results(folder.write("x.h5", "no HDF5")); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace glissade
