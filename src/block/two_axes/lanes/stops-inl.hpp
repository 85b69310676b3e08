// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stops that need no more steps. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_STOPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_STOPS_INL
#undef GLISSADE_TWO_AXES_STOPS_INL
#else
#define GLISSADE_TWO_AXES_STOPS_INL
#endif

#include "block/full_model/stop.hpp"
#include "block/two_axes/lanes/numbers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

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
#endif  // GLISSADE_TWO_AXES_STOPS_INL
