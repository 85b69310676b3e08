// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step by SDIRK4. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_IMPLICIT_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_IMPLICIT_STEP_INL
#undef GLISSADE_TWO_AXES_IMPLICIT_STEP_INL
#else
#define GLISSADE_TWO_AXES_IMPLICIT_STEP_INL
#endif

#include <limits>

#include "block/two_axes/lanes/advance-inl.hpp"
#include "block/two_axes/lanes/implicit_series-inl.hpp"
#include "block/two_axes/lanes/root-inl.hpp"
#include "block/two_axes/lanes/springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// Of the tolerance, for the estimate of a step's error: those of the steps add up over a history.
constexpr double implicit_share = 1.0;

/// An implicit step may end so much after an event of a spring, as a fraction of it.
constexpr double event_window = 1e-7;

/// The fraction of the interval's rest to try.
template <RoofKind roof, Friction friction>
HWY_INLINE V TrialFraction(const ImplicitSeries<roof, friction>& z, const LaneStates& lanes,
                           Here here, V h, Mask& lifted) {
  const Constants<Rows>& c = lanes.constants;
  const LaneMotion<Rows>& m = lanes.motion;
  const V longest = LongestFraction<roof>(lanes, here, h);
  const V zero = hn::Zero(Doubles()), one = Number(1.0), half = Number(0.5);
  const V speed2 = here(m.v_s) * here(m.v_s) + here(m.v_y) * here(m.v_y), speed = hn::Sqrt(speed2);
  const Mask moves = hn::Gt(speed, zero), holds = hn::Gt(z.weight[0], zero);
  V f = hn::Min(longest, hn::Div(here(m.trial), here(m.left)));
  const Mask unknown = hn::And(hn::And(moves, holds), hn::Eq(here(m.trial), Number(never)));
  f = hn::IfThenElse(unknown, hn::Min(longest, hn::Div(z.speed, z.weight[0])), f);

  if constexpr (friction == Friction::by_speed) {
    // Friction that falls with speed: a stage has one solution.
    const V falls = hn::Max(zero, hn::Neg(here(c.fast_excess)) * here(c.speed_rate)) * z.weight[0];
    f = hn::Min(f, hn::Div(Number(2.0), hn::Max(falls, Number(1e-6))));
  }

  // A stage of what comes after a reversal would not see what came before.
  const V last_s = Polynomial(z.p_s, longest), last_y = Polynomial(z.p_y, longest),
          last_n = Polynomial(z.weight, longest);
  const V per_speed = hn::Div(here(c.per_kappa_y), hn::IfThenElse(moves, speed, one));
  V most = z.speed;  // of friction, over that of slow sliding, times the speed
  if constexpr (friction == Friction::by_speed) most = most * hn::Max(one, z.law_factor[0]);
  const V first_brakes = per_speed * (hn::Max(z.weight[0], zero) * most -
                                      (z.p_s[0] * here(m.v_s) + z.p_y[0] * here(m.v_y)));
  const V last_brakes =
      per_speed * (hn::Max(last_n, zero) * most - (last_s * here(m.v_s) + last_y * here(m.v_y)));
  const V growth = hn::Max(zero, last_brakes - first_brakes);
  const V root = hn::Sqrt(first_brakes * first_brakes + Number(2.0) * growth * speed);
  const Mask falls = hn::Gt(first_brakes, zero), will_fall = hn::Gt(growth, zero);
  const V stops_at =
      hn::Div(hn::IfThenElse(falls, Number(2.0) * speed, root - first_brakes),
              hn::IfThenElse(falls, first_brakes + root, hn::IfThenElse(will_fall, growth, one)));
  const Mask stops =
      hn::And(hn::Or(falls, will_fall), hn::Gt(speed, here(c.no_speed) * here(m.fastest)));
  f = hn::IfThenElse(stops, hn::Min(f, Number(approach_to_stop) * stops_at), f);

  // To where the block lifts off, or lands: where the normal force without friction is zero.
  V terms[sizeof(z.weight) / sizeof(V)];
  const V slope = here(c.mu) * hn::Div(here(c.rho_sin_cos), here(c.kappa));
  ForOrders<0, sizeof(z.weight) / sizeof(V)>([&](auto k) GLISSADE_INLINE_LAMBDA {
    terms[k] = z.weight[k];
    if constexpr (is_one_mass_with_block(roof)) terms[k] = terms[k] - slope * z.p_s[k];
    if constexpr (roof == RoofKind::coupled_modes)
      terms[k] = terms[k] - here(c.mu) * (here(lanes.mode_constants.lift_s) * z.p_s[k] +
                                          here(lanes.mode_constants.lift_y) * z.p_y[k]);
  });
  const V begin = terms[0], end = Polynomial(terms, longest);
  lifted = hn::Lt(hn::Min(begin, end), zero);
  V contact = one;
  if (HWY_UNLIKELY(!hn::AllFalse(Doubles(), lifted))) {
    const Mask changes = hn::Xor(hn::Lt(begin, zero), hn::Lt(end, zero));
    // Where the begin is next to a root the line to the end tells little of it.
    constexpr int bisections = 12;
    const V at = RootOf<bisections>(Terms(terms), longest, begin, end);
    constexpr double at_once = 1e-9;  // it was at the end of the last step
    contact = hn::IfThenElse(hn::And(changes, hn::Gt(at, Number(at_once))), at, one);
  }
  // No remainder that is much shorter than the step.
  f = hn::Min(f, contact);
  return hn::IfThenElse(hn::And(hn::Lt(f, contact), hn::Gt(f, half * contact)), half * contact, f);
}

