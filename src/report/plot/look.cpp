// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "glissade/core/units.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/report/format.hpp"

namespace glissade {

Look look(Role role) {
  constexpr Colour blue{0x0072b2}, orange{0xd55e00}, green{0x009e73}, pink{0xcc79a7}, black{0},
      grey{0x777777};
  switch (role) {
    case Role::clearance:
      return {blue, 4.0, 1, 7, 0.5};
    case Role::median:
      return {black, 3.0, 1, 7, 0.6};
    case Role::mean:
      return {blue, 2.0, 3, 5, 0.6};
    case Role::p16:
      return {green, 2.0, 2, 9, 0.6};
    case Role::p84:
      return {orange, 2.5, 1, 5, 0.6};
    case Role::p95:
      return {pink, 2.0, 2, 9, 0.6};
    case Role::largest:
      return {grey, 2.0, 4, 13, 0.7};
    case Role::record:
      return {{0xb0b0b0}, 1.0, 1, 0, 0.0};
    case Role::bound:
      return {{0x555555}, 1.8, 2, 0, 0.0};
    case Role::target:
      return {orange, 4.0, 2, 0, 0.0};
    case Role::prescribed:
      return {orange, 2.5, 5, 4, 1.2};
    case Role::reference:
      return {{0x555555}, 1.5, 3, 0, 0.0};
    case Role::published:
      return {black, 2.0, 1, 12, 1.5};
  }
  return {};
}

Look family_look(std::size_t index, std::size_t count) {
  constexpr std::array<std::array<double, 3>, 5> stops = {{{0x44, 0x01, 0x54},
                                                           {0x3b, 0x52, 0x8b},
                                                           {0x21, 0x91, 0x8c},
                                                           {0x3f, 0xb0, 0x6e},
                                                           {0x8f, 0xc3, 0x2f}}};
  constexpr std::array symbols = {7, 5, 9, 13, 11, 15};  // disc, square, triangle, diamond ...
  const double position =
      count < 2 ? 1.0
                : static_cast<double>(index) / static_cast<double>(count - 1) * (stops.size() - 1);
  const auto lower = std::min<std::size_t>(static_cast<std::size_t>(position), stops.size() - 2);
  const double share = position - static_cast<double>(lower);
  Look family{.width = 2.5, .symbol = symbols[index % symbols.size()]};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double mixed = (1.0 - share) * stops[lower][channel] + share * stops[lower + 1][channel];
    family.colour.rgb = 256 * family.colour.rgb + static_cast<std::uint32_t>(std::lround(mixed));
  }
  return family;
}

Look distinct_look(std::size_t index) {
  constexpr std::array<std::uint32_t, 6> colours = {0x0072b2, 0xd55e00, 0x009e73,
                                                    0xcc79a7, 0xe69f00, 0x56b4e9};
  constexpr std::array<int, 6> symbols = {7, 5, 9, 13, 11, 4};
  const std::size_t one = index % colours.size();
  return {.colour = {colours[one]},
          .width = 3.0,
          .dash = static_cast<int>(one % 5) + 1,
          .symbol = symbols[one]};
}

void DataSeries::add(double x_value, double y_value) {
  x.push_back(x_value);
  y.push_back(y_value);
}

void DataSeries::add(double x_value, const Interval& range) {
  if (std::isnan(range.low + range.high)) return;
  x.push_back(x_value);
  low.push_back(range.low);
  high.push_back(range.high);
}

void DataSeries::end_line() {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  add(gap, gap);
}

Axis share_axis(const std::string& label) {
  Axis axis{label, 0.0, 1.0, {}, Axis::Values::shares};
  for (int percent = 0; percent <= 100; percent += 20)
    axis.ticks.push_back({percent / 100.0, fmt::format("{} %", percent)});
  return axis;
}

Axis log_axis(const std::string& label, double low, double high, std::string (*text)(double),
              const std::vector<double>& digits) {
  constexpr double rounding = 1e-12;
  Axis axis{label, low, high, {}, Axis::Values::logarithms};
  for (int decade = static_cast<int>(std::floor(std::log10(low) + rounding));
       decade <= std::log10(high) + rounding; ++decade) {
    for (const double digit : digits) {
      const double at = std::strtod(fmt::format("{:g}e{}", digit, decade).c_str(), nullptr);
      if (low * (1.0 - rounding) <= at && at <= high * (1.0 + rounding))
        axis.ticks.push_back({at, text(at)});
    }
  }
  return axis;
}

double round_step(double range, double count) {
  const double wanted = range / count, power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double leading = wanted / power;
  return power * (leading < 1.5 ? 1.0 : leading < 3.5 ? 2.0 : leading < 7.5 ? 5.0 : 10.0);
}

Axis length_axis(const std::string& label, double high_m) {
  const auto ticks_every = [&](double unit_m) {
    std::vector<Tick> ticks;
    const double step = round_step(high_m / unit_m, 6.0);
    for (int i = 0; step > 0.0 && i * step * unit_m <= high_m; ++i)
      ticks.push_back({i * step * unit_m, fmt::format("{:g}", i * step)});
    return ticks;
  };
  if (LengthUnits::first() == UnitSystem::us_customary)
    return {label + " (in)", 0.0, high_m, ticks_every(inch_m), Axis::Values::numbers, label};
  return {label + " (m)", 0.0, high_m, {}, Axis::Values::numbers, label};
}

namespace {

/// The nearest heights to those of labels, in their order from the highest on, that are a line
/// apart (by pooling those that would not be) and lie between the ends of the axis, above the
/// lower one.
std::vector<double> apart(const std::vector<Note>& labels, const Axis& axis, double line) {
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    pools.push_back({labels[i].y + line * static_cast<double>(i), 1});
    while (pools.size() > 1 && pools.back().mean() > pools[pools.size() - 2].mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back() = {pools.back().sum + last.sum, pools.back().count + last.count};
    }
  }
  const double least = axis.low + line * (static_cast<double>(labels.size()) - 0.4);
  std::vector<double> heights;
  for (const Pool& pool : pools)
    for (std::size_t i = 0; i < pool.count; ++i)
      heights.push_back(std::max(least, std::min(pool.mean(), axis.high)) -
                        line * static_cast<double>(heights.size()));
  return heights;
}

}  // namespace

void add_side_labels(Panel& panel, std::vector<Note> labels, const LabelMargin& margin) {
  const double width = panel.x.high - panel.x.low;
  const double line = margin.line * (panel.y.high - panel.y.low);
  const bool left = margin.side == Side::left;
  if (panel.x.ticks.empty()) {  // none in the margin
    const double step = round_step(width, 6.0);
    const double first = std::ceil(panel.x.low / step - 1e-6);
    constexpr int most_ticks = 20;  // of 10; equal doubles would repeat without end
    for (int i = 0; i < most_ticks && (first + i) * step <= panel.x.high + 1e-6 * step; ++i)
      panel.x.ticks.push_back(
          {(first + i) * step, fmt::format("{:.6g}", (first + i) * step + 0.0)});
  }
  double& edge = left ? panel.x.low : panel.x.high;
  const double outward = left ? -width : width;
  std::ranges::sort(labels, std::ranges::greater{}, &Note::y);
  const std::vector<double> heights = apart(labels, panel.y, line);
  for (std::size_t i = 0; i < labels.size(); ++i)
    panel.notes.push_back({edge + 0.02 * outward, heights[i], labels[i].text, labels[i].colour,
                           left ? Note::Align::right : Note::Align::left});
  edge += margin.width * outward;
}

}  // namespace glissade
