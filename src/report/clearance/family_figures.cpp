// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance/family_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clearance/plot.hpp"
#include "clearance/view.hpp"
#include "figure_text.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

using Places = std::vector<ClearancePosition>;

std::string style_of(std::size_t index, std::size_t count) {
  return fmt::format("linespoints lw 2.5 pt {} ps 0.9 lc rgb '{}'", point_symbol(index),
                     gnuplot::ramp_colour(index, count));
}

/// The line of medians over the orientations at some places, in one colour of a family.
PlotLine line_through(const ClearanceResults& results, const ClearanceQuestion& question,
                      const Places& places, std::size_t index, std::size_t count,
                      Periods periods = Periods::one) {
  PlotLine line;
  line.colour = gnuplot::ramp_colour(index, count);
  line.style = style_of(index, count);
  for (const ClearancePosition& at : places) {
    const OrientationRange range = over_orientations(results, question, at, periods);
    line.y.push_back(range.median);
    line.low.push_back(range.lowest);
    line.high.push_back(range.highest);
  }
  return line;
}

/// More than a few bands over one another cannot be told apart: then the first alone has one.
void thin_out_bands(LinePlot& plot) {
  if (plot.lines.size() <= 3) return;
  for (std::size_t i = 1; i < plot.lines.size(); ++i) {
    plot.lines[i].low.clear();
    plot.lines[i].high.clear();
  }
}

void tell_bands(const ClearanceResults& results, LinePlot& plot) {
  if (results.orientations.size() == 1) {
    for (PlotLine& line : plot.lines) {
      line.low.clear();
      line.high.clear();
    }
    return;
  }
  const bool bars = plot.lines.front().spread == PlotLine::Spread::bars;
  if (!bars) thin_out_bands(plot);
  const bool all = plot.lines.size() == 1 || !plot.lines[1].low.empty();
  plot.band_title = fmt::format("{}{}: lowest to highest of the {}; lines: their median",
                                bars ? "bars" : "shaded", all ? "" : " (first line only)",
                                orientations_text(results));
}

std::string what_is_averaged(const ClearanceResults& results) {
  return results.displacement == DisplacementMeasure::srss_of_maxima
             ? "Mean over the suite of each history's SRSS of the separate maxima along the roof's "
               "two axes, in plan, relative to the roof"
             : "Mean over the suite of each history's farthest displacement, in plan, relative to "
               "the roof";
}

std::string displacement_label() { return "Displacement, mean of the suite"; }

/// Lines over the building's period, one for each of `family`.
LinePlot over_periods(const ClearanceResults& results, const ClearanceQuestion& question,
                      const Places& family, const std::vector<ClearanceAxis>& told_elsewhere) {
  LinePlot plot;
  plot.x_label = "Period of the building (s)";
  plot.y_label = displacement_label();
  plot.x = results.grid.period_s;
  for (std::size_t i = 0; i < family.size(); ++i) {
    plot.lines.push_back(line_through(results, question,
                                      along(results.grid, ClearanceAxis::period, family[i]), i,
                                      family.size()));
    plot.lines.back().title = distinguished(results.grid, family[i], told_elsewhere);
  }
  tell_bands(results, plot);
  return plot;
}

/// What the paper states of displacements, where a figure over periods can show it.
void mark_statements(const ClearanceResults& results, ClearanceTopic topic, LinePlot& plot) {
  for (const PaperStatement& s : results.statements) {
    if (s.about != topic || std::isnan(s.displacement_m) || std::isnan(s.period_s)) continue;
    plot.marks.push_back(
        {s.period_s, s.displacement_m,
         fmt::format("the paper, {}: {}", s.where, format_length(s.displacement_m))});
  }
}

