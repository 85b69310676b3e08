// SPDX-License-Identifier: GPL-3.0-or-later
#include "figure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {

std::string quoted_file(const FileName& name) { return "'" + name.text() + ".dat'"; }

std::string title_of(const Figure& figure, const std::string& below) {
  // Double quotes would read \n but also backslash escapes; a single-quoted string with a real line
  // break does not exist, so the two lines are joined by gnuplot.
  return "set title " + gnuplot::quoted_markup("{/:Bold " + gnuplot::enhanced(figure.title) + "}") +
         ".\"\\n\"." + gnuplot::quoted_markup("{/*0.9 " + gnuplot::enhanced(below) + "}") + "\n";
}

std::string axis(const std::string& which, const std::string& label) {
  // An empty second line below the x label keeps the key away from it.
  const std::string below = which == "x" ? ".\"\\n \"" : "";
  return "set " + which + "label " + gnuplot::quoted(label) + below + "\n";
}

namespace {

/// 1, 2 or 5 times a power of ten: about six ticks over the range.
double round_tick_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 6.0)));
  const double leading = range / 6.0 / power;
  return power * (leading < 1.5 ? 1.0 : leading < 3.5 ? 2.0 : leading < 7.5 ? 5.0 : 10.0);
}

}  // namespace

std::string inches_beside(const std::string& which, double largest_m, const std::string& label) {
  return fmt::format(
      "set link {0}2 via {0}/{3} inverse {0}*{3}\n"
      "set {0}2tics {2} out nomirror\n"
      "set {0}2label {4}\n"
      "set border {1}\n",
      which, which == "x" ? 7 : 11, round_tick_step(largest_m / inch_m), inch_m,
      gnuplot::quoted(label + " (in)"));
}

std::string at_intensity(const Results& results, double value) {
  const std::string unit = results.measure.unit();
  const std::string name =
      results.intensity_label.substr(0, results.intensity_label.rfind(" ("));
  return name + " = " + format_number(value) + (unit == "-" ? "" : " " + unit);
}

std::string counts_of(const Results& results) {
  return fmt::format("{} records x {} samples", results.records.size(), results.cases.samples);
}

std::string friction_of(const RunResults& run) {
  constexpr std::size_t room = 60;
  return run.friction_description.size() <= room ? "friction " + run.friction_description
                                                 : run.label + " friction";
}

std::string list_of_lengths(const std::vector<double>& lengths_m) {
  std::string list;
  for (const double length_m : lengths_m)
    list += (list.empty() ? "" : ", ") + format_length(length_m);
  return list;
}

std::vector<double> some_levels(const std::vector<double>& levels, std::size_t count) {
  const std::size_t steps = std::min(count, levels.size());
  std::vector<double> chosen;
  for (std::size_t i = 1; i <= steps; ++i) chosen.push_back(levels[i * levels.size() / steps - 1]);
  return chosen;
}

int point_symbol(std::size_t index) {
  static constexpr std::array<int, 5> symbols = {
      7, 5, 9, 13, 11};  // disc, square, triangle, diamond, triangle down
  return symbols[index % symbols.size()];
}

std::vector<double> histories_at(const HistoryTable& histories, CaseSlice cases,
                                 std::size_t first, std::size_t last, std::size_t level) {
  std::vector<double> values;
  for (std::size_t record = first; record < last; ++record) {
    for (std::size_t i = 0; i < cases.count; ++i) {
      const double slip_m = histories.displacement_m(record, cases.first + i, level);
      if (!std::isnan(slip_m)) values.push_back(slip_m);
    }
  }
  return values;
}

}  // namespace glissade
