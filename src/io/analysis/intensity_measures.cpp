// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

void read_intensity_measures(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("intensity_measures");
  constexpr NumberRule period_rule{"from 0.02 to 4",
                                   [](double x) { return x >= 0.02 && x <= 4.0; }};
  IntensityMeasuresConfig& ranked = study.intensity_measures.emplace();
  if (table.has("sa_periods_s"))
    ranked.sa_periods_s = read_increasing(table, "sa_periods_s", period_rule);
}

}  // namespace

AnalysisInFiles IntensityMeasuresAnalysis::in_files() {
  return {
      .table = "intensity_measures",
      .read = read_intensity_measures,
      .keys = {{"sa_periods_s", list_value, "0.2, 0.5, 1, 2",
                "intensity measures are ranked, spectral accelerations at these periods (0.02 to 4 "
                "s) among them"}},
      .needs = {needs_fragility,
                {"another intensity.measure than \"ppa_g\", whose factor on a record depends on "
                 "the roof",
                 [](auto&, auto& s) { return s.intensity.measure != IntensityMeasure::ppa_g; }}},
      .of_any_run = true};
}

}  // namespace glissade
