// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/report/format.hpp"
#include "plot/labels.hpp"

namespace glissade {

std::string value_on(const Axis& axis, double value) {
  if (!axis.length.empty()) return format_length(value);
  if (axis.values == Axis::Values::shares) return format_share(value);
  if (axis.values == Axis::Values::names && !axis.ticks.empty())
    return std::ranges::min_element(axis.ticks, {},
                                    [&](const Tick& tick) { return std::abs(tick.at - value); })
        ->label;
  return format_number(value);
}

namespace {

/// "m/M 0.05: 0.131 m (5.16 in) at 0.2, 0.0480 m (1.89 in) at 2, largest 0.298 m (11.7 in) at 1."
std::string line_text(const Panel& panel, const DataSeries& series) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) drawn.push_back(i);
  const std::string& name = series.name.empty() ? series.label : series.name;
  if (drawn.empty() || name.empty()) return "";
  const auto at = [&](std::size_t i) {
    return value_on(panel.y, series.y[i]) + " at " + value_on(panel.x, series.x[i]);
  };
  const auto value = [&](std::size_t i) { return series.y[i]; };
  const std::size_t largest = *std::ranges::max_element(drawn, {}, value);
  std::string text = " " + name + ": " + at(drawn.front());
  if (drawn.size() > 1) text += ", " + at(drawn.back());
  if (largest != drawn.front() && largest != drawn.back()) text += ", largest " + at(largest);
  return text + ".";
}

}  // namespace

std::string description_of(const Figure& figure) {
  constexpr std::size_t most_lines = 8;
  std::string text = figure.title + ". " + (figure.below.empty() ? "" : figure.below + ".");
  for (const Panel& panel : figure.panels) {
    if (!panel.title.empty()) text += " " + panel.title + ".";
    text +=
        fmt::format(" Across: {}, {} to {}. Up: {}.", panel.x.label, value_on(panel.x, panel.x.low),
                    value_on(panel.x, panel.x.high), panel.y.label);
    std::size_t lines = 0;
    for (const DataSeries& series : panel.series) {
      const std::string line = line_text(panel, series);
      if (!line.empty() && ++lines <= most_lines) text += line;
    }
    if (lines > most_lines) text += fmt::format(" And {} more.", lines - most_lines);
    for (const Rule& rule : panel.rules)
      if (!rule.label.empty()) text += " " + rule.label + ".";
  }
  return text;
}

}  // namespace glissade
