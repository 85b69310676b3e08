// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "clearance/family_figures.hpp"
#include "clearance/family_lines.hpp"
#include "clearance/view.hpp"
#include "figure_text.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {

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
      line.y.push_back(quantile_of(ratios, 0.5));
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
  return with_lines(results, figure, {ClearanceAxis::response_modification}, plot);
}

namespace {

/// A line over an axis for each building period.
void add_buildings(const ClearanceResults& results, ClearanceAxis axis, LinePlot& plot) {
  const Places family = along(results.grid, ClearanceAxis::period);
  for (std::size_t i = 0; i < family.size(); ++i) {
    plot.lines.push_back(
        line_through(results, {}, along(results.grid, axis, family[i]), i, family.size()));
    plot.lines.back().title = "building of " + label_of(results.grid, ClearanceAxis::period, i);
  }
}

}  // namespace

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
  if (grid.period_s.size() > 1) add_buildings(results, ClearanceAxis::slope, plot);
  tell_bands(results, plot);
  Figure figure;
  figure.name = "slope";
  figure.title = "Displacement over the roof's slope";
  figure.caption =
      fmt::format("After Walters et al. (2012), Fig. 17. {}.", what_is_averaged(results));
  return with_lines(results, figure, {ClearanceAxis::slope}, plot);
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
  add_buildings(results, ClearanceAxis::vertical, plot);
  for (PlotLine& line : plot.lines) line.spread = PlotLine::Spread::bars;
  tell_bands(results, plot);
  Figure figure;
  figure.name = "vertical";
  figure.title = "What the roof's vertical motion does to the displacement";
  figure.caption = fmt::format(
      "None: no vertical motion. Rigid: the roof goes up and down with the ground, as Walters et "
      "al. "
      "(2012) take it. Else: with a vertical period of its own, damped as the study says. {}.",
      what_is_averaged(results));
  return with_lines(results, figure, {ClearanceAxis::vertical}, plot);
}

}  // namespace glissade
