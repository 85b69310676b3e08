// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/hazard/hazard.hpp"
#include "glissade/report/format.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_lines = 4;

/// To the right of the curves stand the target rates.
constexpr double room_for_rates = 1.3;

/// Where the figure ends: beyond the displacements of all target rates, and what is asked for.
double right_end_m(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  double right = results.thresholds_m.back();
  for (const HazardRun& run : hazard.runs) {
    for (const TargetDisplacement& row : run.targets)
      if (std::isfinite(row.displacement_m.value))
        right = std::max(right, row.displacement_m.value);
  }
  return 1.15 * right;
}

/// The last displacement that is drawn.
double last_m(const Panel& panel) {
  double last = 0.0;
  for (const DataSeries& series : panel.series) last = std::max(last, largest(series.x));
  return last;
}

/// Decades that hold the curves and the rarest target rate.
Axis rate_axis(const Panel& panel, const HazardResults& hazard) {
  const std::vector<TargetDisplacement>& targets = hazard.runs.front().targets;
  std::vector<double> rates{targets.empty() ? hazard.beyond_rate : targets.back().annual_rate};
  for (const DataSeries& series : panel.series)
    for (const std::vector<double>* values : {&series.y, &series.low, &series.high})
      rates.insert(rates.end(), values->begin(), values->end());
  std::erase_if(rates, [](double rate) { return !(rate > 0.0 && std::isfinite(rate)); });
  if (rates.empty()) rates = {1.0};
  const auto [low, high] = std::ranges::minmax(rates);
  const double decade = std::floor(std::log10(low));
  return log_axis("Annual rate of exceedance", std::pow(10.0, decade),
                  std::pow(10.0, std::max(std::ceil(std::log10(high)), decade + 1.0)),
                  [](double rate) { return fmt::format("1e{:g}", std::round(std::log10(rate))); });
}

}  // namespace

Figure hazard_figure(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  View view{hazard_curve_table(results), "displacement", {}, {{"below_share", 0.0}}};
  keep_rows(view.table, "displacement",
            [end_m = right_end_m(results)](double at_m) { return at_m <= end_m; });
  for (std::size_t i = 0; i < std::min(hazard.runs.size(), most_lines); ++i)
    view.lines.push_back({run_name(results, results.runs[i]),
                          distinct_look(i),
                          as_line,
                          "annual_rate",
                          {{"run", hazard.runs[i].label}}});
  ViewLine& first = view.lines.front();
  first.label = first.name + " (shaded: 95 % interval)";
  first.low = "annual_rate_low95";
  first.high = "annual_rate_high95";
  Panel panel{"", length_axis("Displacement in plan", room_for_rates * right_end_m(results))};
  add_lines(panel, view);
  panel.y = rate_axis(panel, hazard);
  Figure figure{
      "hazard", "Annual rate of exceeding a displacement",
      run_below(results, results.runs.front()) + "; hazard curve " + curve_name(hazard),
      fmt::format("Shaded: 95 % interval over {}, of the first curve. Drawn to {} (farther: "
                  "tables/hazard_curve.csv). Where a curve becomes level it is that of "
                  "shaking above the highest level of the study, {}, all of which counts as "
                  "exceeding (rate {:.3g} a year). Not drawn where histories slide farther at the "
                  "lowest level already. All combinations: tables/hazard_curve.csv.",
                  units_name(results), format_length(last_m(panel)),
                  at_intensity(results, results.levels.back()), hazard.beyond_rate)};
  for (const TargetDisplacement& row : hazard.runs.front().targets) {
    if (row.annual_rate < panel.y.low || row.annual_rate > panel.y.high) continue;
    panel.rules.push_back({Rule::Kind::horizontal, row.annual_rate, look(Role::reference), ""});
    panel.notes.push_back({panel.x.high, row.annual_rate, rate_text(row.annual_rate),
                           look(Role::reference).colour, Note::Align::right});
  }
  figure.panels = {std::move(panel)};
  return figure;
}

Figure life_figure(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  const std::size_t shown = governing_run(results);
  constexpr double least_share = 1e-3;
  // Each is seen where they coincide: a wide line, dashes on it, thin dots on these.
  const std::array lines = {std::pair{LifeQuantity::single, Look{{0x9ecae1}, 9.0}},
                            std::pair{LifeQuantity::accumulated, Look{{0xd55e00}, 4.0, 2}},
                            std::pair{LifeQuantity::farthest, Look{{0x000000}, 2.5, 3}}};
  double right_m = 0.01;
  for (const LifeQuantile& row : hazard.runs[shown].life_distribution)
    if (std::isfinite(row.displacement_m)) right_m = std::max(right_m, row.displacement_m);
  Panel panel{"", length_axis("Displacement in plan", 1.05 * right_m)};
  panel.y = log_axis("Share of the design lives that exceed it", least_share, 1.0,
                     [](double share) { return fmt::format("{:g} %", 100.0 * share); });
  for (const auto& [quantity, look] : lines) {
    const std::string name = quantity_name(quantity);
    DataSeries line{DataSeries::Kind::line, look, name, name};
    for (const LifeQuantile& row : hazard.runs[shown].life_distribution) {
      if (row.quantity != quantity || !std::isfinite(row.displacement_m)) continue;
      line.add(row.displacement_m, 1.0 - row.probability);
    }
    panel.series.push_back(std::move(line));
  }
  Figure figure{
      "design_life",
      "Share of design lives of " + life_text(hazard) + " that exceed a displacement",
      run_below(results, results.runs[shown]) + "; hazard curve " + curve_name(hazard),
      "Residual displacements add up as vectors, since the array is not returned to its initial "
      "position. " +
          std::string(kept_over_life) +
          " Lines end where shaking above the highest level decides, or at one life in a thousand. "
          "Numbers: tables/design_life_distribution.csv."};
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace glissade
