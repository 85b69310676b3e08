// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance/family_lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "clearance/view.hpp"
#include "figure_text.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {

std::string style_of(std::size_t index, std::size_t count) {
  return fmt::format("linespoints lw 2.5 pt {} ps 0.9 lc rgb '{}'", point_symbol(index),
                     gnuplot::ramp_colour(index, count));
}

PlotLine line_through(const ClearanceResults& results, const ClearanceQuestion& question,
                      const Places& places, std::size_t index, std::size_t count, Periods periods) {
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

namespace {

/// More than a few bands over one another cannot be told apart: then the first alone has one.
void thin_out_bands(LinePlot& plot) {
  if (plot.lines.size() <= 3) return;
  for (std::size_t i = 1; i < plot.lines.size(); ++i) {
    plot.lines[i].low.clear();
    plot.lines[i].high.clear();
  }
}

}  // namespace

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
  return results.displacement == DisplacementMeasure::srss
             ? "Mean over the suite of each history's SRSS of the separate maxima along the roof's "
               "two axes, in plan, relative to the roof"
             : "Mean over the suite of each history's farthest displacement, in plan, relative to "
               "the roof";
}

std::string displacement_label() { return "Displacement, mean of the suite"; }

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

Figure with_lines(const ClearanceResults& results, Figure figure, std::vector<ClearanceAxis> shown,
                  const LinePlot& plot) {
  shown.insert(shown.end(), {ClearanceAxis::period, ClearanceAxis::support});
  draw_lines(figure, results.suites.front().name + "; " + conditions_text(results, {}, shown),
             plot);
  return figure;
}

Places places_of(const ClearanceGrid& grid, ClearanceAxis slow, ClearanceAxis fast) {
  Places places;
  for (const ClearancePosition& at : along(grid, slow)) {
    for (const ClearancePosition& place : along(grid, fast, at)) places.push_back(place);
  }
  return places;
}

}  // namespace glissade
