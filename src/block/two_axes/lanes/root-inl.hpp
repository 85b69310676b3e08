// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots in lanes. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_ROOT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_ROOT_INL
#undef GLISSADE_TWO_AXES_ROOT_INL
#else
#define GLISSADE_TWO_AXES_ROOT_INL
#endif

#include "block/two_axes/lanes/numbers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The root of a function that changes sign on [0, to], by the Illinois rule after bisections.
template <int bisections = 0, class Function>
HWY_INLINE V Root(const Function& function, V to, V at_begin, V at_end) {
  V low = hn::Zero(Doubles()), high = to, f_low = at_begin, f_high = at_end, x = to;
  for (int i = 0; i < bisections; ++i) {
    x = Number(0.5) * (low + high);
    const V value = function(x);
    const Mask as_high = hn::Ge(value * f_high, hn::Zero(Doubles()));
    f_low = hn::IfThenElse(as_high, f_low, value);
    low = hn::IfThenElse(as_high, low, x);
    f_high = hn::IfThenElse(as_high, value, f_high);
    high = hn::IfThenElse(as_high, x, high);
  }
  for (int i = 0; i < 9; ++i) {
    const V change = f_high - f_low;
    const Mask flat = hn::Eq(change, hn::Zero(Doubles()));
    x = low - hn::Div(f_low * (high - low), hn::IfThenElse(flat, Number(1.0), change));
    x = hn::IfThenElse(flat, low, x);
    const V value = function(x);
    const Mask as_high = hn::Ge(value * f_high, hn::Zero(Doubles()));
    f_low = hn::IfThenElse(as_high, f_low * Number(0.5), value);
    low = hn::IfThenElse(as_high, low, x);
    f_high = hn::IfThenElse(as_high, value, f_high * Number(0.5));
    high = hn::IfThenElse(as_high, x, high);
  }
  return x;
}

/// Terms of a power series. What is seldom needed takes copies of them: the address of a series
/// would keep all of it in memory.
template <int n>
struct Terms {
  V of[n];

  explicit HWY_INLINE Terms(const V (&terms)[n]) {
    ForOrders<0, n>([&](auto k) GLISSADE_INLINE_LAMBDA { of[k] = terms[k]; });
  }
};

template <int bisections = 0, int n>
HWY_NOINLINE V RootOf(Terms<n> f, V to, V at_begin, V at_end) {
  return Root<bisections>([&](V x) GLISSADE_INLINE_LAMBDA { return Polynomial(f.of, x); }, to,
                          at_begin, at_end);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_ROOT_INL
