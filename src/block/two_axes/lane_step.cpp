// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation is elementwise and
// unfused, so all targets give the same bits.
#include <type_traits>

#include "lane_bank.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/two_axes/lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

#define HWY_INLINE_LAMBDA __attribute__((always_inline))
namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using Indices = hn::RebindToSigned<Doubles>;
using V = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr int order = 6;        // of the velocity
constexpr int roof_order = 10;  // of the building

inline V Number(double value) { return hn::Set(Doubles(), value); }

/// Loops over orders are unrolled: each order is a constant, and its series stay in registers.
template <int k>
using Order = std::integral_constant<int, k>;
template <int begin, int end, class What>
HWY_INLINE void ForOrders(const What& what) {
  if constexpr (begin < end) {
    what(Order<begin>());
    ForOrders<begin + 1, end>(what);
  }
}

template <int k = 0, int n>
HWY_INLINE V Polynomial(const V (&c)[n], V t) {
  if constexpr (k + 1 == n)
    return c[k];
  else
    return Polynomial<k + 1>(c, t) * t + c[k];
}

/// The rest of a sample interval, tau its share, as power series of the block's motion.
template <Roof roof>
struct Series {
  V v_s[order + 1], v_y[order + 1];
  V x_1[roof_order + 1], y_1[roof_order + 1], x_2[roof_order + 1], y_2[roof_order + 1];
  V speed, speed_rate;
  V p_s, p_y, n, p_rate, n_rate;  // the load over the length, and how much it changes
};

struct Line {
  V begin, rise;
};

