// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {

AnalysisInFiles ClearanceAnalysis::in_files() {
  constexpr auto clearance = &StudyConfig::clearance;
  constexpr NumberRule factor_rule{"1 or more", [](double x) { return x >= 1.0; }};
  return {
      .table = "clearance",
      .keys =
          {{"factor", reads<clearance, &ClearanceConfig::factor>(factor_rule),
            "required clearance: this factor on the suite's mean displacement, the largest over "
            "the periods (Walters et al. 2012); also of a [chart]"},
           {"orientation",
            reads<clearance, &ClearanceConfig::orientation>(orientation_rule_names),
            "which mean is the recommended clearance: the largest or the median of the suite's "
            "means, each with all records in one orientation; Walters et al. (2012) state neither, "
            "and call it conservative to put the stronger component downhill",
            {{"several orientations",
              [](auto&, auto& s) {
                return s.orientation.choice == OrientationChoice::all_permutations ||
                       s.orientation.choice == OrientationChoice::azimuths ||
                       s.orientation.slope_axis.size() > 1;
              }}}},
           {"without_target",
            reads<clearance, &ClearanceConfig::without_target>(),
            "a clearance also of a suite that does not meet a design spectrum: not for design",
            {{"a measure other than \"sds_g\", which scales to the target, or a building period "
              "above 2 s",
              [](auto&, auto& s) { return may_miss_target(s); }}}}},
      .uses = {"model.displacement"},
      .stands_alone = true,
      .needs_every_history = true,
      .design_friction = FrictionUse::required};
}

}  // namespace glissade
