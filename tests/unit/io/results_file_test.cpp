// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <limits>

#include "glissade/core/file.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::nan("");

ThresholdFragility make_fragility(double threshold_m, std::size_t band) {
  ThresholdFragility f;
  f.threshold_m = threshold_m;
  f.stripes = {FitStatus::jeffreys_penalised,
               {0.7, 0.4, 0.125},
               {0.6, nan_value},
               {0.3, 0.5},
               {0.1, 0.15},
               {0.55, 0.65},
               -12.5,
               "probit",
               "profile",
               "separated"};
  f.capacities = {
      FitStatus::lower_bound, {1.5, 0.2}, {1.5, infinity}, {}, {}, {}, nan_value, "", "", ""};
  f.probability = {0.0, 0.25, 1.0 / 3};
  f.probability_interval = {{0.0, 0.1}, {0.1, 0.4}, {0.2, nan_value}};
  f.band.assign(band, {0.125, 0.5});
  f.recross_share = 0.01;
  f.record_recross = {0.0, 1.0};
  f.censored_share = 0.5;
  f.free_sliding_share = 0.02;
  return f;
}

RunResults make_run(const std::string& label) {
  RunResults run;
  run.label = label;
  run.friction_description = "normal, mean 0.55, std 0.04";
  run.peak_displacement_m = Array3<double>(2, 4, 3, 0.1);
  for (std::size_t i = 0; i < run.peak_displacement_m.data.size(); ++i)
    run.peak_displacement_m.data[i] = std::sqrt(static_cast<double>(i));
  run.uplift = Array3<std::uint8_t>(2, 4, 3);
  run.uplift(1, 2, 0) = 1;
  run.capacity = Array3<double>(2, 4, 2, infinity);
  run.capacity(0, 3, 1) = 0.0;
  run.fragilities = {make_fragility(0.15, 2), make_fragility(0.3, 0)};  // the second has no band
  run.band_intensities = {0.5, 1.0};
  run.slip = {{0.5, 0.1, 0.2, 0.3, 0.15, {0.1, 0.2}, {0.05, 0.15}, {0.15, 0.25}, 0.0},
              {1.0, 1, 2, 3, 4, {5, 6}, {7, 8}, {9, 10}, 0.5},
              {}};
  run.standards = {{Standard::asce7_16,
                    1.0,
                    {0.55, Provenance::recalled, "5 I_e (S_DS - 0.4)^2 ft"},
                    0.1,
                    {0.05, 0.2}}};
  return run;
}

Results make_results() {
  Results r;
  r.study_name = "σχέδιο";  // UTF-8
  r.program_version = "0.1.0";
  r.plan_hash = "0123456789abcdef";
  r.study_text = "[study]\nname = \"σχέδιο\"\n";
  r.seed = 0xfedcba9876543210u;
  r.measure = IntensityMeasure::avg_sa_g;
  r.intensity_label = "Sa,avg (g)";
  r.suite_name = "suite";
  r.levels = {0.5, 1.0, 1.5};
  r.thresholds_m = {0.15, 0.3};
  r.samples = {
      {0.5, 2.0, 0.7, 0.05, 1, -1}, {0.6, 1.0, 0.0, 0.0, 0, 1}, {}, {0.1, 0.2, 0.3, 0.4, 1, 1}};
  r.records = {
      {"a", "event", "station", 6.9, 8.5, 380.0, 2.5, 1.7, 0.5, 0.4, 0.005, 7671, true, false},
      {"b", "", "", 0, 0, 0, 1, 0, 0, 0, 0.01, 1, false, true}};
  r.spectra = {{0.0, 0.5}, {{0.4, 0.9}, {0.3, 1.1}}, {0.35, 1.0}, {}, 1.3};
  r.runs = {make_run("sampled"), make_run("design")};
  r.runs[1].standards.clear();
  r.notes = {"5 of 22 records have no vertical", ""};
  return r;
}

