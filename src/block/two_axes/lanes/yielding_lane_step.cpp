// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation
// is elementwise and unfused, so all targets give the same bits.
#include "block/two_axes/lanes/lane_states.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/lanes/yielding_lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "block/two_axes/lanes/lane_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

Stepped YieldingStep(LaneStates& lanes, const GroundRows& ground, Friction friction,
                     StepKind kind) {
  constexpr auto roof = RoofKind::yielding;
  if (friction == Friction::coulomb) return StepsOn<roof>(lanes, ground, kind);
  return StepsOn<roof, Friction::by_speed>(lanes, ground, kind);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(YieldingStep);

Stepped yielding_step(LaneStates& lanes, const GroundRows& ground, Friction friction,
                      StepKind kind) {
  return HWY_DYNAMIC_DISPATCH(YieldingStep)(lanes, ground, friction, kind);
}

}  // namespace glissade::block_detail::two_axes
#endif
