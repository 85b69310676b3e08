// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of several lanes, and polynomials of them. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_NUMBERS_INL
#undef GLISSADE_TWO_AXES_NUMBERS_INL
#else
#define GLISSADE_TWO_AXES_NUMBERS_INL
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "block/two_axes/lanes/lane_states.hpp"

#ifndef GLISSADE_INLINE_LAMBDA
#define GLISSADE_INLINE_LAMBDA __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using Indices = hn::RebindToSigned<Doubles>;
using V = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr int order = 6;        // of the velocity
constexpr int roof_order = 10;  // of the building
static_assert(roof_order == row_terms);

inline V Number(double value) { return hn::Set(Doubles(), value); }

using Rows = LaneStates::Lanes;

HWY_INLINE std::uint64_t Bits(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

/// The lanes of a vector: their numbers of a row, read from memory where they are used.
struct Here {
  std::size_t first;
  HWY_INLINE V operator()(const Rows& row) const { return Row(row); }
  HWY_INLINE V Row(const double* row) const { return hn::Load(Doubles(), row + first); }
};

/// Loops over orders are unrolled: each order is a constant, and its series
/// stay in registers.
template <int k>
using Order = std::integral_constant<int, k>;
template <int begin, int end, class What>
HWY_INLINE void ForOrders(const What& what) {
  if constexpr (begin < end) {
    what(Order<begin>());
    ForOrders<begin + 1, end>(what);
  }
}

/// In pairs of terms: half as many operations wait for each other.
template <int k = 0, int n>
HWY_INLINE V Polynomial(const V (&c)[n], V t) {
  if constexpr (k + 1 == n)
    return c[k];
  else if constexpr (k + 2 == n)
    return c[k + 1] * t + c[k];
  else
    return Polynomial<k + 2>(c, t) * (t * t) + (c[k + 1] * t + c[k]);
}

constexpr double inverse[] = {0.0,     1.0,     1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5,
                              1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10};

/// The integral of a power series from zero to t.
template <int n>
HWY_INLINE V Integral(const V (&c)[n], V t) {
  V terms[n];
  ForOrders<0, n>([&](auto k) GLISSADE_INLINE_LAMBDA { terms[k] = c[k] * Number(inverse[k + 1]); });
  return Polynomial(terms, t) * t;
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_NUMBERS_INL
