// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/tooltips.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "glissade/report/format.hpp"
#include "glissade/report/html_text.hpp"

namespace glissade {
namespace {

/// "Building period (s) 1.23"; a length in both units.
std::string value_text(const Axis& axis, double value) {
  if (axis.label.ends_with("(in)") || axis.label.ends_with("(m)"))
    return axis.label.substr(0, axis.label.rfind(" (")) + " " + format_length(value);
  return axis.label + " " + format_number(value);
}

bool is_shown(const Axis& axis, double value) {
  return std::isfinite(value) && value >= axis.low && value <= axis.high;
}

/// Of the points that are drawn, in order.
std::vector<std::string> titles_of(const Panel& panel, const DataSeries& series) {
  std::vector<std::string> titles;
  if (series.kind != DataSeries::Kind::points && series.kind != DataSeries::Kind::line_and_points)
    return titles;
  for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i) {
    if (!is_shown(panel.x, series.x[i]) || !is_shown(panel.y, series.y[i])) continue;
    titles.push_back((series.label.empty() ? "" : series.label + ": ") +
                     value_text(panel.x, series.x[i]) + ", " + value_text(panel.y, series.y[i]));
  }
  return titles;
}

/// Puts the titles into the points of a plot; nothing where gnuplot drew another number of them.
std::string with_titles(const std::string& plot, const std::vector<std::string>& titles) {
  static constexpr std::string_view point = "<use ", end = "/>";
  std::string text;
  std::size_t from = 0, count = 0;
  for (std::size_t at; (at = plot.find(point, from)) != std::string::npos; ++count) {
    const std::size_t close = plot.find(end, at);
    if (close == std::string::npos || count == titles.size()) return plot;
    text += plot.substr(from, close - from) + "><title>" + Html::text(titles[count]).str() +
            "</title></use>";
    from = close + end.size();
  }
  return count == titles.size() ? text + plot.substr(from) : plot;
}

}  // namespace

std::string with_tooltips(std::string svg, const Figure& figure) {
  const std::string plot_begin = "<g id=\"" + figure.name.text() + "_plot_";
  // The first plot is of nothing, for the axes; then the series with numbers, in order.
  std::vector<const DataSeries*> drawn{nullptr};
  if (figure.panels.size() == 1) {
    for (const DataSeries& series : figure.panels.front().series)
      if (!series.x.empty()) drawn.push_back(&series);
  }
  std::size_t at = svg.find(plot_begin);
  std::string text = svg.substr(0, at);
  for (std::size_t plot = 0; at != std::string::npos; ++plot) {
    const std::size_t next = svg.find(plot_begin, at + 1);
    std::string one = svg.substr(at, next - at);
    const std::string_view end = "</title>";
    if (const std::size_t begin = one.find("<title>" + figure.name.text() + "_plot_");
        begin != std::string::npos)
      one.erase(begin, one.find(end, begin) + end.size() - begin);
    text += plot > 0 && plot < drawn.size()
                ? with_titles(one, titles_of(figure.panels.front(), *drawn[plot]))
                : one;
    at = next;
  }
  return text;
}

}  // namespace glissade
