// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

void read_verdict(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("verdict");
  constexpr NumberRule share_rule{"above 0 and below 1",
                                  [](double x) { return x > 0.0 && x < 1.0; }};
  std::vector<double>& exceedance = study.verdict.emplace().exceedance;
  exceedance = table.numbers("exceedance", share_rule).value_or(exceedance);
  if (exceedance.empty() || !std::ranges::is_sorted(exceedance, std::greater_equal<>()))
    table.report("exceedance", "verdict.exceedance is not a decreasing list of probabilities",
                 "for example exceedance = [0.1, 0.05, 0.01]");
}

bool draws_neither_slope_nor_period(const TomlTable&, const StudyConfig& study) {
  return !study.quantities.at("roof", "slope_deg").is_drawn() &&
         !study.quantities.at("building", "period_s").is_drawn();
}

bool has_level_of_mce(const TomlTable&, const StudyConfig& study) {
  const std::vector<double>& levels = study.intensity.levels;
  return std::ranges::any_of(
      levels, [&](double l) { return level_at(levels, mce_over_dbe * l) < levels.size(); });
}

}  // namespace

AnalysisInFiles VerdictAnalysis::in_files() {
  return {
      .table = "verdict",
      .read = read_verdict,
      .keys = {{"exceedance", "list", "[0.1, 0.05, 0.01]",
                "decreasing. The prescribed displacement passes if it is exceeded at DBE with at "
                "most the first probability; for each one the displacement with that probability "
                "is given"}},
      .needs = {{"[standards]", [](auto& root, auto&) { return root.has("standards"); }},
                {"a slope and a building period that are numbers or lists, not drawn",
                 draws_neither_slope_nor_period},
                {"intensity.levels with 1.5 times one of them (the MCE of a design earthquake)",
                 has_level_of_mce}},
      .uses = {"model.displacement", "friction.neighbour_mu", "friction.neighbour_over_mu",
               "standards.compare"},
      .stands_alone = true,
      .needs_every_history = true,
      .of_any_run = true,
      .sampled_friction = FrictionUse::read,
      .design_friction = FrictionUse::read};
}

}  // namespace glissade
