// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figure_text.hpp"
#include "glissade/core/quantile.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

constexpr auto standard_colour = "#d55e00";

/// The height of the figure: without the few slips that would press the others flat.
double curves_top_m(const CurvePlot& plot) {
  std::vector<double> slips;
  for (const Curve& curve : plot.curves)
    std::copy_if(curve.y_m.begin(), curve.y_m.end(), std::back_inserter(slips),
                 [](double slip_m) { return std::isfinite(slip_m) && slip_m > 0.0; });
  if (slips.empty()) return 1.0;
  const double largest = *std::max_element(slips.begin(), slips.end());
  return std::min(largest, 1.5 * quantile_of(slips, plot.share_within));
}

/// That, and the prescribed values where they do not press the curves flat.
double top_m(const CurvePlot& plot) {
  const double curves = curves_top_m(plot);
  double top = curves;
  for (const Horizontal& h : plot.horizontals) {
    if (h.prescribed.value_m < 3.0 * curves) top = std::max(top, h.prescribed.value_m);
  }
  return 1.08 * top;
}

/// The lines with their labels, from the highest down: above the line, or below it where the one
/// before is near.
std::string horizontal_lines(std::vector<Horizontal> horizontals, double top, double right) {
  constexpr double near = 0.12, line = 0.06;  // as shares of the figure's height
  std::sort(horizontals.begin(), horizontals.end(), [](const Horizontal& a, const Horizontal& b) {
    return a.prescribed.value_m > b.prescribed.value_m;
  });
  std::string lines;
  double corner = 0.97, before_m = 2.0 * top;
  for (const Horizontal& horizontal : horizontals) {
    const double value_m = horizontal.prescribed.value_m;
    const std::string text = horizontal.prescribed.label();
    if (value_m > top) {
      lines += fmt::format("set label {} at graph 0.985,{} right front boxed textcolor rgb '{}'\n",
                           gnuplot::quoted(text + ": above the figure"), corner, standard_colour);
      corner -= line;
      before_m = top;
      continue;
    }
    const auto [from, to] = horizontal.where;
    const bool to_the_end = to >= right;
    lines += fmt::format(
        "set arrow from {0},{2} to {1},{2} nohead dt 2 lw 2.5 lc rgb '{3}' front\n"
        "set label {4} at {5},{2} {6} offset {7},{8} front boxed textcolor rgb '{3}'\n",
        from, to, value_m, standard_colour, gnuplot::quoted(text), to_the_end ? to : from,
        to_the_end ? "right" : "left", to_the_end ? -0.7 : 0.7,
        before_m - value_m > near * top ? 0.75 : -0.75);
    before_m = value_m;
  }
  return lines;
}

}  // namespace

std::string family_style(std::size_t index, std::size_t count) {
  return fmt::format("linespoints lw 2 pt {} ps 0.6 lc rgb '{}'", point_symbol(index),
                     gnuplot::ramp_colour(index, count));
}

void draw_curves(Figure& figure, const std::string& below, const CurvePlot& plot) {
  gnuplot::DataBlocks data;
  std::string columns = plot.x_column;
  for (const Curve& curve : plot.curves) columns += " '" + curve.title + "'_m";
  data.begin("curves", columns);
  for (std::size_t i = 0; i < plot.x.size(); ++i) {
    std::vector<double> row = {plot.x[i]};
    for (const Curve& curve : plot.curves) row.push_back(curve.y_m.at(i));
    data.row(row);
  }
  const double top = top_m(plot);
  figure.body =
      title_of(figure, below) + axis("x", plot.x_label) + axis("y", plot.y_label + " (m)") +
      inches_beside("y", top, plot.y_label) +
      fmt::format("set xrange [{}:{}]\nset yrange [0:{}]\n", plot.x.front(), plot.x.back(), top) +
      "set style textbox opaque noborder margins 0.4,0.2\n" +
      fmt::format("set key horizontal maxcols {}\n", plot.key_columns);
  figure.body += horizontal_lines(plot.horizontals, top, plot.x.back()) + "plot \\\n";
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    figure.body +=
        fmt::format("  {} index 'curves' using 1:{} with {} title {}{}\n", quoted_file(figure.name),
                    c + 2, plot.curves[c].style, gnuplot::quoted(plot.curves[c].title),
                    c + 1 < plot.curves.size() ? ", \\" : "");
  }
  const auto curves = static_cast<int>(plot.curves.size());
  figure.key_rows = (curves + plot.key_columns - 1) / plot.key_columns;
  figure.data = data.text();
}

}  // namespace glissade
