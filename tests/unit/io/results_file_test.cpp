// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <limits>

#include "misfits.hpp"
#include "renew_checksum.hpp"
#include "whole_results.hpp"

namespace glissade {
namespace {

using test::states;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(results_file, two_writes_give_the_same_bytes) {
  const TemporaryFolder folder;
  const std::string first = bytes_of(with_fragility(), folder, "a.h5");
  ::sleep(1);  // a time stamp has whole seconds
  EXPECT_EQ(first, bytes_of(with_fragility(), folder, "b.h5"));
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

TEST(results_file, of_every_analysis_comes_back_to_the_last_bit) {
  const TemporaryFolder folder;
  Results chart = whole_results(), clearance = whole_results(true);
  chart.thresholds_m.clear();
  chart.histories.thresholds = 0;
  fill_histories(chart.histories, false);
  add_chart(chart);
  add_clearance(clearance, 1.3);
  for (const Results& written : {with_fragility(), chart, clearance, with_all()}) {
    const std::string bytes = bytes_of(written, folder, "a.h5");
    const Results read = read_results(folder.path() / "a.h5");
    // Whatever is written is read; what follows checks what is written.
    EXPECT_EQ(bytes, bytes_of(read, folder, "b.h5"));
    expect_same_cases(read.cases, written.cases);
    expect_same_histories(read.histories, written.histories);
    EXPECT_EQ(read.axes, written.axes);
    EXPECT_EQ(read.runs.size(), written.runs.size());
    EXPECT_EQ(read.chart.has_value(), written.chart.has_value());
    EXPECT_EQ(read.clearance.has_value(), written.clearance.has_value());
    EXPECT_EQ(read.base_shear.has_value(), written.base_shear.has_value());
    EXPECT_EQ(read.tipping.has_value(), written.tipping.has_value());
    EXPECT_EQ(read.hazard.has_value(), written.hazard.has_value());
    EXPECT_EQ(read.verdict.has_value(), written.verdict.has_value());
    EXPECT_EQ(read.intensity_measures.has_value(), written.intensity_measures.has_value());
    EXPECT_EQ(read.sensitivity.has_value(), written.sensitivity.has_value());
    EXPECT_EQ(read.shape.has_value(), written.shape.has_value());
    EXPECT_EQ(read.conditions.has_value(), written.conditions.has_value());
  }
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(results_file, head_suites_and_records_come_back) {
  const TemporaryFolder folder;
  Results written = with_fragility();
  written.suites.push_back(
      {"other", "of one", "ASCE 7-10, S_S 1 g", {{1.0}, {{0.5}}, {0.5}, {0.4}, 0.0}});
  written.records[1].suite = 1;
  written.suites[0].spectra.srss_g.pop_back();
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
  EXPECT_EQ(read.model.kernel + read.model.building + read.model.friction + read.model.displacement,
            "tableselasticCoulombvector");
  EXPECT_EQ(read.levels, written.levels);
  EXPECT_EQ(read.thresholds_m, written.thresholds_m);
  EXPECT_EQ(read.notes, written.notes);
  EXPECT_EQ(read.warnings_of_run, written.warnings_of_run);
  EXPECT_EQ(read.notes_of_run, written.notes_of_run);
  EXPECT_EQ(read.suites[1].target, "ASCE 7-10, S_S 1 g");
  ASSERT_EQ(read.records.size(), 2u);
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
  EXPECT_EQ(read.records[1].suite, 1u);
  ASSERT_EQ(read.suites.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.suites[i].name, written.suites[i].name);
    EXPECT_EQ(read.suites[i].description, written.suites[i].description);
    const SuiteSpectra &a = read.suites[i].spectra, &b = written.suites[i].spectra;
    EXPECT_EQ(a.periods_s, b.periods_s);
    EXPECT_EQ(a.srss_g, b.srss_g);
    EXPECT_EQ(a.average_srss_g, b.average_srss_g);
    EXPECT_EQ(a.target_g, b.target_g);
    EXPECT_EQ(a.reference_level, b.reference_level);
    EXPECT_PRED2(same_number, a.to_target.lowest.ratio, b.to_target.lowest.ratio);
    EXPECT_PRED2(same_number, a.to_target.lowest.period_s, b.to_target.lowest.period_s);
    EXPECT_PRED2(same_number, a.to_target.highest.ratio, b.to_target.highest.ratio);
    EXPECT_PRED2(same_number, a.to_target.highest.period_s, b.to_target.highest.period_s);
  }
}

TEST(results_file, runs_come_back_in_order_with_ragged_bands) {
  const TemporaryFolder folder;
  const Results written = with_fragility();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");
  ASSERT_EQ(read.runs.size(), 2u);
  EXPECT_EQ(read.runs[1].label, "design");
  EXPECT_TRUE(read.runs[1].standards.empty());
  const RunResults& a = read.runs[0];
  const RunResults& b = written.runs[0];
  EXPECT_EQ(a.label, "sampled");
  EXPECT_EQ(a.friction_description, b.friction_description);
  EXPECT_EQ(read.runs[1].first_case, 4u);
  EXPECT_EQ(read.runs[1].cases, 4u);
  EXPECT_EQ(a.band_intensities, b.band_intensities);
  ASSERT_EQ(a.fragilities.size(), 2u);
  const ThresholdFragility& f = a.fragilities[0];
  EXPECT_EQ(f.threshold_m, 0.15);
  EXPECT_EQ(f.stripes.status, FitStatus::jeffreys_penalised);
  EXPECT_EQ(f.stripes.curve.median, 0.7);
  EXPECT_EQ(f.stripes.curve.log_std, 0.4);
  EXPECT_EQ(f.stripes.curve.floor, 0.125);
  EXPECT_EQ(f.stripes.floor_interval.high, 0.15);
  EXPECT_EQ(f.stripes.p50_interval.low, 0.55);
  EXPECT_EQ(f.stripes.median_interval.low, 0.6);
  EXPECT_TRUE(std::isnan(f.stripes.median_interval.high));
  EXPECT_EQ(f.stripes.log_std_interval.high, 0.5);
  EXPECT_EQ(f.stripes.log_likelihood, -12.5);
  EXPECT_EQ(f.stripes.method + f.stripes.interval_method + f.stripes.note,
            "probitprofileseparated");
  EXPECT_EQ(f.capacities.status, FitStatus::lower_bound);
  EXPECT_EQ(f.capacities.median_interval.high, infinity);
  EXPECT_EQ(f.probability, b.fragilities[0].probability);
  ASSERT_EQ(f.probability_interval.size(), 3u);
  EXPECT_EQ(f.probability_interval[1].high, 0.4);
  EXPECT_EQ(f.band.size(), 2u);
  EXPECT_TRUE(a.fragilities[1].band.empty());
  EXPECT_EQ(f.record_recross, b.fragilities[0].record_recross);
  EXPECT_EQ(f.recross_share, 0.01);
  EXPECT_EQ(f.censored_share, 0.5);
  EXPECT_EQ(f.free_sliding_share, 0.02);
  ASSERT_EQ(a.slip.size(), 3u);
  const SlipStatistics& s = a.slip[1];
  EXPECT_THAT(
      (std::vector<double>{s.level, s.median_m, s.p84_m, s.p95_m, s.mean_m, s.mean_interval.low,
                           s.mean_interval.high, s.median_interval.low, s.median_interval.high,
                           s.p84_interval.low, s.p84_interval.high, s.uplift_share}),
      testing::ElementsAre(1.0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0.5));
  EXPECT_EQ(s.mean_vector_m, 11.0);
  ASSERT_EQ(a.standards.size(), 1u);
  EXPECT_EQ(a.standards[0].standard, Standard::asce7_16);
  EXPECT_EQ(a.standards[0].sds_g, 1.0);
  EXPECT_EQ(a.standards[0].prescribed.value_m, 0.55);
  EXPECT_EQ(a.standards[0].prescribed.provenance, Provenance::recalled);
  EXPECT_EQ(a.standards[0].prescribed.basis, b.standards[0].prescribed.basis);
  EXPECT_EQ(a.standards[0].exceedance_probability, 0.1);
  EXPECT_EQ(a.standards[0].exceedance_interval.high, 0.2);
}

TEST(results_file, holds_study_files_of_any_length) {
  const TemporaryFolder folder;
  Results results = whole_results();
  results.study_text = std::string(300000, 'x') + "end";
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
  const std::string whole = bytes_of(with_fragility(), folder, "a.h5");
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
  const std::string whole = bytes_of(with_fragility(), folder, "a.h5");
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

/// A good file in which one dataset has been replaced by one of numbers with these sides, no value
/// of which is stored.
std::filesystem::path file_with(const TemporaryFolder& folder, const char* dataset,
                                const std::vector<hsize_t>& sides) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, with_fragility());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
  EXPECT_GE(H5Ldelete(file, dataset, H5P_DEFAULT), 0) << dataset;
  const hid_t set =
      H5Dcreate2(file, dataset, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(set, 0) << dataset;
  H5Dclose(set);
  H5Sclose(space);
  EXPECT_GE(H5Fclose(file), 0);
  test::renew_checksum(path);
  return path;
}

TEST(results_file, of_a_program_with_fewer_parameters_has_the_usual_value_of_the_others) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "old.h5";
  write_results(path, with_fragility());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  for (const char* key : {"cases/friction.neighbour_mu", "cases/roof.neighbour_slope"})
    EXPECT_GE(H5Ldelete(file, key, H5P_DEFAULT), 0) << key;
  EXPECT_GE(H5Fclose(file), 0);
  test::renew_checksum(path);
  for (const Case& c : read_results(path).cases.cases) {
    EXPECT_EQ(c.neighbour_friction, Case().neighbour_friction);
    EXPECT_EQ(c.neighbour_slope, NeighbourSlope::same);
  }
}

/// A good file whose levels are stored otherwise: by other properties, or behind a link.
std::filesystem::path file_with_levels(const TemporaryFolder& folder, hid_t properties,
                                       const char* external_link) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, with_fragility());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const auto levels = static_cast<hsize_t>(with_fragility().levels.size());
  const std::string name = "level_g";
  EXPECT_GE(H5Ldelete(file, name.c_str(), H5P_DEFAULT), 0);
  if (external_link != nullptr) {
    EXPECT_GE(
        H5Lcreate_external(external_link, "/level_g", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        0);
  } else {
    const hid_t space = H5Screate_simple(1, &levels, nullptr);
    const hid_t set =
        H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    EXPECT_GE(set, 0);
    H5Dclose(set);
    H5Sclose(space);
  }
  EXPECT_GE(H5Fclose(file), 0);
  test::renew_checksum(path);
  return path;
}

TEST(results_file, what_is_stored_outside_the_file_or_compressed_in_another_way_is_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](hid_t properties, const char* link) {
    const auto file = file_with_levels(folder, properties, link);
    const std::string message = message_of([&] { read_results(file); });
    H5Pclose(properties);
    return message;
  };
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, "/etc/hostname", 0, H5F_UNLIMITED);
  EXPECT_THAT(refusal(external, nullptr), states("level_g", "not stored in the file"));
  const hid_t chunked = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t one = 1;
  H5Pset_chunk(chunked, 1, &one);
  H5Pset_deflate(chunked, 1);
  EXPECT_THAT(refusal(chunked, nullptr), states("level_g", "cut in another way"));
  EXPECT_THAT(refusal(H5Pcreate(H5P_DATASET_CREATE), "other.h5"), states("level_g", "link"));
}

