// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation is elementwise and
// unfused, so all targets give the same bits.
#include "oscillator_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "motion/oscillator_block.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "core/oscillator_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::motion_detail::HWY_NAMESPACE {

namespace lanes = oscillator_lanes::HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;
using lanes::Doubles, lanes::Vector;

/// Some of a block's oscillators, in registers.
struct Walk {
  std::size_t first;
  Vector twice_zeta, bulge;
  lanes::StepOfLanes after;
  lanes::StateOfLanes now, next;
  Vector v, v1, peak;

  Walk(const OscillatorBlock& b, std::size_t first_oscillator)
      : first(first_oscillator),
        twice_zeta(hn::Set(Doubles(), 2.0 * b.zeta)),
        bulge(lanes::Load(b.bulge, first)),
        after(b.steps, first),
        now{lanes::Load(b.now.x, first), lanes::Load(b.now.y, first)},
        next(now),
        v(lanes::Load(b.now.v, first)),
        v1(v),
        peak(lanes::Load(b.peak, first)) {}

  /// Steps to the end of the interval; returns a positive number if the interval must be searched.
  /// Inside it |x| exceeds its end values by at most h^2/8 max|v|; v, a free vibration there,
  /// exceeds its end values by at most 15 % if h <= 1. And y must pass zero, once or twice.
  Vector step(Vector a0, Vector a1) {
    next = after.After(now, a0, a1);
    v1 = hn::Neg(hn::Add(hn::Add(next.x, hn::Mul(twice_zeta, next.y)), a1));
    const Vector x_ends = hn::Max(hn::Abs(next.x), hn::Abs(now.x));
    peak = hn::Max(peak, x_ends);
    const Vector v_ends = hn::Max(hn::Abs(v1), hn::Abs(v));
    const Vector excess = hn::Sub(hn::Add(x_ends, hn::Mul(bulge, v_ends)), peak);
    return hn::Min(excess, hn::Neg(hn::Min(hn::Mul(next.y, now.y), hn::Mul(v1, v))));
  }

  void go_on() { now = next, v = v1; }

  void store(OscillatorBlock& b) const {
    lanes::Store(now.x, b.now.x, first);
    lanes::Store(now.y, b.now.y, first);
    lanes::Store(v, b.now.v, first);
    lanes::Store(next.x, b.next.x, first);
    lanes::Store(next.y, b.next.y, first);
    lanes::Store(v1, b.next.v, first);
    lanes::Store(peak, b.peak, first);
  }
};

void Advance(OscillatorBlock& block, std::size_t count, const double* ground, std::size_t intervals,
             LookInside look_inside) {
  const Doubles d;
  const std::size_t n = hn::Lanes(d);
  for (std::size_t first = 0; first < count; first += 2 * n) {
    Walk one(block, first), other(block, first + n);  // two, to hide each other's latency
    for (std::size_t i = 0; i < intervals; ++i) {
      const Vector a0 = hn::Set(d, ground[i]), a1 = hn::Set(d, ground[i + 1]);
      const Vector look = hn::Max(one.step(a0, a1), other.step(a0, a1));
      if (!hn::AllFalse(d, hn::Gt(look, hn::Zero(d)))) {
        one.store(block);
        other.store(block);
        look_inside(block, first, first + 2 * n, ground[i], ground[i + 1]);
        one.peak = lanes::Load(block.peak, one.first);
        other.peak = lanes::Load(block.peak, other.first);
      }
      one.go_on();
      other.go_on();
    }
    one.store(block);
    other.store(block);
  }
}

}  // namespace glissade::motion_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::motion_detail {
HWY_EXPORT(Advance);

void advance(OscillatorBlock& block, std::size_t count, std::span<const double> ground_mps2,
             LookInside look_inside) {
  HWY_DYNAMIC_DISPATCH(Advance)
  (block, count, ground_mps2.data(), ground_mps2.size() - 1, look_inside);
}

}  // namespace glissade::motion_detail
#endif
