// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analysis/in_files.hpp"
#include "text/scan.hpp"
#include "toml/written_units.hpp"

namespace glissade {
namespace {

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

/// A negative slope counts for its mirror image, which must be there; with every orientation both
/// run twice.
void mirror_exactly(const TomlTable& root, StudyConfig& study) {
  std::vector<double>& slopes = study.quantities.at("roof", "slope_deg").values;
  const TomlTable roof = root.table("roof");
  for (double& slope : slopes) {
    if (slope >= 0.0) break;
    const auto mirror =
        std::find_if(slopes.begin(), slopes.end(), [&](double s) { return same(s, -slope); });
    if (mirror == slopes.end()) {
      roof.report("slope_deg",
                  "roof.slope_deg has " + shortest_decimal(slope) + " and not its mirror image " +
                      shortest_decimal(-slope) + ", which a chart needs",
                  "give both of each, or slopes of 0 and more with [orientation] choice = "
                  "\"all_permutations\"");
      return;
    }
    slope = -*mirror;
  }
}

/// A number, and the key that gives it.
struct Given {
  const char* key;
  std::optional<double> value;
};

/// A rise is in degrees already.
std::string as_given(const std::string& key, double value) {
  return with_unit_of(key == "rise_in_12" ? "slope_deg" : key, value);
}

/// A slope in degrees, given as slope_deg or as rise_in_12.
Given read_slope(const TomlTable& table) {
  if (!table.has("rise_in_12")) return {"slope_deg", table.number("slope_deg")};
  table.refuse_both("slope_deg", "rise_in_12", "give the slope one way");
  const auto rise = table.number("rise_in_12");
  return {"rise_in_12", rise ? std::optional(slope_of_rise_deg(*rise)) : std::nullopt};
}

/// A value of an axis; `otherwise` where the key is not there.
double on_axis(const TomlTable& table, const Given& given, const std::vector<double>& axis,
               double otherwise) {
  const auto& [key, value] = given;
  if (!value || axis.empty()) return otherwise;
  const auto found =
      std::find_if(axis.begin(), axis.end(), [&](double x) { return same(x, *value); });
  if (found != axis.end()) return *found;
  table.report(key, table.name_of(key) + " = " + as_given(key, *value) + " is not on the chart",
               "give one of its values, " + shortest_decimal(axis.front()) + " to " +
                   shortest_decimal(axis.back()));
  return otherwise;
}

/// A value within an axis.
double within_axis(const TomlTable& table, const Given& given, const std::vector<double>& axis) {
  const char* key = given.key;
  if (!table.has(key)) table.report_missing(key);
  const double value = given.value.value_or(0.0);
  if (!given.value || axis.empty() || same(value, axis.front())) return value;
  if (value < axis.front() || value > axis.back()) {
    table.report(key, table.name_of(key) + " = " + as_given(key, value) + " is outside the chart",
                 "a chart is not extrapolated: stay from " + shortest_decimal(axis.front()) +
                     " to " + shortest_decimal(axis.back()));
  }
  return value;
}

ChartQuestion read_question(const TomlTable& table, const std::vector<double>& mu,
                            const std::vector<double>& slopes, const std::vector<double>& levels) {
  ChartQuestion question;
  question.level = on_axis(table, {"level", table.number("level")}, levels,
                           levels.empty() ? 0.0 : levels.back());
  question.slope_deg = within_axis(table, read_slope(table), slopes);
  if (table.has("mu") == table.has("displacement_m")) {
    table.report("", "a [[chart.read]] gives a displacement or a friction",
                 "give mu (and read the displacement), or displacement_m (and read the friction)");
    table.number("mu");
    table.number("displacement_m");
  } else if (table.has("mu")) {
    question.mu = within_axis(table, {"mu", table.number("mu", friction_rule)}, mu);
  } else {
    question.displacement_m = table.required_number("displacement_m", above_zero);
  }
  return question;
}

void read_chart(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("chart");
  ChartConfig& chart = *study.chart;  // without_target is read
  mirror_exactly(root, study);
  const std::vector<double>& levels = study.intensity.levels;
  // Of what is drawn the chart has one column, under its mean.
  const Quantity& friction = study.quantities.at("friction", "mu");
  const std::vector<double> mu =
      friction.is_drawn() ? std::vector{mean(*friction.drawn)} : friction.values;
  std::vector<double> slopes;
  std::ranges::copy_if(study.quantities.at("roof", "slope_deg").values, std::back_inserter(slopes),
                       [](double slope) { return slope >= 0.0; });
  if (slopes.size() < 2) {
    table.report("", "a chart needs two slopes or more of 0 and above",
                 "give roof.slope_deg (or rise_in_12) as a list, or { from, to, count }");
  }
  const auto middle = [](const std::vector<double>& axis) {
    return axis.empty() ? 0.0 : axis[axis.size() / 2];
  };
  const TomlTable shown = table.table("shown");
  chart.shown_slope_deg = on_axis(shown, read_slope(shown), slopes, middle(slopes));
  chart.shown_mu = on_axis(shown, {"mu", shown.number("mu")}, mu, middle(mu));
  chart.shown_level = on_axis(shown, {"level", shown.number("level")}, levels,
                              levels.empty() ? 0.0 : levels.back());
  for (const TomlTable& read : table.tables("read"))
    chart.questions.push_back(read_question(read, mu, slopes, levels));
}

}  // namespace

AnalysisInFiles ChartAnalysis::in_files() {
  return {
      .table = "chart",
      .read = read_chart,
      .keys = {{"shown", "{ slope_deg or rise_in_12, mu, level }", "the middle; the highest level",
                "slope, friction and level of the sections that the figures show"},
               {"read",
                "[[chart.read]] with level, slope_deg or rise_in_12, and mu or displacement_m",
                "none", "a displacement, or the friction required for one, read off the chart"},
               {"without_target",
                reads<&StudyConfig::chart, &ChartConfig::without_target>(),
                "design displacements also of a suite that does not meet its design spectrum: not "
                "for design",
                {{"measure = \"mce_fraction\", or a building period above 2 s",
                  [](auto&, auto& s) {
                    return s.intensity.measure.is_of_design_spectrum() && may_miss_target(s);
                  }}}}},
      .uses = {"model.displacement", "sampling.bootstrap_replicates", "standards.compare"},
      .stands_alone = true,
      .needs_every_history = true,
      .sampled_friction = FrictionUse::required};
}

}  // namespace glissade
