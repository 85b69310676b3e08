// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

void read_tipping(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("tipping");
  RigidBase& base = study.tipping.emplace();
  base.centre_of_mass_height_m = table.required_number("centre_of_mass_height_m", above_zero);
  base.width_m = table.required_number("base_width_m", above_zero);
}

}  // namespace

AnalysisInFiles TippingAnalysis::in_files() {
  return {
      .table = "tipping",
      .read = read_tipping,
      .keys =
          {{"centre_of_mass_height_m", "number", "required",
            "height of the array's centre of mass above the roof, m: onset of tipping is checked"},
           {"base_width_m", "number", "required", "width of the array's base along the slope, m"}},
      .sampled_friction = FrictionUse::read,
      .design_friction = FrictionUse::read};
}

}  // namespace glissade
