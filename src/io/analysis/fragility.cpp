// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

void read_fragility(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("fragility");
  FragilityConfig fragility;
  fragility.thresholds_m = read_increasing(table, "thresholds_m", above_zero);
  fragility.stop_at_largest = table.flag("stop_at_largest").value_or(false);
  study.fragility = fragility;
}

}  // namespace

AnalysisInFiles FragilityAnalysis::in_files() {
  return {
      .table = "fragility",
      .read = read_fragility,
      .keys =
          {{"thresholds_m", list_value, "required",
            "clearances, m: probability that displacement exceeds each"},
           {"stop_at_largest", "true or false", "false",
            "do not run levels above the one at which a history reaches the largest threshold"}},
      .uses = {"model.displacement", "sampling.target_error", "sampling.scrambles",
               "sampling.bootstrap_replicates", "standards.compare"},
      .stands_alone = true,
      .of_stripes = true,
      .sampled_friction = FrictionUse::usual,
      .design_friction = FrictionUse::usual};
}

/// Its keys are in [sampling].
AnalysisInFiles SamplingErrorAnalysis::in_files() { return {}; }

}  // namespace glissade
