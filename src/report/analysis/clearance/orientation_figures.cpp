// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/clearance/orientation_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conditions/family.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/report/clearance_report.hpp"

namespace glissade {
namespace {

/// "falls E-W: down the slope +first, across -second".
std::string line_label(const Results& results, const Orientation& orientation) {
  if (!orientation.is_quarter_turn()) return orientation_text(results, orientation);
  return fmt::format("falls {}: down the slope {}", to_string(orientation.slope_axis),
                     components_text(orientation, slides_on_two_axes(results)));
}

/// The distinct orientations, a line each over the period.
Figure each_orientation_figure(const Results& results, const std::vector<std::size_t>& distinct) {
  constexpr std::size_t most_in_panel = 4;
  const Table of_each = clearance_by_orientation_tables(results).front();
  const Where where =
      rows_at(results, of_each, shown_condition(ConditionGrid(results)), ConditionAxis::period);
  std::vector<Panel> panels;
  double top = 0.0;
  for (std::size_t first = 0; first < distinct.size(); first += most_in_panel) {
    View view{of_each, "period", {}, where};
    const std::size_t count = std::min(most_in_panel, distinct.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t orientation = distinct[first + i];
      view.lines.push_back({line_label(results, orientation_at(results, orientation)),
                            family_look(i, count),
                            as_line_and_points,
                            "mean",
                            {{"orientation", static_cast<double>(orientation + 1)}}});
    }
    panels.push_back(means_panel(results, {view}, period_label));
    top = std::max(top, panels.back().y.high);
  }
  for (Panel& panel : panels) panel.y = length_axis("Mean displacement", top);
  return {"orientations", "Orientation of the records to the roof: each choice by itself",
          below_text(results),
          what_is_averaged(results) +
              ". +: a component as recorded; -: with its sign changed. Of orientations that give "
              "the same, one is drawn." +
              (slides_on_two_axes(results)
                   ? " A change of sign across the slope mirrors the history and changes no peak; "
                     "where friction is the same in both directions of the array it does not "
                     "matter along which of them the roof falls."
                   : ""),
          panels};
}

/// Clearance for each slope along either axis, by m/M.
Figure permutations_figure(const Results& results) {
  const ConditionGrid grid(results);
  const double factor = results.clearance->factor;
  std::vector<std::pair<Condition, SlopeAxis>> permutations;
  std::vector<std::string> ticks;
  for (const Condition& at : shown_along(grid, ConditionAxis::slope)) {
    for (const SlopeAxis axis : {SlopeAxis::e_w, SlopeAxis::n_s}) {
      if (orientations_of(results, {.slope_axis = axis}).empty()) continue;
      permutations.emplace_back(at, axis);
      ticks.push_back(slope_name(grid.value(ConditionAxis::slope, at)) + " " + to_string(axis));
    }
  }
  Panel panel{"", {"Roof slope and the axis it falls along"}};
  panel.x.low = -0.5;
  panel.x.high = static_cast<double>(permutations.size()) - 0.5;
  panel.x.values = Axis::Values::names;
  for (std::size_t i = 0; i < ticks.size(); ++i)
    panel.x.ticks.push_back({static_cast<double>(i), ticks[i]});
  const std::size_t masses = grid.size(ConditionAxis::mass);
  double top_m = 0.0;
  for (std::size_t m = 0; m < masses; ++m) {
    const std::string label = label_of(grid, ConditionAxis::mass, m);
    Look look = family_look(m, masses);
    look.symbol_size = 1.6;
    DataSeries points{DataSeries::Kind::points, look, label, label};
    DataSeries bars{DataSeries::Kind::bars, look, label + ": lowest and highest"};
    // Side by side, so that bars do not hide one another.
    points.aside = bars.aside =
        0.16 * (static_cast<double>(m) - 0.5 * static_cast<double>(masses - 1));
    for (std::size_t i = 0; i < permutations.size(); ++i) {
      const auto& [at, axis] = permutations[i];
      const OrientationRange range = over_orientations(
          results, {.slope_axis = axis}, at.with(ConditionAxis::mass, m), Periods::largest);
      points.add(static_cast<double>(i), factor * range.median);
      bars.add(points.x.back(), {factor * range.lowest, factor * range.highest});
      top_m = std::max(top_m, factor * range.highest);
    }
    panel.series.push_back(std::move(bars));
    panel.series.push_back(std::move(points));
  }
  panel.series.push_back({DataSeries::Kind::bars, look(Role::largest), "",
                          "points: median over the orientations; bars: lowest to highest"});
  panel.y = length_axis(fmt::format("Clearance, {:g} x the largest mean", factor),
                        top_m > 0.0 ? 1.12 * top_m : 1.0);
  return {"permutations",
          "Clearance by slope and the axis it falls along",
          below_text(results, {ConditionAxis::slope, ConditionAxis::mass}),
          what_is_averaged(results) +
              fmt::format("{}, times {:g}. The slope permutations of Walters et al. (2012), with "
                          "friction {}.",
                          over_building_periods(results), factor, friction_text(results)),
          {panel}};
}

}  // namespace

std::optional<Figure> orientation_figure(const Results& results) {
  if (has_two_frictions(results)) return permutations_figure(results);
  constexpr std::size_t most_lines = 8;
  std::vector<std::size_t> distinct;
  const std::vector<CaseNumber> same = same_orientations(results);
  for (std::size_t o = 0; o < same.size(); ++o)
    if (same[o] == o) distinct.push_back(o);
  if (distinct.size() > most_lines || !ConditionGrid(results).has_several(ConditionAxis::period))
    return std::nullopt;
  return each_orientation_figure(results, distinct);
}

}  // namespace glissade
