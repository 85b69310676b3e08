// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step of all lanes, by roof. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_LANE_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_LANE_STEP_INL
#undef GLISSADE_TWO_AXES_LANE_STEP_INL
#else
#define GLISSADE_TWO_AXES_LANE_STEP_INL
#endif

#include <algorithm>
#include <limits>

#include "implicit_series-inl.hpp"
#include "lane_root-inl.hpp"
#include "lane_series-inl.hpp"
#include "lane_shear-inl.hpp"
#include "lane_springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// Of the permitted error of a stop. LaneHistory::stop() sees more of the load's change than a
/// lane: below this it takes most stops at once, which else need a stiff step before.
constexpr double surely_permitted = 0.3;

/// Of the tolerance, for the estimate of a step's error: those of the steps add up over a history.
constexpr double series_share = 0.6, implicit_share = 1.0;

/// The smooth part of a sample interval that is left, and what the ground does in it.
struct LaneInterval {
  hn::Vec<Indices> node, next;
  Mask before;  // the last that the lanes go through
  V end_1, end_2, end_w;
  Ramped ground_1, ground_2, up;
  TableRow row;
  V h;
};

/// Where the row of a node begins in RestTable::rows.
HWY_INLINE hn::Vec<Indices> RowStart(hn::Vec<Indices> node) {
  static_assert(2 * row_terms == 16 + 4);
  return hn::Add(hn::ShiftLeft<4>(node), hn::ShiftLeft<2>(node));
}

HWY_INLINE LaneInterval LoadInterval(const LaneStates& lanes, const GroundRows& ground, Here here) {
  const LaneMotion<Rows>& m = lanes.motion;
  const Constants<Rows>& c = lanes.constants;
  const Doubles d;
  const Indices di;
  const auto node = hn::Load(di, lanes.node + here.first);
  const auto next = hn::Add(node, hn::Set(di, std::int64_t{1}));
  const auto at = hn::ShiftLeft<2>(hn::Min(next, hn::Set(di, ground.last)));
  const V end_1 = here(c.factor_1) * hn::GatherIndex(d, ground.nodes, at);
  const V end_2 = here(c.factor_2) * hn::GatherIndex(d, ground.nodes + 1, at);
  V end_w = here(m.w);
  if (ground.vertical) end_w = here(c.factor_w) * hn::GatherIndex(d, ground.nodes + 2, at);
  return {node,
          next,
          hn::RebindMask(d, hn::Lt(node, hn::Load(di, lanes.limit + here.first))),
          end_1,
          end_2,
          end_w,
          {here(m.ground_1), end_1 - here(m.ground_1)},
          {here(m.ground_2), end_2 - here(m.ground_2)},
          {here(m.w), end_w - here(m.w)},
          {ground.nodes, hn::Add(hn::Load(di, lanes.rows + here.first), RowStart(node))},
          Number(ground.dt_s) * here(m.left)};
}

/// Where the block stops within what is left of the interval by a path known in closed form
/// (LaneHistory::stop).
template <RoofKind roof, Friction friction, class Series>
HWY_INLINE Mask Stops(const Series& z, const Constants<Rows>& c, const LaneMotion<Rows>& m,
                      Here here, V h) {
  const V zero = hn::Zero(Doubles());
  V p_s = z.p_s[0], p_y = here(c.per_aspect) * z.p_y[0], n = z.weight[0];
  V change = hn::Abs(z.p_s[1]) + hn::Abs(z.p_y[1]) + hn::Abs(z.weight[1]);
  V anisotropy = zero;  // what else is not constant
  if constexpr (has_mass(roof)) {
    p_s = p_s * here(c.per_kappa_y);
    p_y = p_y * here(c.per_kappa_y);
    n = n * here(c.per_kappa_y);
    change = change * here(c.per_kappa_y);
    anisotropy = n * here(c.anisotropy);
  }
  if constexpr (friction == Friction::by_speed)
    anisotropy = anisotropy + n * hn::Abs(z.law_factor[0] - Number(1.0));
  const V v_y = here(c.per_aspect) * here(m.v_y);
  const V margin = n * n - (p_s * p_s + p_y * p_y);
  const V q = n * hn::Sqrt(here(m.v_s) * here(m.v_s) + v_y * v_y) + (p_s * here(m.v_s) + p_y * v_y);
  const V allowed =
      (Number(surely_permitted * 12.0 * stop_tolerance) * here(c.tolerance)) * here(m.path);
  return hn::And(hn::And(hn::And(hn::Gt(margin, zero), hn::Gt(n, zero)), hn::Lt(q, margin)),
                 hn::Le((h * (q * q)) * (change * q + (Number(6.0) * anisotropy) * margin),
                        allowed * ((margin * margin) * margin)));
}

