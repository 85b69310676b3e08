// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation
// is elementwise and unfused, so all targets give the same bits.
#include "lane_states.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "lane_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The root of a function that changes sign on [0, to], by the Illinois rule.
template <class Function>
HWY_NOINLINE V Root(const Function& function, V to, V at_begin, V at_end) {
  V low = hn::Zero(Doubles()), high = to, f_low = at_begin, f_high = at_end, x = to;
  for (int i = 0; i < 9; ++i) {
    const V change = f_high - f_low;
    const Mask flat = hn::Eq(change, hn::Zero(Doubles()));
    x = low - hn::Div(f_low * (high - low), hn::IfThenElse(flat, Number(1.0), change));
    x = hn::IfThenElse(flat, low, x);
    const V value = function(x);
    const Mask as_high = hn::Ge(value * f_high, hn::Zero(Doubles()));
    f_low = hn::IfThenElse(as_high, f_low * Number(0.5), value);
    low = hn::IfThenElse(as_high, low, x);
    f_high = hn::IfThenElse(as_high, value, f_high * Number(0.5));
    high = hn::IfThenElse(as_high, x, high);
  }
  return x;
}

/// The lanes' numbers; aggregates, since a constructor made by the compiler is not one of the
/// target's functions.
HWY_INLINE LaneMotion<V> LoadMotion(const LaneStates& lanes, std::size_t first) {
  const auto& m = lanes.motion;
  const auto at = [first](const double* row)
                      GLISSADE_INLINE_LAMBDA { return hn::Load(Doubles(), row + first); };
  return {.left = at(m.left),
          .v_s = at(m.v_s),
          .v_y = at(m.v_y),
          .at_s = at(m.at_s),
          .at_y = at(m.at_y),
          .ground_1 = at(m.ground_1),
          .ground_2 = at(m.ground_2),
          .w = at(m.w),
          .x_1 = at(m.x_1),
          .y_1 = at(m.y_1),
          .x_2 = at(m.x_2),
          .y_2 = at(m.y_2),
          .fastest = at(m.fastest),
          .path = at(m.path),
          .farthest2 = at(m.farthest2),
          .ahead_s = at(m.ahead_s),
          .back_s = at(m.back_s),
          .ahead_y = at(m.ahead_y),
          .back_y = at(m.back_y)};
}

HWY_INLINE Constants<V> LoadConstants(const LaneStates& lanes, std::size_t first) {
  const auto& c = lanes.constants;
  const auto at = [first](const double* row)
                      GLISSADE_INLINE_LAMBDA { return hn::Load(Doubles(), row + first); };
  return {.factor_1 = at(c.factor_1),
          .factor_2 = at(c.factor_2),
          .factor_w = at(c.factor_w),
          .gravity = at(c.gravity),
          .mu = at(c.mu),
          .tangent = at(c.tangent),
          .cosine = at(c.cosine),
          .cosine2 = at(c.cosine2),
          .c = at(c.c),
          .s = at(c.s),
          .c_across = at(c.c_across),
          .s_across = at(c.s_across),
          .tolerance = at(c.tolerance),
          .aspect = at(c.aspect),
          .per_aspect = at(c.per_aspect),
          .omega_1 = at(c.omega_1),
          .omega_2 = at(c.omega_2),
          .twice_zeta_1 = at(c.twice_zeta_1),
          .twice_zeta_2 = at(c.twice_zeta_2),
          .per_mass = at(c.per_mass),
          .omega_rho_1 = at(c.omega_rho_1),
          .omega_rho_2 = at(c.omega_rho_2),
          .kappa = at(c.kappa),
          .rho_sin_cos = at(c.rho_sin_cos),
          .per_kappa_y = at(c.per_kappa_y),
          .anisotropy = at(c.anisotropy)};
}

/// Of the permitted error of a stop. LaneHistory::stop() sees more of the load's change than a
/// lane: below this it takes most stops at once, which else need a stiff step before.
constexpr double surely_permitted = 0.3;

/// Of the tolerance: the errors of the steps add up over a history.
constexpr double series_share = 0.8;

