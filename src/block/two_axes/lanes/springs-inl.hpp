// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the springs of a building yield or unload in a step. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_SPRINGS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_SPRINGS_INL
#undef GLISSADE_TWO_AXES_SPRINGS_INL
#else
#define GLISSADE_TWO_AXES_SPRINGS_INL
#endif

#include "block/two_axes/lanes/root-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The root of a function between 0, where it is above zero, and `high`, where it is below:
/// Newton's method kept within the bracket.
template <int n>
HWY_INLINE V FallOf(const V (&f)[n], const V (&slope)[n - 1], V high, V f_low, V f_high,
                    Mask moves) {
  const V zero = hn::Zero(Doubles()), half = Number(0.5);
  V low = zero, x = hn::Div(high * f_low, f_low - f_high);
  constexpr int iterations = 20;
  constexpr double converged = 1e-9;  // the step after it is below rounding
  for (int i = 0; i < iterations && !hn::AllFalse(Doubles(), moves); ++i) {
    const V value = Polynomial(f, x);
    const Mask above = hn::Gt(value, zero);
    low = hn::IfThenElse(above, x, low);
    high = hn::IfThenElse(above, high, x);
    const V newton = x - hn::Div(value, Polynomial(slope, x));
    const Mask inside = hn::And(hn::Ge(newton, low), hn::Le(newton, high));
    const V next = hn::IfThenElse(inside, newton, half * (low + high));
    const V moved = hn::Abs(next - x);
    x = hn::IfThenElse(moves, next, x);
    moves = hn::And(moves, hn::Gt(moved, Number(converged) * x));
  }
  return x;
}

/// When a function first falls to zero, up to t, or never; where it begins there at once. A step
/// has one minimum at most.
template <int n>
HWY_NOINLINE V FirstFall(Terms<n> f, V t) {
  const V zero = hn::Zero(Doubles());
  V slope[n - 1];
  ForOrders<0, n - 1>([&](auto k) GLISSADE_INLINE_LAMBDA {
    slope[k] = Number(static_cast<double>(k + 1)) * f.of[k + 1];
  });
  const V slope_at_end = Polynomial(slope, t);
  const Mask dips = hn::And(hn::Lt(slope[0], zero), hn::Gt(slope_at_end, zero));
  V lowest = t;
  if (!hn::AllFalse(Doubles(), dips))
    lowest = hn::IfThenElse(dips, RootOf(Terms(slope), t, slope[0], slope_at_end), t);
  const V value = Polynomial(f.of, lowest);
  const Mask at_once = hn::Le(f.of[0], zero);
  const Mask falls = hn::AndNot(at_once, hn::Lt(value, zero));
  V at = hn::IfThenElse(at_once, zero, Number(never));
  if (hn::AllFalse(Doubles(), falls)) return at;
  return hn::IfThenElse(falls, FallOf(f.of, slope, lowest, f.of[0], value, falls), at);
}

