// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation
// is elementwise and unfused, so all targets give the same bits.
#include "block/two_axes/lanes/lane_states.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/lanes/lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "block/two_axes/lanes/lane_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

Stepped Step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, StepKind kind) {
  if (roof == RoofKind::rigid) return StepsOn<RoofKind::rigid>(lanes, ground, kind);
  if (roof == RoofKind::building) return StepsOn<RoofKind::building>(lanes, ground, kind);
  return StepsOn<RoofKind::modes>(lanes, ground, kind);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(Step);

Stepped step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, Friction friction,
             StepKind kind) {
  if (roof == RoofKind::yielding) return yielding_step(lanes, ground, friction, kind);
  if (friction == Friction::by_speed) return by_speed_step(lanes, ground, roof, kind);
  if (has_mass(roof)) return coupled_step(lanes, ground, roof, kind);
  return HWY_DYNAMIC_DISPATCH(Step)(lanes, ground, roof, kind);
}

}  // namespace glissade::block_detail::two_axes
#endif
