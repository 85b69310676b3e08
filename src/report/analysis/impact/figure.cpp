// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/impact/impact.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/tables.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_levels = 3;

/// Enough records reach it for intervals; percentiles of fewer would be of those records alone.
bool reached_by_enough(double low_mps) { return !std::isnan(low_mps); }

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
          friction_and_listed(results, run) + "."};
  std::vector<double> levels;  // where there is anything to show
  for (const double level : results.levels)
    if (std::ranges::any_of(run.impact, [&](const ImpactStatistics& s) {
          return s.level == level && reached_by_enough(s.speed_median_mps.interval.low);
        }))
      levels.push_back(level);
  levels = some_levels(levels, most_levels);
  if (levels.empty()) return figure;
  View view{impact_table(results), "threshold", {}, {{"run", run.label}}};
  keep_rows(view.table, "median_speed_low95", reached_by_enough);
  for (const double level : levels)
    view.lines.push_back({"median at " + at_intensity(results, level),
                          family_look(view.lines.size(), levels.size()),
                          as_line_and_points,
                          "median_speed",
                          {{"level", level}},
                          "p16_speed",
                          "p84_speed"});
  const double right_m = 1.08 * (results.thresholds_m.empty() ? 1.0 : results.thresholds_m.back());
  view.spread = DataSeries::Kind::bars;
  view.spread_name = "16th to 84th percentile";
  view.apart = 0.006 * right_m;
  Panel panel{"", length_axis("Clearance: distance in plan from the initial position", right_m)};
  add_lines(panel, view);
  const double top_mps = largest_y(panel);
  panel.series.push_back({DataSeries::Kind::bars, look(Role::largest), "",
                          "bars: 16th to 84th percentile of the histories that reach it"});
  const double shown_mps = top_mps > 0.0 ? 1.08 * top_mps : 1.0;
  panel.y = {"Speed in plan, relative to the roof (m/s)", 0.0, shown_mps};
  figure.panels = {std::move(panel)};
  return figure;
}

}  // namespace glissade
