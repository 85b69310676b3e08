// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/on_building.hpp"

#include <algorithm>
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

/// Pieces of longest_phase for one mass; without its bounds on a series, twice as long.
int pieces(const Modes& modes, double dt_s) {
  if (modes.rigid()) return 1;
  const double of_longest = modes.is_one_mass() ? 1.0 : 0.5;
  double pieces = 1.0;
  for (const Mode& mode : modes) {
    const double phase = 2.0 * std::numbers::pi / mode.period_s * dt_s;
    pieces = std::max(
        pieces, block_detail::pieces_of(of_longest * phase * (1.0 + 2.0 * mode.damping_ratio)));
  }
  return static_cast<int>(pieces);
}

void check([[maybe_unused]] const BuildingGround& ground, const MotionFactors& factors,
           const BiaxialBuilding& building, const Block& block) {
  require_finite_scene(building, block, factors);
  GLISSADE_EXPECTS(ground.horizontal[0] != nullptr);
  [[maybe_unused]] const double step_s = ground.horizontal[0]->step_s();
  GLISSADE_EXPECTS(ground.horizontal[1] == nullptr || ground.horizontal[1]->step_s() == step_s);
  GLISSADE_EXPECTS(ground.vertical == nullptr || ground.vertical->step_s() == step_s);
  for ([[maybe_unused]] std::size_t n : {0u, 1u}) {
    [[maybe_unused]] const Modes& modes = building.horizontal[n];
    GLISSADE_EXPECTS(modes.is_one_mass() || !building.yielding[n].yields());
    GLISSADE_EXPECTS(std::ranges::all_of(modes, [&](const Mode& mode) {
      return (mode.period_s > 0.0 || (modes.size() == 1 && mode.period_s == 0.0)) &&
             mode.damping_ratio >= 0.0 && mode.mass_share > 0.0;
    }));
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
    if (!building.horizontal[n].rigid())
      by_axis[n] = building.mass_ratio * building.horizontal[n].accelerance();
  return contact.accelerance(by_axis);
}

TwoAxisTrack track_of(const Block& block, std::span<const double> thresholds_m = {},
                      std::span<Crossing> crossings = {}) {
  return {BuildingContact(block).loading().to_plan(), thresholds_m, crossings};
}

/// @param track of the block
BuildingSlip slide_along(const TwoAxisTrack& track, const BuildingGround& ground,
                         const MotionFactors& factors, const BiaxialBuilding& building,
                         const Block& block, double tolerance) {
  check(ground, factors, building, block);
  require_tolerance(tolerance, 1e-11);

  const Excitation excitation(ground, factors);
  const double dt = excitation.dt_s();
  std::array<Modes, 2> axes;
  int pieces_per_interval = 1;
  double longest_period_s = 0.0;  // of the building with the array on its roof, at most
  for (std::size_t n = 0; n < 2; ++n) {
    const Modes& modes = building.horizontal[n];
    if (!modes.rigid()) require_no_rigid_spring(modes[0].oscillator(), building.yielding[n], dt);
    axes[n] = block_detail::responding(modes, dt);
    pieces_per_interval = std::max(pieces_per_interval, pieces(axes[n], dt));
    const double carried = building.mass_ratio * axes[n].accelerance();
    longest_period_s = std::max(longest_period_s, axes[n].period_s() * std::sqrt(1.0 + carried));
  }
  const double r = building.mass_ratio, piece_s = dt / pieces_per_interval;
  const BuildingContact contact(block);
  FullModelBody body(contact,
                     {BuildingAxis(axes[0], building.yielding[0], r, piece_s),
                      BuildingAxis(axes[1], building.yielding[1], r, piece_s)},
                     r, pieces_per_interval, piece_s, tolerance, track);

  body.follow(excitation, longest_period_s);

  BuildingSlip result;
  result.slip = body.result();
  for (std::size_t k = 0; k < 2; ++k) {
    result.peak_base_shear[k] = body.peaks().shear[k] / block.gravity_mps2;
    if (axes[k].rigid()) continue;
    const double omega = 2.0 * std::numbers::pi / axes[k].period_s();
    result.peak_roof_displacement_m[k] = body.peaks().x[k] / (omega * omega);
  }
  return result;
}

[[maybe_unused]] bool is_whole(std::span<const double> component, std::size_t samples) {
  return component.empty() || component.size() == samples;
}

void check(const TwoAxisAcceleration& roof, [[maybe_unused]] const Block& block) {
  for (const auto& horizontal : roof.horizontal_mps2)
    require_acceleration(horizontal, "the horizontal roof acceleration");
  require_acceleration(roof.vertical_mps2, "the vertical roof acceleration");
  require_finite({roof.dt_s}, "step");
  GLISSADE_EXPECTS(roof.dt_s > 0.0 && !roof.horizontal_mps2[0].empty());
  GLISSADE_EXPECTS(is_whole(roof.horizontal_mps2[1], roof.horizontal_mps2[0].size()) &&
                   is_whole(roof.vertical_mps2, roof.horizontal_mps2[0].size()));
  GLISSADE_EXPECTS(block.law.is_coulomb());
}

SlipResult slide_with(const TwoAxisAcceleration& roof, const Block& block, double tolerance,
                      std::vector<PathPiece>* path) {
  check(roof, block);
  require_tolerance(tolerance, 1e-11);
  const BuildingContact contact(block);
  const BuildingAxis rigid({}, {}, 0.0, roof.dt_s);
  TwoAxisTrack track(contact.loading().to_plan(), {}, {});
  track.keep(path);
  FullModelBody body(contact, {rigid, rigid}, 0.0, 1, roof.dt_s, tolerance, track);
  body.follow(Excitation(roof), 0.0);
  return body.result();
}

/// A path in the axes of another slope.
/// @param angle_rad from the azimuth of that slope to the azimuth of the path's
void rotate(std::span<PathPiece> path, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (PathPiece& piece : path)
    for (block_detail::Vector& d : piece.points) d = {c * d.s - s * d.y, s * d.s + c * d.y};
}

}  // namespace

