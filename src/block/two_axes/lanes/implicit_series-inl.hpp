// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step at low speed, where friction turns the block quickly: SDIRK4. Included once per SIMD
// target.
#if defined(GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#undef GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#else
#define GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#endif

#include "block/full_model/sdirk4.hpp"
#include "block/two_axes/lanes/brake-inl.hpp"
#include "block/two_axes/lanes/roof_series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

constexpr int cubic = 4;  // terms

/// The velocity as the cubic through velocities and accelerations at both ends of the step, the
/// roof under it, and the stages. Velocity per cos(slope), rates times the interval's rest.
template <RoofKind roof, Friction friction>
class ImplicitSeries : public RoofSeries<roof, cubic, roof == RoofKind::rigid ? 2 : roof_order> {
  static constexpr int load_terms = roof == RoofKind::rigid ? 2 : roof_order;
  static constexpr bool by_speed = friction == Friction::by_speed;
  static constexpr bool coupled = has_mass(roof), of_modes = roof == RoofKind::coupled_modes;
  using Base = RoofSeries<roof, cubic, load_terms>;
  using Base::c, Base::here, Base::of;

 public:
  using Base::p_s, Base::p_y, Base::v_s, Base::v_y, Base::weight;
  V speed;          // |M v| at the begin
  V law_factor[1];  // mu(|v|) / mu, there
  V end_s, end_y;   // velocity at the step's end

  /// The roof as if the block's rate stayed what it is at the begin.
  HWY_INLINE ImplicitSeries(const LaneStates& states, Here lanes, const Ramped& first,
                            const Ramped& second, const Ramped& vertical, const TableRow& row,
                            V length)
      : Base(states, lanes, first, second, vertical, row, length) {
    const LaneMotion<Rows>& m = states.motion;
    speed = hn::Sqrt(here(m.v_s) * here(m.v_s) +
                     (here(c.aspect) * here(m.v_y)) * (here(c.aspect) * here(m.v_y)));
    if constexpr (by_speed) {
      const SpeedLaw law(c, here);
      law_factor[0] = law.Factor(law.Decay(Length(v_s[0], v_y[0])));
    }
    v_s[2] = v_s[3] = v_y[2] = v_y[3] = hn::Zero(Doubles());
    this->template Term<0>();
    BeginRate();
    ForOrders<1, load_terms>([&](auto k) GLISSADE_INLINE_LAMBDA { this->template Term<k>(); });
  }

  /// The step over a fraction of the interval's rest. Its stages are to be made in order.
  /// @param small difference of the velocity that does not matter
  HWY_INLINE void Begin(V fraction, V small) {
    f = fraction;
    negligible = small;
    t = Number(Sdirk4::gamma) * f;
    per_t = hn::Div(Number(1.0), t);
    changed = hn::Zero(Doubles());
    again = hn::Ge(speed, changed);  // all
  }

  template <int i, bool anew>
  HWY_INLINE void Stage() {
    using S = Sdirk4;
    V sum_s = hn::Zero(Doubles()), sum_y = sum_s;
    ForOrders<0, i>([&](auto j) GLISSADE_INLINE_LAMBDA {
      sum_s = sum_s + Number(S::a[i][j]) * rate_s[j];
      sum_y = sum_y + Number(S::a[i][j]) * rate_y[j];
    });
    const Velocity known{v_s[0] + f * sum_s, v_y[0] + f * sum_y};
    const V tau = Number(S::at[i]) * f, n = Polynomial(weight, tau);
    const BrakedStage<roof, by_speed> braking(c, of, here, known, t,
                                              {Polynomial(p_s, tau), Polynomial(p_y, tau)}, n);
    Braked braked = stages[i];
    const Velocity v = braking.template Solve<anew>(braked, negligible);
    const auto set = [&](V& value, V next) GLISSADE_INLINE_LAMBDA {
      value = anew ? next : hn::IfThenElse(again, next, value);
    };
    set(stages[i].sigma, braked.sigma);
    set(stages[i].lambda, braked.lambda);
    set(rate_s[i], (v.s - known.s) * per_t);
    set(rate_y[i], (v.y - known.y) * per_t);
    if constexpr (i + 1 == S::stages) {
      last_s = end_s;
      last_y = end_y;
      set(end_s, v.s);
      set(end_y, v.y);
      end_weight = n;
    }
  }

  /// After the last stage. Where the roof follows the block the stages are to be made once more,
  /// with the velocity that the block then has, until that changes nothing.
  template <bool anew>
  HWY_INLINE bool OnceMore() {
    if constexpr (coupled && !anew) {
      const V change = FeedBack() * Length(end_s - last_s, end_y - last_y);
      changed = hn::IfThenElse(again, change, changed);
      again = hn::And(again, hn::Gt(changed, negligible));
      if (hn::AllFalse(Doubles(), again)) return false;
    }
    FitCubic();
    if constexpr (coupled)
      ForOrders<0, load_terms>([&](auto k) GLISSADE_INLINE_LAMBDA { this->template Term<k>(); });
    return coupled;
  }

