// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes the lanes over a step, with the base shear that the building had in it. Included once per
// SIMD target.
#if defined(GLISSADE_TWO_AXES_ADVANCE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_ADVANCE_INL
#undef GLISSADE_TWO_AXES_ADVANCE_INL
#else
#define GLISSADE_TWO_AXES_ADVANCE_INL
#endif

#include "block/two_axes/lanes/interval-inl.hpp"
#include "block/two_axes/lanes/peaks-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// No |value| of the series up to t is larger: that at the ends, and how far it leaves its chord.
template <int n>
HWY_INLINE V Bound(const V (&c)[n], V t) {
  V sizes[n - 2];
  ForOrders<0, n - 2>([&](auto k) GLISSADE_INLINE_LAMBDA { sizes[k] = hn::Abs(c[k + 2]); });
  sizes[0] = Number(0.25) * sizes[0];
  return hn::Max(hn::Abs(c[0]), hn::Abs(Polynomial(c, t))) + (t * t) * Polynomial(sizes, t);
}

/// Keeps the series of the lanes whose base shear may exceed what it was in a step over the
/// fraction f: those lanes, as bits.
template <class Series>
HWY_INLINE std::uint64_t FollowShear(LaneStates& lanes, Here here, const Series& z, V f,
                                     Mask goes) {
  const Doubles d;
  LaneStates::Shear& shear = lanes.shear;
  const Mask exceeds = hn::Or(hn::Gt(Bound(z.a_1, f), here(shear.largest[0])),
                              hn::Gt(Bound(z.a_2, f), here(shear.largest[1])));
  const Mask kept = hn::And(goes, exceeds);
  if (HWY_LIKELY(hn::AllFalse(d, kept))) return 0;
  ForOrders<0, roof_order>([&](auto k) GLISSADE_INLINE_LAMBDA {
    hn::Store(z.a_1[k], d, shear.a[0][k] + here.first);
    hn::Store(z.a_2[k], d, shear.a[1][k] + here.first);
  });
  hn::Store(f, d, shear.fraction + here.first);
  return Bits(kept);
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

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_ADVANCE_INL