void require_finite_scene(const BiaxialBuilding& building, const Block& block,
                          const MotionFactors& factors) {
  require_acceleration({factors.horizontal[0], factors.horizontal[1], factors.vertical},
                       "the factors");
  require_finite({building.mass_ratio}, "mass ratio");
  for (const std::size_t n : {0u, 1u}) {
    for (const Mode& mode : building.horizontal[n])
      require_finite({mode.period_s, mode.damping_ratio, mode.participation, mode.mass_share},
                     "period, damping, participation, mass share");
    require_finite({building.yielding[n].hardening_ratio}, "hardening");
    require_no_nan(building.yielding[n].yield_acceleration_mps2, "yield acceleration");
  }
  require_finite({block.friction.along, block.friction.across, block.slope_rad, block.azimuth_rad,
                  block.gravity_mps2},
                 "friction, slope, azimuth, gravity");
  require_finite({block.law.static_over_sliding, block.law.fast_over_slow, block.law.rate_s_per_m},
                 "friction law");
}

bool coupling_is_regular(const Block& block, const BiaxialBuilding& building) {
  const BuildingContact contact(block);
  return building.mass_ratio >= 0.0 && contact.is_regular(accelerance(contact, building));
}

BuildingSlip slide_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               double tolerance) {
  return slide_on_building(ground, factors, building, block, {}, {}, tolerance);
}

BuildingSlip slide_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings,
                               double tolerance) {
  return slide_along(track_of(block, thresholds_m, crossings), ground, factors, building, block,
                     tolerance);
}

PlanVector closing_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               const Block& neighbour, double tolerance) {
  require_finite_scene(building, block, factors);
  std::array<std::vector<PathPiece>, 2> paths;
  for (std::size_t i = 0; i < 2; ++i) {
    const Block& one = i == 0 ? block : neighbour;
    TwoAxisTrack track = track_of(one);
    track.keep(&paths[i]);
    slide_along(track, ground, factors, building, one, tolerance);
  }
  rotate(paths[1], neighbour.fall_azimuth_rad() - block.fall_azimuth_rad());
  const block_detail::Vector lead = largest_lead(paths[0], paths[1]);
  return {lead.s, lead.y};
}

SlipResult slide_two_axis(const TwoAxisAcceleration& roof, const Block& block, double tolerance) {
  return slide_with(roof, block, tolerance, nullptr);
}

SlipResult slide_two_axis(const TwoAxisAcceleration& roof, const Block& block,
                          std::vector<TwoAxisPoint>& history, double tolerance) {
  std::vector<PathPiece> path;
  const SlipResult result = slide_with(roof, block, tolerance, &path);
  history.assign(1, TwoAxisPoint{});
  const auto add = [&](double time_s, block_detail::Vector d) {
    history.push_back({time_s, {d.s, d.y}});
  };
  for (const PathPiece& piece : path) {
    if (piece.begin_s > history.back().time_s) add(piece.begin_s, piece.points.front());
    add(piece.end_s, piece.points.back());
  }
  return result;
}

}  // namespace glissade