/// Lanes that can make the step: the block would not stop within what is left
/// of the interval by a path known in closed form (LaneHistory::stop), is not too
/// stiff, does not turn far, stays on the roof.
template <RoofKind roof>
HWY_INLINE Mask CanStep(const StepSeries<roof>& z, const Constants<V>& c, const LaneMotion<V>& m,
                        V h, V v_s, V v_y) {
  const V zero = hn::Zero(Doubles());
  V p_s = z.p_s[0], p_y = c.per_aspect * z.p_y[0], n = z.weight[0];
  V change = hn::Abs(z.p_s[1]) + hn::Abs(z.p_y[1]) + hn::Abs(z.weight[1]);
  V anisotropy = zero;
  if constexpr (roof == RoofKind::coupled) {
    p_s = p_s * c.per_kappa_y;
    p_y = p_y * c.per_kappa_y;
    n = n * c.per_kappa_y;
    change = change * c.per_kappa_y;
    anisotropy = n * c.anisotropy;
  }
  const V margin = n * n - (p_s * p_s + p_y * p_y);
  const V q = n * z.speed[0] + (p_s * m.v_s + p_y * (c.per_aspect * m.v_y));
  const V allowed = (Number(surely_permitted * 12.0 * stop_tolerance) * c.tolerance) * m.path;
  const Mask stops =
      hn::And(hn::And(hn::Gt(margin, zero), hn::Lt(q, margin)),
              hn::Le((h * (q * q)) * (change * q + (Number(6.0) * anisotropy) * margin),
                     allowed * ((margin * margin) * margin)));
  const Mask stiff = hn::Gt(z.weight[0], Number(stiffest) * z.speed[0]);
  const V alignment = v_s * m.v_s + (c.aspect * v_y) * (c.aspect * m.v_y);
  const Mask straight = hn::Ge(alignment, Number(least_alignment) * (z.speed[0] * z.speed[0]));
  const V least = (Number(least_weight) * c.mu) * (c.gravity * h);
  const Mask stays = hn::Gt(hn::Min(z.weight[0], z.weight[0] + z.weight[1]), least);
  return hn::AndNot(hn::Or(stops, stiff), hn::And(straight, stays));
}

/// Displacement over the step, as series in tau.
static_assert(order + 2 == LaneStates::path_terms);
struct PathSeries {
  V s[order + 2], y[order + 2];

  template <RoofKind roof>
  HWY_INLINE PathSeries(const StepSeries<roof>& z, const Constants<V>& c, const LaneMotion<V>& m,
                        V h) {
    s[0] = m.at_s;
    y[0] = m.at_y;
    const V h_s = h * c.cosine2, h_y = h * c.cosine;
    ForOrders<0, order + 1>([&](auto k) GLISSADE_INLINE_LAMBDA {
      s[k + 1] = (h_s * Number(inverse[k + 1])) * z.v_s[k];
      y[k + 1] = (h_y * Number(inverse[k + 1])) * z.v_y[k];
    });
  }
};