/// Displacement along an axis: its rate by tau is that of the velocity times `scale`.
struct Displacement {
  V begin, scale;

  template <int n>
  HWY_INLINE V At(const V (&velocity)[n], V t) const {
    return begin + scale * Integral(velocity, t);
  }
};

/// The displacement squared where the block turns back within a step over the fraction f.
template <int n>
HWY_NOINLINE V FarthestAtTurn(Displacement along, Displacement across, Terms<n> v_s, Terms<n> v_y,
                              V f, V out_at_begin, V out_at_end) {
  const auto out = [&](V t) GLISSADE_INLINE_LAMBDA {
    return along.At(v_s.of, t) * (along.scale * Polynomial(v_s.of, t)) +
           across.At(v_y.of, t) * (across.scale * Polynomial(v_y.of, t));
  };
  const V t = Root(out, f, out_at_begin, out_at_end);
  const V s = along.At(v_s.of, t), y = across.At(v_y.of, t);
  return s * s + y * y;
}

/// Raises what a history has seen so far to the step's end and to what is
/// between.
template <int n>
HWY_INLINE void RaisePeaks(const V (&v_s)[n], const V (&v_y)[n], const LaneMotion<Rows>& m,
                           Here here, const Displacement& along, const Displacement& across,
                           Mask goes, V f, LaneMotion<V>& to) {
  const V zero = hn::Zero(Doubles());
  to.farthest2 = hn::Max(here(m.farthest2), to.at_s * to.at_s + to.at_y * to.at_y);
  to.ahead_s = hn::Max(here(m.ahead_s), to.at_s);
  to.back_s = hn::Max(here(m.back_s), zero - to.at_s);
  to.ahead_y = hn::Max(here(m.ahead_y), to.at_y);
  to.back_y = hn::Max(here(m.back_y), zero - to.at_y);

  // Half the rate of the displacement squared.
  const V out0 = along.begin * (along.scale * v_s[0]) + across.begin * (across.scale * v_y[0]);
  const V out1 = to.at_s * (along.scale * to.v_s) + to.at_y * (across.scale * to.v_y);
  const auto along_path = [&]() GLISSADE_INLINE_LAMBDA {
    const Mask turns = hn::And(goes, hn::And(hn::Gt(out0, zero), hn::Lt(out1, zero)));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), turns))) return;
    // Twice what is gained where the rate falls as a line.
    const V gain = (Number(2.0) * f) * hn::Div(out0 * out0, out0 - out1);
    const V begin2 = along.begin * along.begin + across.begin * across.begin;
    const Mask returns = hn::And(turns, hn::Gt(begin2 + gain, to.farthest2));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), returns))) return;
    const V farthest2 = FarthestAtTurn<n>(along, across, Terms(v_s), Terms(v_y), f, out0, out1);
    to.farthest2 = hn::IfThenElse(returns, hn::Max(to.farthest2, farthest2), to.farthest2);
  };
  const auto along_axis = [&](const V(&v)[n], V v1, const Displacement& at, V& ahead,
                              V& back) GLISSADE_INLINE_LAMBDA {
    const Mask turns = hn::And(goes, hn::Lt(v[0] * v1, zero));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), turns))) return;
    const V reach = at.begin + hn::Div((f * at.scale) * (v[0] * v[0]), v[0] - v1);
    const Mask reverses = hn::And(turns, hn::Or(hn::Gt(reach, ahead), hn::Gt(zero - reach, back)));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), reverses))) return;
    const V t = RootOf(Terms(v), f, v[0], v1);
    const V value = at.At(v, t);
    ahead = hn::IfThenElse(reverses, hn::Max(ahead, value), ahead);
    back = hn::IfThenElse(reverses, hn::Max(back, zero - value), back);
  };
  along_path();
  along_axis(v_s, to.v_s, along, to.ahead_s, to.back_s);
  along_axis(v_y, to.v_y, across, to.ahead_y, to.back_y);
}

