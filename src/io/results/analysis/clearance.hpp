// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/analysis/suite_mean.hpp"

namespace glissade {

// C is ClearanceResults or const ClearanceResults; so with the parts.

template <class Archive, class C>
void exchange_clearance(const Archive& archive, const IntensityScale& scale, C& clearance) {
  archive.attribute("factor", clearance.factor);
  name_attribute<OrientationRule>(archive, "orientation", orientation_rule_names(),
                                  clearance.orientation);
  const auto required = archive.group("required");
  exchange_suite_means(required, scale,
                       {"displacement_m", "m", "displacement, the largest over the periods"},
                       clearance.required, &RequiredClearance::largest);
  const Columns column(required, clearance.required);
  column("clearance_m", {"m", "required clearance, by the rule that is the attribute orientation"},
         &RequiredClearance::clearance_m);
  column("clearance_median_m", {"m", "the factor x median_displacement_m"},
         &RequiredClearance::median_m);
  column("clearance_highest_m", {"m", "the factor x highest_displacement_m"},
         &RequiredClearance::highest_m);
  exchange_suite_means(archive.group("by_period"), scale, {"displacement_m", "m", "displacement"},
                       clearance.by_period, std::identity{});
}

}  // namespace glissade
