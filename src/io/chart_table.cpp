// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/io/csv.hpp"
#include "number_list.hpp"

namespace glissade {
namespace {

constexpr NumberRule slope_rule{"in degrees, -89.9 to 89.9",
                                [](double x) { return std::abs(x) <= 89.9; }};
constexpr NumberRule slope_read_rule{"in degrees, 0 to 89.9",
                                     [](double x) { return x >= 0.0 && x <= 89.9; }};

/// An axis that something can be interpolated along.
std::vector<double> read_axis(const TomlTable& chart, const char* key, const NumberRule& rule) {
  std::vector<double> axis = read_increasing(chart, key, rule);
  if (axis.size() == 1) {
    chart.report(
        key, chart.name_of(key) + " has one value, and a chart interpolates between two or more",
        "give a list, or { from, to, count }; for one value run a study without [chart]");
  }
  return axis;
}

constexpr double most_points = 1e6;  // each for every record and orientation

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

/// A negative slope counts for its mirror image, which must be there.
void mirror_exactly(const TomlTable& chart, std::vector<double>& slopes) {
  for (double& slope : slopes) {
    if (slope >= 0.0) break;
    const auto mirror =
        std::find_if(slopes.begin(), slopes.end(), [&](double s) { return same(s, -slope); });
    if (mirror == slopes.end()) {
      chart.report("slope_deg",
                   chart.name_of("slope_deg") + " has " + shortest_decimal(slope) +
                       " and not its mirror image " + shortest_decimal(-slope),
                   "give both of each, or slopes of 0 and more with [orientation] sign = \"both\"");
      return;
    }
    slope = -*mirror;
  }
}

/// A value of an axis, to be read from a key; `otherwise` where the key is not there.
double read_on_axis(const TomlTable& table, const char* key, const std::vector<double>& axis,
                    double otherwise) {
  const auto value = table.number(key);
  if (!value || axis.empty()) return otherwise;
  const auto found =
      std::find_if(axis.begin(), axis.end(), [&](double x) { return same(x, *value); });
  if (found != axis.end()) return *found;
  table.report(key, table.name_of(key) + " = " + shortest_decimal(*value) + " is not on the chart",
               "give one of its values, " + shortest_decimal(axis.front()) + " to " +
                   shortest_decimal(axis.back()));
  return otherwise;
}

/// A value within an axis.
double read_within(const TomlTable& table, const char* key, const std::vector<double>& axis,
                   const NumberRule& rule) {
  const double value = table.required_number(key, rule);
  if (axis.size() > 1 && table.has(key) && (value < axis.front() || value > axis.back())) {
    table.report(key,
                 table.name_of(key) + " = " + shortest_decimal(value) + " is outside the chart",
                 "a chart is not extrapolated: stay from " + shortest_decimal(axis.front()) +
                     " to " + shortest_decimal(axis.back()));
  }
  return value;
}

ChartQuestion read_question(const TomlTable& table, const ChartConfig& chart,
                            const std::vector<double>& slopes, const std::vector<double>& levels) {
  ChartQuestion question;
  question.level = read_on_axis(table, "level", levels, levels.empty() ? 0.0 : levels.back());
  question.slope_deg = read_within(table, "slope_deg", slopes, slope_read_rule);
  if (table.has("mu") == table.has("displacement_m")) {
    table.report("", "a [[chart.read]] asks for a displacement or for a friction",
                 "give mu (and read the displacement), or displacement_m (and read the friction)");
    table.number("mu");
    table.number("displacement_m");
  } else if (table.has("mu")) {
    question.mu = read_within(table, "mu", chart.mu, friction_rule);
  } else {
    question.displacement_m = table.required_number("displacement_m", above_zero);
  }
  return question;
}

}  // namespace

ChartConfig read_chart(const TomlTable& table, const std::vector<double>& levels) {
  ChartConfig chart;
  chart.slope_deg = read_axis(table, "slope_deg", slope_rule);
  mirror_exactly(table, chart.slope_deg);
  chart.mu = read_axis(table, "mu", friction_rule);
  chart.period_s = table.has("period_s") ? read_increasing(table, "period_s", not_negative)
                                         : std::vector<double>{0.0};

  const double points =
      static_cast<double>(chart.slope_deg.size()) * static_cast<double>(chart.mu.size()) *
      static_cast<double>(chart.period_s.size()) * static_cast<double>(levels.size());
  if (points > most_points) {
    table.report("",
                 "the chart has " + fmt::format("{:.0f}", points) +
                     " combinations of slope, friction, period and level",
                 "a million at most: fewer values of slope_deg, mu, period_s or intensity.levels");
  }
  std::vector<double> slopes;
  std::copy_if(chart.slope_deg.begin(), chart.slope_deg.end(), std::back_inserter(slopes),
               [](double slope) { return slope >= 0.0; });
  if (slopes.size() == 1 && chart.slope_deg.size() > 1) {
    table.report("slope_deg", "chart.slope_deg has one slope and its mirror image, which is one",
                 "give two or more of 0 and above");
  }
  const auto middle = [](const std::vector<double>& axis) {
    return axis.empty() ? 0.0 : axis[axis.size() / 2];
  };
  const TomlTable shown = table.table("shown");
  chart.shown_slope_deg = read_on_axis(shown, "slope_deg", slopes, middle(slopes));
  chart.shown_mu = read_on_axis(shown, "mu", chart.mu, middle(chart.mu));
  chart.shown_level = read_on_axis(shown, "level", levels, levels.empty() ? 0.0 : levels.back());
  for (const TomlTable& read : table.tables("read"))
    chart.questions.push_back(read_question(read, chart, slopes, levels));
  return chart;
}

}  // namespace glissade
