// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade::block_detail::two_axes {
namespace {

constexpr double longest_phase_in_lanes = 0.85;  // over a sample interval: an eighth of a period
constexpr double least_aspect = 0.5, most_aspect = 2.0;  // of the friction ellipse
constexpr double least_friction = 1.02;  // over tan(slope): less stops the block too late
constexpr double most_friction = 2.0;
constexpr double least_damping = 1e-3, most_damping = 0.5;

double omega_of(const Mode& mode) {
  return mode.period_s > 0.0 ? 2.0 * std::numbers::pi / mode.period_s : 0.0;
}

/// Of modes only, whose roof is a polynomial to 1e-8 up to this phase.
constexpr double longest_phase_of_modes = 2.6;

bool fits_lanes(const Modes& axis, double longest_phase, double dt_s) {
  return std::ranges::all_of(axis, [&](const Mode& mode) {
    return omega_of(mode) * dt_s <= longest_phase && mode.damping_ratio >= least_damping &&
           mode.damping_ratio <= most_damping;
  });
}

}  // namespace

RoofKind roof_of(const TwoAxisScene& scene) {
  const auto& [first, second] = scene.building.horizontal;
  if (first.rigid()) return RoofKind::rigid;
  if (scene.building.mass_ratio > 0.0) return RoofKind::coupled;
  return first.is_one_mass() && second.is_one_mass() ? RoofKind::building : RoofKind::modes;
}

bool fits_lanes(const TwoAxisScene& scene, const BuildingGround& ground) {
  const TwoAxisBlock& block = scene.block;
  const auto& [first, second] = scene.building.horizontal;
  if (!block.law.is_coulomb()) return false;
  const double aspect = block.friction.across / block.friction.along;
  if (!(aspect >= least_aspect && aspect <= most_aspect)) return false;
  if (!(block.friction.along > least_friction * std::tan(block.slope_rad) &&
        block.friction.along < most_friction))
    return false;
  if (first.rigid() != second.rigid()) return false;
  const double dt_s = ground.horizontal[0]->step_s();
  const RoofKind roof = roof_of(scene);
  const double phase = roof == RoofKind::modes ? longest_phase_of_modes : longest_phase_in_lanes;
  if (roof == RoofKind::coupled && !(first.is_one_mass() && second.is_one_mass())) return false;
  if (!first.rigid() && !(fits_lanes(first, phase, dt_s) && fits_lanes(second, phase, dt_s)))
    return false;
  for (const Yielding& spring : scene.building.yielding)
    if (spring.yields()) return false;
  return ground.vertical == nullptr || ground.vertical->rigid();
}

Constants<double> constants_of(const TwoAxisScene& scene, double tolerance) {
  const TwoAxisBlock& block = scene.block;
  const RoofKind roof = roof_of(scene);
  const double r = roof == RoofKind::coupled ? scene.building.mass_ratio : 0.0, rho = r / (1.0 + r);
  Constants<double> c{};
  c.factor_1 = scene.factors.horizontal[0];
  c.factor_2 = scene.factors.horizontal[1];
  c.factor_w = scene.factors.vertical;
  c.gravity = block.gravity_mps2;
  c.mu = block.friction.along;
  c.tangent = std::tan(block.slope_rad);
  c.cosine = std::cos(block.slope_rad);
  c.cosine2 = c.cosine * c.cosine;
  c.c = std::cos(block.azimuth_rad);
  c.s = std::sin(block.azimuth_rad);
  c.c_across = c.c / c.cosine;
  c.s_across = c.s / c.cosine;
  c.tolerance = tolerance;
  c.aspect = block.friction.across / block.friction.along;
  c.per_aspect = 1.0 / c.aspect;
  const auto& axes = scene.building.horizontal;
  c.omega_1 = omega_of(axes[0][0]);
  c.omega_2 = omega_of(axes[1][0]);
  c.twice_zeta_1 = 2.0 * axes[0][0].damping_ratio;
  c.twice_zeta_2 = 2.0 * axes[1][0].damping_ratio;
  c.per_mass = 1.0 / (1.0 + r);
  c.omega_rho_1 = rho * c.omega_1;
  c.omega_rho_2 = rho * c.omega_2;
  c.kappa = 1.0 - rho * c.cosine2;
  c.rho_sin_cos = rho * std::sin(block.slope_rad) * c.cosine;
  c.per_kappa_y = 1.0 + r;
  c.anisotropy = c.per_kappa_y * (std::abs(1.0 / c.per_kappa_y - c.kappa) + c.mu * c.rho_sin_cos);
  return c;
}

}  // namespace glissade::block_detail::two_axes
