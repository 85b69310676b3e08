// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base shear of the building in a step. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_SHEAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_SHEAR_INL
#undef GLISSADE_TWO_AXES_SHEAR_INL
#else
#define GLISSADE_TWO_AXES_SHEAR_INL
#endif

#include "block/two_axes/lanes/numbers-inl.hpp"

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

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_SHEAR_INL
