// SPDX-License-Identifier: GPL-3.0-or-later
//
// When the springs of a building yield or unload in a step. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_LANE_SPRINGS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_LANE_SPRINGS_INL
#undef GLISSADE_TWO_AXES_LANE_SPRINGS_INL
#else
#define GLISSADE_TWO_AXES_LANE_SPRINGS_INL
#endif

#include "lane_root-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

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
  constexpr int bisections = 4;
  return hn::IfThenElse(falls, RootOf<bisections>(f, lowest, f.of[0], value), at);
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
    V up[n], down[n];
    ForOrders<0, n>([&](auto k) GLISSADE_INLINE_LAMBDA {
      V unloads = zero;
      if constexpr (k < m) unloads = direction * rate[k];
      up[k] = hn::IfThenElse(elastic, hn::Neg(x[k]), unloads);
      down[k] = hn::IfThenElseZero(elastic, x[k]);
    });
    up[0] = hn::IfThenElse(elastic, here(s.high[axis]) - x[0], up[0]) + margin;
    down[0] = hn::IfThenElse(elastic, x[0] - here(s.low[axis]), zero) + margin;
    V changes[n];
    changes[0] = zero;
    ForOrders<1, n>([&](auto k) GLISSADE_INLINE_LAMBDA { changes[k] = hn::Abs(up[k]); });
    const V change = Polynomial(changes, t);
    if (HWY_UNLIKELY(!hn::AllTrue(Doubles(), hn::Ge(up[0], change))))
      up_[axis] = FirstFall<n>(Terms(up), t);
    const Mask stays = hn::Or(hn::Not(elastic), hn::Ge(down[0], change));
    if (HWY_UNLIKELY(!hn::AllTrue(Doubles(), stays))) down_[axis] = FirstFall<n>(Terms(down), t);
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

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_LANE_SPRINGS_INL