/// All places of two axes, the others at their first.
Places places_of(const ClearanceGrid& grid, ClearanceAxis slow, ClearanceAxis fast) {
  Places places;
  for (const ClearancePosition& at : along(grid, slow)) {
    for (const ClearancePosition& place : along(grid, fast, at)) places.push_back(place);
  }
  return places;
}

}  // namespace

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
    const OwnWayBounds bounds = own_way_bounds(results, question, at, Periods::one);
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
  mark_statements(results, ClearanceTopic::period, plot);
  Figure figure;
  figure.name = "period";
  figure.title = "Displacement over the building's period, and the clearance";
  figure.caption = fmt::format(
      "After Walters et al. (2012), Fig. 13. {}. All records lie alike, in each of the "
      "orientations "
      "in turn. Star: what the paper states.",
      what_is_averaged(results));
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {},
                                 {ClearanceAxis::period, ClearanceAxis::mass,
                                  ClearanceAxis::vertical, ClearanceAxis::support}),
             plot);
  return figure;
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
  mark_statements(results, ClearanceTopic::period, plot);
  Figure figure;
  figure.name = "orientations";
  figure.title = "How the records lie to the roof: each choice by itself";
  figure.caption = what_is_averaged(results) +
                   ". +: a component as recorded; -: turned round. Turning round what acts across "
                   "the slope mirrors the history and changes no "
                   "peak; where friction is the same in both directions of the array it does not "
                   "matter along which of them the roof falls.";
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {}, {ClearanceAxis::period, ClearanceAxis::support}),
             plot);
  return figure;
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
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {},
                                 {ClearanceAxis::period, ClearanceAxis::slope, ClearanceAxis::mass,
                                  ClearanceAxis::support}),
             plot);
  return figure;
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

Figure level_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot;
  plot.x_label = "Suite";
  plot.y_label = displacement_label();
  for (std::size_t i = 0; i < results.suites.size(); ++i) {
    plot.x.push_back(static_cast<double>(i));
    plot.ticks.push_back({static_cast<double>(i), results.suites[i].name});
  }
  const Places family = along(grid, ClearanceAxis::period);
  for (std::size_t i = 0; i < family.size(); ++i) {
    PlotLine line;
    line.colour = gnuplot::ramp_colour(i, family.size());
    line.style = style_of(i, family.size());
    line.title = "building of " + label_of(grid, ClearanceAxis::period, i);
    for (std::size_t suite = 0; suite < results.suites.size(); ++suite) {
      const OrientationRange range =
          over_orientations(results, {.suite = suite}, family[i], Periods::one);
      line.y.push_back(range.median);
      line.low.push_back(range.lowest);
      line.high.push_back(range.highest);
    }
    plot.lines.push_back(line);
  }
  tell_bands(results, plot);
  Figure figure;
  figure.name = "level";
  figure.title = "Displacement as the seismic level rises";
  figure.caption =
      fmt::format("After Walters et al. (2012), Fig. 14. {}.", what_is_averaged(results));
  draw_lines(figure, conditions_text(results, {}, {ClearanceAxis::period, ClearanceAxis::support}),
             plot);
  return figure;
}

Figure yielding_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot;
  plot.x_label = "Response modification R (1: elastic)";
  plot.y_label = "Displacement over that on an elastic building";
  plot.length = PlotLength::no;
  plot.x = grid.response_modification;
  const Places family = along(grid, ClearanceAxis::period);
  for (std::size_t i = 0; i < family.size(); ++i) {
    PlotLine line;
    line.colour = gnuplot::ramp_colour(i, family.size());
    line.style = style_of(i, family.size());
    line.title = "building of " + label_of(grid, ClearanceAxis::period, i);
    for (const ClearancePosition& at :
         along(grid, ClearanceAxis::response_modification, family[i])) {
      const std::vector<double> ratios = ratios_by_orientation(results, {}, at, family[i]);
      line.y.push_back(percentile(ratios, 0.5));
      line.low.push_back(ratios.empty() ? std::nan("") : ratios.front());
      line.high.push_back(ratios.empty() ? std::nan("") : ratios.back());
    }
    plot.lines.push_back(line);
  }
  tell_bands(results, plot);
  plot.levels.push_back({1.0, "elastic building", "#555555"});
  Figure figure;
  figure.name = "yielding";
  figure.title = "What a yielding building does to the displacement";
  figure.caption = fmt::format(
      "After Walters et al. (2012), Fig. 15. {}, over the same on a building that stays elastic. "
      "At R the building yields where the design spectrum asks an elastic force R times as large; "
      "R = 1 is taken elastic.",
      what_is_averaged(results));
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {},
                                 {ClearanceAxis::response_modification, ClearanceAxis::period,
                                  ClearanceAxis::support}),
             plot);
  return figure;
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
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {}, {ClearanceAxis::period, ClearanceAxis::support}),
             plot);
  return figure;
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
      line.y.push_back(percentile(ratios, 0.5));
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
  draw_lines(figure,
             results.suites.front().name + "; " +
                 conditions_text(results, {}, {ClearanceAxis::period, ClearanceAxis::support}),
             plot);
  return figure;
}

