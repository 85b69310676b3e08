// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
AnalysisInFiles TippingAnalysis::in_files() {
  constexpr auto tipping = &StudyConfig::tipping;
  return {
      .table = "tipping",
      .keys =
          {{"centre_of_mass_height_m",
            requires_number<tipping, &RigidBase::centre_of_mass_height_m>(above_zero),
            "height of the array's centre of mass above the roof, m: onset of tipping is checked"},
           {"base_width_m", requires_number<tipping, &RigidBase::width_m>(above_zero),
            "width of the array's base along the slope, m"}},
      .sampled_friction = FrictionUse::read,
      .design_friction = FrictionUse::read};
}

}  // namespace glissade
