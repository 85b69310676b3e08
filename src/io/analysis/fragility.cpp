// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

/// Each has its fits, intervals and curves.
void check_thresholds(const TomlTable& root, StudyConfig& study) {
  constexpr std::size_t most = 200;
  const std::size_t count = study.fragility ? study.fragility->thresholds_m.size() : 0;
  if (count > most)
    root.table("fragility")
        .report("thresholds_m", fmt::format("fragility.thresholds_m has {} clearances", count),
                fmt::format("give {} at most: their curves cannot be distinguished", most));
}

}  // namespace

AnalysisInFiles FragilityAnalysis::in_files() {
  constexpr auto fragility = &StudyConfig::fragility;
  return {
      .table = "fragility",
      .read = check_thresholds,
      .keys = {{"thresholds_m", reads<fragility, &FragilityConfig::thresholds_m>(above_zero),
                "clearances, m: probability that displacement exceeds each"},
               {"stop_at_largest",
                reads<fragility, &FragilityConfig::stop_at_largest>(),
                "do not run levels above the one at which a history reaches the largest threshold",
                {{"a study without suite.stripes", [](auto&, auto& s) { return !s.by_stripes; }}}}},
      .uses = {"model.displacement", "sampling.target_error", "sampling.scrambles",
               "sampling.bootstrap_replicates", "standards.compare"},
      .stands_alone = true,
      .of_stripes = true,
      .sampled_friction = FrictionUse::usual,
      .design_friction = FrictionUse::usual};
}

/// Its keys are in [sampling].
AnalysisInFiles SamplingErrorAnalysis::in_files() { return {}; }

AnalysisInFiles ModelUncertaintyAnalysis::in_files() { return {}; }

}  // namespace glissade
