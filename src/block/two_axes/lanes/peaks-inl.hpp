// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest displacements of a step. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_PEAKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_PEAKS_INL
#undef GLISSADE_TWO_AXES_PEAKS_INL
#else
#define GLISSADE_TWO_AXES_PEAKS_INL
#endif

#include "block/two_axes/lanes/root-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

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

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_PEAKS_INL