template <Roof roof>
HWY_INLINE void Expand(const Constants<V>& c, const Motion<V>& m, const Line& ground_1,
                       const Line& ground_2, const Line& up, V h, Series<roof>& z) {
  constexpr double inverse[] = {0.0,     1.0,     1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5,
                                1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10};
  V e_s[order], e_y[order], d_s[order], d_y[order], u[order], n[order], weight[order];
  V c_1[roof_order], c_2[roof_order];
  const V zero = hn::Zero(Doubles());
  z.v_s[0] = m.v_s;
  z.v_y[0] = m.v_y;
  u[0] = hn::Sqrt(m.v_s * m.v_s + m.v_y * m.v_y);
  const V per_u = hn::Div(Number(1.0), u[0]);
  z.speed = u[0];
  V phase_1 = zero, phase_2 = zero;
  if constexpr (roof != Roof::rigid) {
    phase_1 = c.omega_1 * h;
    phase_2 = c.omega_2 * h;
    z.x_1[0] = m.x_1;
    z.y_1[0] = m.y_1;
    z.x_2[0] = m.x_2;
    z.y_2[0] = m.y_2;
  }
  V b_along = zero, b_across = zero;
  V per_kappa = zero;
  // One axis' next order; returns its acceleration as far as the block has no part in it.
  const auto respond = [&](int k, V* x, V* y, V* a, V phase, V twice_zeta, V omega_rho, V b,
                           const Line& ground) HWY_INLINE_LAMBDA {
    V rate = y[k];
    if constexpr (roof == Roof::coupled) {
      if (k <= order) rate = rate - omega_rho * b;
    }
    a[k] = zero - (twice_zeta * rate + x[k]);
    if constexpr (roof == Roof::coupled) a[k] = a[k] * c.per_mass;
    const V share = phase * Number(inverse[k + 1]);
    x[k + 1] = share * rate;
    V rise = a[k];
    if (k == 0) rise = rise - ground.begin;
    if (k == 1) rise = rise - ground.rise;
    y[k + 1] = share * rise;
  };
  const auto respond_both = [&](int k) HWY_INLINE_LAMBDA {
    V b_1 = zero, b_2 = zero;
    if constexpr (roof == Roof::coupled) {
      if (k <= order) {
        b_along = c.cosine2 * z.v_s[k];
        b_across = c.cosine * z.v_y[k];
        b_1 = c.c * b_along - c.s * b_across;
        b_2 = c.s * b_along + c.c * b_across;
      }
    }
    respond(k, z.x_1, z.y_1, c_1, phase_1, c.twice_zeta_1, c.omega_rho_1, b_1, ground_1);
    respond(k, z.x_2, z.y_2, c_2, phase_2, c.twice_zeta_2, c.omega_rho_2, b_2, ground_2);
  };
  ForOrders<0, order>([&](auto order_now) HWY_INLINE_LAMBDA {
    constexpr int k = order_now;
    // The load.
    V p_s = zero, p_y = zero;
    if constexpr (roof == Roof::rigid) {
      if (k == 0) c_1[0] = ground_1.begin, c_2[0] = ground_2.begin;
      if (k == 1) c_1[1] = ground_1.rise, c_2[1] = ground_2.rise;
    } else {
      respond_both(k);
    }
    if constexpr (k < 2 || roof != Roof::rigid) {
      const V along = c.c * c_1[k] + c.s * c_2[k];
      p_s = zero - along;
      p_y = c.s_across * c_1[k] - c.c_across * c_2[k];
      weight[k] = c.tangent * along;
      if (k == 0) {
        const V fall = c.gravity + up.begin;
        p_s = p_s + fall * c.tangent;
        weight[0] = weight[0] + fall;
      }
      if (k == 1) {
        p_s = p_s + up.rise * c.tangent;
        weight[1] = weight[1] + up.rise;
      }
      p_s = h * p_s;
      p_y = h * p_y;
      weight[k] = (h * c.mu) * weight[k];
    }
    // The direction.
    if (k == 0) {
      e_s[0] = z.v_s[0] * per_u;
      e_y[0] = z.v_y[0] * per_u;
    } else {
      V s = zero, y = zero;
      ForOrders<2, k>([&](auto j) HWY_INLINE_LAMBDA {
        s = s + u[j] * e_s[k - j];
        y = y + u[j] * e_y[k - j];
      });
      if (k > 1) {
        s = s + u[1] * e_s[k - 1];
        y = y + u[1] * e_y[k - 1];
      }
      e_s[k] = ((z.v_s[k] - u[k] * e_s[0]) - s) * per_u;
      e_y[k] = ((z.v_y[k] - u[k] * e_y[0]) - y) * per_u;
    }
    // The rate.
    if constexpr (roof == Roof::coupled) {
      if (k == 0) per_kappa = hn::Div(Number(1.0), c.kappa - (c.mu * c.gives) * e_s[0]);
      V s = p_s, y = p_y;
      ForOrders<1, k>([&](auto j) HWY_INLINE_LAMBDA {
        s = s - n[k - j] * e_s[j];
        y = y - n[k - j] * e_y[j];
      });
      if (k > 0) {
        s = s - n[0] * e_s[k];
        y = y - n[0] * e_y[k];
      }
      d_s[k] = (s - weight[k] * e_s[0]) * per_kappa;
      n[k] = weight[k] - (c.mu * c.gives) * d_s[k];
      d_y[k] = (y - n[k] * e_y[0]) * c.per_kappa_y;
    } else {
      n[k] = weight[k];
      V s = p_s, y = p_y;
      constexpr int first = roof == Roof::rigid && k > 1 ? k - 1 : 0;
      ForOrders<first, k + 1>([&](auto j) HWY_INLINE_LAMBDA {
        s = s - n[k - j] * e_s[j];
        y = y - n[k - j] * e_y[j];
      });
      d_s[k] = s;
      d_y[k] = y;
    }
    if (k == 0) {
      z.p_s = p_s;
      z.p_y = p_y;
      z.n = weight[0];
    }
    if (k == 1) {
      z.p_rate = hn::Abs(p_s) + hn::Abs(p_y);
      z.n_rate = hn::Abs(weight[1]);
    }
    const V share = Number(inverse[k + 1]);
    z.v_s[k + 1] = d_s[k] * share;
    z.v_y[k + 1] = d_y[k] * share;
    if constexpr (k + 1 < order) {
      V sum = zero;
      ForOrders<1, k>([&](auto j) HWY_INLINE_LAMBDA {
        sum = sum + (e_s[j] * d_s[k - j] + e_y[j] * d_y[k - j]);
      });
      if (k > 0) sum = sum + (e_s[k] * d_s[0] + e_y[k] * d_y[0]);
      sum = sum + (e_s[0] * d_s[k] + e_y[0] * d_y[k]);
      u[k + 1] = sum * share;
    }
  });
  z.speed_rate = u[1];
  if constexpr (roof != Roof::rigid) {
    ForOrders<order, roof_order>([&](auto k) HWY_INLINE_LAMBDA { respond_both(k); });
  }
}

