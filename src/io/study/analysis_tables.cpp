// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/analysis_tables.hpp"

#include <algorithm>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

bool is_given(const AnalysisInFiles& analysis, const TomlTable& root) {
  return analysis.table != nullptr && root.has(analysis.table);
}

/// A value of drawn friction that the study leaves out or runs for nothing.
void check_friction_value(const TomlTable& root, bool is_run, bool others_are_run,
                          const std::string& value, FrictionUse AnalysisInFiles::*use) {
  const TomlTable friction = root.table("friction");
  bool is_read = false;
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (!is_given(analysis, root)) continue;
    is_read |= analysis.*use != FrictionUse::none;
    if (!is_run && analysis.*use == FrictionUse::required)
      friction.report("value",
                      std::string("[") + analysis.table + "] is found with " + value +
                          " friction, which friction.value leaves out",
                      "add \"" + value + "\", or leave friction.value out");
  }
  if (is_run && others_are_run && !is_read)
    friction.report("value", "no analysis of the study reads \"" + value + "\" of friction.value",
                    "leave it out");
}

/// Which values of drawn friction an analysis reads, and no more are run than are read.
void check_friction_values(const TomlTable& root, const StudyConfig& study) {
  if (!study.quantities.at("friction", "mu").is_drawn() &&
      !study.quantities.at("friction", "across_mu").is_drawn())
    return;
  const std::vector<FrictionValue>& values = study.friction.values;
  const bool sampled = study.samples_friction(),
             design = std::ranges::find(values, FrictionValue::design) != values.end();
  check_friction_value(root, sampled, design, "sampled", &AnalysisInFiles::sampled_friction);
  check_friction_value(root, design, sampled, "design", &AnalysisInFiles::design_friction);
}

}  // namespace

const std::vector<AnalysisInFiles>& analyses_in_files() {
  static const std::vector<AnalysisInFiles> all = [] {
    std::vector<AnalysisInFiles> analyses;
    for (const auto& in_files : Analyses::in_files) analyses.push_back(in_files());
    return analyses;
  }();
  return all;
}

std::vector<std::string> tables_where(const std::function<bool(const AnalysisInFiles&)>& property) {
  std::vector<std::string> names;
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (analysis.table != nullptr && property(analysis)) names.emplace_back(analysis.table);
  }
  return names;
}

std::string listed(const std::vector<std::string>& tables, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < tables.size(); ++i)
    text += (i == 0 ? "" : i + 1 < tables.size() ? ", " : last) + "[" + tables[i] + "]";
  return text;
}

bool may_miss_target(const StudyConfig& study) {
  return study.intensity.measure != IntensityMeasure::sds_g ||
         (study.intensity.scaling_rule == ScalingRule::walters_2012 &&
          study.quantities.at("building", "period_s").largest() *
                  study.quantities.at("building", "period_ratio").largest() >
              longest_scaled_period_s);
}

std::vector<FrictionValue> usual_friction_values(const TomlTable& root) {
  const auto is_usual = [&](FrictionUse AnalysisInFiles::*use) {
    return std::ranges::any_of(analyses_in_files(), [&](const AnalysisInFiles& analysis) {
      return is_given(analysis, root) && analysis.*use >= FrictionUse::usual;
    });
  };
  const bool design = is_usual(&AnalysisInFiles::design_friction);
  std::vector<FrictionValue> values;
  if (!design || is_usual(&AnalysisInFiles::sampled_friction))
    values.push_back(FrictionValue::as_drawn);
  if (design) values.push_back(FrictionValue::design);
  return values;
}

void read_analyses(const TomlTable& root, StudyConfig& study) {
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (!is_given(analysis, root)) continue;
    read_keys(analysis.keys, root.table(analysis.table), study);
    if (analysis.read != nullptr) analysis.read(root, study);
    const std::string table = listed({analysis.table});
    if (study.by_stripes && !analysis.of_stripes)
      root.report(analysis.table,
                  table +
                      " reads each record at every level, and by suite.stripes a record is run "
                      "at one level only",
                  "leave out " + table + ", or run one suite at all levels (suite.file)");
    for (const StudyNeed& need : analysis.needs) {
      if (!need.is_met(root, study))
        root.report(analysis.table, table + " needs " + need.what,
                    "give it, or leave out " + table);
    }
  }
  check_friction_values(root, study);
  const std::vector<double>& levels = study.intensity.levels;
  if (levels.size() == 1 && levels.front() == 0.0)
    root.table("intensity").report("levels", "intensity.levels has no level above 0");
  if (tables_where([&](const auto& a) { return a.stands_alone && root.has(a.table); }).empty()) {
    root.report("", "the study has no analysis",
                "give " + listed(tables_where([](const auto& a) { return a.stands_alone; })) +
                    "; " + listed(tables_where([](const auto& a) { return !a.stands_alone; })) +
                    " are read beside one of them");
  }
  const std::string others = listed(
      tables_where([&](const auto& a) { return a.needs_every_history && root.has(a.table); }));
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