/// One step of neighbouring lanes by SDIRK4; see Stepped.
template <RoofKind roof, Friction friction>
class ImplicitStep {
 public:
  HWY_INLINE ImplicitStep(const LaneStates& lanes, const GroundRows& ground, std::size_t first)
      : here{first},
        m(lanes.motion),
        c(lanes.constants),
        i(LoadInterval(lanes, ground, here)),
        z(lanes, here, i.ground_1, i.ground_2, i.up, i.row, i.h) {
    const V zero = hn::Zero(Doubles());
    // A speed within the tolerance, against the load (LaneHistory::reverse).
    speed = Length(here(m.v_s), here(m.v_y));
    const Mask slowest =
        hn::And(hn::Le(speed, here(c.no_speed) * here(m.fastest)),
                hn::And(hn::Gt(z.weight[0], zero),
                        hn::Le(z.p_s[0] * here(m.v_s) + z.p_y[0] * here(m.v_y), zero)));
    const Mask may_end = hn::Eq(here(m.forced), zero);
    event = hn::Or(hn::Not(i.before),
                   hn::And(may_end, hn::Or(slowest, Stops<roof, friction>(z, c, m, here, i.h))));
    f = TrialFraction(z, lanes, here, i.h, lifted);
    constexpr double epsilons = 16.0 * std::numeric_limits<double>::epsilon();
    const V load = hn::Abs(z.p_s[0]) + hn::Abs(z.p_y[0]) + hn::Abs(z.weight[0]);
    rounding = (Number(epsilons) * f) * load;
    constexpr double negligible = 1e-3;  // of the permitted error
    z.Begin(f, Number(negligible) * Allowed(here(m.fastest)));
  }

  HWY_INLINE Stepped Finish(LaneStates& lanes, const GroundRows& ground) {
    const Doubles d;
    const V zero = hn::Zero(d);
    LaneMotion<V> to{};
    to.v_s = z.end_s;
    to.v_y = z.end_y;
    const V end_speed = Length(z.end_s, z.end_y);
    to.fastest = hn::Max(here(m.fastest), end_speed);
    to.path = here(m.path) + (Number(0.5) * (i.h * f)) * (speed + end_speed);

    const V error = z.Error(), allowed = Allowed(to.fastest);
    const Mask accurate = hn::Or(hn::Le(error, allowed), hn::Le(f, Number(shortest_step)));
    const Mask finite = hn::Lt(error, Number(never));
    Mask goes = hn::AndNot(event, hn::And(accurate, finite));
    [[maybe_unused]] const auto events = SpringEventsOf<roof>(lanes, here, z, f);
    // step_factor() in sdirk4.hpp.
    const V ratio = hn::Div(allowed, hn::Max(error, Number(1e-4) * allowed));
    const V factor =
        hn::Min(hn::Max(Number(step_safety) * hn::Sqrt(hn::Sqrt(ratio)), Number(least_step_factor)),
                Number(most_step_factor));
    V trial = hn::IfThenElse(finite, (f * here(m.left)) * factor, zero);
    [[maybe_unused]] Mask springs_change = goes, at_begin = goes;
    if constexpr (roof == RoofKind::yielding) {
      // Once more, up to the event; one at the begin needs no step.
      const V first = events.First();
      const Mask beyond = hn::And(goes, hn::Lt(first, f * Number(1.0 - event_window)));
      at_begin = hn::And(beyond, hn::Lt(first, Number(shortest_step)));
      trial = hn::IfThenElse(beyond, hn::IfThenElse(at_begin, here(m.trial), first * here(m.left)),
                             trial);
      goes = hn::AndNot(beyond, goes);
      springs_change = hn::Or(goes, at_begin);
    }
    const V next_trial = hn::IfThenElse(event, here(m.trial), trial);

    const V end_weight = Polynomial(z.weight, f);
    const V end_m_speed = Length(z.end_s, here(c.aspect) * z.end_y);
    const Mask fast = hn::Lt(end_weight, (Number(smooth) * here(m.left)) * end_m_speed);
    const Mask pressed =
        hn::Gt(end_weight, (Number(enough_weight) * here(c.mu)) * (here(c.gravity) * i.h));
    const Mask rests = hn::Eq(end_speed, zero);
    Stepped stepped;
    stepped.event = Bits(hn::Or(hn::Or(event, hn::Not(finite)), hn::And(goes, rests)));
    stepped.other = Bits(hn::And(goes, hn::And(fast, pressed))) & ~stepped.event;
    stepped.lifted = Bits(lifted);
    Advance<roof>(lanes, ground, here, i, z, z.v_s, z.v_y, f, goes, to, stepped);
    if constexpr (roof == RoofKind::yielding)
      events.Take(lanes, here, springs_change, hn::IfThenElse(at_begin, Number(shortest_step), f),
                  hn::IfThenElse(at_begin, z.x_1[0], to.x_1),
                  hn::IfThenElse(at_begin, z.x_2[0], to.x_2));
    hn::Store(next_trial, d, lanes.motion.trial + here.first);
    return stepped;
  }

 private:
  HWY_INLINE V Allowed(V fastest) const {
    return (Number(implicit_share) * here(c.tolerance)) * fastest + rounding;
  }

  Here here;
  const LaneMotion<Rows>& m;
  const Constants<Rows>& c;
  LaneInterval i;
  V f, speed, rounding;
  Mask event, lifted;

 public:
  ImplicitSeries<roof, friction> z;
};

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_IMPLICIT_STEP_INL