/// Raises what a history has seen so far to the step's end and to what is
/// between.
template <RoofKind roof>
HWY_INLINE void RaisePeaks(const StepSeries<roof>& z, const Constants<V>& c, const PathSeries& path,
                           Mask goes, V f, V along, LaneMotion<V>& to) {
  const V zero = hn::Zero(Doubles());
  to.farthest2 = hn::Max(to.farthest2, to.at_s * to.at_s + to.at_y * to.at_y);
  to.ahead_s = hn::Max(to.ahead_s, to.at_s);
  to.back_s = hn::Max(to.back_s, zero - to.at_s);
  to.ahead_y = hn::Max(to.ahead_y, to.at_y);
  to.back_y = hn::Max(to.back_y, zero - to.at_y);

  const V begin2 = path.s[0] * path.s[0] + path.y[0] * path.y[0];
  const V out0 = path.s[0] * (c.cosine2 * z.v_s[0]) + path.y[0] * (c.cosine * z.v_y[0]);
  const V out1 = to.at_s * (c.cosine2 * to.v_s) + to.at_y * (c.cosine * to.v_y);
  const auto along_path = [&]() GLISSADE_INLINE_LAMBDA {
    const Mask turns = hn::And(goes, hn::And(hn::Gt(out0, zero), hn::Lt(out1, zero)));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), turns))) return;
    // Twice what is gained where the rate falls as a line.
    const V gain = (Number(2.0) * along) * hn::Div(out0 * out0, out0 - out1);
    const Mask returns = hn::And(turns, hn::Gt(begin2 + gain, to.farthest2));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), returns))) return;
    const auto out = [&](V t) {
      return Polynomial(path.s, t) * (c.cosine2 * Polynomial(z.v_s, t)) +
             Polynomial(path.y, t) * (c.cosine * Polynomial(z.v_y, t));
    };
    const V t = Root(out, f, out0, out1);
    const V s = Polynomial(path.s, t), y = Polynomial(path.y, t);
    to.farthest2 = hn::IfThenElse(returns, hn::Max(to.farthest2, s * s + y * y), to.farthest2);
  };
  const auto along_axis = [&](const V(&v)[order + 1], V v1, const V(&w)[order + 2], V& ahead,
                              V& back) GLISSADE_INLINE_LAMBDA {
    const Mask turns = hn::And(goes, hn::Lt(v[0] * v1, zero));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), turns))) return;
    const V reach = w[0] + hn::Div((f * w[1]) * v[0], v[0] - v1);
    const Mask reverses = hn::And(turns, hn::Or(hn::Gt(reach, ahead), hn::Gt(zero - reach, back)));
    if (HWY_LIKELY(hn::AllFalse(Doubles(), reverses))) return;
    const V t = Root([&](V x) { return Polynomial(v, x); }, f, v[0], v1);
    const V value = Polynomial(w, t);
    ahead = hn::IfThenElse(reverses, hn::Max(ahead, value), ahead);
    back = hn::IfThenElse(reverses, hn::Max(back, zero - value), back);
  };
  along_path();
  along_axis(z.v_s, to.v_s, path.s, to.ahead_s, to.back_s);
  along_axis(z.v_y, to.v_y, path.y, to.ahead_y, to.back_y);
}

/// Writes the motion of the lanes that make the step.
template <RoofKind roof>
HWY_INLINE void Commit(LaneStates& lanes, std::size_t first, Mask goes, const LaneMotion<V>& m) {
  const auto commit = [&](double* row, V value) GLISSADE_INLINE_LAMBDA {
    const V old = hn::Load(Doubles(), row + first);
    hn::Store(hn::IfThenElse(goes, value, old), Doubles(), row + first);
  };
  auto& to = lanes.motion;
  commit(to.left, m.left);
  commit(to.v_s, m.v_s);
  commit(to.v_y, m.v_y);
  commit(to.at_s, m.at_s);
  commit(to.at_y, m.at_y);
  commit(to.ground_1, m.ground_1);
  commit(to.ground_2, m.ground_2);
  commit(to.w, m.w);
  if constexpr (roof != RoofKind::rigid) {
    commit(to.x_1, m.x_1);
    commit(to.y_1, m.y_1);
    commit(to.x_2, m.x_2);
    commit(to.y_2, m.y_2);
  }
  commit(to.fastest, m.fastest);
  commit(to.path, m.path);
  commit(to.farthest2, m.farthest2);
  commit(to.ahead_s, m.ahead_s);
  commit(to.back_s, m.back_s);
  commit(to.ahead_y, m.ahead_y);
  commit(to.back_y, m.back_y);
}