/// Writes the motion of the lanes that make the step, all but trial.
template <RoofKind roof>
HWY_INLINE void Commit(LaneStates& lanes, std::size_t first, Mask goes, const LaneMotion<V>& m) {
  const auto commit = [&](double* row, V value) GLISSADE_INLINE_LAMBDA {
    const V old = hn::Load(Doubles(), row + first);
    hn::Store(hn::IfThenElse(goes, value, old), Doubles(), row + first);
  };
  auto& to = lanes.motion;
  commit(to.left, m.left);
  commit(to.forced, m.forced);
  commit(to.v_s, m.v_s);
  commit(to.v_y, m.v_y);
  commit(to.at_s, m.at_s);
  commit(to.at_y, m.at_y);
  commit(to.ground_1, m.ground_1);
  commit(to.ground_2, m.ground_2);
  commit(to.w, m.w);
  if constexpr (has_state(roof) && roof != RoofKind::coupled_modes) {
    commit(to.x_1, m.x_1);
    commit(to.y_1, m.y_1);
    commit(to.x_2, m.x_2);
    commit(to.y_2, m.y_2);
  }
  commit(to.fastest, m.fastest);
  commit(to.path, m.path);
  commit(to.farthest2, m.farthest2);
  commit(to.ahead_s, m.ahead_s);
  commit(to.back_s, m.back_s);
  commit(to.ahead_y, m.ahead_y);
  commit(to.back_y, m.back_y);
}

/// The displacement of a step as a series, for LaneHistory::crossed.
template <int n>
HWY_INLINE void KeepPath(double (&to)[LaneStates::path_terms][LaneStates::count], std::size_t first,
                         const Displacement& at, const V (&v)[n]) {
  static_assert(n < LaneStates::path_terms);
  hn::Store(at.begin, Doubles(), to[0] + first);
  for (std::size_t k = 1; k < LaneStates::path_terms; ++k)
    hn::Store(k <= n ? (at.scale * Number(inverse[k])) * v[k - 1] : hn::Zero(Doubles()), Doubles(),
              to[k] + first);
}

/// Takes the lanes that make the step over the fraction f of the interval's rest, at whose end `to`
/// has velocity, path and largest speed.
template <RoofKind roof, class Series, int n>
HWY_INLINE void Advance(LaneStates& lanes, const GroundRows& ground, Here here,
                        const LaneInterval& interval, const Series& z, const V (&v_s)[n],
                        const V (&v_y)[n], V f, Mask goes, LaneMotion<V>& to, Stepped& stepped) {
  const LaneMotion<Rows>& m = lanes.motion;
  const Constants<Rows>& c = lanes.constants;
  const std::size_t first = here.first;
  const Doubles d;
  const Indices di;
  const V one = Number(1.0), h = interval.h;
  const Displacement along{here(m.at_s), h * here(c.cosine2)},
      across{here(m.at_y), h * here(c.cosine)};
  to.at_s = along.At(v_s, f);
  to.at_y = across.At(v_y, f);
  RaisePeaks(v_s, v_y, m, here, along, across, goes, f, to);

  const Mask whole = hn::Eq(f, one);
  to.left = hn::IfThenElse(whole, one, here(m.left) * (one - f));
  const auto ramp = [&](V end, const Ramped& r) GLISSADE_INLINE_LAMBDA {
    return hn::IfThenElse(whole, end, r.begin + f * r.rise);
  };
  to.ground_1 = ramp(interval.end_1, interval.ground_1);
  to.ground_2 = ramp(interval.end_2, interval.ground_2);
  to.w = ramp(interval.end_w, interval.up);
  if constexpr (roof == RoofKind::coupled_modes) {
    ModeMotion<Rows>& modes = lanes.mode_motion;
    const auto commit = [&](double* row, V value) GLISSADE_INLINE_LAMBDA {
      hn::Store(hn::IfThenElse(goes, value, hn::Load(d, row + first)), d, row + first);
    };
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t mode = 0; mode < lanes.modes; ++mode) {
        commit(modes.x[axis][mode], Polynomial(z.modes.x[axis][mode], f));
        commit(modes.y[axis][mode], Polynomial(z.modes.y[axis][mode], f));
      }
  } else if constexpr (has_state(roof)) {
    to.x_1 = Polynomial(z.x_1, f);
    to.y_1 = Polynomial(z.y_1, f);
    to.x_2 = Polynomial(z.x_2, f);
    to.y_2 = Polynomial(z.y_2, f);
  }
  to.forced = hn::Zero(d);
  const V begin_s = (hn::ConvertTo(d, interval.next) - here(m.left)) * Number(ground.dt_s);
  Commit<roof>(lanes, first, goes, to);
  const auto moved = hn::RebindMask(di, hn::And(goes, whole));
  hn::Store(hn::IfThenElse(moved, interval.next, interval.node), di, lanes.node + first);

  if constexpr (is_one_mass_with_block(roof))
    if (HWY_UNLIKELY(lanes.follows_shear)) stepped.shear = FollowShear(lanes, here, z, f, goes);

  const Mask reached = hn::And(goes, hn::Ge(to.farthest2, hn::Load(d, lanes.next2 + first)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, reached))) {
    LaneStates::Passed& passed = lanes.passed;
    KeepPath(passed.path_s, first, along, v_s);
    KeepPath(passed.path_y, first, across, v_y);
    hn::Store(begin_s, d, passed.begin_s + first);
    hn::Store(h, d, passed.length_s + first);
    hn::Store(f, d, passed.fraction + first);
    stepped.passed = Bits(reached);
  }
}