/// How far a step may go, as a share of what is left of the interval.
template <Roof roof>
HWY_INLINE V StepShare(const Series<roof>& z, V allowed) {
  const V one = Number(1.0), half = Number(0.5);
  const V error = hn::Abs(z.v_s[order]) + hn::Abs(z.v_y[order]);
  V f = hn::Min(one, hn::Div(Number(3.0) * z.speed, z.n));
  const Mask slows = hn::Lt(z.speed_rate, hn::Zero(Doubles()));
  const V to_stop = hn::Div(Number(-0.6) * z.speed, hn::IfThenElse(slows, z.speed_rate, one));
  f = hn::IfThenElse(slows, hn::Min(f, to_stop), f);
  const Mask rough = hn::Gt(error, allowed);
  if (!hn::AllFalse(Doubles(), rough)) {
    // x^(1/6) to 1 %, by a sixth of its exponent.
    const hn::Rebind<float, Doubles> df;
    const hn::RebindToSigned<decltype(df)> di;
    constexpr float one_bits = 1065353216.0F;
    const auto ratio = hn::DemoteTo(df, hn::Max(hn::Div(allowed, error), Number(1e-30)));
    const auto bits = hn::ConvertTo(df, hn::BitCast(di, ratio));
    const auto sixth = hn::Add(hn::Mul(hn::Sub(bits, hn::Set(df, one_bits)), hn::Set(df, 1.0F / 6)),
                               hn::Set(df, one_bits));
    const V x = Number(0.9) * hn::PromoteTo(Doubles(), hn::BitCast(df, hn::ConvertTo(di, sixth)));
    f = hn::IfThenElse(rough, hn::Min(f, x), f);
  }
  return hn::IfThenElse(hn::And(hn::Lt(f, one), hn::Gt(f, half)), half, f);
}

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

