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
constexpr double largest_rate_s_per_m = 1000.0;  // beyond it friction is nearly a jump in speed
constexpr double least_damping = 1e-3, most_damping = 0.5;

double omega_of(const Mode& mode) {
  return mode.period_s > 0.0 ? 2.0 * std::numbers::pi / mode.period_s : 0.0;
}

/// Of modes, whose roof is a polynomial to 1e-8 up to this phase; coupled, a step of the lanes is
/// shorter.
constexpr double longest_phase_of_modes = 2.6;

bool fits_lanes(const Modes& axis, double longest_phase, double dt_s) {
  return std::ranges::all_of(axis, [&](const Mode& mode) {
    return omega_of(mode) * dt_s <= longest_phase && mode.damping_ratio >= least_damping &&
           mode.damping_ratio <= most_damping;
  });
}

bool yields(const BiaxialBuilding& building) {
  return building.yielding[0].yields() || building.yielding[1].yields();
}

/// Of one mass, or rigid without the block's mass.
bool gives_base_shear(const TwoAxisScene& scene) {
  const RoofKind roof = roof_of(scene);
  return roof == RoofKind::building || is_one_mass_with_block(roof) ||
         (roof == RoofKind::rigid && scene.building.mass_ratio == 0.0);
}

}  // namespace

Friction friction_of(const TwoAxisScene& scene) {
  return scene.block.law.depends_on_speed() ? Friction::by_speed : Friction::coulomb;
}

RoofKind roof_of(const TwoAxisScene& scene) {
  const auto& [first, second] = scene.building.horizontal;
  if (first.rigid()) return RoofKind::rigid;
  if (yields(scene.building)) return RoofKind::yielding;
  const bool one_mass = first.is_one_mass() && second.is_one_mass();
  if (scene.building.mass_ratio > 0.0 || (one_mass && friction_of(scene) == Friction::by_speed))
    return one_mass ? RoofKind::coupled : RoofKind::coupled_modes;
  return one_mass ? RoofKind::building : RoofKind::modes;
}

bool fits_lanes(const TwoAxisScene& scene, const BuildingGround& ground) {
  const Block& block = scene.block;
  const auto& [first, second] = scene.building.horizontal;
  const FrictionLaw& law = block.law;
  if (law.depends_on_speed() && law.rate_s_per_m > largest_rate_s_per_m) return false;
  const double aspect = block.friction.across / block.friction.along;
  if (!(aspect >= least_aspect && aspect <= most_aspect)) return false;
  const double slowest = law.depends_on_speed() ? law.least_factor() : 1.0,
               fastest = law.depends_on_speed() ? law.largest_factor() : 1.0;
  if (!(slowest * block.friction.along > least_friction * std::tan(std::abs(block.slope_rad)) &&
        fastest * block.friction.along < most_friction))
    return false;
  if (first.rigid() != second.rigid()) return false;
  if (scene.base_shear && !gives_base_shear(scene)) return false;
  const double dt_s = ground.horizontal[0]->step_s();
  const RoofKind roof = roof_of(scene);
  const bool of_modes = roof == RoofKind::modes || roof == RoofKind::coupled_modes;
  const double phase = of_modes ? longest_phase_of_modes : longest_phase_in_lanes;
  if (!first.rigid() && !(fits_lanes(first, phase, dt_s) && fits_lanes(second, phase, dt_s)))
    return false;
  if (first.rigid() && yields(scene.building)) return false;
  return ground.vertical == nullptr || ground.vertical->rigid();
}

