// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clearance/family_figures.hpp"
#include "clearance/family_lines.hpp"
#include "clearance/view.hpp"
#include "figure_text.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {

Figure period_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  const ClearanceQuestion question;
  constexpr std::size_t most_lines = 4;
  Places family = places_of(grid, ClearanceAxis::vertical, ClearanceAxis::mass);
  if (family.size() > most_lines) family = along(grid, ClearanceAxis::mass);
  const std::vector<ClearanceAxis> others = {ClearanceAxis::slope, ClearanceAxis::level,
                                             ClearanceAxis::response_modification,
                                             ClearanceAxis::support, ClearanceAxis::period};
  LinePlot plot = over_periods(results, question, family, others);
  for (PlotLine& line : plot.lines) {
    if (line.title.empty()) line.title = "median of the orientations";
  }
  // Each record its own way, around the first line.
  PlotLine low, high;
  low.title = "dashed: least and most if each record could lie its own way (first line)";
  low.style = high.style = "lines lw 1.8 dt 2 lc rgb '#555555'";
  for (const ClearancePosition& at : along(grid, ClearanceAxis::period)) {
    const PerRecordBounds bounds = per_record_bounds(results, question, at, Periods::one);
    low.y.push_back(bounds.lowest);
    high.y.push_back(bounds.highest);
  }
  if (results.orientations.size() > 1) plot.lines.insert(plot.lines.end(), {low, high});
  const OrientationRange largest = over_orientations(results, question, {}, Periods::largest);
  const double clearance = results.clearance_factor * largest.median;
  plot.levels.push_back({clearance,
                         fmt::format("clearance, {:g} x the largest median: {}",
                                     results.clearance_factor, format_length(clearance)),
                         "#0072b2"});
  Figure figure;
  figure.name = "period";
  figure.title = "Displacement over the building's period, and the clearance";
  figure.caption = fmt::format(
      "After Walters et al. (2012), Fig. 13. {}. All records lie alike, in each of the "
      "orientations "
      "in turn. Star: what the paper states.",
      what_is_averaged(results));
  return with_lines(results, figure, {ClearanceAxis::mass, ClearanceAxis::vertical}, plot);
}

namespace {

/// The distinct orientations, a line each over the period.
Figure each_orientation_figure(const ClearanceResults& results) {
  LinePlot plot;
  plot.x_label = "Period of the building (s)";
  plot.y_label = displacement_label();
  plot.x = results.grid.period_s;
  std::vector<std::size_t> distinct;
  for (std::size_t o = 0; o < results.orientations.size(); ++o) {
    if (results.same_as[o] == o) distinct.push_back(o);
  }
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const auto alike = std::ranges::count(results.same_as, distinct[i]);
    PlotLine line;
    line.style = style_of(i, distinct.size());
    line.title = to_string(results.orientations[distinct[i]]) +
                 (alike > 1 ? fmt::format(" (and {} more that give the same)", alike - 1) : "");
    for (const ClearancePosition& at : along(results.grid, ClearanceAxis::period))
      line.y.push_back(suite_mean(results, {}, distinct[i], at));
    plot.lines.push_back(line);
  }
  Figure figure;
  figure.name = "orientations";
  figure.title = "How the records lie to the roof: each choice by itself";
  figure.caption = what_is_averaged(results) +
                   ". +: a component as recorded; -: turned round. Turning round what acts across "
                   "the slope mirrors the history and changes no "
                   "peak; where friction is the same in both directions of the array it does not "
                   "matter along which of them the roof falls.";
  return with_lines(results, figure, {}, plot);
}

/// Clearance for each slope along either axis, by m/M.
Figure permutations_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot;
  plot.x_label = "Roof slope and the axis it falls along";
  plot.y_label = fmt::format("Clearance, {:g} x the largest mean", results.clearance_factor);
  const std::array<SlopeAxis, 2> axes = {SlopeAxis::e_w, SlopeAxis::n_s};
  std::vector<std::pair<std::size_t, SlopeAxis>> permutations;
  for (std::size_t slope = 0; slope < grid.slope_deg.size(); ++slope) {
    for (const SlopeAxis axis : axes) {
      if (!orientations_of(results, {.slope_axis = axis}).empty())
        permutations.emplace_back(slope, axis);
    }
  }
  for (std::size_t i = 0; i < permutations.size(); ++i) {
    const auto& [slope, axis] = permutations[i];
    const std::string text = slope_text(grid.slope_deg[slope]);
    plot.x.push_back(static_cast<double>(i));
    plot.ticks.push_back(
        {static_cast<double>(i), text.substr(0, text.find(" (")) + " " + to_string(axis)});
  }
  const std::size_t masses = grid.mass_ratio.size();
  for (std::size_t m = 0; m < masses; ++m) {
    PlotLine line;
    line.title = label_of(grid, ClearanceAxis::mass, m);
    line.colour = gnuplot::ramp_colour(m, masses);
    line.style = fmt::format("points pt {} ps 1.6 lc rgb '{}'", point_symbol(m), line.colour);
    line.spread = PlotLine::Spread::bars;
    line.shift = 0.16 * (static_cast<double>(m) - 0.5 * static_cast<double>(masses - 1));
    for (const auto& [slope, axis] : permutations) {
      ClearancePosition at;
      at[ClearanceAxis::slope] = slope;
      at[ClearanceAxis::mass] = m;
      const OrientationRange range =
          over_orientations(results, {.slope_axis = axis}, at, Periods::largest);
      line.y.push_back(results.clearance_factor * range.median);
      line.low.push_back(results.clearance_factor * range.lowest);
      line.high.push_back(results.clearance_factor * range.highest);
    }
    plot.lines.push_back(line);
  }
  plot.band_title = "points: median over the orientations; bars: lowest to highest";
  Figure figure;
  figure.name = "permutations";
  figure.title = "Clearance by slope and the axis it falls along";
  figure.caption =
      what_is_averaged(results) + fmt::format(
                                      ", the largest over the building periods, times {:g}. The "
                                      "slope permutations of Walters et "
                                      "al. (2012), with friction {}.",
                                      results.clearance_factor, friction_text(results));
  return with_lines(results, figure, {ClearanceAxis::slope, ClearanceAxis::mass}, plot);
}

}  // namespace