TEST(results_file, datasets_that_claim_more_than_the_file_can_hold_are_refused) {
  const TemporaryFolder folder;
  constexpr hsize_t huge = hsize_t{1} << 40;
  const auto refuses = [&](const std::string& dataset, const std::vector<hsize_t>& sides) {
    EXPECT_THAT(message_of([&] { read_results(file_with(folder, dataset.c_str(), sides)); }),
                states(dataset.substr(dataset.rfind('/') + 1), "larger"));
  };
  refuses("level_g", {huge});
  refuses("suites/spectra_0/srss_g", {huge, 0});     // rows of nothing
  refuses("suites/spectra_0/srss_g", {huge, huge});  // 2^80 wraps round to 0
  refuses("histories/capacity_g", {1 << 16, 1 << 16, huge});
  refuses("histories/uplift", {huge, 0, huge});
}

TEST(results_file, an_empty_first_column_is_not_filled_up_by_the_next) {
  const TemporaryFolder folder;
  for (const char* dataset :
       {"cases/friction.mu", "runs/sampled/slip/level_g", "runs/sampled/fragility/threshold_m"}) {
    const std::string misfit = misfit_of([&] { read_results(file_with(folder, dataset, {0})); });
    EXPECT_NE(misfit, "") << dataset;
    EXPECT_EQ(misfit.find(' '), std::string::npos) << misfit;
  }
}

