// SPDX-License-Identifier: GPL-3.0-or-later
#include "max_pass.hpp"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/max_pass.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Four accumulators: a maximum takes several cycles, and its chain must not be what is measured.
double max_pass(const double* values, std::size_t count) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  auto m0 = hn::Zero(d), m1 = m0, m2 = m0, m3 = m0;
  std::size_t i = 0;
  for (; i + 4 * lanes <= count; i += 4 * lanes) {
    m0 = hn::Max(m0, hn::Abs(hn::LoadU(d, values + i)));
    m1 = hn::Max(m1, hn::Abs(hn::LoadU(d, values + i + lanes)));
    m2 = hn::Max(m2, hn::Abs(hn::LoadU(d, values + i + 2 * lanes)));
    m3 = hn::Max(m3, hn::Abs(hn::LoadU(d, values + i + 3 * lanes)));
  }
  double most = hn::GetLane(hn::MaxOfLanes(d, hn::Max(hn::Max(m0, m1), hn::Max(m2, m3))));
  for (; i < count; ++i) most = std::max(most, std::abs(values[i]));
  return most;
}

const char* target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace glissade::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::bench {

HWY_EXPORT(max_pass);
HWY_EXPORT(target);

double max_pass(std::span<const double> values) {
  return HWY_DYNAMIC_DISPATCH(max_pass)(values.data(), values.size());
}
std::string max_pass_target() { return HWY_DYNAMIC_DISPATCH(target)(); }

}  // namespace glissade::bench
#endif
