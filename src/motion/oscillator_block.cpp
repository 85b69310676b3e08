// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation is elementwise and
// unfused, so all targets give the same bits.
#include "oscillator_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "motion/oscillator_block.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::motion_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, block_size / 2);
using Vector = hn::Vec<Doubles>;

Vector Lanes(const PerOscillator& numbers, std::size_t first) {
  return hn::Load(Doubles(), numbers.values + first);
}
void Put(Vector lanes, PerOscillator& numbers, std::size_t first) {
  hn::Store(lanes, Doubles(), numbers.values + first);
}

/// Some of a block's oscillators, in registers.
struct Walk {
  std::size_t first;
  Vector twice_zeta, bulge, xx, xy, yy, x_start, x_end, y_start, y_end;
  Vector x, y, v, x1, y1, v1, peak;

  Walk(const OscillatorBlock& b, std::size_t first_oscillator) : first(first_oscillator) {
    twice_zeta = hn::Set(Doubles(), 2.0 * b.zeta);
    bulge = Lanes(b.bulge, first);
    xx = Lanes(b.xx, first);
    xy = Lanes(b.xy, first);
    yy = Lanes(b.yy, first);
    x_start = Lanes(b.x_start, first);
    x_end = Lanes(b.x_end, first);
    y_start = Lanes(b.y_start, first);
    y_end = Lanes(b.y_end, first);
    x = Lanes(b.now.x, first);
    y = Lanes(b.now.y, first);
    v = Lanes(b.now.v, first);
    x1 = x, y1 = y, v1 = v;
    peak = Lanes(b.peak, first);
  }

  /// Steps to the end of the interval; returns a positive number if the interval must be searched.
  /// Inside it |x| exceeds its end values by at most h^2/8 max|v|; v, a free vibration there,
  /// exceeds its end values by at most 15 % if h <= 1. And y must pass zero, once or twice.
  Vector step(Vector a0, Vector a1) {
    const Vector x_forced = hn::Add(hn::Mul(x_start, a0), hn::Mul(x_end, a1));
    const Vector y_forced = hn::Add(hn::Mul(y_start, a0), hn::Mul(y_end, a1));
    x1 = hn::Sub(hn::Add(hn::Mul(xx, x), hn::Mul(xy, y)), x_forced);
    y1 = hn::Sub(hn::Sub(hn::Mul(yy, y), hn::Mul(xy, x)), y_forced);
    v1 = hn::Neg(hn::Add(hn::Add(x1, hn::Mul(twice_zeta, y1)), a1));
    const Vector x_ends = hn::Max(hn::Abs(x1), hn::Abs(x));
    peak = hn::Max(peak, x_ends);
    const Vector v_ends = hn::Max(hn::Abs(v1), hn::Abs(v));
    const Vector excess = hn::Sub(hn::Add(x_ends, hn::Mul(bulge, v_ends)), peak);
    return hn::Min(excess, hn::Neg(hn::Min(hn::Mul(y1, y), hn::Mul(v1, v))));
  }

  void go_on() { x = x1, y = y1, v = v1; }

  void store(OscillatorBlock& b) const {
    Put(x, b.now.x, first);
    Put(y, b.now.y, first);
    Put(v, b.now.v, first);
    Put(x1, b.next.x, first);
    Put(y1, b.next.y, first);
    Put(v1, b.next.v, first);
    Put(peak, b.peak, first);
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
        one.peak = Lanes(block.peak, one.first);
        other.peak = Lanes(block.peak, other.first);
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