Figure slope_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot;
  plot.x_label = "Roof slope (rise in 12)";
  plot.y_label = displacement_label();
  for (std::size_t i = 0; i < grid.slope_deg.size(); ++i) {
    const std::string text = slope_text(grid.slope_deg[i]);
    plot.x.push_back(12.0 * std::tan(grid.slope_deg[i] * rad_per_deg));
    plot.ticks.push_back({plot.x.back(), text.substr(0, text.find(" ("))});
  }
  PlotLine largest =
      line_through(results, {}, along(grid, ClearanceAxis::slope), 0, 1, Periods::largest);
  largest.title = "largest over the periods";
  largest.style = "linespoints lw 3.5 pt 7 ps 1.1 lc rgb '#000000'";
  largest.colour = "#000000";
  plot.lines.push_back(largest);
  const Places family = along(grid, ClearanceAxis::period);
  for (std::size_t i = 0; family.size() > 1 && i < family.size(); ++i) {
    plot.lines.push_back(
        line_through(results, {}, along(grid, ClearanceAxis::slope, family[i]), i, family.size()));
    plot.lines.back().title = "building of " + label_of(grid, ClearanceAxis::period, i);
  }
  tell_bands(results, plot);
  Figure figure;
  figure.name = "slope";
  figure.title = "Displacement over the roof's slope";
  figure.caption =
      fmt::format("After Walters et al. (2012), Fig. 17. {}.", what_is_averaged(results));
  draw_lines(
      figure,
      results.suites.front().name + "; " +
          conditions_text(results, {},
                          {ClearanceAxis::period, ClearanceAxis::slope, ClearanceAxis::support}),
      plot);
  return figure;
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
  draw_lines(
      figure,
      results.suites.front().name + "; " +
          conditions_text(results, {},
                          {ClearanceAxis::period, ClearanceAxis::level, ClearanceAxis::support}),
      plot);
  return figure;
}

Figure vertical_figure(const ClearanceResults& results) {
  const ClearanceGrid& grid = results.grid;
  LinePlot plot;
  plot.x_label = "Vertical motion of the roof";
  plot.y_label = displacement_label();
  for (std::size_t i = 0; i < grid.vertical.size(); ++i) {
    const VerticalCondition& vertical = grid.vertical[i];
    plot.x.push_back(static_cast<double>(i));
    plot.ticks.push_back({plot.x.back(), vertical.use == VerticalChoice::none ? "none"
                                         : vertical.period_s == 0.0
                                             ? "rigid"
                                             : fmt::format("{:g} s", vertical.period_s)});
  }
  const Places family = along(grid, ClearanceAxis::period);
  for (std::size_t i = 0; i < family.size(); ++i) {
    plot.lines.push_back(line_through(results, {}, along(grid, ClearanceAxis::vertical, family[i]),
                                      i, family.size()));
    plot.lines.back().title = "building of " + label_of(grid, ClearanceAxis::period, i);
    plot.lines.back().spread = PlotLine::Spread::bars;
  }
  tell_bands(results, plot);
  Figure figure;
  figure.name = "vertical";
  figure.title = "What the roof's vertical motion does to the displacement";
  figure.caption = fmt::format(
      "None: no vertical motion. Rigid: the roof goes up and down with the ground, as Walters et "
      "al. "
      "(2012) take it. Else: with a vertical period of its own, damped as the study says. {}.",
      what_is_averaged(results));
  draw_lines(
      figure,
      results.suites.front().name + "; " +
          conditions_text(results, {},
                          {ClearanceAxis::period, ClearanceAxis::vertical, ClearanceAxis::support}),
      plot);
  return figure;
}

}  // namespace glissade