template <Roof roof>
HWY_INLINE std::uint64_t StepVector(LaneBank& bank, const LaneGround& ground, std::size_t first) {
  const Doubles d;
  const Indices di;
  const auto load = [&](const double* row) { return hn::Load(d, row + first); };
  const auto& mb = bank.motion;
  const auto& cb = bank.constants;
  const V zero = hn::Zero(d), one = Number(1.0);
  Motion<V> m;
  Constants<V> c;
  m.left = load(mb.left);
  m.v_s = load(mb.v_s);
  m.v_y = load(mb.v_y);
  m.ground_1 = load(mb.ground_1);
  m.ground_2 = load(mb.ground_2);
  m.w = load(mb.w);
  c.gravity = load(cb.gravity);
  c.mu = load(cb.mu);
  c.tangent = load(cb.tangent);
  c.cosine = load(cb.cosine);
  c.cosine2 = load(cb.cosine2);
  c.c = load(cb.c);
  c.s = load(cb.s);
  c.c_across = load(cb.c_across);
  c.s_across = load(cb.s_across);
  c.tolerance = load(cb.tolerance);
  if constexpr (roof != Roof::rigid) {
    m.x_1 = load(mb.x_1);
    m.x_2 = load(mb.x_2);
    m.y_1 = load(mb.y_1);
    m.y_2 = load(mb.y_2);
    c.omega_1 = load(cb.omega_1);
    c.omega_2 = load(cb.omega_2);
    c.twice_zeta_1 = load(cb.twice_zeta_1);
    c.twice_zeta_2 = load(cb.twice_zeta_2);
  }
  if constexpr (roof == Roof::coupled) {
    c.per_mass = load(cb.per_mass);
    c.omega_rho_1 = load(cb.omega_rho_1);
    c.omega_rho_2 = load(cb.omega_rho_2);
    c.kappa = load(cb.kappa);
    c.gives = load(cb.gives);
    c.per_kappa_y = load(cb.per_kappa_y);
  }
  const auto node = hn::Load(di, bank.node + first);
  const auto next = hn::Add(node, hn::Set(di, std::int64_t{1}));
  const auto at = hn::ShiftLeft<2>(hn::Min(next, hn::Set(di, ground.last)));
  const V end_1 = load(cb.factor_1) * hn::GatherIndex(d, ground.nodes, at);
  const V end_2 = load(cb.factor_2) * hn::GatherIndex(d, ground.nodes + 1, at);
  V end_w = m.w;
  if (ground.vertical) end_w = load(cb.factor_w) * hn::GatherIndex(d, ground.nodes + 2, at);
  const Line ground_1{m.ground_1, end_1 - m.ground_1}, ground_2{m.ground_2, end_2 - m.ground_2},
      up{m.w, end_w - m.w};
  const V h = Number(ground.dt_s) * m.left;
  Series<roof> z;
  Expand(c, m, ground_1, ground_2, up, h, z);

  const V fastest = hn::Max(load(mb.fastest), z.speed);
  const V path = load(mb.path);
  const V f = StepShare(z, c.tolerance * fastest);
  const V v_s = Polynomial(z.v_s, f), v_y = Polynomial(z.v_y, f);

  // Who cannot go: it would stop, is too stiff, turns too far, may lift off, is at the end.
  V p_s = z.p_s, p_y = z.p_y, n = z.n, jerk = z.p_rate + z.n_rate;
  if constexpr (roof == Roof::coupled) {
    p_s = p_s * c.per_kappa_y;
    p_y = p_y * c.per_kappa_y;
    n = n * c.per_kappa_y;
    jerk = jerk * c.per_kappa_y;
  }
  const V margin = n * n - (p_s * p_s + p_y * p_y);
  const V q = n * z.speed + (p_s * m.v_s + p_y * m.v_y);
  const V allowed = (Number(12e-3) * c.tolerance) * path;
  const Mask stops =
      hn::And(hn::And(hn::Gt(margin, zero), hn::Lt(q, margin)),
              hn::Le(((jerk * h) * q) * (q * q), allowed * ((margin * margin) * margin)));
  const Mask stiff = hn::Gt(z.n, Number(stiffest) * z.speed);
  const V turned = v_s * m.v_s + v_y * m.v_y;
  const Mask fine = hn::And(hn::Ge(turned, Number(0.2) * (z.speed * z.speed)),
                            hn::Gt(z.n, (Number(0.05) * c.mu) * (c.gravity * h)));
  const Mask before = hn::RebindMask(d, hn::Lt(node, hn::Set(di, ground.limit)));
  const Mask goes = hn::AndNot(hn::Or(stops, stiff), hn::And(fine, before));

  // Its way.
  V way_s[order + 2], way_y[order + 2];
  constexpr double inverse[] = {0.0, 1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7};
  const V h_s = h * c.cosine2, h_y = h * c.cosine;
  const V at_s0 = load(mb.at_s), at_y0 = load(mb.at_y);
  way_s[0] = at_s0;
  way_y[0] = at_y0;
  ForOrders<0, order + 1>([&](auto k) HWY_INLINE_LAMBDA {
    way_s[k + 1] = (h_s * Number(inverse[k + 1])) * z.v_s[k];
    way_y[k + 1] = (h_y * Number(inverse[k + 1])) * z.v_y[k];
  });
  const V at_s = Polynomial(way_s, f), at_y = Polynomial(way_y, f);
  V farthest2 = hn::Max(load(mb.farthest2), at_s * at_s + at_y * at_y);
  V ahead_s = hn::Max(load(mb.ahead_s), at_s), back_s = hn::Max(load(mb.back_s), zero - at_s);
  V ahead_y = hn::Max(load(mb.ahead_y), at_y), back_y = hn::Max(load(mb.back_y), zero - at_y);

  // Peaks between its ends.
  const V out0 = at_s0 * (c.cosine2 * m.v_s) + at_y0 * (c.cosine * m.v_y);
  const V out1 = at_s * (c.cosine2 * v_s) + at_y * (c.cosine * v_y);
  const V along = h * f;
  // Twice what the way out goes on where its rate falls as a line.
  const V gain = (Number(2.0) * along) * hn::Div(out0 * out0, out0 - out1);
  const Mask turns =
      hn::And(goes, hn::And(hn::And(hn::Gt(out0, zero), hn::Lt(out1, zero)),
                            hn::Gt((at_s0 * at_s0 + at_y0 * at_y0) + gain, farthest2)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, turns))) {
    const auto out = [&](V t) {
      return Polynomial(way_s, t) * (c.cosine2 * Polynomial(z.v_s, t)) +
             Polynomial(way_y, t) * (c.cosine * Polynomial(z.v_y, t));
    };
    const V t = Root(out, f, out0, out1);
    const V s = Polynomial(way_s, t), y = Polynomial(way_y, t);
    farthest2 = hn::IfThenElse(turns, hn::Max(farthest2, s * s + y * y), farthest2);
  }
  const auto turns_along = [&](const V(&v)[order + 1], V v1, const V(&way)[order + 2], V& ahead,
                               V& back) {
    const V reach = way[0] + hn::Div((f * way[1]) * v[0], v[0] - v1);
    const Mask turn = hn::And(hn::And(goes, hn::Lt(v[0] * v1, zero)),
                              hn::Or(hn::Gt(reach, ahead), hn::Gt(zero - reach, back)));
    if (HWY_LIKELY(hn::AllFalse(d, turn))) return;
    const V t = Root([&](V x) { return Polynomial(v, x); }, f, v[0], v1);
    const V value = Polynomial(way, t);
    ahead = hn::IfThenElse(turn, hn::Max(ahead, value), ahead);
    back = hn::IfThenElse(turn, hn::Max(back, zero - value), back);
  };
  turns_along(z.v_s, v_s, way_s, ahead_s, back_s);
  turns_along(z.v_y, v_y, way_y, ahead_y, back_y);

  // Those that go.
  const Mask whole = hn::Eq(f, one);
  const auto commit = [&](double* row, V value) {
    hn::Store(hn::IfThenElse(goes, value, load(row)), d, row + first);
  };
  auto& to = bank.motion;
  commit(to.left, hn::IfThenElse(whole, one, m.left * (one - f)));
  commit(to.v_s, v_s);
  commit(to.v_y, v_y);
  commit(to.at_s, at_s);
  commit(to.at_y, at_y);
  const auto move_on = [&](const Line& line, V end) {
    return hn::IfThenElse(whole, end, line.begin + f * line.rise);
  };
  commit(to.ground_1, move_on(ground_1, end_1));
  commit(to.ground_2, move_on(ground_2, end_2));
  commit(to.w, move_on(up, end_w));
  if constexpr (roof != Roof::rigid) {
    commit(to.x_1, Polynomial(z.x_1, f));
    commit(to.y_1, Polynomial(z.y_1, f));
    commit(to.x_2, Polynomial(z.x_2, f));
    commit(to.y_2, Polynomial(z.y_2, f));
  }
  commit(to.fastest, fastest);
  commit(to.path, path + along * z.speed);
  commit(to.farthest2, farthest2);
  commit(to.ahead_s, ahead_s);
  commit(to.back_s, back_s);
  commit(to.ahead_y, ahead_y);
  commit(to.back_y, back_y);
  const auto moved = hn::RebindMask(di, hn::And(goes, whole));
  hn::Store(hn::IfThenElse(moved, next, node), di, bank.node + first);

  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, goes, bits);
  return static_cast<std::uint64_t>(static_cast<std::uint8_t>(~bits[0])) &
         ((std::uint64_t{1} << hn::Lanes(d)) - 1);
}

template <Roof roof>
std::uint64_t StepAll(LaneBank& bank, const LaneGround& ground) {
  const std::size_t n = hn::Lanes(Doubles());
  std::uint64_t left = 0;
  for (std::size_t first = 0; first < LaneBank::lanes; first += n) {
    if (((bank.active >> first) & ((std::uint64_t{1} << n) - 1)) == 0) continue;
    left |= StepVector<roof>(bank, ground, first) << first;
  }
  return left & bank.active;
}

std::uint64_t Step(LaneBank& bank, const LaneGround& ground, Roof roof) {
  switch (roof) {
    case Roof::rigid:
      return StepAll<Roof::rigid>(bank, ground);
    case Roof::building:
      return StepAll<Roof::building>(bank, ground);
    case Roof::coupled:
      break;
  }
  return StepAll<Roof::coupled>(bank, ground);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail::two_axes {
HWY_EXPORT(Step);

std::uint64_t step(LaneBank& bank, const LaneGround& ground, Roof roof) {
  return HWY_DYNAMIC_DISPATCH(Step)(bank, ground, roof);
}

}  // namespace glissade::block_detail::two_axes
#endif
