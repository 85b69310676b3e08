// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/in_files.hpp"
#include "keys/hazard_table.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

constexpr NumberRule annual_rate_rule{"above 0, at most 1",
                                      [](double x) { return x > 0.0 && x <= 1.0; },
                                      "a return period of 475 years is a rate of 1/475 = 0.0021"};

void read_hazard_of_study(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("hazard");
  study.hazard = read_hazard(table, study.intensity.measure.key(),
                             table.number("sds_g", above_zero).value_or(0.0));
  std::vector<double> targets = {rate_of(0.01, 50.0), 1.0 / 2475.0, 1.0 / 700.0};
  if (table.has("target_rates_per_year"))
    targets = read_increasing(table, "target_rates_per_year", annual_rate_rule);
  std::ranges::reverse(targets);
  if (!study.hazard) return;
  study.hazard->target_rates_per_year = targets;
  if (study.intensity.levels.empty()) return;
  check_events(
      table, *study.hazard, study.intensity.levels.front(),
      "check the curve's unit, which is that of intensity.measure, or begin the levels higher");
}

}  // namespace

AnalysisInFiles HazardAnalysis::in_files() {
  return {
      .table = "hazard",
      .read = read_hazard_of_study,
      .keys =
          {{"curve", "path", "none",
            "hazard curve: annual rate of exceedance; CSV with the columns annual_rate and the key "
            "of the study's intensity measure"},
           {"k0", "number", "none", "in place of a curve: annual rate of exceeding x = k0 x^-k"},
           {"k", "number", "none", "the exponent of that"},
           {"sds_g",
            "number",
            "none",
            "S_DS of the site, g: rates of the prescribed displacements; with k and without k0 the "
            "curve is assumed from it, by the risk target of ASCE 7",
            {{"measure = \"sds_g\"",
              [](auto&, auto& study) {
                return study.intensity.measure == IntensityMeasure::sds_g;
              }}}},
           {"design_life_years", "number", "required",
            "years over which slip is accumulated and probabilities are given"},
           {"target_rates_per_year", list_value, "1/700, 1/2475 and 1 % in 50 years",
            "the displacement exceeded at each of these annual rates is found"}},
      .needs = {needs_fragility},
      .needs_every_history = true,
      .of_any_run = true};
}

}  // namespace glissade
