// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a sample interval. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_INTERVAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_INTERVAL_INL
#undef GLISSADE_TWO_AXES_INTERVAL_INL
#else
#define GLISSADE_TWO_AXES_INTERVAL_INL
#endif

#include "block/two_axes/lanes/roof_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The smooth part of a sample interval that is left, and what the ground does in it.
struct LaneInterval {
  hn::Vec<Indices> node, next;
  Mask before;  // the last that the lanes go through
  V end_1, end_2, end_w;
  Ramped ground_1, ground_2, up;
  TableRow row;
  V h;
};

/// Where the row of a node begins in RestTable::rows.
HWY_INLINE hn::Vec<Indices> RowStart(hn::Vec<Indices> node) {
  static_assert(2 * row_terms == 16 + 4);
  return hn::Add(hn::ShiftLeft<4>(node), hn::ShiftLeft<2>(node));
}

HWY_INLINE LaneInterval LoadInterval(const LaneStates& lanes, const GroundRows& ground, Here here) {
  const LaneMotion<Rows>& m = lanes.motion;
  const Constants<Rows>& c = lanes.constants;
  const Doubles d;
  const Indices di;
  const auto node = hn::Load(di, lanes.node + here.first);
  const auto next = hn::Add(node, hn::Set(di, std::int64_t{1}));
  const auto at = hn::ShiftLeft<2>(hn::Min(next, hn::Set(di, ground.last)));
  const V end_1 = here(c.factor_1) * hn::GatherIndex(d, ground.nodes, at);
  const V end_2 = here(c.factor_2) * hn::GatherIndex(d, ground.nodes + 1, at);
  V end_w = here(m.w);
  if (ground.vertical) end_w = here(c.factor_w) * hn::GatherIndex(d, ground.nodes + 2, at);
  return {node,
          next,
          hn::RebindMask(d, hn::Lt(node, hn::Load(di, lanes.limit + here.first))),
          end_1,
          end_2,
          end_w,
          {here(m.ground_1), end_1 - here(m.ground_1)},
          {here(m.ground_2), end_2 - here(m.ground_2)},
          {here(m.w), end_w - here(m.w)},
          {ground.nodes, hn::Add(hn::Load(di, lanes.rows + here.first), RowStart(node))},
          Number(ground.dt_s) * here(m.left)};
}

/// Of the interval's rest, over which the roof's series converge.
template <RoofKind roof>
HWY_INLINE V LongestFraction(const LaneStates& lanes, Here here, V h) {
  const V one = Number(1.0);
  if constexpr (roof == RoofKind::coupled_modes)
    return hn::Min(one, hn::Div(here(lanes.mode_constants.longest_s), h));
  return one;
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_INTERVAL_INL
