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

#include <type_traits>

#include "block/full_model/stop.hpp"
#include "lane_speed_law-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// A quantity linear over the rest of the interval.
struct Ramped {
  V begin, rise;
};

/// The series of a roof of modes over a sample interval, of the lanes' own tables.
struct TableRow {
  const double* nodes;
  hn::Vec<Indices> at;

  template <std::size_t axis, int k>
  HWY_INLINE V Term() const {
    return hn::GatherIndex(Doubles(), nodes + (axis * row_terms + k), at);
  }
};

/// Of a building of several modes.
struct ModeSeries {
  V x[2][most_modes][roof_order + 1], y[2][most_modes][roof_order + 1], phase[2][most_modes];

  HWY_INLINE ModeSeries() {}  // an implicit one is not compiled for the target (GCC, Arm)
};
struct NoModes {};

/// Series in tau, the fraction of the rest of the interval that has passed; h is its length. The
/// roof under a block whose velocity is given by its first terms, and the load, times h.
template <RoofKind roof, int velocity_terms, int load_terms>
class RoofSeries {
  static constexpr bool of_modes = roof == RoofKind::coupled_modes;

 public:
  V v_s[velocity_terms], v_y[velocity_terms];
  V x_1[roof_order + 1], y_1[roof_order + 1], x_2[roof_order + 1], y_2[roof_order + 1];
  std::conditional_t<of_modes, ModeSeries, NoModes> modes;
  V rate_1[roof_order], rate_2[roof_order];  // y without the block's part, where the roof yields
  V a_1[roof_order], a_2[roof_order];  // the roof, as far as the block's own rate has no part in it
  V p_s[load_terms], p_y[load_terms];  // load
  V weight[load_terms];                // n on a roof that the block does not accelerate