  /// Of the velocity at the end.
  HWY_INLINE V Error() const {
    using S = Sdirk4;
    const V zero = hn::Zero(Doubles()), one = Number(1.0);
    V error_s = zero, error_y = zero;
    ForOrders<0, S::stages>([&](auto i) GLISSADE_INLINE_LAMBDA {
      error_s = error_s + Number(S::difference[i]) * rate_s[i];
      error_y = error_y + Number(S::difference[i]) * rate_y[i];
    });
    // What stiffness damps is no error (damped() in sdirk4.hpp).
    const V speed2 = end_s * end_s + end_y * end_y;
    const Mask rests = hn::Eq(speed2, zero);
    const V along = hn::Div(error_s * end_s + error_y * end_y, hn::IfThenElse(rests, one, speed2));
    const V along_s = along * end_s, along_y = along * end_y;
    const V stiffness =
        (t * here(c.per_kappa_y)) * (hn::Max(end_weight, zero) * hn::Min(here(c.aspect), one));
    const V end_speed = hn::Sqrt(speed2);
    const V left = hn::IfThenElse(rests, one, hn::Div(end_speed, end_speed + stiffness));
    return changed +
           f * Length(along_s + left * (error_s - along_s), along_y + left * (error_y - along_y));
  }

 private:
  V f, t, per_t, negligible;
  V rate_s[Sdirk4::stages], rate_y[Sdirk4::stages];
  V last_s, last_y, end_weight, changed;
  Mask again;
  Braked stages[Sdirk4::stages];  // where the iteration of each has ended

  /// By how much the velocity at the step's end changes with that in the step, through the roof.
  HWY_INLINE V FeedBack() const {
    if constexpr (of_modes) {
      const V length = this->h * f;
      return (here(of.feedback_damping) + here(of.feedback_spring) * length) * length;
    }
    const auto of_axis = [&](V omega, V omega_rho, V twice_zeta) GLISSADE_INLINE_LAMBDA {
      const V length = this->h * f;
      return omega_rho * ((twice_zeta + omega * length) * length);
    };
    return of_axis(here(c.omega_1), here(c.omega_rho_1), here(c.twice_zeta_1)) +
           of_axis(here(c.omega_2), here(c.omega_rho_2), here(c.twice_zeta_2));
  }

  /// The rate at the begin; of a block at rest, that with which it starts.
  HWY_INLINE void BeginRate() {
    const V zero = hn::Zero(Doubles()), one = Number(1.0);
    const Mask rests = hn::Eq(speed, zero);
    const V per_speed = hn::Div(one, hn::IfThenElse(rests, one, speed));
    const auto times_law = [&](V value) GLISSADE_INLINE_LAMBDA {
      if constexpr (by_speed) value = value * law_factor[0];
      return value;
    };
    const V n = times_law(hn::Max(weight[0], zero));
    const V e_s = v_s[0] * per_speed, e_y = (here(c.aspect) * v_y[0]) * per_speed;
    V s = p_s[0] - n * e_s, brakes = n, y;
    if constexpr (of_modes) {
      const Mask holds = hn::Gt(weight[0], zero);
      const V along = times_law(hn::IfThenElseZero(holds, here(c.mu) * here(c.rho_sin_cos))),
              across = times_law(hn::IfThenElseZero(holds, here(c.mu) * here(of.rho_sin)));
      const V m_y = here(c.aspect) * e_y, r_y = p_y[0] - n * m_y;
      const auto solve = [&](V a_ss, V a_sy, V a_ys, V a_yy, V r_s, V r_y_) GLISSADE_INLINE_LAMBDA {
        const V per = hn::Div(one, a_ss * a_yy - a_sy * a_ys);
        return Velocity{per * (a_yy * r_s - a_sy * r_y_), per * (a_ss * r_y_ - a_ys * r_s)};
      };
      const V k = here(c.kappa), k_sy = here(of.kappa_sy), k_y = here(of.kappa_y);
      const Velocity braked = solve(k - e_s * along, k_sy - e_s * across, k_sy - m_y * along,
                                    k_y - m_y * across, s, r_y);
      brakes = hn::Max(n - (along * braked.s + across * braked.y), zero);
      const Velocity rate = solve(k, k_sy, k_sy, k_y, p_s[0] - brakes * e_s, p_y[0] - brakes * m_y);
      s = rate.s;
      y = rate.y;
    } else if constexpr (coupled) {
      const V coupling =
          times_law(hn::IfThenElseZero(hn::Gt(weight[0], zero), here(c.mu) * here(c.rho_sin_cos)));
      s = hn::Div(s, here(c.kappa) - coupling * e_s);
      brakes = hn::Max(n - coupling * s, zero);
    }
    if constexpr (!of_modes) y = p_y[0] - brakes * (here(c.aspect) * e_y);
    if constexpr (is_one_mass_with_block(roof)) y = y * here(c.per_kappa_y);
    if (HWY_UNLIKELY(!hn::AllFalse(Doubles(), rests))) {
      const BrakedStage<roof, false> braking(c, of, here, {zero, zero}, one, {p_s[0], p_y[0]},
                                             weight[0]);
      const Velocity start = braking.template Solve<true>(stages[0], zero);
      s = hn::IfThenElse(rests, start.s, s);
      y = hn::IfThenElse(rests, start.y, y);
    }
    v_s[1] = s;
    v_y[1] = y;
  }

  HWY_INLINE void FitCubic() {
    const V per = hn::Div(Number(1.0), f), per2 = per * per;
    const auto fit = [&](V(&v)[cubic], V end, V end_rate) GLISSADE_INLINE_LAMBDA {
      const V gain = end - v[0], rise = f * v[1], last = f * end_rate;
      v[2] = hn::IfThenElse(again, (Number(3.0) * gain - Number(2.0) * rise - last) * per2, v[2]);
      v[3] = hn::IfThenElse(again, (rise + last - Number(2.0) * gain) * (per2 * per), v[3]);
    };
    fit(v_s, end_s, rate_s[Sdirk4::stages - 1]);
    fit(v_y, end_y, rate_y[Sdirk4::stages - 1]);
  }
};

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
