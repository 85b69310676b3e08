// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/events/coupled_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/building/rigid.hpp"

namespace glissade::block_detail {

namespace {
constexpr double most_pieces = 4096.0;  // 512 for any period that is not rigid, without a block
}  // namespace

/// @throw NotConverged if the roof has so little mass left that the pieces would be too many
Subdivision subdivide(const Oscillator& oscillator, const CoupledContact& contact, double dt_s) {
  if (is_rigid(oscillator, dt_s)) return {};
  const double omega = 2.0 * std::numbers::pi / oscillator.period_s,
               zeta = oscillator.damping_ratio;
  // The fastest regime is the lightest.
  const double mass =
      std::min({1.0, contact.sliding_down().mass, contact.sliding_up().mass, contact.stuck().mass});
  const double root = std::sqrt(mass);
  const double phase = omega * dt_s / root * (1.0 + 2.0 * zeta / root);
  const double pieces = pieces_of(phase);
  if (pieces > most_pieces)
    throw NotConverged(
        "the block's friction on its slope all but cancels the mass of the roof: give a smaller "
        "mass ratio");
  const double piece_phase = phase / pieces;
  // Of the first term: below rounding (1.1e-16) in the sum of all pieces of a history. 14 terms at
  // the longest phase.
  constexpr double last_term = 1e-19;
  int terms = 3;
  for (double term = piece_phase * piece_phase * piece_phase / 6.0; term > last_term;)
    term *= piece_phase / ++terms;
  return {{omega, zeta, terms + 1}, static_cast<int>(pieces)};
}

// In the elapsed fraction s of the piece, with phase = omega length:
//   dx/ds = phase y,  dy/ds = phase (a - a_ground),  mass a = E - weight (g + w).
RoofMotionSeries roof_motion_series(const BuildingOscillator& building, const ContactRegime& regime,
                                    double gravity_mps2, const RoofState& from,
                                    const SpringLine& spring, const GroundPiece& ground) {
  RoofMotionSeries m;
  const Roof rise{ground.end.a - ground.begin.a, ground.end.w - ground.begin.w};
  m.w_begin = ground.begin.w;
  m.w_rise = rise.w;
  const double weight[2] = {regime.weight * (gravity_mps2 + ground.begin.w),
                            regime.weight * rise.w};
  if (building.rigid()) {
    m.x.terms = m.y.terms = m.resisting.terms = m.a.terms = 2;
    m.a.c[0] = ground.begin.a;
    m.a.c[1] = rise.a;
    for (int k = 0; k < 2; ++k) m.x.c[k] = m.y.c[k] = 0.0;
    for (int k = 0; k < 2; ++k) m.resisting.c[k] = regime.mass * m.a.c[k] + weight[k];
    return m;
  }
  // With A = a_ground + weight (g + w) / mass, in the order that keeps the chain from term to term
  // short: y_{k+1} = -(factor/mass) (f_k + 2 zeta y_k) - factor A_k.
  const double phase = building.omega_radps * ground.length_s, per_mass = 1.0 / regime.mass,
               twice_zeta = 2.0 * building.damping_ratio;
  const int terms = building.terms;
  m.x.terms = m.y.terms = m.resisting.terms = m.a.terms = terms;
  const double forcing[2] = {ground.begin.a + weight[0] * per_mass, rise.a + weight[1] * per_mass};
  double x = from.x, y = from.y, force = spring.force;
  for (int k = 0; k < terms; ++k) {
    m.x.c[k] = x;
    m.y.c[k] = y;
    m.resisting.c[k] = -(force + twice_zeta * y);
    m.a.c[k] = m.resisting.c[k] * per_mass;
    const double factor = phase * Series::inverse[k + 1], per_mass_factor = factor * per_mass;
    double next = -(per_mass_factor * force) - (per_mass_factor * twice_zeta) * y;
    if (k < 2) next -= factor * forcing[k];
    x = factor * y;
    y = next;
    force = spring.stiffness * x;
  }
  for (int k = 0; k < 2; ++k) m.a.c[k] -= weight[k] * per_mass;
  return m;
}

}  // namespace glissade::block_detail
