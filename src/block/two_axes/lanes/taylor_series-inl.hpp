// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block's velocity over the rest of a sample interval as a power series. Included once per SIMD
// target.
#if defined(GLISSADE_TWO_AXES_TAYLOR_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_TAYLOR_SERIES_INL
#undef GLISSADE_TWO_AXES_TAYLOR_SERIES_INL
#else
#define GLISSADE_TWO_AXES_TAYLOR_SERIES_INL
#endif

#include "block/full_model/stop.hpp"
#include "block/two_axes/lanes/roof_series-inl.hpp"
#include "block/two_axes/lanes/speed_law-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// The block's velocity too, as a series. With the load p, the friction n along the slope,
/// M = diag(1, aspect), the speed u = |M v|, g = n / u and the rate d of v, all times h:
///   u_k = (sum of M v_j . M v_k-j / 2, all j, - sum of u_j u_k-j / 2, 0 < j < k) / u_0,
///   g_k = (n_k - sum of u_j g_k-j, j > 0) / u_0,   d = p - g M M v,   v_k+1 = d_k / (k + 1)
/// On a roof that the block accelerates n and d depend on each other (kappa, rho_sin_cos in
/// Constants, A in ModeConstants). In every sum the newest term is added last: the lanes wait for
/// it. There are few series, so that most of their terms stay in registers.
template <RoofKind roof, Friction friction>
class StepSeries : public RoofSeries<roof, order + 1, order> {
  using Base = RoofSeries<roof, order + 1, order>;
  using Base::c, Base::here, Base::of;

 public:
  using Base::p_s, Base::p_y, Base::v_s, Base::v_y, Base::weight;
  V speed[order];       // u
  V law_factor[order];  // mu(|v|) / mu

  HWY_INLINE StepSeries(const LaneStates& states, Here lanes, const Ramped& first,
                        const Ramped& second, const Ramped& vertical, const TableRow& row, V length)
      : Base(states, lanes, first, second, vertical, row, length) {
    aspect2 = here(c.aspect) * here(c.aspect);
    speed[0] = hn::Sqrt(v_s[0] * v_s[0] + aspect2 * (v_y[0] * v_y[0]));
    per_speed = hn::Div(Number(1.0), speed[0]);
    e_s = v_s[0] * per_speed;
    w_y = aspect2 * v_y[0];
    e_y = w_y * per_speed;
    if constexpr (by_speed) BeginLaw();
    ForOrders<0, order>([&](auto k) GLISSADE_INLINE_LAMBDA {
      this->template Term<k>();
      if constexpr (k > 0) Speed<k>();
      if constexpr (k > 0 && by_speed) Law<k>();
      Rate<k>();
    });
    if constexpr (has_state(roof))
      ForOrders<order, roof_order>([&](auto k)
                                       GLISSADE_INLINE_LAMBDA { this->template Term<k>(); });
  }

 private:
  static constexpr bool by_speed = friction == Friction::by_speed;
  V aspect2, per_speed, per_kappa;
  V b_ss, b_sy, b_ys, b_yy;  // of modes: (A - friction's part)^-1
  V w_y, e_s, e_y;           // the first term of M M v across, and of M M v / u
  V g[order], g2[order];     // n / u, and times aspect^2
  V size[order], per_size;   // |v|
  V decay[order];            // SpeedLaw::Decay
  V normal[order];           // n without the law's factor

  /// Half the term k of M v . M v - u u, without what is of the order k itself.
  template <int k>
  HWY_INLINE V HalfOfSquares() const {
    const auto product = [&](auto i) GLISSADE_INLINE_LAMBDA {
      constexpr int j = k - i;
      return (v_s[i] * v_s[j] - speed[i] * speed[j]) + aspect2 * (v_y[i] * v_y[j]);
    };
    if constexpr (k == 2)
      return Number(0.5) * product(Order<1>());
    else {
      V sum = product(Order<1>());
      ForOrders<2, (k + 1) / 2>([&](auto i) GLISSADE_INLINE_LAMBDA { sum = sum + product(i); });
      if constexpr (k % 2 == 0) sum = sum + Number(0.5) * product(Order<k / 2>());
      return sum;
    }
  }

  template <int k>
  HWY_INLINE void Speed() {
    const V by_s = e_s * v_s[k], by_y = e_y * v_y[k];
    if constexpr (k == 1)
      speed[1] = by_s + by_y;
    else
      speed[k] = (HalfOfSquares<k>() * per_speed + by_s) + by_y;
  }

  HWY_INLINE void BeginLaw() {
    const SpeedLaw law(c, here);
    size[0] = hn::Sqrt(v_s[0] * v_s[0] + v_y[0] * v_y[0]);
    per_size = hn::Div(Number(1.0), size[0]);
    decay[0] = law.Decay(size[0]);
    law_factor[0] = law.Factor(decay[0]);
  }

  /// |v| as u, and the law's decay w = exp(-a |v|) by w' = -a |v|' w.
  template <int k>
  HWY_INLINE void Law() {
    const SpeedLaw law(c, here);
    V square = v_s[0] * v_s[k] + v_y[0] * v_y[k];
    ForOrders<1, k + 1>([&](auto j) GLISSADE_INLINE_LAMBDA {
      square = square + (v_s[j] * v_s[k - j] + v_y[j] * v_y[k - j]);
      if constexpr (j < k) square = square - size[j] * size[k - j];
    });
    size[k] = (Number(0.5) * square) * per_size;
    V falls = hn::Zero(Doubles());
    ForOrders<1, k + 1>([&](auto j) GLISSADE_INLINE_LAMBDA {
      falls = falls + (Number(static_cast<double>(j)) * size[j]) * decay[k - j];
    });
    decay[k] = hn::Neg((law.rate * Number(inverse[k])) * falls);
    law_factor[k] = hn::Neg(law.excess * decay[k]);
  }