HWY_INLINE std::uint64_t Bits(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

HWY_INLINE void KeepPath(LaneStates::Passed& to, std::size_t first, const PathSeries& path,
                         V begin_s, V length_s, V fraction) {
  const Doubles d;
  for (std::size_t k = 0; k < LaneStates::path_terms; ++k) {
    hn::Store(path.s[k], d, to.path_s[k] + first);
    hn::Store(path.y[k], d, to.path_y[k] + first);
  }
  hn::Store(begin_s, d, to.begin_s + first);
  hn::Store(length_s, d, to.length_s + first);
  hn::Store(fraction, d, to.fraction + first);
}

/// One step of neighbouring lanes; see Stepped.
template <RoofKind roof>
HWY_INLINE Stepped StepVector(LaneStates& lanes, const GroundRows& ground, std::size_t first) {
  const Doubles d;
  const Indices di;
  const V one = Number(1.0);
  const LaneMotion<V> m = LoadMotion(lanes, first);
  const Constants<V> c = LoadConstants(lanes, first);
  const auto node = hn::Load(di, lanes.node + first);
  const auto next = hn::Add(node, hn::Set(di, std::int64_t{1}));
  const auto at = hn::ShiftLeft<2>(hn::Min(next, hn::Set(di, ground.last)));
  const V end_1 = c.factor_1 * hn::GatherIndex(d, ground.nodes, at);
  const V end_2 = c.factor_2 * hn::GatherIndex(d, ground.nodes + 1, at);
  V end_w = m.w;
  if (ground.vertical) end_w = c.factor_w * hn::GatherIndex(d, ground.nodes + 2, at);
  const Ramped ground_1{m.ground_1, end_1 - m.ground_1}, ground_2{m.ground_2, end_2 - m.ground_2},
      up{m.w, end_w - m.w};
  const V h = Number(ground.dt_s) * m.left;
  const StepSeries<roof> z(c, m, ground_1, ground_2, up, h);

  LaneMotion<V> to = m;
  to.fastest = hn::Max(m.fastest, z.speed[0]);
  const V f = StepFraction(z, Number(series_share) * c.tolerance * to.fastest), along = h * f;
  to.path = m.path + along * z.speed[0];
  to.v_s = Polynomial(z.v_s, f);
  to.v_y = Polynomial(z.v_y, f);
  const Mask before = hn::RebindMask(d, hn::Lt(node, hn::Set(di, ground.limit)));
  const Mask goes = hn::And(before, CanStep(z, c, m, h, to.v_s, to.v_y));

  const PathSeries path(z, c, m, h);
  to.at_s = Polynomial(path.s, f);
  to.at_y = Polynomial(path.y, f);
  RaisePeaks(z, c, path, goes, f, along, to);

  const Mask whole = hn::Eq(f, one);
  to.left = hn::IfThenElse(whole, one, m.left * (one - f));
  to.ground_1 = hn::IfThenElse(whole, end_1, ground_1.begin + f * ground_1.rise);
  to.ground_2 = hn::IfThenElse(whole, end_2, ground_2.begin + f * ground_2.rise);
  to.w = hn::IfThenElse(whole, end_w, up.begin + f * up.rise);
  if constexpr (roof != RoofKind::rigid) {
    to.x_1 = Polynomial(z.x_1, f);
    to.y_1 = Polynomial(z.y_1, f);
    to.x_2 = Polynomial(z.x_2, f);
    to.y_2 = Polynomial(z.y_2, f);
  }
  Commit<roof>(lanes, first, goes, to);
  const auto moved = hn::RebindMask(di, hn::And(goes, whole));
  hn::Store(hn::IfThenElse(moved, next, node), di, lanes.node + first);

  const Mask reached = hn::And(goes, hn::Ge(to.farthest2, hn::Load(d, lanes.next2 + first)));
  Stepped stepped;
  if (HWY_UNLIKELY(!hn::AllFalse(d, reached))) {
    const V whole_nodes = hn::ConvertTo(d, next);
    KeepPath(lanes.passed, first, path, (whole_nodes - m.left) * Number(ground.dt_s), h, f);
    stepped.passed = Bits(reached);
  }
  stepped.left = ~Bits(goes) & ((std::uint64_t{1} << hn::Lanes(d)) - 1);
  return stepped;
}

template <RoofKind roof>
Stepped StepAll(LaneStates& lanes, const GroundRows& ground) {
  const std::size_t n = hn::Lanes(Doubles());
  Stepped all;
  for (std::size_t first = 0; first < LaneStates::count; first += n) {
    if (((lanes.active >> first) & ((std::uint64_t{1} << n) - 1)) == 0) continue;
    const Stepped some = StepVector<roof>(lanes, ground, first);
    all.left |= some.left << first;
    all.passed |= some.passed << first;
  }
  return {all.left & lanes.active, all.passed & lanes.active};
}

Stepped Step(LaneStates& lanes, const GroundRows& ground, RoofKind roof) {
  switch (roof) {
    case RoofKind::rigid:
      return StepAll<RoofKind::rigid>(lanes, ground);
    case RoofKind::building:
      return StepAll<RoofKind::building>(lanes, ground);
    case RoofKind::coupled:
      break;
  }
  return StepAll<RoofKind::coupled>(lanes, ground);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(Step);

Stepped step(LaneStates& lanes, const GroundRows& ground, RoofKind roof) {
  return HWY_DYNAMIC_DISPATCH(Step)(lanes, ground, roof);
}

}  // namespace glissade::block_detail::two_axes
#endif
