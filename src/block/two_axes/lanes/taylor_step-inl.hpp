// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step by a Taylor series. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_TAYLOR_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_TAYLOR_STEP_INL
#undef GLISSADE_TWO_AXES_TAYLOR_STEP_INL
#else
#define GLISSADE_TWO_AXES_TAYLOR_STEP_INL
#endif

#include "block/two_axes/lanes/advance-inl.hpp"
#include "block/two_axes/lanes/springs-inl.hpp"
#include "block/two_axes/lanes/taylor_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// Of the tolerance, for the estimate of a step's error: those of the steps add up over a history.
constexpr double series_share = 0.6;

/// One step of neighbouring lanes by a Taylor series; see Stepped.
template <RoofKind roof, Friction friction>
HWY_INLINE Stepped TaylorStep(LaneStates& lanes, const GroundRows& ground, Here here) {
  const LaneMotion<Rows>& m = lanes.motion;
  const Constants<Rows>& c = lanes.constants;
  LaneInterval i = LoadInterval(lanes, ground, here);
  StepSeries<roof, friction> z(lanes, here, i.ground_1, i.ground_2, i.up, i.row, i.h);

  LaneMotion<V> to{};
  to.fastest = hn::Max(here(m.fastest), z.speed[0]);
  const V longest = LongestFraction<roof>(lanes, here, i.h);
  V f = StepFraction(z, longest, Number(series_share) * here(c.tolerance) * to.fastest);
  [[maybe_unused]] const auto events = SpringEventsOf<roof>(lanes, here, z, f);
  if constexpr (roof == RoofKind::yielding) f = hn::Min(f, events.First());
  to.path = here(m.path) + (i.h * f) * z.speed[0];
  to.v_s = Polynomial(z.v_s, f);
  to.v_y = Polynomial(z.v_y, f);

  const Mask slow = hn::Gt(z.weight[0], (Number(stiff) * here(m.left)) * z.speed[0]);
  const V alignment =
      to.v_s * here(m.v_s) + (here(c.aspect) * to.v_y) * (here(c.aspect) * here(m.v_y));
  const Mask straight = hn::Ge(alignment, Number(least_alignment) * (z.speed[0] * z.speed[0]));
  const V least = (Number(least_weight) * here(c.mu)) * (here(c.gravity) * i.h);
  const Mask stays = hn::Gt(hn::Min(z.weight[0], z.weight[0] + z.weight[1]), least);
  const Mask smooth = hn::AndNot(slow, hn::And(straight, stays));
  const Mask event = hn::Or(hn::Not(i.before), Stops<roof, friction>(z, c, m, here, i.h));
  const Mask goes = hn::AndNot(event, smooth);
  Stepped stepped;
  Advance<roof>(lanes, ground, here, i, z, z.v_s, z.v_y, f, goes, to, stepped);
  if constexpr (roof == RoofKind::yielding) events.Take(lanes, here, goes, f, to.x_1, to.x_2);
  stepped.event = Bits(event);
  stepped.other = Bits(hn::Not(smooth)) & ~stepped.event;
  return stepped;
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_TAYLOR_STEP_INL