std::optional<Figure> orientation_figure(const ClearanceResults& results) {
  if (results.friction[0] != results.friction[1]) return permutations_figure(results);
  constexpr std::size_t most_lines = 8;
  std::size_t distinct = 0;
  for (std::size_t o = 0; o < results.orientations.size(); ++o) distinct += results.same_as[o] == o;
  if (distinct > most_lines || !has_several(results.grid, ClearanceAxis::period))
    return std::nullopt;
  return each_orientation_figure(results);
}

Figure mce_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot = over_periods(
      results, {}, along(grid, ClearanceAxis::level),
      {ClearanceAxis::period, ClearanceAxis::slope, ClearanceAxis::mass, ClearanceAxis::support,
       ClearanceAxis::response_modification, ClearanceAxis::vertical});
  const OrientationRange weak = over_orientations(results, {}, {}, Periods::largest);
  plot.levels.push_back(
      {weak.median,
       "largest at " + label_of(grid, ClearanceAxis::level, 0) + ": " + format_length(weak.median),
       plot.lines.front().colour});
  Figure figure;
  figure.name = "mce";
  figure.title = "Displacement under weaker and stronger shaking";
  figure.caption =
      fmt::format("After Walters et al. (2012), Fig. 18. {}.", what_is_averaged(results));
  return with_lines(results, figure, {ClearanceAxis::level}, plot);
}

Figure base_shear_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  const ClearanceQuestion question{.number = HistoryNumber::base_shear};
  LinePlot plot = over_periods(
      results, question, along(grid, ClearanceAxis::support),
      {ClearanceAxis::period, ClearanceAxis::slope, ClearanceAxis::mass, ClearanceAxis::level,
       ClearanceAxis::vertical, ClearanceAxis::response_modification});
  plot.length = PlotLength::no;
  plot.y_label = "Base shear over the bare building's weight";
  Figure figure;
  figure.name = "base_shear";
  figure.title = "Base shear of the building: array isolated, anchored, none";
  figure.caption =
      "After Walters et al. (2012), Fig. 16. Mean over the suite of each history's SRSS of the "
      "peak "
      "base shears along both axes, over the weight of the building without the array.";
  return with_lines(results, figure, {}, plot);
}

Figure base_shear_ratio_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  const std::size_t bare = *place_of(grid, ArraySupport::no_array);
  LinePlot plot;
  plot.x_label = "Period of the building (s)";
  plot.y_label = "Base shear over that without an array";
  plot.length = PlotLength::no;
  plot.x = grid.period_s;
  for (const ArraySupport support : {ArraySupport::isolated, ArraySupport::anchored}) {
    const auto place = place_of(grid, support);
    if (!place) continue;
    PlotLine line;
    const std::size_t index = plot.lines.size();
    line.colour = gnuplot::ramp_colour(index, 3);
    line.style = style_of(index, 3);
    line.title = label_of(grid, ClearanceAxis::support, *place);
    for (const ClearancePosition& at : along(grid, ClearanceAxis::period)) {
      const std::vector<double> ratios = ratios_by_orientation(
          results, {.number = HistoryNumber::base_shear}, at.with(ClearanceAxis::support, *place),
          at.with(ClearanceAxis::support, bare));
      line.y.push_back(quantile_of(ratios, 0.5));
      line.low.push_back(ratios.front());
      line.high.push_back(ratios.back());
    }
    plot.lines.push_back(line);
  }
  tell_bands(results, plot);
  plot.levels.push_back({1.0, "no array", "#555555"});
  plot.from_zero = false;
  Figure figure;
  figure.name = "base_shear_ratio";
  figure.title = "What the array does to the base shear of its building";
  figure.caption =
      "The same relative to the building without an array: below 1 the array relieves its "
      "building. "
      "An anchored array adds its mass.";
  return with_lines(results, figure, {}, plot);
}

}  // namespace glissade
