// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "glissade/study/cases/sample_points.hpp"

namespace glissade {
namespace {

void refuse_others(const TomlTable& root, StudyConfig&) {
  for (const AnalysisInFiles& other : analyses_in_files()) {
    if (other.table != nullptr && other.table != std::string("rare") && root.has(other.table))
      root.report("rare",
                  std::string("[rare] draws from wider distributions, and [") + other.table +
                      "] would count its samples as drawn",
                  "divide the study into two");
  }
}

}  // namespace

AnalysisInFiles RareAnalysis::in_files() {
  constexpr auto rare = &StudyConfig::rare;
  constexpr NumberRule widening_rule{"from 1 to 10",
                                     [](double x) { return x >= 1.0 && x <= 10.0; }};
  return {
      .table = "rare",
      .read = refuse_others,
      .keys = {{"thresholds_m", reads<rare, &RareConfig::thresholds_m>(above_zero),
                "clearances, m: small probabilities that displacement reaches each, at each level; "
                "drawn quantities without bounds are drawn from wider distributions, with weights; "
                "stands alone"},
               {"widening", reads<rare, &RareConfig::widening>(widening_rule),
                "factor on the standard normal numbers of these quantities, 1 to 10"}},
      .needs = {{"a drawn quantity without bounds (normal or lognormal)",
                 [](auto&, auto& s) {
                   return s.samples_friction() && !unbounded_dimensions(s).empty();
                 }},
                {"sampling.scrambles of 8 or more, which give its sampling error",
                 [](auto&, auto& s) { return s.sampling.scrambles >= least_scrambles; }}},
      .uses = {"model.displacement", "sampling.scrambles"},
      .stands_alone = true,
      .needs_every_history = true,
      .sampled_friction = FrictionUse::usual};
}

}  // namespace glissade
