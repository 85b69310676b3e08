// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block's motion over the rest of a sample interval as power series, in
// SIMD lanes. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_LANE_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_LANE_SERIES_INL
#undef GLISSADE_TWO_AXES_LANE_SERIES_INL
#else
#define GLISSADE_TWO_AXES_LANE_SERIES_INL
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "block/full_model/stop.hpp"
#include "lane_states.hpp"

#ifndef GLISSADE_INLINE_LAMBDA
#define GLISSADE_INLINE_LAMBDA __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using Indices = hn::RebindToSigned<Doubles>;
using V = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

constexpr int order = 6;        // of the velocity
constexpr int roof_order = 10;  // of the building

inline V Number(double value) { return hn::Set(Doubles(), value); }

/// Numbers of the lanes of a vector, read from memory where they are used.
struct Row {
  const double* numbers;
  HWY_INLINE V operator()() const { return hn::Load(Doubles(), numbers); }
};

/// Loops over orders are unrolled: each order is a constant, and its series
/// stay in registers.
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

constexpr double inverse[] = {0.0,     1.0,     1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5,
                              1.0 / 6, 1.0 / 7, 1.0 / 8, 1.0 / 9, 1.0 / 10};

/// A quantity linear over the rest of the interval.
struct Ramped {
  V begin, rise;
};

/// Series in tau, the fraction of the rest of the interval that has passed; h is its length. The
/// roof under a block whose velocity is given by its first terms, and the load, times h.
template <RoofKind roof, int velocity_terms, int load_terms>
class RoofSeries {
 public:
  V v_s[velocity_terms], v_y[velocity_terms];
  V x_1[roof_order + 1], y_1[roof_order + 1], x_2[roof_order + 1], y_2[roof_order + 1];
  V p_s[load_terms], p_y[load_terms];  // load
  V weight[load_terms];                // n on a roof that the block does not accelerate

  HWY_INLINE RoofSeries(const Constants<Row>& constants, const LaneMotion<Row>& m,
                        const Ramped& first, const Ramped& second, const Ramped& vertical, V length)
      : c(constants), h(length), ground_1(first), ground_2(second), up(vertical) {
    v_s[0] = m.v_s();
    v_y[0] = m.v_y();
    h_c = h * c.c();
    h_s = h * c.s();
    h_c_across = h * c.c_across();
    h_s_across = h * c.s_across();
    if constexpr (roof == RoofKind::coupled) {
      b_1s = c.omega_rho_1() * (c.c() * c.cosine2());
      b_1y = c.omega_rho_1() * (c.s() * c.cosine());
      b_2s = c.omega_rho_2() * (c.s() * c.cosine2());
      b_2y = c.omega_rho_2() * (c.c() * c.cosine());
    }
    if constexpr (roof != RoofKind::rigid) {
      phase_1 = c.omega_1() * h;
      phase_2 = c.omega_2() * h;
      x_1[0] = m.x_1();
      y_1[0] = m.y_1();
      x_2[0] = m.x_2();
      y_2[0] = m.y_2();
    }
  }

  /// The term k of the load, by those of the velocity up to it.
  template <int k>
  HWY_INLINE void Term() {
    HWY_FENCE;  // Rows are read again, not kept on the stack
    if constexpr (roof != RoofKind::rigid) Respond<k>();
    if constexpr (k < load_terms) Load<k>();
  }

 protected:
  const Constants<Row>& c;
  V h;

 private:
  const Ramped &ground_1, &ground_2, &up;
  V phase_1, phase_2;
  V h_c, h_s, h_c_across, h_s_across;
  V b_1s, b_1y, b_2s, b_2y;  // from the block's velocity to its effect on the building's axes
  V a_1[roof_order], a_2[roof_order];

  /// One axis of the building, and its acceleration as far as the block's own
  /// has no part in it.
  template <int k>
  HWY_INLINE void Respond(V* x, V* y, V* a, V phase, V twice_zeta, V block_velocity,
                          const Ramped& ground) {
    V rate = y[k];
    if constexpr (roof == RoofKind::coupled && k < velocity_terms) rate = rate - block_velocity;
    a[k] = hn::Neg(twice_zeta * rate + x[k]);
    if constexpr (roof == RoofKind::coupled) a[k] = a[k] * c.per_mass();
    const V factor = phase * Number(inverse[k + 1]);
    x[k + 1] = factor * rate;
    V rise = a[k];
    if constexpr (k == 0) rise = rise - ground.begin;
    if constexpr (k == 1) rise = rise - ground.rise;
    y[k + 1] = factor * rise;
  }

