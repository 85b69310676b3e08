// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/analysis_tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "enum_names.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/analysis/verdict.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "study/hazard_table.hpp"
#include "text/scan.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

template <class T>
bool each_once(std::vector<T> values) {
  std::ranges::sort(values);
  return !values.empty() && std::ranges::adjacent_find(values) == values.end();
}

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

/// A slope in degrees, given as slope_deg or as rise_in_12.
Given read_slope(const TomlTable& table) {
  if (!table.has("rise_in_12")) return {"slope_deg", table.number("slope_deg")};
  if (table.has("slope_deg"))
    table.report(
        "slope_deg",
        table.name_of("slope_deg") + " and " + table.name_of("rise_in_12") + " are both given",
        "give the slope one way");
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
  table.report(key, table.name_of(key) + " = " + shortest_decimal(*value) + " is not on the chart",
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
    table.report(key,
                 table.name_of(key) + " = " + shortest_decimal(value) + " is outside the chart",
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

constexpr NumberRule factor_rule{"1 or more", [](double x) { return x >= 1.0; }};

void read_chart(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("chart");
  ChartConfig chart;
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
  chart.without_target = table.flag("without_target").value_or(chart.without_target);
  study.chart = chart;
}

void read_clearance(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("clearance");
  ClearanceConfig clearance;
  clearance.factor = table.number("factor", factor_rule).value_or(clearance.factor);
  clearance.orientation = table.choice<OrientationRule>("orientation", orientation_rule_names())
                              .value_or(clearance.orientation);
  clearance.without_target = table.flag("without_target").value_or(clearance.without_target);
  study.clearance = clearance;
}

void read_fragility(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("fragility");
  FragilityConfig fragility;
  fragility.thresholds_m = read_increasing(table, "thresholds_m", above_zero);
  fragility.stop_at_largest = table.flag("stop_at_largest").value_or(false);
  study.fragility = fragility;
}

/// An analysis that needs another one, or a model.
void needs(const TomlTable& root, const char* table, bool met, const char* what) {
  if (met) return;
  root.report(table, std::string("[") + table + "] needs " + what,
              std::string("give it, or leave out [") + table + "]");
}

void read_standards(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("standards");
  constexpr NumberRule importance_rule{"from 1 to 1.5",
                                       [](double x) { return x >= 1.0 && x <= 1.5; }};
  StandardsConfig& standards = study.standards;
  standards.compare =
      table.choices<Standard>("compare", standard_names()).value_or(standards.compare);
  if (!table.has("compare")) table.report_missing("compare", "name the standards to compare with");
  if (table.has("compare") && !each_once(standards.compare))
    table.report("compare", "standards.compare names none, or one twice", "name each once");
  standards.importance = table.number("importance", importance_rule).value_or(standards.importance);
  using Sdc = SeismicDesignCategory;
  standards.category = table
                           .choice<Sdc>("seismic_design_category", {{"A", Sdc::a},
                                                                    {"B", Sdc::b},
                                                                    {"C", Sdc::c},
                                                                    {"D", Sdc::d},
                                                                    {"E", Sdc::e},
                                                                    {"F", Sdc::f}})
                           .value_or(standards.category);
  if (!standards.compare.empty() && study.intensity.measure != IntensityMeasure::sds_g) {
    table.report(
        "compare",
        "standards.compare needs intensity.measure = \"sds_g\": the standards prescribe by S_DS",
        "measure by sds_g, or leave [standards] out");
  }
  needs(root, "standards", root.has("fragility") || root.has("chart") || root.has("verdict"),
        "[fragility], [chart] or [verdict]");
}

void read_impact(const TomlTable& root, StudyConfig& study) {
  study.impact = root.table("impact").exists();
  needs(root, "impact", root.has("fragility"), "[fragility] thresholds_m");
}

void read_shape(const TomlTable& root, StudyConfig& study) {
  study.shape = root.table("shape").exists();
  needs(root, "shape", root.has("fragility"), "[fragility] thresholds_m");
}

void read_base_shear(const TomlTable& root, StudyConfig& study) {
  study.base_shear = root.table("base_shear").exists();
  needs(root, "base_shear", study.two_axes(), "[model] axes = 2");
}

void read_tipping(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("tipping");
  RigidBase& base = study.tipping.emplace();
  base.centre_of_mass_height_m = table.required_number("centre_of_mass_height_m", above_zero);
  base.width_m = table.required_number("base_width_m", above_zero);
}

void read_verdict(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("verdict");
  constexpr NumberRule share_rule{"above 0 and below 1",
                                  [](double x) { return x > 0.0 && x < 1.0; }};
  std::vector<double>& exceedance = study.verdict.emplace().exceedance;
  exceedance = table.numbers("exceedance", share_rule).value_or(exceedance);
  if (exceedance.empty() || !std::ranges::is_sorted(exceedance, std::greater_equal<>()))
    table.report("exceedance", "verdict.exceedance is not a falling list of probabilities",
                 "for example exceedance = [0.1, 0.05, 0.01]");
  needs(root, "verdict", root.has("standards"), "[standards] compare");
  const std::vector<double>& levels = study.intensity.levels;
  needs(root, "verdict",
        std::ranges::any_of(
            levels, [&](double l) { return level_at(levels, mce_over_dbe * l) < levels.size(); }),
        "intensity.levels with 1.5 times one of them: the MCE of a design earthquake");
}

void read_sensitivity(const TomlTable& root, StudyConfig& study) {
  study.sensitivity = root.table("sensitivity").exists();
  needs(root, "sensitivity", root.has("fragility"), "[fragility] thresholds_m");
  needs(root, "sensitivity", !drawn_factors(study).empty(), "a quantity that is drawn");
  needs(root, "sensitivity", study.sampling.samples >= 2, "sampling.samples of 2 or more");
  needs(root, "sensitivity",
        (study.orientation.choice == OrientationChoice::random ||
         study.orientation.choice == OrientationChoice::as_recorded) &&
            study.orientation.slope_axis.size() == 1,
        "one orientation of a sample: orientation.choice = \"random\" or \"as_recorded\", one "
        "slope_axis");
}

void read_rare(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("rare");
  constexpr NumberRule widening_rule{"from 1 to 10",
                                     [](double x) { return x >= 1.0 && x <= 10.0; }};
  RareConfig& rare = study.rare.emplace();
  rare.thresholds_m = read_increasing(table, "thresholds_m", above_zero);
  rare.widening = table.number("widening", widening_rule).value_or(rare.widening);
  needs(root, "rare", study.samples_friction() && !unbounded_dimensions(study).empty(),
        "a drawn quantity without bounds (normal or lognormal)");
  needs(root, "rare", study.sampling.scrambles >= least_scrambles,
        "sampling.scrambles of 8 or more, which give its sampling error");
  for (const char* other :
       {"fragility", "chart", "clearance", "base_shear", "tipping", "verdict", "sensitivity"}) {
    if (root.has(other))
      root.report("rare",
                  std::string("[rare] draws from wider distributions, and [") + other +
                      "] would count its samples as drawn",
                  "divide the study into two");
  }
}

void read_intensity_measures(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("intensity_measures");
  constexpr NumberRule period_rule{"from 0.02 to 4",
                                   [](double x) { return x >= 0.02 && x <= 4.0; }};
  IntensityMeasuresConfig& ranked = study.intensity_measures.emplace();
  if (table.has("sa_periods_s"))
    ranked.sa_periods_s = read_increasing(table, "sa_periods_s", period_rule);
  needs(root, "intensity_measures", root.has("fragility"), "[fragility] thresholds_m");
  needs(root, "intensity_measures", study.intensity.measure != IntensityMeasure::ppa_g,
        "another intensity.measure than \"ppa_g\", whose factor on a record depends on the roof");
}

/// Which values of drawn friction an analysis reads, and no more are run than are read.
void check_friction_values(const TomlTable& root, const StudyConfig& study) {
  if (!study.quantities.at("friction", "mu").is_drawn() &&
      !study.quantities.at("friction", "across_mu").is_drawn())
    return;
  const auto runs = [&](FrictionValue value) {
    return std::ranges::find(study.friction.values, value) != study.friction.values.end();
  };
  const bool by_combination = study.fragility || study.tipping || study.verdict,
             by_condition = study.clearance || study.base_shear;
  const bool sampled = runs(FrictionValue::as_drawn), design = runs(FrictionValue::design);
  const auto report = [&](const char* what, const char* suggestion) {
    root.table("friction").report("value", what, suggestion);
  };
  if (study.clearance && !design)
    report(
        "[clearance] is found with the design value of friction, mean - 2 std, which "
        "friction.value leaves out",
        "add \"design\", or leave friction.value out");
  if (study.chart && !sampled)
    report("[chart] is read from sampled friction, which friction.value leaves out",
           "add \"sampled\", or leave friction.value out");
  if (!sampled || !design) return;
  if (!by_combination && !study.chart)
    report("no analysis of the study reads \"sampled\" of friction.value", "leave it out");
  if (!by_combination && !by_condition)
    report("no analysis of the study reads \"design\" of friction.value", "leave it out");
}

/// The table of an analysis.
struct AnalysisTable {
  const char* name;
  void (*read)(const TomlTable& root, StudyConfig& study);
  bool stands_alone;         ///< or is read beside one that does
  bool needs_every_history;  ///< those beyond the largest threshold too
  bool of_any_run = false;   ///< can be added to finished results: every run keeps what it reads
};
constexpr AnalysisTable analysis_tables[] = {
    {"fragility", read_fragility, true, false},
    {"chart", read_chart, true, true},
    {"clearance", read_clearance, true, true},
    {"base_shear", read_base_shear, true, true},
    {"standards", read_standards, false, true, true},
    {"impact", read_impact, false, true},
    {"hazard", read_hazard, false, true, true},
    {"tipping", read_tipping, false, false},
    {"verdict", read_verdict, true, true, true},
    {"sensitivity", read_sensitivity, false, false, true},
    {"shape", read_shape, false, false, true},
    {"rare", read_rare, true, true},
    {"intensity_measures", read_intensity_measures, false, false, true}};

/// "[fragility], [chart] ..." of those for which a property holds.
template <class Property>
std::string names_of(Property property) {
  std::string names;
  for (const AnalysisTable& analysis : analysis_tables) {
    if (property(analysis)) names += std::string(names.empty() ? "[" : ", [") + analysis.name + "]";
  }
  return names;
}

}  // namespace

std::vector<std::string> tables_of_same_histories() {
  std::vector<std::string> names;
  for (const AnalysisTable& analysis : analysis_tables) {
    if (analysis.of_any_run) names.emplace_back(analysis.name);
  }
  return names;
}

void read_analyses(const TomlTable& root, StudyConfig& study) {
  for (const AnalysisTable& analysis : analysis_tables) {
    if (root.has(analysis.name)) analysis.read(root, study);
  }
  check_friction_values(root, study);
  const std::vector<double>& levels = study.intensity.levels;
  if (levels.size() == 1 && levels.front() == 0.0)
    root.table("intensity").report("levels", "intensity.levels has no level above 0");
  if (names_of([&](const auto& a) { return a.stands_alone && root.has(a.name); }).empty()) {
    root.report("", "the study has no analysis",
                "give " + names_of([](const auto& a) { return a.stands_alone; }) + "; " +
                    names_of([](const auto& a) { return !a.stands_alone; }) +
                    " are read beside one of them");
  }
  const std::string others =
      names_of([&](const auto& a) { return a.needs_every_history && root.has(a.name); });
  if (study.fragility && study.fragility->stop_at_largest && !others.empty()) {
    root.table("fragility")
        .report("stop_at_largest",
                "fragility.stop_at_largest = true leaves out histories beyond the largest "
                "threshold, which " +
                    others + " needs",
                "leave it out, or leave out " + others);
  }
}

}  // namespace glissade
