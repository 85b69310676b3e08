// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step of all lanes, by roof and friction. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_LANE_STEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_LANE_STEP_INL
#undef GLISSADE_TWO_AXES_LANE_STEP_INL
#else
#define GLISSADE_TWO_AXES_LANE_STEP_INL
#endif

#include <algorithm>

#include "block/two_axes/lanes/implicit_step-inl.hpp"
#include "block/two_axes/lanes/taylor_step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The lanes' bits of neighbouring lanes, as those of all.
HWY_INLINE void Add(const Stepped& some, std::size_t first, std::uint64_t active, Stepped& all) {
  const std::uint64_t mask = (active >> first) & ((std::uint64_t{1} << hn::Lanes(Doubles())) - 1);
  all.event |= (some.event & mask) << first;
  all.other |= (some.other & mask) << first;
  all.passed |= (some.passed & mask) << first;
  all.lifted |= (some.lifted & mask) << first;
  all.shear |= (some.shear & mask) << first;
}

/// Calls what(first) for the vectors with active lanes.
template <class What>
HWY_INLINE void ForVectors(std::uint64_t active, const What& what) {
  const std::size_t n = hn::Lanes(Doubles());
  for (std::size_t first = 0; first < LaneStates::count; first += n)
    if (((active >> first) & ((std::uint64_t{1} << n) - 1)) != 0) what(first);
}

template <RoofKind roof, Friction friction>
Stepped TaylorSteps(LaneStates& lanes, const GroundRows& ground) {
  Stepped all;
  ForVectors(lanes.active, [&](std::size_t first) GLISSADE_INLINE_LAMBDA {
    Add(TaylorStep<roof, friction>(lanes, ground, {first}), first, lanes.active, all);
  });
  return all;
}

/// A stage of one vector waits for the one before: those of all vectors are made in turn.
template <RoofKind roof, Friction friction>
Stepped ImplicitSteps(LaneStates& lanes, const GroundRows& ground) {
  using Step = ImplicitStep<roof, friction>;
  alignas(Step) unsigned char memory[LaneStates::count][sizeof(Step)];
  Step* steps[LaneStates::count];
  std::size_t firsts[LaneStates::count], count = 0;
  ForVectors(lanes.active, [&](std::size_t first) GLISSADE_INLINE_LAMBDA {
    firsts[count] = first;
    steps[count] = new (memory[count]) Step(lanes, ground, first);
    ++count;
  });
  std::size_t left = count;
  Step* todo[LaneStates::count];
  std::copy_n(steps, count, todo);
  const auto pass = [&](auto anew) GLISSADE_INLINE_LAMBDA {
    ForOrders<0, Sdirk4::stages>([&](auto i) GLISSADE_INLINE_LAMBDA {
      for (std::size_t k = 0; k < left; ++k) todo[k]->z.template Stage<i, anew>();
    });
    std::size_t more = 0;
    for (std::size_t k = 0; k < left; ++k)
      if (todo[k]->z.template OnceMore<anew>()) todo[more++] = todo[k];
    left = more;
  };
  pass(std::true_type());
  constexpr int most_passes = 6;
  for (int k = 1; k < most_passes && left > 0; ++k) pass(std::false_type());
  Stepped all;
  for (std::size_t k = 0; k < count; ++k)
    Add(steps[k]->Finish(lanes, ground), firsts[k], lanes.active, all);
  return all;
}

template <RoofKind roof, Friction friction = Friction::coulomb>
Stepped StepsOn(LaneStates& lanes, const GroundRows& ground, StepKind kind) {
  return kind == StepKind::taylor ? TaylorSteps<roof, friction>(lanes, ground)
                                  : ImplicitSteps<roof, friction>(lanes, ground);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_LANE_STEP_INL
