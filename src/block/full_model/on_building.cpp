// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/on_building.hpp"

#include <cmath>
#include <numbers>

#include "block/events/coupled_motion.hpp"
#include "block/full_model/body.hpp"
#include "glissade/building/rigid.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

using block_detail::BuildingAxis;
using block_detail::BuildingContact;
using block_detail::Excitation;
using block_detail::FullModelBody;
using block_detail::PathPiece;
using block_detail::TwoAxisTrack;

int pieces(const Oscillator& oscillator, double dt_s) {
  if (oscillator.period_s == 0.0) return 1;
  const double phase = 2.0 * std::numbers::pi / oscillator.period_s * dt_s;
  return static_cast<int>(block_detail::pieces_of(phase * (1.0 + 2.0 * oscillator.damping_ratio)));
}

void check([[maybe_unused]] const BuildingGround& ground, const BuildingFactors& factors,
           const BiaxialBuilding& building, const TwoAxisBlock& block) {
  require_finite_scene(building, block, factors);
  GLISSADE_EXPECTS(ground.horizontal[0] != nullptr);
  [[maybe_unused]] const double step_s = ground.horizontal[0]->step_s();
  GLISSADE_EXPECTS(ground.horizontal[1] == nullptr || ground.horizontal[1]->step_s() == step_s);
  GLISSADE_EXPECTS(ground.vertical == nullptr || ground.vertical->step_s() == step_s);
  for ([[maybe_unused]] std::size_t n : {0u, 1u}) {
    GLISSADE_EXPECTS(building.horizontal[n].is_one_mass());
    GLISSADE_EXPECTS(building.horizontal[n][0].period_s >= 0.0 &&
                     building.horizontal[n][0].damping_ratio >= 0.0);
    GLISSADE_EXPECTS(building.yielding[n].yield_acceleration_mps2 > 0.0 &&
                     building.yielding[n].hardening_ratio >= 0.0 &&
                     building.yielding[n].hardening_ratio < 1.0);
  }
  GLISSADE_EXPECTS(coupling_is_regular(block, building));
}

block_detail::Accelerance accelerance(const BuildingContact& contact,
                                      const BiaxialBuilding& building) {
  block_detail::Axes by_axis{};
  for (std::size_t n = 0; n < 2; ++n)
    if (building.horizontal[n][0].period_s > 0.0) by_axis[n] = building.mass_ratio;
  return contact.accelerance(by_axis);
}

TwoAxisTrack track_of(const TwoAxisBlock& block, std::span<const double> thresholds_m = {},
                      std::span<Crossing> crossings = {}) {
  return {BuildingContact(block).loading().to_plan(), thresholds_m, crossings};
}

/// @param track of the block
BuildingSlip slide_along(const TwoAxisTrack& track, const BuildingGround& ground,
                         const BuildingFactors& factors, const BiaxialBuilding& building,
                         const TwoAxisBlock& block, double tolerance) {
  check(ground, factors, building, block);
  require_tolerance(tolerance, 1e-11);

  const Excitation excitation(ground, factors);
  const double dt = excitation.dt_s();
  std::array<Oscillator, 2> oscillators{building.horizontal[0][0].oscillator(),
                                        building.horizontal[1][0].oscillator()};
  int pieces_per_interval = 1;
  double longest_period_s = 0.0;
  for (std::size_t n = 0; n < 2; ++n) {
    Oscillator& oscillator = oscillators[n];
    if (oscillator.period_s > 0.0) require_no_rigid_spring(oscillator, building.yielding[n], dt);
    if (is_rigid(oscillator, dt)) oscillator.period_s = 0.0;
    pieces_per_interval = std::max(pieces_per_interval, pieces(oscillator, dt));
    longest_period_s = std::max(longest_period_s, oscillator.period_s);
  }
  longest_period_s *= std::sqrt(1.0 + building.mass_ratio);
  const double r = building.mass_ratio, piece_s = dt / pieces_per_interval;
  const BuildingContact contact(block);
  FullModelBody body(contact,
                     {BuildingAxis(oscillators[0], building.yielding[0], r, piece_s),
                      BuildingAxis(oscillators[1], building.yielding[1], r, piece_s)},
                     r, pieces_per_interval, tolerance, track);

  body.follow(excitation, longest_period_s);

  BuildingSlip result;
  result.slip = body.result();
  for (std::size_t k = 0; k < 2; ++k) {
    result.peak_base_shear[k] = body.peaks().resisting[k] / block.gravity_mps2;
    if (oscillators[k].period_s == 0.0) continue;
    const double omega = 2.0 * std::numbers::pi / oscillators[k].period_s;
    result.peak_roof_displacement_m[k] = body.peaks().x[k] / (omega * omega);
  }
  return result;
}

/// A path in the axes of another slope.
/// @param angle_rad from the azimuth of that slope to the azimuth of the path's
void rotate(std::span<PathPiece> path, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (PathPiece& piece : path)
    for (block_detail::Vector& d : piece.points) d = {c * d.s - s * d.y, s * d.s + c * d.y};
}

}  // namespace

void require_finite_scene(const BiaxialBuilding& building, const TwoAxisBlock& block,
                          const BuildingFactors& factors) {
  require_acceleration({factors.horizontal[0], factors.horizontal[1], factors.vertical},
                       "the factors");
  require_finite({building.mass_ratio}, "mass ratio");
  for (const std::size_t n : {0u, 1u}) {
    require_finite({building.horizontal[n][0].period_s, building.horizontal[n][0].damping_ratio,
                    building.yielding[n].hardening_ratio},
                   "period, damping, hardening");
    require_no_nan(building.yielding[n].yield_acceleration_mps2, "yield acceleration");
  }
  require_finite({block.friction.along, block.friction.across, block.slope_rad, block.azimuth_rad,
                  block.gravity_mps2},
                 "friction, slope, azimuth, gravity");
  require_finite({block.law.static_over_sliding, block.law.fast_over_slow, block.law.rate_s_per_m},
                 "friction law");
}

bool coupling_is_regular(const TwoAxisBlock& block, const BiaxialBuilding& building) {
  const BuildingContact contact(block);
  return building.mass_ratio >= 0.0 && contact.is_regular(accelerance(contact, building));
}

BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               double tolerance) {
  return slide_on_building(ground, factors, building, block, {}, {}, tolerance);
}

BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings,
                               double tolerance) {
  return slide_along(track_of(block, thresholds_m, crossings), ground, factors, building, block,
                     tolerance);
}

PlanVector closing_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               const TwoAxisBlock& neighbour, double tolerance) {
  require_finite_scene(building, block, factors);
  std::array<std::vector<PathPiece>, 2> paths;
  for (std::size_t i = 0; i < 2; ++i) {
    const TwoAxisBlock& one = i == 0 ? block : neighbour;
    TwoAxisTrack track = track_of(one);
    track.keep(&paths[i]);
    slide_along(track, ground, factors, building, one, tolerance);
  }
  rotate(paths[1], neighbour.azimuth_rad - block.azimuth_rad);
  const block_detail::Vector lead = largest_lead(paths[0], paths[1]);
  return {lead.s, lead.y};
}

}  // namespace glissade
