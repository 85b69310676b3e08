// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation
// is elementwise and unfused, so all targets give the same bits.
#include "block/two_axes/lanes/lane_states.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/lanes/by_speed_lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "block/two_axes/lanes/lane_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

Stepped BySpeedStep(LaneStates& lanes, const GroundRows& ground, RoofKind roof, StepKind kind) {
  constexpr Friction by_speed = Friction::by_speed;
  if (roof == RoofKind::rigid) return StepsOn<RoofKind::rigid, by_speed>(lanes, ground, kind);
  if (roof == RoofKind::modes) return StepsOn<RoofKind::modes, by_speed>(lanes, ground, kind);
  if (roof == RoofKind::coupled) return StepsOn<RoofKind::coupled, by_speed>(lanes, ground, kind);
  return StepsOn<RoofKind::coupled_modes, by_speed>(lanes, ground, kind);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(BySpeedStep);

Stepped by_speed_step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, StepKind kind) {
  return HWY_DYNAMIC_DISPATCH(BySpeedStep)(lanes, ground, roof, kind);
}

}  // namespace glissade::block_detail::two_axes
#endif