TEST(results_file, parts_that_do_not_fit_each_other_are_refused) {
  const auto refusal = [](void (*spoil)(Results&)) {
    Results results = with_all();
    spoil(results);
    return misfit_in(results);
  };
  EXPECT_EQ(refusal([](Results&) {}), "");
  // Cases.
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = 0; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = 3; }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.samples = std::size_t{1} << 63; }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.orientations = 0; }), "samples");
  EXPECT_EQ(refusal([](Results& r) { r.cases.orientations = 2; }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.axes.clear(); }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.axes[0].values.clear(); }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.axes[0].values[1] = 7.0; }), "values");
  EXPECT_EQ(refusal([](Results& r) { r.cases.axes[0].names.pop_back(); }), "names");
  EXPECT_EQ(refusal([](Results& r) { r.cases.axes[0].key = "building.colour"; }), "axes");
  EXPECT_EQ(refusal([](Results& r) { r.cases.cases[7].orientation.ground_azimuth_deg = 360.0; }),
            "ground_azimuth_deg");
  EXPECT_EQ(
      refusal([](Results& r) { r.cases.cases[0].orientation.ground_azimuth_deg = std::nan(""); }),
      "ground_azimuth_deg");
  EXPECT_EQ(refusal([](Results& r) { r.cases.cases[3].orientation.across_sign = 0; }),
            "across_sign");
  // Histories.
  const auto histories = [](Results& r, std::size_t HistoryTable::*side, std::size_t size) {
    r.histories.*side = size;
    fill_histories(r.histories, true);
  };
  for (const auto& [side, field] : {std::pair{&HistoryTable::records, "peak_displacement_m"},
                                    {&HistoryTable::cases, "peak_displacement_m"},
                                    {&HistoryTable::levels, "peak_displacement_m"},
                                    {&HistoryTable::thresholds, "capacity_g"}}) {
    for (const std::size_t size : {1u, 9u}) {
      Results results = with_all();
      histories(results, side, size);
      EXPECT_EQ(misfit_in(results), field);
    }
  }
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.peak_displacement_m.clear(); }),
            "peak_displacement_m");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.peak_vector_m.clear(); }), "peak_vector_m");
  EXPECT_EQ(refusal([](Results& r) { r.axes = SlidingAxes::one; }), "peak_vector_m");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.residual_across_m.clear(); }),
            "residual_along_m");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.peak_across_m.clear(); }), "peak_along_m");
  EXPECT_EQ(refusal([](Results& r) { r.notes_of_run = 3; }), "remarks_of_run");
  EXPECT_EQ(refusal([](Results& r) {
              r.histories.fields.residual_along_m.clear();
              r.histories.fields.residual_across_m.clear();
            }),
            "residual_along_m");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.closing_across_m.clear(); }),
            "closing_along_m");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.shear_across.clear(); }), "shear_along");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.uplift.clear(); }), "uplift");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.failed.clear(); }), "uplift");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.capacity.clear(); }), "capacity");
  EXPECT_EQ(refusal([](Results& r) { r.histories.fields.crossing_time_s.clear(); }),
            "crossing_time_s");
  // Records and suites.
  EXPECT_EQ(refusal([](Results& r) { r.records[1].suite = 7; }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.records[0].suite = 1; }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.records[1].stronger = 2; }), "stronger");
  EXPECT_EQ(refusal([](Results& r) { r.suites.push_back(r.suites[0]); }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.suites.clear(); }), "records");
  EXPECT_EQ(refusal([](Results& r) { r.measure = IntensityMeasure::sds_g; }), "target_g");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.srss_g.pop_back(); }), "srss_g");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.srss_g[1].pop_back(); }), "spectra");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.average_srss_g.pop_back(); }), "spectra");
  EXPECT_EQ(refusal([](Results& r) { r.suites[0].spectra.target_g = {1.0}; }), "spectra");
  // Runs.
  EXPECT_EQ(refusal([](Results& r) { r.runs[1].cases = 0; }), "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.runs[1].cases = 9; }), "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.runs[1].first_case = 5; }), "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.runs[1].first_case = ~std::uint64_t{0}; }), "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].slip.pop_back(); }), "slip");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].fragilities.pop_back(); }), "fragility");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].fragilities[1].probability.clear(); }),
            "probability");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].fragilities[1].probability_interval.clear(); }),
            "probability_low");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].fragilities[1].record_recross.pop_back(); }),
            "record_recross");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].fragilities[0].band.pop_back(); }), "band_low");
  EXPECT_EQ(refusal([](Results& r) { r.runs[0].impact.pop_back(); }), "impact");
  EXPECT_EQ(refusal([](Results& r) {
              r.histories.fields.crossing_time_s.clear();
              r.histories.fields.crossing_speed_mps.clear();
            }),
            "impact");
}