/// Of the interval's rest, over which the roof's series converge.
template <RoofKind roof>
HWY_INLINE V LongestFraction(const LaneStates& lanes, Here here, V h) {
  const V one = Number(1.0);
  if constexpr (roof == RoofKind::coupled_modes)
    return hn::Min(one, hn::Div(here(lanes.mode_constants.longest_s), h));
  return one;
}

/// An implicit step may end so much after an event of a spring, as a fraction of it.
constexpr double event_window = 1e-7;

/// The springs' events in a step up to t; on other roofs nothing.
template <RoofKind roof, class Series>
HWY_INLINE auto SpringEventsOf([[maybe_unused]] const LaneStates& lanes, [[maybe_unused]] Here here,
                               [[maybe_unused]] const Series& z, [[maybe_unused]] V t) {
  if constexpr (roof == RoofKind::yielding)
    return SpringEvents(lanes, here, z, t);
  else
    return 0;
}

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
    speed = z.Length(here(m.v_s), here(m.v_y));
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
    const V end_speed = z.Length(z.end_s, z.end_y);
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
    const V end_m_speed = z.Length(z.end_s, here(c.aspect) * z.end_y);
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

/// The lanes' bits of neighbouring lanes, as those of all.
HWY_INLINE void Add(const Stepped& some, std::size_t first, std::uint64_t active, Stepped& all) {
  const std::uint64_t mask = (active >> first) & ((std::uint64_t{1} << hn::Lanes(Doubles())) - 1);
  all.event |= (some.event & mask) << first;
  all.other |= (some.other & mask) << first;
  all.passed |= (some.passed & mask) << first;
  all.lifted |= (some.lifted & mask) << first;
  all.shear |= (some.shear & mask) << first;
}

/// Calls what(first) for the vectors with active lanes.
template <class What>
HWY_INLINE void ForVectors(std::uint64_t active, const What& what) {
  const std::size_t n = hn::Lanes(Doubles());
  for (std::size_t first = 0; first < LaneStates::count; first += n)
    if (((active >> first) & ((std::uint64_t{1} << n) - 1)) != 0) what(first);
}

template <RoofKind roof, Friction friction>
Stepped TaylorSteps(LaneStates& lanes, const GroundRows& ground) {
  Stepped all;
  ForVectors(lanes.active, [&](std::size_t first) GLISSADE_INLINE_LAMBDA {
    Add(TaylorStep<roof, friction>(lanes, ground, {first}), first, lanes.active, all);
  });
  return all;
}

/// A stage of one vector waits for the one before: those of all vectors are made in turn.
template <RoofKind roof, Friction friction>
Stepped ImplicitSteps(LaneStates& lanes, const GroundRows& ground) {
  using Step = ImplicitStep<roof, friction>;
  alignas(Step) unsigned char memory[LaneStates::count][sizeof(Step)];
  Step* steps[LaneStates::count];
  std::size_t firsts[LaneStates::count], count = 0;
  ForVectors(lanes.active, [&](std::size_t first) GLISSADE_INLINE_LAMBDA {
    firsts[count] = first;
    steps[count] = new (memory[count]) Step(lanes, ground, first);
    ++count;
  });
  std::size_t left = count;
  Step* todo[LaneStates::count];
  std::copy_n(steps, count, todo);
  const auto pass = [&](auto anew) GLISSADE_INLINE_LAMBDA {
    ForOrders<0, Sdirk4::stages>([&](auto i) GLISSADE_INLINE_LAMBDA {
      for (std::size_t k = 0; k < left; ++k) todo[k]->z.template Stage<i, anew>();
    });
    std::size_t more = 0;
    for (std::size_t k = 0; k < left; ++k)
      if (todo[k]->z.template OnceMore<anew>()) todo[more++] = todo[k];
    left = more;
  };
  pass(std::true_type());
  constexpr int most_passes = 6;
  for (int k = 1; k < most_passes && left > 0; ++k) pass(std::false_type());
  Stepped all;
  for (std::size_t k = 0; k < count; ++k)
    Add(steps[k]->Finish(lanes, ground), firsts[k], lanes.active, all);
  return all;
}

template <RoofKind roof, Friction friction = Friction::coulomb>
Stepped StepsOn(LaneStates& lanes, const GroundRows& ground, StepKind kind) {
  return kind == StepKind::taylor ? TaylorSteps<roof, friction>(lanes, ground)
                                  : ImplicitSteps<roof, friction>(lanes, ground);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_LANE_STEP_INL
