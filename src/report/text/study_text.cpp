// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/report/format.hpp"

namespace glissade {

std::string with_unit(const Results& results, const std::string& value) {
  const std::string unit = results.measure.unit();
  return unit == "-" ? value : value + " " + unit;
}

std::string at_intensity(const Results& results, double value) {
  return results.intensity_label.substr(0, results.intensity_label.rfind(" (")) + " = " +
         with_unit(results, format_number(value));
}

Column intensity_column(const Results& results, const std::string& stem, const std::string& heading,
                        bool with_interval) {
  const std::string unit = results.measure.unit(), suffix = unit_suffix(unit);
  return {stem, suffix.empty() ? "" : suffix.substr(1),
          heading + (unit == "-" ? "" : ", " + unit) + (with_interval ? " [95 %]" : ""),
          ColumnKind::number, with_interval};
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

std::vector<double> histories_at(const HistoryTable& histories, CaseSlice cases, std::size_t first,
                                 std::size_t last, std::size_t level) {
  std::vector<double> values;
  for (std::size_t record = first; record < last; ++record) {
    for (std::size_t i = 0; i < cases.count; ++i) {
      const double slip_m = histories.displacement_m(record, cases.first + i, level);
      if (!std::isnan(slip_m)) values.push_back(slip_m);
    }
  }
  return values;
}

double largest(const std::vector<double>& values) {
  double found = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) found = std::max(found, value);
  return found;
}

void end_line(DataSeries& series) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  series.x.push_back(gap);
  series.y.push_back(gap);
}

}  // namespace glissade