TEST(results_file, refuses_levels_that_do_not_rise_and_displacements_that_are_no_numbers) {
  Results results = with_all();
  EXPECT_EQ(misfit_in(results), "");
  std::ranges::reverse(results.levels);
  EXPECT_THAT(misfit_in(results), states("levels"));
  results = with_all();
  results.histories.fields.peak_displacement_m.front() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(misfit_in(results), states("displacement"));
}

TEST(results_file, names_of_what_is_listed_that_could_act_in_a_script_or_page_are_refused) {
  for (const char* name : {"`touch pwned`", "'; system('x'); '", "a\nb", "<script>", "../design"}) {
    Results results = with_fragility();
    results.cases.axes[0].names[1] = name;
    EXPECT_THAT(misfit_in(results), states("name")) << name;
  }
}

/// A good file in which the run "design" is called otherwise.
std::filesystem::path file_with_label(const TemporaryFolder& folder, const std::string& label) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, with_fragility());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t runs = H5Gopen2(file, "runs", H5P_DEFAULT);
  EXPECT_GE(H5Ldelete(runs, "label", H5P_DEFAULT), 0);
  const std::size_t longest = std::max(label.size(), std::size_t{7});
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, longest);
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const hsize_t two = 2;
  const hid_t space = H5Screate_simple(1, &two, nullptr);
  const hid_t set = H5Dcreate2(runs, "label", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  std::string packed = "sampled" + std::string(longest - 7, '\0') + label;
  packed.resize(2 * longest, '\0');
  EXPECT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), 0);
  H5Lmove(runs, "design", runs, label.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  H5Dclose(set);
  H5Sclose(space);
  H5Tclose(type);
  H5Gclose(runs);
  EXPECT_GE(H5Fclose(file), 0);
  test::renew_checksum(path);
  return path;
}

TEST(results_file, labels_of_runs_that_could_act_in_a_script_or_page_are_refused) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_results(file_with_label(folder, "nominal")).runs.at(1).label, "nominal");
  for (const char* label : {"`touch pwned`", "'; system('x'); '", "a\"b", "a\nb", "$(x)",
                            "<script>", "../design", "./design", "de sign"}) {
    EXPECT_THAT(message_of([&] { read_results(file_with_label(folder, label)); }), states("name"))
        << label;
  }
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
  const std::string message = message_of([&] { write_results(file, with_fragility()); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, states("a.h5", "too large"));
  EXPECT_EQ(read_text_file(file), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
  EXPECT_THAT(message_of([&] { write_results("/dev/full", with_fragility()); }),
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
