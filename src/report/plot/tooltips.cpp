// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "glissade/report/format.hpp"
#include "glissade/report/html_text.hpp"
#include "plot/labels.hpp"
#include "plot/script.hpp"

namespace glissade {
namespace {

/// "Building period (s) 1.23"; a length in both units.
std::string value_text(const Axis& axis, double value) {
  const std::string& label = axis.length.empty() ? axis.label : axis.length;
  const char* link = axis.values == Axis::Values::names ? (label.empty() ? "" : ": ")
                     : axis.values == Axis::Values::logarithms && value <= axis.low ? " at most "
                                                                                    : " ";
  const bool is_below = axis.values == Axis::Values::logarithms && value < axis.low;
  return label + link + value_on(axis, is_below ? axis.low : value);
}

bool is_shown(const Axis& axis, double value) {
  const bool to_low_end = axis.values == Axis::Values::logarithms;
  return std::isfinite(value) && (value >= axis.low || to_low_end) && value <= axis.high;
}

const std::string& name_of(const DataSeries& series) {
  return series.name.empty() ? series.label : series.name;
}

bool is_line(const DataSeries& series) {
  return series.kind == DataSeries::Kind::line || series.kind == DataSeries::Kind::line_and_points;
}

/// What a plot of gnuplot's drawing shows.
struct DrawnSeries {
  const Panel* panel = nullptr;
  const DataSeries* series = nullptr;
};

/// The first plot of a panel, "1", is of nothing, for its axes; then the series with numbers, in
/// order. "3b": the second one of the second panel.
DrawnSeries drawn_as(const Figure& figure, const std::string& number) {
  std::size_t plot = 0;
  const char* end = number.data() + number.size();
  const char* letter = std::from_chars(number.data(), end, plot).ptr;
  const std::size_t p = letter == end ? 0 : static_cast<std::size_t>(*letter - 'a');
  if (p >= figure.panels.size()) return {};
  for (const DataSeries& series : figure.panels[p].series)
    if (!series.x.empty() && --plot == 1) return {&figure.panels[p], &series};
  return {};
}

/// Of the points that are drawn, in order.
std::vector<std::string> titles_of(const Panel& panel, const DataSeries& series) {
  std::vector<std::string> titles;
  if (series.kind != DataSeries::Kind::points && series.kind != DataSeries::Kind::line_and_points)
    return titles;
  const std::string& name = name_of(series);
  for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i) {
    if (!is_shown(panel.x, series.x[i]) || !is_shown(panel.y, series.y[i])) continue;
    titles.push_back((name.empty() ? "" : name + ": ") + value_text(panel.x, series.x[i]) + ", " +
                     value_text(panel.y, series.y[i]));
  }
  return titles;
}

std::string title(const std::string& text) {
  return "<title>" + Html::text(text).str() + "</title>";
}

/// Puts the titles into the points of a plot; nothing where gnuplot drew another number of them.
std::string with_titles(const std::string& plot, const std::vector<std::string>& titles) {
  static constexpr std::string_view point = "<use ", end = "/>";
  std::string text;
  std::size_t from = 0, count = 0;
  for (std::size_t at; (at = plot.find(point, from)) != std::string::npos; ++count) {
    const std::size_t close = plot.find(end, at);
    if (close == std::string::npos || count == titles.size()) return plot;
    text += plot.substr(from, close - from) + ">" + title(titles[count]) + "</use>";
    from = close + end.size();
  }
  return count == titles.size() ? text + plot.substr(from) : plot;
}

/// Between the first begin and end of a tag; nothing where it is not there.
void replace_element(std::string& svg, const std::string& begin, const std::string& end,
                     const std::string& by) {
  const std::size_t from = svg.find(begin), to = svg.find(end, from);
  if (to != std::string::npos) svg.replace(from, to + end.size() - from, by);
}

/// In place of those of gnuplot.
std::string with_description(std::string head, const Figure& figure) {
  replace_element(head, "<title>", "</title>", title(figure.title));
  replace_element(head, "<desc>", "</desc>",
                  "<desc id=\"" + figure.name.text() + "_desc\">" +
                      Html::text(description_of(figure)).str() + "</desc>");
  return head;
}

}  // namespace

std::string with_tooltips(const std::string& svg, const Figure& figure) {
  const std::string name = gnuplot::identifier(figure.name).text() + "_plot_";
  const std::string plot_begin = "<g id=\"" + name;
  std::size_t at = svg.find(plot_begin);
  std::string text = with_description(svg.substr(0, at), figure);
  while (at != std::string::npos) {
    const std::size_t next = svg.find(plot_begin, at + 1);
    std::string one = svg.substr(at, next - at);
    const std::size_t number = plot_begin.size();
    const DrawnSeries drawn = drawn_as(figure, one.substr(number, one.find('"', number) - number));
    if (drawn.series != nullptr) one = with_titles(one, titles_of(*drawn.panel, *drawn.series));
    const std::string_view end = "</title>";
    if (const std::size_t begin = one.find("<title>" + name); begin != std::string::npos)
      one.erase(begin, one.find(end, begin) + end.size() - begin);
    if (drawn.series != nullptr && is_line(*drawn.series) && !name_of(*drawn.series).empty())
      one.insert(one.find('>') + 1, title(name_of(*drawn.series)));
    text += one;
    at = next;
  }
  return text;
}

}  // namespace glissade