  /// The term k of n times the law's factor, as far as it does not depend on the rate d_k.
  template <int k>
  HWY_INLINE V Normal() const {
    if constexpr (!by_speed) return weight[k];
    V n = law_factor[0] * weight[k];
    ForOrders<0, k>([&](auto j) GLISSADE_INLINE_LAMBDA { n = n + normal[j] * law_factor[k - j]; });
    return n;
  }
  HWY_INLINE V TimesLaw(V value) const {
    if constexpr (by_speed) return value * law_factor[0];
    return value;
  }

  template <int k>
  HWY_INLINE void Rate() {
    // Sums of g times v and u.
    V s = p_s[k], y = p_y[k], n = Normal<k>();
    const auto subtract = [&](auto j) GLISSADE_INLINE_LAMBDA {
      s = s - g[k - j] * v_s[j];
      y = y - g2[k - j] * v_y[j];
      n = n - g[k - j] * speed[j];
    };
    ForOrders<1, k + 1>(subtract);
    if constexpr (by_speed) normal[k] = weight[k];
    V d_s, d_y;
    if constexpr (is_one_mass_with_block(roof)) {
      const V lifts = here(c.mu) * here(c.rho_sin_cos), coupling = TimesLaw(lifts);
      if constexpr (k == 0) per_kappa = hn::Div(Number(1.0), here(c.kappa) - coupling * e_s);
      d_s = (s - n * e_s) * per_kappa;
      g[k] = (n - coupling * d_s) * per_speed;
      g2[k] = aspect2 * g[k];
      d_y = (y - g[k] * w_y) * here(c.per_kappa_y);
      if constexpr (by_speed) normal[k] = weight[k] - lifts * d_s;
    } else if constexpr (roof == RoofKind::coupled_modes) {
      const V lifts_s = here(c.mu) * here(c.rho_sin_cos), lifts_y = here(c.mu) * here(of.rho_sin);
      const V along = TimesLaw(lifts_s), across = TimesLaw(lifts_y);
      if constexpr (k == 0) {
        const V a_ss = here(c.kappa) - e_s * along, a_sy = here(of.kappa_sy) - e_s * across,
                a_ys = here(of.kappa_sy) - e_y * along, a_yy = here(of.kappa_y) - e_y * across;
        const V per = hn::Div(Number(1.0), a_ss * a_yy - a_sy * a_ys);
        b_ss = a_yy * per;
        b_sy = hn::Neg(a_sy * per);
        b_ys = hn::Neg(a_ys * per);
        b_yy = a_ss * per;
      }
      const V r_s = s - n * e_s, r_y = y - n * e_y;
      d_s = b_ss * r_s + b_sy * r_y;
      d_y = b_ys * r_s + b_yy * r_y;
      g[k] = (n - (along * d_s + across * d_y)) * per_speed;
      g2[k] = aspect2 * g[k];
      if constexpr (by_speed) normal[k] = weight[k] - (lifts_s * d_s + lifts_y * d_y);
    } else {
      g[k] = n * per_speed;
      g2[k] = aspect2 * g[k];
      d_s = s - g[k] * v_s[0];
      d_y = y - g[k] * w_y;
    }
    v_s[k + 1] = d_s * Number(inverse[k + 1]);
    v_y[k + 1] = d_y * Number(inverse[k + 1]);
  }
};

/// How far a step may go, as a fraction of what is left of the interval.
template <class Series>
HWY_INLINE V StepFraction(const Series& z, V longest, V allowed) {
  const V one = Number(1.0), half = Number(0.5);
  const V error = hn::Abs(z.v_s[order]) + hn::Abs(z.v_y[order]);
  V f = hn::Min(longest, hn::Div(Number(3.0) * z.speed[0], z.weight[0]));
  const Mask slows = hn::Lt(z.speed[1], hn::Zero(Doubles()));
  const V to_stop =
      hn::Div(Number(-approach_to_stop) * z.speed[0], hn::IfThenElse(slows, z.speed[1], one));
  f = hn::IfThenElse(slows, hn::Min(f, to_stop), f);
  // (allowed / error)^(1/6) to 3 %, by a sixth of the difference of their exponents.
  const Mask rough = hn::Gt(error, allowed);
  const Indices di;
  const auto excess = hn::Sub(hn::BitCast(di, error), hn::BitCast(di, allowed));
  auto sixth =
      hn::Add(hn::ShiftRight<3>(excess), hn::ShiftRight<5>(excess));  // times 15/16, a series
  sixth = hn::Add(sixth, hn::ShiftRight<4>(sixth));
  sixth = hn::Add(sixth, hn::ShiftRight<8>(sixth));
  const V x = Number(0.9) * hn::BitCast(Doubles(), hn::Sub(hn::BitCast(di, one), sixth));
  f = hn::IfThenElse(rough, hn::Min(f, x), f);
  return hn::IfThenElse(hn::And(hn::Lt(f, one), hn::Gt(f, half)), half, f);
}

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_TAYLOR_SERIES_INL
