// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "convergence/text.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/convergence_report.hpp"

namespace glissade {
namespace {

struct MeasureName {
  ErrorMeasure measure;
  const char* stem;
  const char* heading;
};
constexpr MeasureName measures[] = {{ErrorMeasure::finest, "of_finest", "of finest"},
                                    {ErrorMeasure::exact_residual, "of_exact_residual", "of exact"},
                                    {ErrorMeasure::exact_peak, "of_exact_peak", "of peak"}};

double as_percent(double share) { return 100.0 * share; }

double count(std::size_t n) { return static_cast<double>(n); }

/// "-" where there is no error.
std::string worst_of(const ConvergenceResults& results, const ErrorSummary& summary) {
  return summary.largest > 0.0 ? scene_text(results, summary.worst) : "-";
}

/// Whether, and how, the exact solution slides.
std::string motion_of(const ConvergenceScene& scene, const ExactSlip& slip) {
  if (slip.peak_m == 0.0) return "rests";
  return std::tan(std::abs(scene.slope_deg) * rad_per_deg) >= scene.mu ? "slides freely" : "slips";
}

}  // namespace

Table convergence_table(const ConvergenceResults& results, const MaybeTimes& times) {
  Table table{
      "convergence",
      fmt::format("Error of the published scheme's residual displacement at P substeps of a sample "
                  "interval: "
                  "relative to the residual at P = {} (finest), to the exact residual and to the "
                  "exact peak; "
                  "clear residuals are those of {} or more of the peak. Wall time of a history",
                  results.substeps.back(), stated_percent(clear_residual)),
      {{"substeps", "", "P", ColumnKind::count}},
      {}};
  for (const MeasureName& m : measures) {
    table.columns.push_back({std::string("largest_error_") + m.stem, "percent",
                             std::string("Largest ") + m.heading + ", %"});
    table.columns.push_back({std::string("median_error_") + m.stem, "percent",
                             std::string("Median ") + m.heading + ", %"});
  }
  table.columns.push_back(
      {"largest_error_of_finest_clear", "percent", "Largest of finest, clear residuals, %"});
  table.columns.push_back({"counted", "", "Histories counted", ColumnKind::count});
  for (const MeasureName& m : measures) {
    table.columns.push_back(
        {std::string("worst_") + m.stem, "", std::string("Worst ") + m.heading, ColumnKind::text});
  }
  table.columns.push_back({"longest_time", "s", "Longest time, s"});
  table.columns.push_back({"median_time", "s", "Median time, s"});
  for (std::size_t step = 0; step < results.substeps.size(); ++step) {
    std::vector<Cell> row{static_cast<double>(results.substeps[step])};
    std::vector<Cell> worst;
    for (const MeasureName& m : measures) {
      const ErrorSummary summary = error_summary(results, step, m.measure);
      row.insert(row.end(), {as_percent(summary.largest), as_percent(summary.median)});
      worst.emplace_back(worst_of(results, summary));
    }
    row.emplace_back(as_percent(clear_error(results, step).largest));
    row.emplace_back(count(error_summary(results, step, ErrorMeasure::finest).counted));
    row.insert(row.end(), worst.begin(), worst.end());
    const TimeSummary time =
        times ? times->published[step] : TimeSummary{std::nan(""), std::nan("")};
    row.insert(row.end(), {time.longest_s, time.median_s});
    table.add(std::move(row));
  }
  return table;
}

Table convergence_records_table(const ConvergenceResults& results) {
  const std::size_t step = chosen_step(results.substeps);
  Table table{
      "records",
      fmt::format("How the record decides: largest errors at P = {}, and of the finest P = {}",
                  results.substeps[step], results.substeps.back()),
      {{"id", "", "Record", ColumnKind::text},
       {"event", "", "Event", ColumnKind::text},
       {"station", "", "Station", ColumnKind::text},
       {"dt", "s", "Step, s"},
       {"samples", "", "Samples", ColumnKind::count},
       {"pga", "g", "PGA as recorded, g"},
       {"slips", "", "Scenes counted", ColumnKind::count}},
      {}};
  for (const MeasureName& m : measures) {
    table.columns.push_back({std::string("largest_error_") + m.stem, "percent",
                             std::string("Largest ") + m.heading + ", %"});
  }
  table.columns.push_back(
      {"finest_largest_error_of_exact_residual", "percent", "Finest P: largest of exact, %"});
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    const ConvergenceRecord& r = results.records[i];
    const Selection alone{i, i + 1};
    const auto largest = [&](std::size_t at, ErrorMeasure measure) {
      return as_percent(error_summary(results, at, measure, alone).largest);
    };
    std::vector<Cell> row{r.id,
                          r.event,
                          r.station,
                          r.dt_s,
                          static_cast<double>(r.samples),
                          r.pga_g,
                          count(error_summary(results, step, ErrorMeasure::finest, alone).counted)};
    for (const MeasureName& m : measures) row.emplace_back(largest(step, m.measure));
    row.emplace_back(largest(results.substeps.size() - 1, ErrorMeasure::exact_residual));
    table.add(std::move(row));
  }
  return table;
}

Table convergence_scenes_table(const ConvergenceResults& results) {
  Table table{"scenes",
              "Residual displacement in plan of every scene: exact, and by the published scheme at "
              "each P",
              {{"record", "", "Record", ColumnKind::text},
               {"slope", "deg", "Slope, deg"},
               {"mu", "", "mu"},
               {"ppa", "g", "Peak acceleration, g"},
               {"motion", "", "Exact solution", ColumnKind::text},
               {"uplift", "", "Uplift", ColumnKind::count},
               {"exact_peak", "m", "Exact peak, m"},
               {"exact_residual", "m", "Exact residual, m"}},
              {}};
  for (const int p : results.substeps) {
    table.columns.push_back(
        {fmt::format("residual_p{}", p), "m", fmt::format("Residual at P = {}, m", p)});
  }
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    for (std::size_t j = 0; j < results.scenes.size(); ++j) {
      const ConvergenceScene& scene = results.scenes[j];
      const ExactSlip& slip = results.exact_at(i, j);
      std::vector<Cell> row{results.records[i].id, scene.slope_deg,        scene.mu,
                            scene.ppa_g,           motion_of(scene, slip), 1.0 * slip.uplift,
                            slip.peak_m,           slip.residual_m};
      for (std::size_t k = 0; k < results.substeps.size(); ++k)
        row.emplace_back(results.residual_m(i, j, k));
      table.add(std::move(row));
    }
  }
  return table;
}

}  // namespace glissade