/// Every double the same bits, nan included: the writer's bytes are a function of the content.
std::string bytes_of(const Results& results, const TemporaryFolder& folder,
                     const std::string& name) {
  write_results(folder.path() / name, results);
  return read_text_file(folder.path() / name);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(results_file, two_writes_give_the_same_bytes) {
  const TemporaryFolder folder;
  const std::string first = bytes_of(make_results(), folder, "a.h5");
  ::sleep(1);  // a time stamp has whole seconds
  EXPECT_EQ(first, bytes_of(make_results(), folder, "b.h5"));
}

TEST(results_file, everything_comes_back_to_the_last_bit) {
  const TemporaryFolder folder;
  const Results written = make_results();
  const std::string bytes = bytes_of(written, folder, "a.h5");
  const Results read = read_results(folder.path() / "a.h5");
  EXPECT_EQ(bytes,
            bytes_of(read, folder,
                     "b.h5"));  // whatever is written is read; what follows checks what is written

  EXPECT_EQ(read.study_name, written.study_name);
  EXPECT_EQ(read.study_text, written.study_text);
  EXPECT_EQ(read.program_version, written.program_version);
  EXPECT_EQ(read.plan_hash, written.plan_hash);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.measure, written.measure);
  EXPECT_EQ(read.intensity_label, written.intensity_label);
  EXPECT_EQ(read.suite_name, written.suite_name);
  EXPECT_EQ(read.suite_description, written.suite_description);
  EXPECT_EQ(read.levels, written.levels);
  EXPECT_EQ(read.thresholds_m, written.thresholds_m);
  EXPECT_EQ(read.notes, written.notes);
  ASSERT_EQ(read.samples.size(), 4u);
  EXPECT_EQ(read.samples[0].friction, 0.5);
  EXPECT_EQ(read.samples[0].slope_deg, 2.0);
  EXPECT_EQ(read.samples[0].period_s, 0.7);
  EXPECT_EQ(read.samples[0].damping, 0.05);
  EXPECT_EQ(read.samples[0].component, 1);
  EXPECT_EQ(read.samples[0].sign, -1);
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
  EXPECT_EQ(record.dt_s, 0.005);
  EXPECT_EQ(record.samples, 7671u);
  EXPECT_TRUE(record.has_second);
  EXPECT_FALSE(record.has_vertical);
  EXPECT_EQ(read.spectra.periods_s, written.spectra.periods_s);
  EXPECT_EQ(read.spectra.srss_g, written.spectra.srss_g);
  EXPECT_EQ(read.spectra.average_srss_g, written.spectra.average_srss_g);
  EXPECT_TRUE(read.spectra.target_g.empty());
  EXPECT_EQ(read.spectra.reference_level, 1.3);
}

TEST(results_file, runs_come_back_in_order_with_ragged_bands) {
  const TemporaryFolder folder;
  const Results written = make_results();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");
  ASSERT_EQ(read.runs.size(), 2u);
  EXPECT_EQ(read.runs[1].label, "design");
  EXPECT_TRUE(read.runs[1].standards.empty());
  const RunResults& a = read.runs[0];
  const RunResults& b = written.runs[0];
  EXPECT_EQ(a.label, "sampled");
  EXPECT_EQ(a.friction_description, b.friction_description);
  EXPECT_EQ(a.peak_displacement_m.rows, 2u);
  EXPECT_EQ(a.peak_displacement_m.columns, 4u);
  EXPECT_EQ(a.peak_displacement_m.depth, 3u);
  EXPECT_EQ(a.peak_displacement_m.data, b.peak_displacement_m.data);
  EXPECT_EQ(a.uplift.data, b.uplift.data);
  EXPECT_EQ(a.capacity.data, b.capacity.data);
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
  EXPECT_TRUE(same_bits(f.stripes.median_interval.high, nan_value));
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
  ASSERT_EQ(a.standards.size(), 1u);
  EXPECT_EQ(a.standards[0].standard, Standard::asce7_16);
  EXPECT_EQ(a.standards[0].sds_g, 1.0);
  EXPECT_EQ(a.standards[0].prescribed.value_m, 0.55);
  EXPECT_EQ(a.standards[0].prescribed.provenance, Provenance::recalled);
  EXPECT_EQ(a.standards[0].prescribed.basis, b.standards[0].prescribed.basis);
  EXPECT_EQ(a.standards[0].exceedance_probability, 0.1);
  EXPECT_EQ(a.standards[0].exceedance_interval.high, 0.2);
}

TEST(results_file, holds_empty_results_and_study_files_of_any_length) {
  const TemporaryFolder folder;
  Results results;
  results.study_text = std::string(300000, 'x') + "end";
  write_results(folder.path() / "a.h5", results);
  const Results read = read_results(folder.path() / "a.h5");
  EXPECT_EQ(read.study_text, results.study_text);
  EXPECT_TRUE(read.runs.empty());
  EXPECT_TRUE(read.records.empty());
}

TEST(results_file, cut_damaged_and_foreign_files_are_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& content) {
    const auto file = folder.write("x.h5", content);
    return message_of([&] { read_results(file); });
  };
  const std::string whole = bytes_of(make_results(), folder, "a.h5");
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("is not a whole glissade results file"))
        << length;
  }
  EXPECT_THAT(refusal("im,num_gms,num_exceed\n"),
              HasSubstr("is not a whole glissade results file"));
  std::string other = whole;
  const std::size_t at = other.find("glissade results");
  ASSERT_NE(at, std::string::npos);
  other[at] = 'G';
  EXPECT_THAT(refusal(other), HasSubstr("is not a whole glissade results file"));
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "none.h5"); }),
              HasSubstr("no such file"));
  EXPECT_THAT(message_of([&] { read_results(folder.path()); }), HasSubstr("no ordinary file"));
}

/// A good file in which one dataset has been replaced by one of numbers with these sides, no value
/// of which is stored.
std::filesystem::path file_with(const TemporaryFolder& folder, const char* dataset,
                                const std::vector<hsize_t>& sides) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, make_results());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
  EXPECT_GE(H5Ldelete(file, dataset, H5P_DEFAULT), 0) << dataset;
  const hid_t set =
      H5Dcreate2(file, dataset, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(set, 0) << dataset;
  H5Dclose(set);
  H5Sclose(space);
  EXPECT_GE(H5Fclose(file), 0);
  return path;
}