namespace {

/// The modes of a scene, and the equations of the contact (ModeConstants).
void set_modes(const TwoAxisScene& scene, SceneConstants& c) {
  ModeConstants<double>& of = c.modes;
  double rho[2], fastest = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Modes& modes = scene.building.horizontal[axis];
    const double r = scene.building.mass_ratio * modes.accelerance();
    rho[axis] = r / (1.0 + r);
    of.per_mass[axis] = 1.0 / (1.0 + r);
    of.ground_share[axis] = modes.ground_share();
    std::size_t& n = c.count[axis];
    for (const Mode& mode : modes) {
      if (mode.participation == 0.0) continue;
      const double omega = omega_of(mode), twice_zeta = 2.0 * mode.damping_ratio;
      const double share = scene.building.mass_ratio * of.per_mass[axis] * mode.participation *
                           mode.participation / mode.mass_share;
      of.omega[axis][n] = omega;
      of.twice_zeta[axis][n] = twice_zeta;
      of.gamma[axis][n] = mode.participation;
      of.share[axis][n] = share;
      of.omega_share[axis][n] = omega * share;
      of.feedback_damping += omega * share * twice_zeta;
      of.feedback_spring += omega * omega * share;
      fastest = std::max(fastest, omega);
      ++n;
    }
  }
  of.longest_s = longest_phase_in_lanes / fastest;
  const double sine = std::sin(std::atan(c.tangent)), cos2 = c.c * c.c, sin2 = c.s * c.s;
  const double rho_s = cos2 * rho[0] + sin2 * rho[1], rho_y = sin2 * rho[0] + cos2 * rho[1],
               rho_sy = c.c * c.s * (rho[1] - rho[0]), mean = 0.5 * (rho[0] + rho[1]);
  c.kappa = 1.0 - rho_s * c.cosine2;
  c.rho_sin_cos = rho_s * sine * c.cosine;
  of.kappa_sy = -rho_sy * c.cosine;
  of.kappa_y = 1.0 - rho_y;
  of.rho_sin = rho_sy * sine;
  const double det = c.kappa * of.kappa_y - of.kappa_sy * of.kappa_sy;
  of.lift_s = (c.rho_sin_cos * of.kappa_y - of.rho_sin * of.kappa_sy) / det;
  of.lift_y = (of.rho_sin * c.kappa - c.rho_sin_cos * of.kappa_sy) / det;
  // Jacobi's rotation.
  const double a = c.kappa, b = of.kappa_sy * c.per_aspect,
               d = of.kappa_y * c.per_aspect * c.per_aspect;
  const double angle = 0.5 * std::atan2(2.0 * b, a - d);
  of.turn_c = std::cos(angle);
  of.turn_s = std::sin(angle);
  const double cross = 2.0 * of.turn_c * of.turn_s * b;
  of.principal_1 = of.turn_c * of.turn_c * a + of.turn_s * of.turn_s * d + cross;
  of.principal_2 = of.turn_s * of.turn_s * a + of.turn_c * of.turn_c * d - cross;
  const double lifts_y = of.rho_sin * c.per_aspect;
  of.lifts_1 = of.turn_c * c.rho_sin_cos + of.turn_s * lifts_y;
  of.lifts_2 = of.turn_c * lifts_y - of.turn_s * c.rho_sin_cos;
  // About the mean of both axes.
  c.per_kappa_y = 1.0 / (1.0 - mean);
  const double differs =
      std::max(std::abs(1.0 - mean - c.kappa), std::abs(1.0 - mean - of.kappa_y)) +
      std::abs(of.kappa_sy);
  c.anisotropy = c.per_kappa_y * (differs + c.mu * (c.rho_sin_cos + std::abs(of.rho_sin)));
}

}  // namespace

SceneConstants constants_of(const TwoAxisScene& scene, double tolerance) {
  const Block& block = scene.block;
  const RoofKind roof = roof_of(scene);
  const double r = is_one_mass_with_block(roof) ? scene.building.mass_ratio : 0.0,
               rho = r / (1.0 + r);
  SceneConstants c{};
  c.factor_1 = scene.factors.horizontal[0];
  c.factor_2 = scene.factors.horizontal[1];
  c.factor_w = scene.factors.vertical;
  c.gravity = block.gravity_mps2;
  c.mu = block.friction.along;
  c.mu_at_rest = block.law.static_over_sliding * c.mu;
  if (block.law.depends_on_speed()) {
    c.fast_excess = block.law.fast_over_slow - 1.0;
    c.speed_rate = block.law.rate_s_per_m * std::cos(block.slope_rad);
  }
  c.tangent = std::tan(std::abs(block.slope_rad));
  c.cosine = std::cos(block.slope_rad);
  c.cosine2 = c.cosine * c.cosine;
  c.c = std::cos(block.fall_azimuth_rad());
  c.s = std::sin(block.fall_azimuth_rad());
  c.c_across = c.c / c.cosine;
  c.s_across = c.s / c.cosine;
  c.tolerance = tolerance;
  constexpr double held_at = 0.1;  // static friction: a block that is as slow may stick
  c.no_speed = (block.law.static_over_sliding > 1.0 ? held_at : 1.0) * tolerance;
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
  c.rho_sin_cos = rho * std::sin(std::abs(block.slope_rad)) * c.cosine;
  c.per_kappa_y = 1.0 + r;
  c.anisotropy = c.per_kappa_y * (std::abs(1.0 / c.per_kappa_y - c.kappa) + c.mu * c.rho_sin_cos);
  if (roof == RoofKind::coupled_modes) set_modes(scene, c);
  for (std::size_t n = 0; n < 2; ++n) {
    const Yielding& spring = scene.building.yielding[n];
    c.springs.hardening[n] = spring.hardening_ratio;
    c.springs.range[n] = 2.0 * spring.yield_acceleration_mps2;
    constexpr double negligible = 1e-11;  // of the yield force
    c.springs.margin[n] = spring.yields() ? negligible * spring.yield_acceleration_mps2 : 0.0;
  }
  return c;
}

}  // namespace glissade::block_detail::two_axes
