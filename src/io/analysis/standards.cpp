// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

template <Standard standard>
bool compares(const TomlTable&, const StudyConfig& study) {
  return std::ranges::find(study.standards.compare, standard) != study.standards.compare.end();
}

void read_standards(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("standards");
  constexpr NumberRule importance_rule{"from 1 to 1.5",
                                       [](double x) { return x >= 1.0 && x <= 1.5; }};
  StandardsConfig& standards = study.standards;
  standards.compare =
      read_choices<Standard>(table, "compare", standard_names()).value_or(standards.compare);
  if (!table.has("compare")) table.report_missing("compare", "name the standards to compare with");
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
}

}  // namespace

AnalysisInFiles StandardsAnalysis::in_files() {
  return {
      .table = "standards",
      .read = read_standards,
      .keys = {{"compare", one_of(standard_names()) + ", or a list", "required",
                "prescriptive displacements to compare with"},
               {"importance", "number", fmt::format("{:g}", StandardsConfig{}.importance),
                "importance factor, 1 to 1.5"},
               {"seismic_design_category", "\"A\" to \"F\"", "\"D\"", "seismic design category"}},
      .needs = {{"intensity.measure = \"sds_g\" (the standards prescribe by S_DS)",
                 [](const TomlTable&, const StudyConfig& s) {
                   return s.intensity.measure == IntensityMeasure::sds_g;
                 }}},
      .key_needs = {{"standards", "importance", "\"asce7_16\" in compare",
                     compares<Standard::asce7_16>},
                    {"standards", "seismic_design_category", "\"seaoc_pv1_2012\" in compare",
                     compares<Standard::seaoc_pv1_2012>}},
      .needs_every_history = true,
      .of_stripes = true,
      .of_any_run = true};
}

}  // namespace glissade
