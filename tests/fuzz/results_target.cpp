// SPDX-License-Identifier: GPL-3.0-or-later
// Results files: a small good one, edited as the input says (results_edit.hpp). What is then still
// taken must be whole and writable, to a file that reads as the same bytes.
#include "check.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "results_edit.hpp"

namespace {

using namespace glissade;
using fuzz::check;

constexpr std::size_t records = 2, samples = 3, levels = 4, thresholds = 1;

RunResults small_run(const std::string& label) {
  RunResults run;
  run.label = label;
  run.peak_displacement_m = Array3<double>(records, samples, levels, 0.1);
  run.uplift = Array3<std::uint8_t>(records, samples, levels);
  run.capacity = Array3<double>(records, samples, thresholds, 1.0);
  run.band_intensities = {0.5, 1.0};
  run.fragilities.resize(thresholds);
  for (ThresholdFragility& f : run.fragilities) {
    f.probability.assign(levels, 0.5);
    f.probability_interval.resize(levels);
    f.band.resize(run.band_intensities.size());
    f.record_recross.assign(records, 0.0);
  }
  run.slip.resize(levels);
  run.standards.resize(1);
  return run;
}

Results small_results() {
  Results results;
  results.study_name = "small";
  results.levels = {0.5, 1.0, 1.5, 2.0};
  results.thresholds_m = {0.15};
  results.samples.resize(samples);
  results.records.resize(records);
  results.spectra.periods_s = {0.0, 1.0};
  results.spectra.srss_g.assign(records, {0.4, 0.2});
  results.spectra.average_srss_g = {0.4, 0.2};
  results.runs = {small_run("sampled"), small_run("design")};
  results.notes = {"a note"};
  return results;
}

const std::string& good_file() {
  static const std::string bytes = [] {
    const auto file = fuzz::folder().path() / "good.h5";
    write_results(file, small_results());
    return read_text_file(file);
  }();
  return bytes;
}

void check_whole(const Results& results) {
  const auto is_cube = [&](const auto& cube, std::size_t depth) {
    return cube.rows == results.records.size() && cube.columns == results.samples.size() &&
           cube.depth == depth && cube.data.size() == cube.rows * cube.columns * cube.depth;
  };
  for (const RunResults& run : results.runs) {
    check(is_cube(run.peak_displacement_m, results.levels.size()) &&
              is_cube(run.uplift, results.levels.size()) &&
              is_cube(run.capacity, results.thresholds_m.size()),
          "cubes fit the records, samples, levels and thresholds");
    check(run.slip.size() == results.levels.size(), "slip at each level");
    check(run.fragilities.size() == results.thresholds_m.size(), "a fragility for each threshold");
    for (const ThresholdFragility& f : run.fragilities) {
      check(f.probability.size() == results.levels.size() &&
                f.probability_interval.size() == results.levels.size(),
            "a share for each level");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  check(silent && !good_file().empty(), "there is a file to edit");
  const auto file = fuzz::folder().write("results.h5", good_file());
  {
    fuzz::ResultsEditor editor(file);
    fuzz::Bytes bytes(data, std::min<std::size_t>(size, 4096));
    while (bytes.left() > 0) editor.edit(bytes);
  }
  fuzz::may_refuse([&] {
    const Results results = read_results(file);
    check_whole(results);
    const auto copy = fuzz::folder().path() / "copy.h5",
               second = fuzz::folder().path() / "second.h5";
    write_results(copy, results);
    write_results(second, read_results(copy));
    check(read_text_file(copy) == read_text_file(second), "results survive their file");
  });
  return 0;
}