  HWY_INLINE RoofSeries(const LaneStates& states, Here lanes, const Ramped& first,
                        const Ramped& second, const Ramped& vertical, const TableRow& row, V length)
      : c(states.constants),
        of(states.mode_constants),
        here(lanes),
        h(length),
        count(states.modes),
        ground_1(first),
        ground_2(second),
        up(vertical) {
    const LaneMotion<Rows>& m = states.motion;
    v_s[0] = here(m.v_s);
    v_y[0] = here(m.v_y);
    h_c = h * here(c.c);
    h_s = h * here(c.s);
    h_c_across = h * here(c.c_across);
    h_s_across = h * here(c.s_across);
    if constexpr (is_one_mass_with_block(roof)) {
      b_1s = here(c.omega_rho_1) * (here(c.c) * here(c.cosine2));
      b_1y = here(c.omega_rho_1) * (here(c.s) * here(c.cosine));
      b_2s = here(c.omega_rho_2) * (here(c.s) * here(c.cosine2));
      b_2y = here(c.omega_rho_2) * (here(c.c) * here(c.cosine));
    }
    if constexpr (roof == RoofKind::modes) {
      Read<0>(row, here(c.factor_1), here(m.left), a_1);
      Read<1>(row, here(c.factor_2), here(m.left), a_2);
    }
    if constexpr (of_modes) {
      b_1s = here(c.c) * here(c.cosine2);
      b_1y = here(c.s) * here(c.cosine);
      b_2s = here(c.s) * here(c.cosine2);
      b_2y = here(c.c) * here(c.cosine);
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t n = 0; n < count; ++n) {
          modes.x[axis][n][0] = here(states.mode_motion.x[axis][n]);
          modes.y[axis][n][0] = here(states.mode_motion.y[axis][n]);
          modes.phase[axis][n] = here(of.omega[axis][n]) * h;
        }
    } else if constexpr (has_state(roof)) {
      phase_1 = here(c.omega_1) * h;
      phase_2 = here(c.omega_2) * h;
      if constexpr (roof == RoofKind::yielding) {
        spring_phase_1 = phase_1 * Stiffness(states, 0);
        spring_phase_2 = phase_2 * Stiffness(states, 1);
      }
      x_1[0] = here(m.x_1);
      y_1[0] = here(m.y_1);
      x_2[0] = here(m.x_2);
      y_2[0] = here(m.y_2);
    }
  }

  /// The term k of the load, by those of the velocity up to it.
  template <int k>
  HWY_INLINE void Term() {
    if constexpr (has_state(roof)) Respond<k>();
    if constexpr (k < load_terms) Load<k>();
  }

 protected:
  const Constants<Rows>& c;
  const ModeConstants<Rows>& of;
  Here here;
  V h;
  std::size_t count;  // of modes

 private:
  const Ramped &ground_1, &ground_2, &up;
  V phase_1, phase_2, spring_phase_1, spring_phase_2;
  V h_c, h_s, h_c_across, h_s_across;
  V b_1s, b_1y, b_2s, b_2y;  // from the block's velocity to its effect on the building's axes

  /// The acceleration of an axis over the rest of the interval.
  template <std::size_t axis>
  HWY_INLINE void Read(const TableRow& row, V factor, V left, V (&a)[roof_order]) {
    const V one = Number(1.0);
    if (hn::AllTrue(Doubles(), hn::Eq(left, one))) {
      ForOrders<0, load_terms>([&](auto k)
                                   GLISSADE_INLINE_LAMBDA { a[k] = factor * row.Term<axis, k>(); });
      return;
    }
    ForOrders<0, roof_order>([&](auto k) GLISSADE_INLINE_LAMBDA { a[k] = row.Term<axis, k>(); });
    // Horner's shift to what has passed, then a change of scale.
    const V passed = one - left;
    ForOrders<0, load_terms>([&](auto i) GLISSADE_INLINE_LAMBDA {
      ForOrders<0, roof_order - 1 - i>([&](auto j) GLISSADE_INLINE_LAMBDA {
        constexpr int k = roof_order - 2 - j;
        a[k] = a[k] + passed * a[k + 1];
      });
    });
    V scale = factor;
    ForOrders<0, load_terms>([&](auto k) GLISSADE_INLINE_LAMBDA {
      a[k] = scale * a[k];
      scale = scale * left;
    });
  }

  /// Of a spring, over that of the elastic one.
  HWY_INLINE V Stiffness(const LaneStates& states, std::size_t axis) const {
    const Mask elastic = hn::Eq(here(states.spring_motion.direction[axis]), hn::Zero(Doubles()));
    return hn::IfThenElse(elastic, Number(1.0), here(states.spring_constants.hardening[axis]));
  }

  /// One axis of the building, and its acceleration as far as the block's own
  /// has no part in it.
  template <int k>
  HWY_INLINE void Respond(V* x, V* y, V* a, V* rates, V phase, V spring_phase, V twice_zeta,
                          V block_velocity, const Ramped& ground) {
    V rate = y[k];
    if constexpr (is_one_mass_with_block(roof) && k < velocity_terms) rate = rate - block_velocity;
    a[k] = hn::Neg(twice_zeta * rate + x[k]);
    if constexpr (is_one_mass_with_block(roof)) a[k] = a[k] * here(c.per_mass);
    const V factor = phase * Number(inverse[k + 1]);
    if constexpr (roof == RoofKind::yielding) {
      rates[k] = rate;
      x[k + 1] = (spring_phase * Number(inverse[k + 1])) * rate;
    } else {
      x[k + 1] = factor * rate;
    }
    V rise = a[k];
    if constexpr (k == 0) rise = rise - ground.begin;
    if constexpr (k == 1) rise = rise - ground.rise;
    y[k + 1] = factor * rise;
  }

  /// The same of all modes of an axis: with x, Y, E_n times gamma, E the sum of E_n and of what
  /// moves with the ground,
  ///   x' = omega (Y - omega share b),   Y' = omega (E_n - share E - gamma a_ground),
  ///   E_n = -(2 zeta (Y - omega share b) + x),   a = (1 - rho) E
  template <int k>
  HWY_INLINE void RespondModes(std::size_t axis, V* a, V block_velocity, const Ramped& ground) {
    V e[most_modes];
    V sum = hn::Zero(Doubles()), forcing = sum;
    if constexpr (k < 2) {
      forcing = k == 0 ? ground.begin : ground.rise;
      sum = here(of.ground_share[axis]) * forcing;
    }
    for (std::size_t n = 0; n < count; ++n) {
      V rate = modes.y[axis][n][k];
      if constexpr (k < velocity_terms)
        rate = rate - here(of.omega_share[axis][n]) * block_velocity;
      e[n] = hn::Neg(here(of.twice_zeta[axis][n]) * rate + modes.x[axis][n][k]);
      sum = sum + e[n];
      modes.x[axis][n][k + 1] = (modes.phase[axis][n] * Number(inverse[k + 1])) * rate;
    }
    for (std::size_t n = 0; n < count; ++n) {
      V rise = e[n] - here(of.share[axis][n]) * sum;
      if constexpr (k < 2) rise = rise - here(of.gamma[axis][n]) * forcing;
      modes.y[axis][n][k + 1] = (modes.phase[axis][n] * Number(inverse[k + 1])) * rise;
    }
    a[k] = here(of.per_mass[axis]) * sum;
  }

  template <int k>
  HWY_INLINE void Respond() {
    V block_rate_1 = hn::Zero(Doubles()), block_rate_2 = block_rate_1;
    if constexpr (has_mass(roof) && k < velocity_terms) {
      block_rate_1 = b_1s * v_s[k] - b_1y * v_y[k];
      block_rate_2 = b_2s * v_s[k] + b_2y * v_y[k];
    }
    if constexpr (of_modes) {
      RespondModes<k>(0, a_1, block_rate_1, ground_1);
      RespondModes<k>(1, a_2, block_rate_2, ground_2);
      return;
    }
    Respond<k>(x_1, y_1, a_1, rate_1, phase_1, spring_phase_1, here(c.twice_zeta_1), block_rate_1,
               ground_1);
    Respond<k>(x_2, y_2, a_2, rate_2, phase_2, spring_phase_2, here(c.twice_zeta_2), block_rate_2,
               ground_2);
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
      const V fall = h * (k == 0 ? here(c.gravity) + up.begin : up.rise);
      p_s[k] = fall * here(c.tangent) - along;
      weight[k] = here(c.mu) * (fall + here(c.tangent) * along);
    } else {
      p_s[k] = hn::Neg(along);
      weight[k] = (here(c.mu) * here(c.tangent)) * along;
    }
  }
};

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
#endif  // GLISSADE_TWO_AXES_LANE_SERIES_INL