TEST(results_file, datasets_that_claim_more_than_the_file_can_hold_are_refused) {
  const TemporaryFolder folder;
  constexpr hsize_t huge = hsize_t{1} << 40;
  const auto refusal = [&](const char* dataset, const std::vector<hsize_t>& sides) {
    return message_of([&] { read_results(file_with(folder, dataset, sides)); });
  };
  const auto is_too_large = HasSubstr("larger than the file");
  EXPECT_THAT(refusal("level_g", {huge}), is_too_large);
  EXPECT_THAT(refusal("spectra/srss_g", {huge, 0}), is_too_large);     // rows of nothing
  EXPECT_THAT(refusal("spectra/srss_g", {huge, huge}), is_too_large);  // 2^80 wraps round to 0
  EXPECT_THAT(refusal("runs/design/capacity_g", {1 << 16, 1 << 16, huge}), is_too_large);
  EXPECT_THAT(refusal("runs/design/uplift", {huge, 0, huge}), is_too_large);
}

TEST(results_file, an_empty_first_column_is_not_filled_up_by_the_next) {
  const TemporaryFolder folder;
  for (const char* dataset :
       {"samples/friction", "runs/sampled/slip/level_g", "runs/sampled/fragility/threshold_m"}) {
    EXPECT_THAT(message_of([&] { read_results(file_with(folder, dataset, {0})); }),
                HasSubstr("to the other columns"))
        << dataset;
  }
}

TEST(results_file, parts_that_do_not_fit_each_other_are_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](void (*spoil)(Results&)) {
    Results results = make_results();
    spoil(results);
    write_results(folder.path() / "a.h5", results);
    return message_of([&] { read_results(folder.path() / "a.h5"); });
  };
  const auto does_not_fit = [](const std::string& part, const std::string& whole) {
    return HasSubstr("cannot fit " + part + " to the " + whole);
  };
  EXPECT_EQ(refusal([](Results&) {}), "");
  EXPECT_THAT(refusal([](Results& r) { r.levels.pop_back(); }),
              does_not_fit("peak_displacement_m", "records, samples and levels"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[1].uplift = Array3<std::uint8_t>(2, 3, 4); }),
              does_not_fit("uplift", "records, samples and levels"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].peak_vector_m = Array3<double>(2, 3, 4); }),
              does_not_fit("peak_vector_m", "records, samples and levels"));
  EXPECT_THAT(refusal([](Results& r) { r.thresholds_m.push_back(1.0); }),
              does_not_fit("capacity_g", "records, samples and thresholds"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].slip.pop_back(); }),
              does_not_fit("slip", "levels"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].fragilities.pop_back(); }),
              does_not_fit("fragility", "thresholds"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].fragilities[1].probability.clear(); }),
              does_not_fit("probability", "levels"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].fragilities[1].probability_interval.clear(); }),
              does_not_fit("probability_low", "levels"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].fragilities[1].record_recross.pop_back(); }),
              does_not_fit("record_recross", "records"));
  EXPECT_THAT(refusal([](Results& r) { r.runs[0].fragilities[0].band.pop_back(); }),
              does_not_fit("band_low", "band's intensities"));
  EXPECT_THAT(refusal([](Results& r) { r.spectra.srss_g.pop_back(); }),
              does_not_fit("srss_g", "records"));
  EXPECT_THAT(refusal([](Results& r) { r.spectra.srss_g[1].pop_back(); }),
              does_not_fit("srss_g", "periods"));
  EXPECT_THAT(refusal([](Results& r) { r.spectra.average_srss_g.pop_back(); }),
              does_not_fit("average_srss_g", "periods"));
  EXPECT_THAT(refusal([](Results& r) { r.spectra.target_g = {1.0}; }),
              does_not_fit("target_g", "periods"));
}

/// A good file in which the run "design" is called otherwise.
std::filesystem::path file_with_label(const TemporaryFolder& folder, const std::string& label) {
  const auto path = folder.path() / "edited.h5";
  write_results(path, make_results());
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
  return path;
}

TEST(results_file, labels_of_runs_that_could_act_in_a_script_or_page_are_refused) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_results(file_with_label(folder, "nominal")).runs.at(1).label, "nominal");
  for (const char* label : {"`touch pwned`", "'; system('x'); '", "a\"b", "a\nb", "$(x)",
                            "<script>", "../design", "./design", "de sign"}) {
    EXPECT_THAT(message_of([&] { read_results(file_with_label(folder, label)); }),
                HasSubstr("cannot take the label of a run"))
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
  const std::string message = message_of([&] { write_results(file, make_results()); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(message, AllOf(HasSubstr("a.h5"), HasSubstr("too large")));
  EXPECT_EQ(read_text_file(file), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
  EXPECT_THAT(message_of([&] { write_results("/dev/full", make_results()); }),
              HasSubstr("No space left"));
}

TEST(results_file, leaves_hdf5s_own_error_printing_silent) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  message_of([&] { read_results(folder.write("x.h5", "no HDF5")); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace glissade
