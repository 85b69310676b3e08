// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a sample interval, and whether the block stops in it. Included once per SIMD
// target.
#if defined(GLISSADE_TWO_AXES_INTERVAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_INTERVAL_INL
#undef GLISSADE_TWO_AXES_INTERVAL_INL
#else
#define GLISSADE_TWO_AXES_INTERVAL_INL
#endif

#include "block/full_model/stop.hpp"
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

/// Where the row of a node begins, from GroundRows::nodes on. A lane of no history has no rows, and
/// its node goes on: it reads where the nodes begin.
HWY_INLINE hn::Vec<Indices> RowStart(hn::Vec<Indices> rows, hn::Vec<Indices> node) {
  static_assert(2 * row_terms == 16 + 4);
  const auto in_rows = hn::Add(hn::ShiftLeft<4>(node), hn::ShiftLeft<2>(node));
  return hn::IfThenZeroElse(hn::Eq(rows, hn::Zero(Indices())), hn::Add(rows, in_rows));
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
          {ground.nodes, RowStart(hn::Load(di, lanes.rows + here.first), node)},
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

/// Of the permitted error of a stop. LaneHistory::stop() sees more of the load's change than a
/// lane: below this it takes most stops at once, which else need a stiff step before.
constexpr double surely_permitted = 0.3;

/// Where the block stops within what is left of the interval by a path known in closed form
/// (LaneHistory::stop).
template <RoofKind roof, Friction friction, class Series>
HWY_INLINE Mask Stops(const Series& z, const Constants<Rows>& c, const LaneMotion<Rows>& m,
                      Here here, V h) {
  const V zero = hn::Zero(Doubles());
  V p_s = z.p_s[0], p_y = here(c.per_aspect) * z.p_y[0], n = z.weight[0];
  V change = hn::Abs(z.p_s[1]) + hn::Abs(z.p_y[1]) + hn::Abs(z.weight[1]);
  V anisotropy = zero;  // what else is not constant
  if constexpr (has_mass(roof)) {
    p_s = p_s * here(c.per_kappa_y);
    p_y = p_y * here(c.per_kappa_y);
    n = n * here(c.per_kappa_y);
    change = change * here(c.per_kappa_y);
    anisotropy = n * here(c.anisotropy);
  }
  if constexpr (friction == Friction::by_speed)
    anisotropy = anisotropy + n * hn::Abs(z.law_factor[0] - Number(1.0));
  const V v_y = here(c.per_aspect) * here(m.v_y);
  const V margin = n * n - (p_s * p_s + p_y * p_y);
  const V q = n * hn::Sqrt(here(m.v_s) * here(m.v_s) + v_y * v_y) + (p_s * here(m.v_s) + p_y * v_y);
  const V allowed =
      (Number(surely_permitted * 12.0 * stop_tolerance) * here(c.tolerance)) * here(m.path);
  return hn::And(hn::And(hn::And(hn::Gt(margin, zero), hn::Gt(n, zero)), hn::Lt(q, margin)),
                 hn::Le((h * (q * q)) * (change * q + (Number(6.0) * anisotropy) * margin),
                        allowed * ((margin * margin) * margin)));
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_INTERVAL_INL
