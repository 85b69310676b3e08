// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact step of oscillators in SIMD lanes. Included once per SIMD target.
#if defined(GLISSADE_OSCILLATOR_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_OSCILLATOR_LANES_INL
#undef GLISSADE_OSCILLATOR_LANES_INL
#else
#define GLISSADE_OSCILLATOR_LANES_INL
#endif

#include <hwy/highway.h>

#include "core/oscillator_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::oscillator_lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, count / 2);
using Vector = hn::Vec<Doubles>;

/// The lanes from `first` on.
HWY_INLINE Vector Load(const PerOscillator& numbers, std::size_t first) {
  return hn::Load(Doubles(), numbers.values + first);
}
HWY_INLINE void Store(Vector lanes, PerOscillator& numbers, std::size_t first) {
  hn::Store(lanes, Doubles(), numbers.values + first);
}

struct StateOfLanes {
  Vector x, y;
};

/// Those of some lanes, in registers.
struct StepOfLanes {
  Vector xx, xy, yy, x_start, x_end, y_start, y_end;

  HWY_INLINE StepOfLanes(const Steps& of, std::size_t first)
      : xx(Load(of.xx, first)),
        xy(Load(of.xy, first)),
        yy(Load(of.yy, first)),
        x_start(Load(of.x_start, first)),
        x_end(Load(of.x_end, first)),
        y_start(Load(of.y_start, first)),
        y_end(Load(of.y_end, first)) {}

  /// OscillatorStep::after
  HWY_INLINE StateOfLanes After(const StateOfLanes& s, Vector a0, Vector a1) const {
    const Vector x_forced = hn::Add(hn::Mul(x_start, a0), hn::Mul(x_end, a1));
    const Vector y_forced = hn::Add(hn::Mul(y_start, a0), hn::Mul(y_end, a1));
    return {hn::Sub(hn::Add(hn::Mul(xx, s.x), hn::Mul(xy, s.y)), x_forced),
            hn::Sub(hn::Sub(hn::Mul(yy, s.y), hn::Mul(xy, s.x)), y_forced)};
  }
};

}  // namespace glissade::oscillator_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_OSCILLATOR_LANES_INL