  template <int k>
  HWY_INLINE void Respond() {
    V block_rate_1 = hn::Zero(Doubles()), block_rate_2 = block_rate_1;
    if constexpr (roof == RoofKind::coupled && k < velocity_terms) {
      block_rate_1 = b_1s * v_s[k] - b_1y * v_y[k];
      block_rate_2 = b_2s * v_s[k] + b_2y * v_y[k];
    }
    Respond<k>(x_1, y_1, a_1, phase_1, c.twice_zeta_1(), block_rate_1, ground_1);
    Respond<k>(x_2, y_2, a_2, phase_2, c.twice_zeta_2(), block_rate_2, ground_2);
  }

  template <int k>
  HWY_INLINE void Load() {
    if constexpr (roof == RoofKind::rigid && k < 2) {
      a_1[k] = k == 0 ? ground_1.begin : ground_1.rise;
      a_2[k] = k == 0 ? ground_2.begin : ground_2.rise;
    }
    if constexpr (roof == RoofKind::rigid && k > 1) {
      p_s[k] = p_y[k] = weight[k] = hn::Zero(Doubles());
      return;
    }
    const V along = h_c * a_1[k] + h_s * a_2[k];
    p_y[k] = h_s_across * a_1[k] - h_c_across * a_2[k];
    if constexpr (k < 2) {
      const V fall = h * (k == 0 ? c.gravity() + up.begin : up.rise);
      p_s[k] = fall * c.tangent() - along;
      weight[k] = c.mu() * (fall + c.tangent() * along);
    } else {
      p_s[k] = hn::Neg(along);
      weight[k] = (c.mu() * c.tangent()) * along;
    }
  }
};

/// The block's velocity too, as a series. With the load p, the friction n along the slope,
/// M = diag(1, aspect), the direction e = M v / |M v|, the speed u = |M v| and the rate d of v, all
/// times h:
///   e_k = (M v_k - sum of u_j e_k-j, j > 0) / u_0,   d = p - n M e,
///   v_k+1 = d_k / (k + 1),   u_k+1 = (M e . d)_k / (k + 1)
/// On a roof that the block accelerates n and d depend on each other (kappa, rho_sin_cos in
/// Constants). In every sum the newest term is added last: the lanes wait for it.
template <RoofKind roof>
class StepSeries : public RoofSeries<roof, order + 1, order> {
  using Base = RoofSeries<roof, order + 1, order>;
  using Base::c;

 public:
  using Base::p_s, Base::p_y, Base::v_s, Base::v_y, Base::weight;
  V speed[order];  // |M v|

  HWY_INLINE StepSeries(const Constants<Row>& constants, const LaneMotion<Row>& m,
                        const Ramped& first, const Ramped& second, const Ramped& vertical, V length)
      : Base(constants, m, first, second, vertical, length) {
    speed[0] = hn::Sqrt(m.v_s() * m.v_s() + (c.aspect() * m.v_y()) * (c.aspect() * m.v_y()));
    per_speed = hn::Div(Number(1.0), speed[0]);
    ForOrders<0, order>([&](auto k) GLISSADE_INLINE_LAMBDA {
      this->template Term<k>();
      Direction<k>();
      Rate<k>();
      Speed<k>();
    });
    ForOrders<order, roof_order>([&](auto k) GLISSADE_INLINE_LAMBDA { this->template Term<k>(); });
  }

 private:
  V per_speed, per_kappa;
  V e_s[order], e_y[order], f_y[order], d_s[order], d_y[order], n[order];

  template <int k>
  HWY_INLINE void Direction() {
    if constexpr (k == 0) {
      e_s[0] = v_s[0] * per_speed;
      e_y[0] = (c.aspect() * v_y[0]) * per_speed;
    } else {
      V s = hn::Zero(Doubles()), y = s;
      ForOrders<2, k>([&](auto j) GLISSADE_INLINE_LAMBDA {
        s = s + speed[j] * e_s[k - j];
        y = y + speed[j] * e_y[k - j];
      });
      if constexpr (k > 1) {
        s = s + speed[1] * e_s[k - 1];
        y = y + speed[1] * e_y[k - 1];
      }
      e_s[k] = ((v_s[k] - speed[k] * e_s[0]) - s) * per_speed;
      e_y[k] = ((c.aspect() * v_y[k] - speed[k] * e_y[0]) - y) * per_speed;
    }
    f_y[k] = c.aspect() * e_y[k];
  }

