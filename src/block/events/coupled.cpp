// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/coupled.hpp"

#include <algorithm>
#include <cmath>

#include "block/events/coupled_body.hpp"
#include "block/events/sampled_motion.hpp"
#include "glissade/building/rigid.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

using block_detail::CoupledBody;
using block_detail::CoupledContact;
using block_detail::GroundPiece;
using block_detail::Roof;
using block_detail::SampledMotion;
using block_detail::Subdivision;

/// The interval that ends with sample i.
void walk_interval(CoupledBody& body, const SampledMotion& ground, std::size_t i, int pieces) {
  const Roof begin = ground.at(i - 1), end = ground.at(i);
  const double dt = ground.dt_s();
  const auto fraction = [&](int part) {
    if (part == pieces) return end;
    const double tau = static_cast<double>(part) / pieces;
    return Roof{begin.a + tau * (end.a - begin.a), begin.w + tau * (end.w - begin.w)};
  };
  for (int part = 0; part < pieces; ++part) {
    const double at_end = static_cast<double>(i - 1) + static_cast<double>(part + 1) / pieces;
    body.advance({dt / pieces, fraction(part), fraction(part + 1)}, at_end * dt);
  }
}

/// The ground is at rest from sample `quiet` on. A free vibration has its largest displacement and
/// acceleration within one period.
void ring_down(CoupledBody& body, const SampledMotion& ground, std::size_t quiet,
               const Subdivision& subdivision, const CoupledBuilding& building,
               const Block& block) {
  if (subdivision.building.rigid()) return body.coast();
  const double period_s = building.horizontal.period_s * std::sqrt(1.0 + building.mass_ratio);
  const std::size_t last = quiet + block_detail::longest_ring_down(ground.dt_s());
  double at_rest_s = 0.0;
  const auto settled = [&] { return !body.sliding() && !body.may_yield(); };
  for (std::size_t i = quiet;;) {
    if (settled() && at_rest_s >= period_s &&
        cannot_slip(block, body.largest_acceleration_to_come_mps2(), 0.0))
      return;
    if (i == last) return body.coast();
    walk_interval(body, ground, ++i, subdivision.pieces);
    at_rest_s = settled() ? at_rest_s + ground.dt_s() : 0.0;
  }
}

void require_finite_scene(const CoupledBuilding& building, const Block& block,
                          const MotionFactors& factors) {
  require_finite({building.horizontal.period_s, building.horizontal.damping_ratio,
                  building.mass_ratio, building.yielding.hardening_ratio},
                 "period, damping, mass ratio, hardening");
  require_no_nan(building.yielding.yield_acceleration_mps2, "yield acceleration");
  block_detail::require_block(block);
  require_acceleration({factors.horizontal[0], factors.vertical}, "the factors");
}

CoupledResult walk(const GroundMotion& motion, const MotionFactors& factors,
                   const CoupledBuilding& building, const Block& block,
                   std::span<const double> thresholds_m, std::span<Crossing> crossings,
                   CoupledBody::History history) {
  require_finite_scene(building, block, factors);
  GLISSADE_EXPECTS(block.law.static_over_sliding >= 1.0 && !block.law.depends_on_speed());
  GLISSADE_EXPECTS(building.horizontal.period_s >= 0.0 && building.horizontal.damping_ratio >= 0.0);
  GLISSADE_EXPECTS(coupling_is_regular(block, building.mass_ratio));

  const CoupledContact contact(block, building.mass_ratio);
  const SampledMotion ground(motion, factors, block);
  const Subdivision subdivision =
      block_detail::subdivide(building.horizontal, contact, motion.dt_s);
  const Yielding& spring = building.yielding;
  require_no_rigid_spring(building.horizontal, spring, motion.dt_s);
  GLISSADE_EXPECTS(spring.yield_acceleration_mps2 > 0.0);
  GLISSADE_EXPECTS(spring.hardening_ratio >= 0.0 && spring.hardening_ratio < 1.0);
  CoupledBody body(contact, subdivision.building, block, spring);
  body.keep(std::move(history));
  body.crossings() = {thresholds_m, crossings, contact.cos_slope()};

  const std::size_t n =
      contact.slides_at_rest() ? ground.size() : ground.size_without_trailing_zeros();
  for (std::size_t i = 1; i < n; ++i) walk_interval(body, ground, i, subdivision.pieces);
  if (!contact.slides_at_rest()) walk_interval(body, ground, n, subdivision.pieces);
  if (contact.stops_at_rest()) ring_down(body, ground, n, subdivision, building, block);
  CoupledResult result = body.result();
  if (block.slope_rad < 0.0)
    result.residual_roof_displacement_m = 0.0 - result.residual_roof_displacement_m;
  result.slip.free_sliding = body.slides_at_rest() || body.sliding();
  return result;
}

}  // namespace

bool coupling_is_regular(const Block& block, double mass_ratio) {
  const CoupledContact contact(block, mass_ratio);
  return mass_ratio >= 0.0 && contact.sliding_down().mass > 0.0;
}

CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  return walk(ground, factors, building, block, thresholds_m, crossings, {});
}

CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::vector<CoupledPoint>& history) {
  const double to_axes_of_x = block_detail::mirror(block);
  history.assign(1, CoupledPoint{});
  const auto keep = [&](CoupledPoint point) {
    point.roof_displacement_m *= to_axes_of_x;
    point.roof_acceleration_mps2 *= to_axes_of_x;
    point.spring_acceleration_mps2 *= to_axes_of_x;
    history.push_back(point);
  };
  return walk(ground, factors, building, block, {}, {}, keep);
}

}  // namespace glissade