/// Both springs over a step up to t.
class SpringEvents {
 public:
  template <class Series>
  HWY_INLINE SpringEvents(const LaneStates& lanes, Here here, const Series& z, V t)
      : up_{Number(never), Number(never)}, down_{Number(never), Number(never)} {
    Find(lanes, here, 0, z.x_1, z.rate_1, t);
    Find(lanes, here, 1, z.x_2, z.rate_2, t);
  }
  /// The first of them, or never.
  HWY_INLINE V First() const {
    return hn::Min(hn::Min(up_[0], down_[0]), hn::Min(up_[1], down_[1]));
  }
  /// Changes the springs of the lanes that have made a step over the fraction f with an event by
  /// its end; their forces are then x.
  HWY_INLINE void Take(LaneStates& lanes, Here here, Mask goes, V f, V x_1, V x_2) const {
    const Mask first = hn::And(goes, hn::Le(First(), f));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), first))) return;
    TakeAxis(lanes, here, 0, first, f, x_1);
    TakeAxis(lanes, here, 1, first, f, x_2);
  }

 private:
  template <int n, int m>
  HWY_INLINE void Find(const LaneStates& lanes, Here here, std::size_t axis, const V (&x)[n],
                       const V (&rate)[m], V t) {
    static_assert(m < n);
    const SpringMotion<Rows>& s = lanes.spring_motion;
    const V zero = hn::Zero(Doubles());
    const V direction = here(s.direction[axis]), margin = here(lanes.spring_constants.margin[axis]);
    const Mask elastic = hn::Eq(direction, zero);
    // Up to the upper limit, or until it unloads; and down to the lower limit.
    const V up_0 = margin + hn::IfThenElse(elastic, here(s.high[axis]) - x[0], direction * rate[0]),
            down_0 = margin + hn::IfThenElseZero(elastic, x[0] - here(s.low[axis]));
    V moves[n], changes[n];
    moves[0] = changes[0] = zero;
    ForOrders<1, n>([&](auto k) GLISSADE_INLINE_LAMBDA {
      V of_rate = zero;
      if constexpr (k < m) of_rate = rate[k];
      moves[k] = hn::IfThenElse(elastic, x[k], of_rate);
      changes[k] = hn::Abs(moves[k]);
    });
    const V change = Polynomial(changes, t);
    const Mask stays_below = hn::Ge(up_0, change),
               stays_above = hn::Or(hn::Not(elastic), hn::Ge(down_0, change));
    if (HWY_LIKELY(hn::AllTrue(Doubles(), hn::And(stays_below, stays_above)))) return;
    const auto first_fall = [&](Mask stays, V begin, V sign) GLISSADE_INLINE_LAMBDA {
      if (hn::AllTrue(Doubles(), stays)) return Number(never);
      Terms f(moves);
      f.of[0] = begin;
      ForOrders<1, n>([&](auto k) GLISSADE_INLINE_LAMBDA { f.of[k] = sign * f.of[k]; });
      return FirstFall<n>(f, t);
    };
    const V one = Number(1.0);
    up_[axis] = first_fall(stays_below, up_0, hn::IfThenElse(elastic, hn::Neg(one), direction));
    down_[axis] = first_fall(stays_above, down_0, hn::IfThenElseZero(elastic, one));
  }

  HWY_INLINE void TakeAxis(LaneStates& lanes, Here here, std::size_t axis, Mask goes, V f,
                           V x) const {
    SpringMotion<Rows>& s = lanes.spring_motion;
    const Doubles d;
    const V zero = hn::Zero(d), one = Number(1.0), range = here(lanes.spring_constants.range[axis]);
    const V direction = here(s.direction[axis]);
    const Mask elastic = hn::Eq(direction, zero);
    const Mask rises = hn::And(goes, hn::Le(up_[axis], f)),
               falls = hn::AndNot(rises, hn::And(goes, hn::Le(down_[axis], f)));
    const Mask unloads = hn::AndNot(elastic, rises), from_above = hn::Gt(direction, zero);
    const auto keep = [&](double* row, Mask changed, V value) GLISSADE_INLINE_LAMBDA {
      hn::Store(hn::IfThenElse(changed, value, here.Row(row)), d, row + here.first);
    };
    keep(s.high[axis], unloads, hn::IfThenElse(from_above, x, x + range));
    keep(s.low[axis], unloads, hn::IfThenElse(from_above, x - range, x));
    const V next = hn::IfThenElse(falls, hn::Neg(one), hn::IfThenElseZero(elastic, one));
    keep(s.direction[axis], hn::Or(rises, falls), next);
  }

  V up_[2], down_[2];
};

/// The springs' events in a step up to t; on other roofs nothing.
template <RoofKind roof, class Series>
HWY_INLINE auto SpringEventsOf([[maybe_unused]] const LaneStates& lanes, [[maybe_unused]] Here here,
                               [[maybe_unused]] const Series& z, [[maybe_unused]] V t) {
  if constexpr (roof == RoofKind::yielding)
    return SpringEvents(lanes, here, z, t);
  else
    return 0;
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_SPRINGS_INL
