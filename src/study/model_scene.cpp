// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_scene.hpp"

#include <cmath>
#include <numbers>

#include "glissade/core/units.hpp"
#include "glissade/motion/design_spectrum.hpp"

namespace glissade {

Yielding strength_of(const Plan& plan, double period_s) {
  const std::optional<StrengthConfig>& strength = plan.config.building.strength;
  if (!strength || period_s == 0.0) return {};
  if (strength->yield_coefficient)
    return yielding_for(YieldCoefficient{*strength->yield_coefficient}, strength->hardening_ratio);
  const auto& own = plan.config.intensity.target;
  const TargetSpectrum spectrum(own ? *own : *plan.suite.target);
  return yielding_for(ReducedDemand{spectrum.design_sa_g(period_s) * standard_gravity_mps2,
                                    *strength->response_modification},
                      strength->hardening_ratio);
}

TwoAxisBlock two_axis_block(const Plan& plan, std::size_t run, std::size_t sample) {
  const SamplePoint& s = plan.samples[sample];
  const FrictionRun& friction = plan.runs[run];
  const double along = friction.friction[sample];
  const double across = friction.friction_across.empty() ? along : friction.friction_across[sample];
  // A slope that falls toward -x falls toward +x, half a turn on.
  const double turn = s.slope_deg < 0.0 ? std::numbers::pi : 0.0;
  return {.friction = {along, across},
          .slope_rad = std::abs(s.slope_deg) * rad_per_deg,
          .azimuth_rad = s.azimuth_deg * rad_per_deg + turn,
          .law = plan.config.friction.law};
}

BiaxialBuilding biaxial_building(const Plan& plan, std::size_t sample) {
  const SamplePoint& s = plan.samples[sample];
  const double second_s = plan.config.building.period_ratio * s.period_s;
  return {.horizontal = {Oscillator{s.period_s, s.damping}, Oscillator{second_s, s.damping}},
          .yielding = {strength_of(plan, s.period_s), strength_of(plan, second_s)},
          .mass_ratio = s.mass_ratio};
}

}  // namespace glissade
