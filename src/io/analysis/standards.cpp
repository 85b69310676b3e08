// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

template <Standard standard>
bool compares(const TomlTable&, const StudyConfig& study) {
  return std::ranges::find(study.standards.compare, standard) != study.standards.compare.end();
}

void read_category(const TomlTable& table, const char* key, StudyConfig& study) {
  using Sdc = SeismicDesignCategory;
  study.standards.category = table
                                 .choice<Sdc>(key, {{"A", Sdc::a},
                                                    {"B", Sdc::b},
                                                    {"C", Sdc::c},
                                                    {"D", Sdc::d},
                                                    {"E", Sdc::e},
                                                    {"F", Sdc::f}})
                                 .value_or(study.standards.category);
}

void check_compared(const TomlTable& root, StudyConfig&) {
  const TomlTable table = root.table("standards");
  if (!table.has("compare")) table.report_missing("compare", "name the standards to compare with");
}

}  // namespace

AnalysisInFiles StandardsAnalysis::in_files() {
  constexpr auto standards = &StudyConfig::standards;
  constexpr NumberRule importance_rule{"from 1 to 1.5",
                                       [](double x) { return x >= 1.0 && x <= 1.5; }};
  return {
      .table = "standards",
      .read = check_compared,
      .keys = {{"compare", reads<standards, &StandardsConfig::compare>(standard_names),
                "prescriptive displacements to compare with"},
               {"importance",
                reads<standards, &StandardsConfig::importance>(importance_rule),
                "importance factor, 1 to 1.5",
                {{"\"asce7_16\" in compare", compares<Standard::asce7_16>}}},
               {"seismic_design_category",
                Reading{"\"A\" to \"F\"", "\"D\"", read_category},
                "seismic design category",
                {{"\"seaoc_pv1_2012\" in compare", compares<Standard::seaoc_pv1_2012>}}}},
      .needs = {{"intensity.measure = \"sds_g\" (the standards prescribe by S_DS)",
                 [](auto&, auto& s) { return s.intensity.measure == IntensityMeasure::sds_g; }}},
      .needs_every_history = true,
      .of_stripes = true,
      .of_any_run = true};
}

}  // namespace glissade