  template <int k>
  HWY_INLINE void Rate() {
    V s = p_s[k], y = p_y[k];
    if constexpr (roof == RoofKind::coupled) {
      const V coupling = c.mu() * c.rho_sin_cos();
      if constexpr (k == 0) per_kappa = hn::Div(Number(1.0), c.kappa() - coupling * e_s[0]);
      ForOrders<1, k + 1>([&](auto j) GLISSADE_INLINE_LAMBDA {
        s = s - n[k - j] * e_s[j];
        y = y - n[k - j] * f_y[j];
      });
      d_s[k] = (s - weight[k] * e_s[0]) * per_kappa;
      n[k] = weight[k] - coupling * d_s[k];
      d_y[k] = (y - n[k] * f_y[0]) * c.per_kappa_y();
    } else {
      constexpr int first = roof == RoofKind::rigid && k > 1 ? k - 1 : 0;
      ForOrders<first, k + 1>([&](auto j) GLISSADE_INLINE_LAMBDA {
        s = s - weight[k - j] * e_s[j];
        y = y - weight[k - j] * f_y[j];
      });
      d_s[k] = s;
      d_y[k] = y;
    }
    v_s[k + 1] = d_s[k] * Number(inverse[k + 1]);
    v_y[k + 1] = d_y[k] * Number(inverse[k + 1]);
  }

  template <int k>
  HWY_INLINE void Speed() {
    if constexpr (k + 1 < order) {
      V sum = hn::Zero(Doubles());
      ForOrders<1, k>([&](auto j) GLISSADE_INLINE_LAMBDA {
        sum = sum + (e_s[j] * d_s[k - j] + f_y[j] * d_y[k - j]);
      });
      if constexpr (k > 0) sum = sum + (e_s[k] * d_s[0] + f_y[k] * d_y[0]);
      sum = sum + (e_s[0] * d_s[k] + f_y[0] * d_y[k]);
      speed[k + 1] = sum * Number(inverse[k + 1]);
    }
  }
};

/// How far a step may go, as a fraction of what is left of the interval.
template <RoofKind roof>
HWY_INLINE V StepFraction(const StepSeries<roof>& z, V allowed) {
  const V one = Number(1.0), half = Number(0.5);
  const V error = hn::Abs(z.v_s[order]) + hn::Abs(z.v_y[order]);
  V f = hn::Min(one, hn::Div(Number(3.0) * z.speed[0], z.weight[0]));
  const Mask slows = hn::Lt(z.speed[1], hn::Zero(Doubles()));
  const V to_stop =
      hn::Div(Number(-approach_to_stop) * z.speed[0], hn::IfThenElse(slows, z.speed[1], one));
  f = hn::IfThenElse(slows, hn::Min(f, to_stop), f);
  const Mask rough = hn::Gt(error, allowed);
  if (!hn::AllFalse(Doubles(), rough)) {
    // x^(1/5) to 1 %, by a fifth of its exponent: errors add up to the tolerance over an interval.
    const hn::Rebind<float, Doubles> df;
    const hn::RebindToSigned<decltype(df)> di;
    constexpr float one_bits = 1065353216.0F;
    const auto ratio = hn::DemoteTo(df, hn::Max(hn::Div(allowed, error), Number(1e-30)));
    const auto bits = hn::ConvertTo(df, hn::BitCast(di, ratio));
    const auto fifth = hn::Add(hn::Mul(hn::Sub(bits, hn::Set(df, one_bits)), hn::Set(df, 1.0F / 5)),
                               hn::Set(df, one_bits));
    const V x = Number(0.9) * hn::PromoteTo(Doubles(), hn::BitCast(df, hn::ConvertTo(di, fifth)));
    f = hn::IfThenElse(rough, hn::Min(f, x), f);
  }
  return hn::IfThenElse(hn::And(hn::Lt(f, one), hn::Gt(f, half)), half, f);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_LANE_SERIES_INL
