// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

// C is ClearanceResults or const ClearanceResults; so with the parts.
constexpr NumberRule factor_rule{"1 or more", [](double x) { return x >= 1.0; }};

void read_clearance(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("clearance");
  ClearanceConfig clearance;
  clearance.factor = table.number("factor", factor_rule).value_or(clearance.factor);
  clearance.orientation = table.choice<OrientationRule>("orientation", orientation_rule_names())
                              .value_or(clearance.orientation);
  clearance.without_target = table.flag("without_target").value_or(clearance.without_target);
  study.clearance = clearance;
}

}  // namespace

AnalysisInFiles ClearanceAnalysis::in_files() {
  return {
      .table = "clearance",
      .read = read_clearance,
      .keys =
          {{"factor", "number", fmt::format("{:g}", ClearanceConfig{}.factor),
            "required clearance: this factor on the suite's mean displacement, the largest over "
            "the periods (Walters et al. 2012); also of a [chart]"},
           {"orientation", one_of(orientation_rule_names()),
            quoted(orientation_rule_names(), ClearanceConfig{}.orientation),
            "which mean is the recommended clearance: the largest or the median of the suite's "
            "means, each "
            "with all records in one orientation; Walters et al. (2012) state neither, and call it "
            "conservative to put the stronger component downhill"},
           {"without_target", "true or false", "false",
            "a clearance also of a suite that does not meet a design spectrum: not for design"}},
      .key_needs = {{"clearance", "orientation", "several orientations",
                     [](const TomlTable&, const StudyConfig& s) {
                       return s.orientation.choice == OrientationChoice::all_permutations ||
                              s.orientation.choice == OrientationChoice::azimuths ||
                              s.orientation.slope_axis.size() > 1;
                     }},
                    {"clearance", "without_target",
                     "a measure other than \"sds_g\", which scales to the target, or a building "
                     "period above 2 s",
                     [](const TomlTable&, const StudyConfig& s) { return may_miss_target(s); }}},
      .uses = {"model.displacement"},
      .stands_alone = true,
      .needs_every_history = true,
      .design_friction = FrictionUse::required};
}

}  // namespace glissade
