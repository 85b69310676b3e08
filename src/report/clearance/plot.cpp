// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure_text.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

struct AxisRange {
  double low = 0.0, high = 1.0;
};

/// What y has to hold, with some room.
AxisRange y_range(const LinePlot& plot) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  const auto take = [&](double y) {
    if (!std::isfinite(y)) return;
    low = std::min(low, y);
    high = std::max(high, y);
  };
  for (const PlotLine& line : plot.lines) {
    for (const auto* values : {&line.y, &line.low, &line.high})
      std::ranges::for_each(*values, take);
  }
  for (const PlotMark& mark : plot.marks) take(mark.y);
  for (const PlotLevel& level : plot.levels) take(level.y);
  if (!(high > 0.0)) return {};
  if (plot.from_zero) return {0.0, 1.12 * high};
  const double room = 0.15 * std::max(high - low, 1e-3 * high);
  return {low - room, high + room};
}

std::string ticks_of(const LinePlot& plot) {
  if (plot.ticks.empty()) return "";
  std::string list;
  for (const PlotTick& tick : plot.ticks)
    list += (list.empty() ? "" : ", ") + fmt::format("{} {}", gnuplot::quoted(tick.label), tick.x);
  const char* turned = plot.ticks.size() > 7 ? "rotate by 30 right " : "";  // else they touch
  return std::string("set xtics ") + turned + "(" + list + ")\n";
}

std::string data_of(const LinePlot& plot) {
  gnuplot::DataBlocks data;
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const PlotLine& line = plot.lines[i];
    data.begin(fmt::format("line {}", i), "x '" + line.title + "' low high");
    for (std::size_t j = 0; j < plot.x.size(); ++j) {
      const bool spreads = !line.low.empty();
      data.row({plot.x[j] + line.shift, line.y.at(j), spreads ? line.low.at(j) : line.y.at(j),
                spreads ? line.high.at(j) : line.y.at(j)});
    }
  }
  return data.text();
}

std::string spread_of(const PlotLine& line, const std::string& source) {
  if (line.low.empty()) return "";
  if (line.spread == PlotLine::Spread::band) {
    return fmt::format("  {} using 1:3:4 with filledcurves fc rgb '{}' notitle, \\\n", source,
                       line.colour);
  }
  return fmt::format("  {} using 1:2:3:4 with yerrorbars pt 0 lw 2 lc rgb '{}' notitle, \\\n",
                     source, line.colour);
}

std::string levels_of(const LinePlot& plot) {
  std::string text;
  for (const PlotLevel& level : plot.levels) {
    text += fmt::format(
        "set arrow from graph 0,first {0} to graph 1,first {0} nohead dt 2 lw 2 lc rgb '{1}' "
        "front\n"
        "set label {2} at graph 0.985,first {0} right offset 0,0.7 front boxed tc rgb '{1}'\n",
        level.y, level.colour, gnuplot::quoted(level.label));
  }
  return text;
}

std::string marks_of(const LinePlot& plot) {
  std::string text;
  for (const PlotMark& mark : plot.marks) {
    text += fmt::format(
        "set label {3} at first {0},first {1} point pt 3 ps 2 lw 2.5 lc rgb '{2}' front left "
        "offset 1.5,0.5 boxed tc rgb '{2}'\n",
        mark.x, mark.y, mark.colour, gnuplot::quoted(mark.label));
  }
  return text;
}

}  // namespace

void draw_lines(Figure& figure, const std::string& below, const LinePlot& plot) {
  const AxisRange range = y_range(plot);
  const auto [first, last] = std::minmax_element(plot.x.begin(), plot.x.end());
  const double room = 0.05 * std::max(*last - *first, 1e-9);
  figure.body = title_of(figure, below) + axis("x", plot.x_label) +
                axis("y", plot.y_label + (plot.length == PlotLength::metres ? " (m)" : ""));
  if (plot.length == PlotLength::metres)
    figure.body += inches_beside("y", range.high, plot.y_label);
  figure.body += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", *first - room,
                             *last + room, range.low, range.high) +
                 "set style textbox opaque noborder margins 0.4,0.2\n" +
                 fmt::format("set key horizontal maxcols {}\n", plot.key_columns) + ticks_of(plot) +
                 levels_of(plot) + marks_of(plot) + "plot \\\n";
  std::string spreads, lines;
  const std::string file = quoted_file(figure.name);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const std::string source = fmt::format("{} index 'line {}'", file, i);
    spreads += spread_of(plot.lines[i], source);
    lines += fmt::format("{}  {} using 1:2 with {} title {}", i == 0 ? "" : ", \\\n", source,
                         plot.lines[i].style, gnuplot::quoted(plot.lines[i].title));
  }
  figure.body += spreads + lines;
  auto entries = static_cast<int>(plot.lines.size());
  if (!plot.band_title.empty()) {
    const bool bars = plot.lines.front().spread == PlotLine::Spread::bars;
    figure.body +=
        fmt::format(", \\\n  keyentry with {} rgb '#777777' title {}",
                    bars ? "lines lw 2 lc" : "filledcurves fc", gnuplot::quoted(plot.band_title));
    ++entries;
  }
  figure.body += "\n";
  figure.key_rows = (entries + plot.key_columns - 1) / plot.key_columns;
  figure.data = data_of(plot);
}

}  // namespace glissade
