// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/impact/impact.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/figures.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Percentiles of fewer records' histories would be of those records alone.
constexpr std::size_t fewest_records = 3;
constexpr std::size_t most_levels = 3;

/// Speeds over the thresholds that enough records reach at a level: the median, and 16th to 84th
/// percentile.
DataSeries speeds_at(const Results& results, const RunResults& run, std::size_t level) {
  const std::size_t records = results.records.size(), samples = run.cases,
                    thresholds = results.thresholds_m.size();
  const HistoryTable& table = results.histories;
  DataSeries points{DataSeries::Kind::line_and_points};
  for (std::size_t t = 0; t < thresholds; ++t) {
    std::vector<double> speeds;
    std::size_t reaching = 0;
    for (std::size_t i = 0; i < records; ++i) {
      const std::size_t before = speeds.size();
      for (std::size_t j = 0; j < samples; ++j) {
        const double speed =
            table.fields
                .crossing_speed_mps[table.at(i, run.first_case + j, level) * thresholds + t];
        if (!std::isnan(speed)) speeds.push_back(speed);
      }
      reaching += speeds.size() > before ? 1 : 0;
    }
    if (reaching < fewest_records) continue;
    points.x.push_back(results.thresholds_m[t]);
    points.low.push_back(quantile_of(speeds, 0.16));
    points.y.push_back(quantile_of(speeds, 0.5));
    points.high.push_back(quantile_of(speeds, 0.84));
  }
  return points;
}

}  // namespace

Figure impact_figure(const Results& results, const RunResults& run) {
  Figure figure{
      "impact", "Speed of the array when it first reaches a clearance",
      "given that it is reached; " + counts_of(results) + "; " + friction_of(results, run),
      "Half its square is the energy in J that a parapet there must absorb for each kilogram that "
      "moves together. " +
          impact_explained() +
          " Points: median over all histories (records and samples together) that reach it, at "
          "three levels of intensity at most; bars: 16th to 84th percentile. Clearances that fewer "
          "than three records reach are left out at that level. Friction " +
          run.friction_description + "."};
  std::vector<double> levels;  // where there is anything to show
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    if (!speeds_at(results, run, l).x.empty()) levels.push_back(results.levels[l]);
  }
  levels = some_levels(levels, most_levels);
  if (levels.empty()) return figure;
  const double right_m = 1.08 * (results.thresholds_m.empty() ? 1.0 : results.thresholds_m.back());
  Panel panel{"", length_axis("Clearance: distance in plan from the initial position", right_m)};
  double top_mps = 0.0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto level = std::ranges::find(results.levels, levels[k]) - results.levels.begin();
    DataSeries median = speeds_at(results, run, static_cast<std::size_t>(level));
    median.look = family_look(k, levels.size());
    median.name = median.label = "median at " + at_intensity(results, levels[k]);
    // Bars of different levels do not hide each other.
    median.aside = 0.006 * right_m * (static_cast<double>(k) - 1.0);
    top_mps = std::max(top_mps, *std::ranges::max_element(median.high));
    DataSeries bars = median;
    bars.kind = DataSeries::Kind::bars;
    bars.name = at_intensity(results, levels[k]) + ": 16th to 84th percentile";
    bars.label.clear();
    median.low.clear();
    median.high.clear();
    panel.series.insert(panel.series.begin(), std::move(bars));
    panel.series.push_back(std::move(median));
  }
  panel.series.push_back({DataSeries::Kind::bars, look(Role::largest), "",
                          "bars: 16th to 84th percentile of the histories that reach it"});
  const double shown_mps = top_mps > 0.0 ? 1.08 * top_mps : 1.0;
  panel.y = {"Speed in plan, relative to the roof (m/s)", 0.0, shown_mps};
  figure.panels = {std::move(panel)};
  return figure;
}

}  // namespace glissade
