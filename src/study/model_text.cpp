// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_text.hpp"

#include <fmt/format.h>

namespace glissade {
namespace {

std::string building_text(const BuildingConfig& building) {
  if (!building.strength) return "";
  const StrengthConfig& strength = *building.strength;
  return fmt::format(
      "It yields at {}, bilinear with kinematic hardening, with {:g} of its stiffness from there "
      "on. ",
      strength.response_modification
          ? fmt::format("the design spectrum's elastic demand at its period over R = {:g}",
                        *strength.response_modification)
          : fmt::format("{:g} of its weight", *strength.yield_coefficient),
      strength.hardening_ratio);
}

std::string friction_text(const FrictionLaw& law) {
  std::string text;
  if (law.static_ratio != 1.0) {
    text += fmt::format("At rest friction holds {:g} times what it does while the array slides. ",
                        law.static_ratio);
  }
  if (law.depends_on_speed()) {
    text += fmt::format(
        "The coefficients are those of slow sliding; with the speed v they go to {0:g} times that, "
        "as {0:g} - {1:g} exp(-{2:g} v) with v in m/s. ",
        law.fast_ratio, law.fast_ratio - 1.0, law.rate_spm);
  }
  return text;
}

std::string displacement_text(const ModelConfig& model) {
  if (model.axes == SlidingAxes::one) return "";
  if (model.displacement == DisplacementMeasure::vector)
    return "The longest displacement vector in plan. ";
  return "The SRSS of the separate maxima along and across the slope (Walters et al. 2012), which "
         "is not less than the longest displacement vector. ";
}

}  // namespace

ModelText model_text(const Plan& plan) {
  return {describe(plan.kernel.kernel) + "; because " + plan.kernel.reason,
          building_text(plan.config.building), friction_text(plan.config.friction.law),
          displacement_text(plan.config.model)};
}

}  // namespace glissade
