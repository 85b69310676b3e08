// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/case_scene.hpp"

#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/cases/axis_motion.hpp"

namespace glissade {

Yielding strength_of(const Case& c, double period_s, const DesignTarget* target) {
  if (!c.yields() || period_s == 0.0) return {};
  if (c.yield_coefficient > 0.0)
    return yielding_for(YieldCoefficient{c.yield_coefficient}, c.hardening_ratio);
  GLISSADE_EXPECTS(target != nullptr);
  const double demand_g = TargetSpectrum(*target).design_sa_g(period_s);
  return yielding_for(ReducedDemand{demand_g * standard_gravity_mps2, c.response_modification},
                      c.hardening_ratio);
}

std::array<Modes, 2> building_axes(const Case& c, const BuildingModel& model) {
  const Modes first = modes_along(model, 0, {c.period_s, c.damping}, c.alpha);
  // Solving a cantilever takes as long as a history.
  if (c.period_ratio == 1.0 && model.modes[1].empty()) return {first, first};
  return {first, modes_along(model, 1, {c.period_ratio * c.period_s, c.damping}, c.alpha)};
}

Block block_of(const Case& c) {
  return {.friction = {c.friction, c.friction_across},
          .slope_rad = c.slope_deg * rad_per_deg,
          .azimuth_rad = c.azimuth_deg * rad_per_deg,
          .law = c.law};
}

Block neighbour_block(const Case& c) {
  const bool turned = c.orientation.slope_axis == SlopeAxis::n_s;
  const double ratio = c.neighbour_friction / (turned ? c.friction_across : c.friction);
  Case on_its_slope = c;
  if (c.neighbour_slope == NeighbourSlope::facing) on_its_slope.slope_deg = -c.slope_deg;
  Block block = block_of(on_its_slope);
  block.friction = {ratio * block.friction.along, ratio * block.friction.across};
  return block;
}

BiaxialBuilding biaxial_building(const Case& c, const BuildingModel& model,
                                 const DesignTarget* target) {
  const std::array<Modes, 2> axes = building_axes(c, model);
  return {.horizontal = axes,
          .yielding = {strength_of(c, axes[0].period_s(), target),
                       strength_of(c, axes[1].period_s(), target)},
          .mass_ratio = c.support == ArraySupport::no_array ? 0.0 : c.mass_ratio};
}

Block anchored_block() {
  constexpr double overwhelming = 1e6;
  return {.friction = overwhelming};
}

AxisMotion axis_motion(const Orientation& o, int axis) {
  if (!o.is_quarter_turn()) return {axis, o.ground_azimuth_deg, axis == 0 ? 1 : o.across_sign};
  const SignedComponent along = along_axis(o, axis);
  return {along.component, -1.0, along.sign};
}

}  // namespace glissade
