// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction that depends on speed (theory.md, 3.5). Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_SPEED_LAW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_SPEED_LAW_INL
#undef GLISSADE_TWO_AXES_SPEED_LAW_INL
#else
#define GLISSADE_TWO_AXES_SPEED_LAW_INL
#endif

#include "block/two_axes/lanes/numbers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// exp(-x) for x >= 0, to rounding, by the same operations on all targets: 2^-k exp(-r), with
/// |r| <= ln(2) / 2.
HWY_INLINE V ExpOfNegative(V x) {
  constexpr double per_ln2 = 1.4426950408889634, ln2_high = 0x1.62e42fefa39efp-1,
                   ln2_low = 0x1.abc9e3b39803fp-56;
  constexpr double to_integer = 0x1.8p52, largest = 700.0;
  x = hn::Min(x, Number(largest));
  const V shifted = x * Number(per_ln2) + Number(to_integer);
  const V k = shifted - Number(to_integer);
  const V r = (k * Number(ln2_high) - x) + k * Number(ln2_low);
  constexpr int terms = 14;
  V series[terms];
  double factorial = 1.0;
  for (int i = 0; i < terms; ++i) {
    if (i > 0) factorial *= i;
    series[i] = Number(1.0 / factorial);
  }
  const Indices di;
  const auto exponent = hn::Sub(hn::Set(di, std::int64_t{1023}), hn::BitCast(di, shifted));
  return Polynomial(series, r) * hn::BitCast(Doubles(), hn::ShiftLeft<52>(exponent));
}

/// mu(|v|) / mu over that of slow sliding, and its rate.
struct SpeedLaw {
  V excess, rate;  ///< fast over slow, less 1; per speed along the slope over its cosine

  HWY_INLINE SpeedLaw(const Constants<Rows>& c, Here here)
      : excess(here(c.fast_excess)), rate(here(c.speed_rate)) {}
  HWY_INLINE V Decay(V speed) const { return ExpOfNegative(rate * speed); }
  HWY_INLINE V Factor(V decay) const { return Number(1.0) + excess * (Number(1.0) - decay); }
  HWY_INLINE V Slope(V decay) const { return (excess * rate) * decay; }
};

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_SPEED_LAW_INL
