// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation
// is elementwise and unfused, so all targets give the same bits.
#include "block/two_axes/roof/rest_search.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/roof/rest_search.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::size_t FirstRelease(const RestMotion& motion, const Constants<double>& c, double needed) {
  const HWY_CAPPED(double, 8) d;
  const auto number = [d](double value) { return hn::Set(d, value); };
  for (std::size_t k = 0; k < 8; k += hn::Lanes(d)) {
    const auto roof = [&](const RestMotion::Axis& axis) {
      auto a = number(axis.factor) * hn::LoadU(d, axis.a + k);
      for (std::size_t n = 0; n < axis.count; ++n) {
        const RestMotion::Axis::Free& free = axis.free[n];
        a = a + (hn::LoadU(d, free.x_part + k) * number(free.state.x) +
                 hn::LoadU(d, free.y_part + k) * number(free.state.y));
      }
      return a;
    };
    const auto a_1 = roof(motion.axis[0]), a_2 = roof(motion.axis[1]);
    const auto fall = number(c.gravity) + number(c.factor_w) * hn::LoadU(d, motion.w + k);
    const auto along = number(c.c) * a_1 + number(c.s) * a_2;
    const auto p_s = fall * number(c.tangent) - along;
    const auto p_y = number(c.per_aspect) * (number(c.s_across) * a_1 - number(c.c_across) * a_2);
    const auto holds = number(c.mu_at_rest) * (fall + number(c.tangent) * along) - number(needed);
    auto rests = hn::And(hn::Ge(holds, hn::Zero(d)), hn::Le(p_s * p_s + p_y * p_y, holds * holds));
    for (const RestMotion::Axis& axis : motion.axis) {
      if (!motion.springs) break;
      const RestMotion::Axis::Spring& spring = axis.spring;
      const OscillatorState& free = axis.free[0].state;
      const auto x = number(axis.factor) * hn::LoadU(d, spring.x + k) +
                     (hn::LoadU(d, spring.x_part + k) * number(free.x) +
                      hn::LoadU(d, spring.y_part + k) * number(free.y));
      rests =
          hn::And(rests, hn::And(hn::Lt(x, number(spring.high)), hn::Gt(x, number(spring.low))));
    }
    const auto released = hn::FindFirstTrue(d, hn::Not(rests));
    if (released >= 0) return k + static_cast<std::size_t>(released);
  }
  return 8;
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(FirstRelease);

std::size_t first_release(const RestMotion& motion, const Constants<double>& constants,
                          double needed) {
  return HWY_DYNAMIC_DISPATCH(FirstRelease)(motion, constants, needed);
}

}  // namespace glissade::block_detail::two_axes
#endif
