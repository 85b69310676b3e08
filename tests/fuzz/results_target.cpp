// SPDX-License-Identifier: GPL-3.0-or-later
// Results files: a small good one, edited as the input says (results_edit.hpp). What is then still
// taken must be whole and writable, to a file that reads as the same bytes.
#include "check.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/study/clearance_study.hpp"
#include "results_edit.hpp"

namespace {

using namespace glissade;
using fuzz::check;

constexpr std::size_t records = 2, samples = 3, cases = 6, levels = 4, thresholds = 1;

RunResults small_run(const std::string& label, std::uint64_t first_case) {
  RunResults run;
  run.label = label;
  run.first_case = first_case;
  run.cases = samples;
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
  run.impact.resize(levels * thresholds);
  return run;
}

void fill_histories(HistoryTable& table) {
  table = {records, cases, levels, thresholds, {}};
  for_each_history_field([&](auto field) {
    (table.fields.*field.of).assign(records * cases * table.depth(field.depth), 1);
  });
}

Chart small_chart() {
  Chart chart;
  chart.slope_deg = {0.0, 2.0};
  chart.mu = {0.5};
  chart.period_s = {0.0};
  chart.points.resize(levels * chart.slope_deg.size());
  for (ChartPoint& point : chart.points) point.by_period.resize(1);
  chart.readings.resize(1);
  chart.standards.resize(1);
  return chart;
}

Results small_results() {
  Results results;
  results.study_name = "small";
  results.levels = {0.5, 1.0, 1.5, 2.0};
  results.thresholds_m = {0.15};
  results.axes = SlidingAxes::two;
  results.cases.axes = {{"friction.value", "-", {0.0, 1.0}, {"sampled", "design"}}};
  results.cases.samples = samples;
  results.cases.cases.resize(cases);
  results.records.resize(records);
  results.suites = {
      {"suite", "", {{0.0, 1.0}, {{0.4, 0.2}, {0.4, 0.2}}, {0.4, 0.2}, {0.4, 0.2}, 1.0}}};
  fill_histories(results.histories);
  results.runs = {small_run("sampled", 0), small_run("design", samples)};
  results.chart = small_chart();
  results.clearance = ClearanceConfig{};
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
  const HistoryTable& table = results.histories;
  check(table.records == results.records.size() && table.cases == results.cases.size() &&
            table.levels == results.levels.size() &&
            table.thresholds == results.thresholds_m.size(),
        "histories fit the records, cases, levels and thresholds");
  for_each_history_field([&](auto field) {
    const auto& values = table.fields.*field.of;
    check(values.empty() || values.size() == table.records * table.cases * table.depth(field.depth),
          "a field is whole or absent");
  });
  check(results.cases.combinations() * results.cases.per_combination() == results.cases.size(),
        "cases are every combination");
  if (results.clearance) {
    const ClearanceResults clearance = clearance_results(results);
    check(clearance.histories.size() ==
              clearance.records.size() * clearance.orientations.size() * clearance.grid.count(),
          "a clearance has all its histories");
  }
  for (const RunResults& run : results.runs) {
    check(run.first_case + run.cases <= results.cases.size(), "a run is of the cases");
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
