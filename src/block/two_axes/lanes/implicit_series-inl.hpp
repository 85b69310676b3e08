// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step at low speed, where friction turns the block quickly: SDIRK4 in SIMD
// lanes. Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#undef GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#else
#define GLISSADE_TWO_AXES_IMPLICIT_SERIES_INL
#endif

#include "block/full_model/sdirk4.hpp"
#include "block/two_axes/lanes/roof_series-inl.hpp"
#include "block/two_axes/lanes/speed_law-inl.hpp"

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
    V sigma = stage_sigma[i], lambda = stage_lambda[i];
    const Velocity v = Braked<anew, by_speed>(known, t, Polynomial(p_s, tau), Polynomial(p_y, tau),
                                              n, negligible, sigma, lambda);
    const auto set = [&](V& value, V next) GLISSADE_INLINE_LAMBDA {
      value = anew ? next : hn::IfThenElse(again, next, value);
    };
    set(stage_sigma[i], sigma);
    set(stage_lambda[i], lambda);
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

  static HWY_INLINE V Length(V s, V y) { return hn::Sqrt(s * s + y * y); }

 private:
  V f, t, per_t, negligible;
  V rate_s[Sdirk4::stages], rate_y[Sdirk4::stages];
  V last_s, last_y, end_weight, changed;
  Mask again;

  struct Velocity {
    V s, y;
  };

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

  /// Where the iteration of a stage has ended.
  V stage_sigma[Sdirk4::stages], stage_lambda[Sdirk4::stages];

  /// The velocity v with v = known + t (p - n M e), t = length, M v = |M v| e, by which the roof is
  /// accelerated too; zero where friction holds the block. With A v = q - lambda M e and sigma = |M
  /// v|
  ///   v_s = q_s sigma / (A_s sigma + lambda),   v_y = q_y sigma / (A_y sigma + lambda aspect^2)
  /// where A is diagonal; else in the axes of ModeConstants.
  /// sigma is the root of |M v| / sigma = 1, by Newton's method on its inverse (ImplicitEllipse);
  /// lambda = t n follows.
  /// @param end_sigma,end_lambda if not `anew`, to begin with
  /// @tparam with_law of friction by speed; else that of a slow block
  template <bool anew, bool with_law>
  HWY_INLINE Velocity Braked(Velocity known, V length, V load_s, V load_y, V n, V small,
                             V& end_sigma, V& end_lambda) const {
    const V zero = hn::Zero(Doubles()), one = Number(1.0);
    V a_s = coupled ? here(c.kappa) : one, a_y = coupled ? here(c.per_mass) : one;
    V aspect = here(c.aspect), per_aspect = here(c.per_aspect);
    const V first_lambda = hn::Max(length * n, zero);  // where v = known
    V q_s = known.s, q_y = known.y, lambda_0 = length * n, at_rest = lambda_0;
    V coupling = here(c.mu) * here(c.rho_sin_cos), coupling_y = zero;
    if constexpr (of_modes) {
      lambda_0 = lambda_0 + (coupling * known.s + (here(c.mu) * here(of.rho_sin)) * known.y);
      at_rest = lambda_0;
      const V by_s = a_s * known.s + here(of.kappa_sy) * known.y + length * load_s;
      const V by_y =
          per_aspect * (here(of.kappa_sy) * known.s + here(of.kappa_y) * known.y + length * load_y);
      q_s = here(of.turn_c) * by_s + here(of.turn_s) * by_y;
      q_y = here(of.turn_c) * by_y - here(of.turn_s) * by_s;
      a_s = here(of.principal_1);
      a_y = here(of.principal_2);
      coupling = here(c.mu) * here(of.lifts_1);
      coupling_y = here(c.mu) * here(of.lifts_2);
      aspect = per_aspect = one;
    } else if constexpr (coupled) {
      q_s = a_s * q_s;
      q_y = a_y * q_y;
      lambda_0 = lambda_0 + coupling * known.s;  // where v_s = 0
      at_rest = lambda_0;
    }
    if constexpr (!of_modes) {
      q_s = q_s + length * load_s;
      q_y = q_y + length * load_y;
    }
    at_rest = hn::Max(at_rest, zero);
    const V on_circle = per_aspect * q_y;
    const Mask slides = hn::Gt(q_s * q_s + on_circle * on_circle, at_rest * at_rest);

    const V square = aspect * aspect, forced = aspect * q_y;
    Mask inexact = slides;
    if constexpr (anew) {
      const V weight_s = q_s * q_s, weight_y = forced * forced, weights = weight_s + weight_y;
      const V size = hn::Sqrt(weights);
      end_lambda = first_lambda;
      if constexpr (with_law) {
        const SpeedLaw law(c, here);
        end_lambda = first_lambda * law.Factor(law.Decay(Length(known.s, known.y)));
      }
      if constexpr (coupled) {
        // To the first order in what is not the same in both directions.
        end_sigma =
            hn::Max(zero, hn::Div(size * weights - end_lambda * (weight_s + square * weight_y),
                                  a_s * weight_s + a_y * weight_y));
      } else {
        end_sigma = hn::Max(zero, size - end_lambda);  // exact on a circle
        if constexpr (!with_law) inexact = hn::And(slides, hn::Ne(aspect, one));
      }
    }
    constexpr int iterations = 12;
    for (int i = 0; i < iterations && !hn::AllFalse(Doubles(), inexact); ++i) {
      const V d_s = a_s * end_sigma + end_lambda, d_y = a_y * end_sigma + end_lambda * square;
      const V per = hn::Div(one, d_s * d_y), inverse_s = per * d_y, inverse_y = per * d_s;
      const V x_s = q_s * inverse_s, x_y = forced * inverse_y;
      const V square_s = x_s * x_s, square_y = x_y * x_y, size2 = square_s + square_y;
      // (|x| - 1) |x|^2, with |x| to the third order in |x|^2 - 1: times size2 + 3.
      V gain = (Number(2.0) * (size2 - one)) * size2;
      V slope = a_s * (square_s * inverse_s) + a_y * (square_y * inverse_y);
      // Change of lambda, and with sigma; what is left of it falls by `feedback` squared.
      V follows = zero, lambda_slope = zero, feedback = zero;
      [[maybe_unused]] V law_bends = zero;  // half the second derivative of lambda
      if constexpr (coupled) {
        const V per_lambda = square_s * inverse_s + square * (square_y * inverse_y);
        V coupled_x = coupling * x_s, per_d = coupled_x * inverse_s;
        if constexpr (of_modes) {
          const V coupled_y = coupling_y * x_y;
          per_d = per_d + coupled_y * inverse_y;
          coupled_x = coupled_x + coupled_y;
        }
        feedback = of_modes ? per_d * end_sigma : coupled_x * (end_sigma * inverse_s);
        const V slow = hn::Max(zero, lambda_0 - coupled_x * end_sigma);
        V target = slow, target_slope = zero - (of_modes ? per_d * end_lambda
                                                         : coupled_x * (inverse_s * end_lambda));
        if constexpr (with_law)
          FollowLaw(x_s, x_y, end_sigma, slow, target, target_slope, feedback, law_bends);
        follows = (target - end_lambda) * (one + feedback);
        lambda_slope = target_slope * (one + feedback);
        gain = gain - (size2 + Number(3.0)) * (per_lambda * follows);
        slope = slope + per_lambda * lambda_slope;
      } else if constexpr (with_law) {
        const V per_lambda = square_s * inverse_s + square * (square_y * inverse_y);
        V target = first_lambda;
        FollowLaw(x_s, x_y, end_sigma, first_lambda, target, lambda_slope, feedback, law_bends);
        follows = target - end_lambda;
        gain = gain - (size2 + Number(3.0)) * (per_lambda * follows);
        slope = slope + per_lambda * lambda_slope;
      }
      const V moves = hn::Div(gain, (size2 + Number(3.0)) * slope);
      const V next = hn::Max(zero, end_sigma + moves);
      end_sigma = hn::IfThenElse(inexact, next, end_sigma);
      if constexpr (coupled || with_law)
        end_lambda = hn::IfThenElse(
            inexact, hn::Max(zero, end_lambda + (follows + lambda_slope * moves)), end_lambda);
      // What is left falls with the square of the change, and of what differs by direction.
      const V differs = a_s * d_y - a_y * d_s, both = a_s * d_y + a_y * d_s;
      const V left = (hn::Abs(moves) + hn::Abs(follows)) * differs;
      Mask goes_on = hn::Gt(left * left, (small * next) * (both * both));
      if constexpr (coupled)
        goes_on = hn::Or(goes_on, hn::Gt((feedback * feedback) * hn::Abs(follows), small));
      if constexpr (with_law) goes_on = hn::Or(goes_on, hn::Gt(law_bends * (moves * moves), small));
      // On an ellipse x turns too, which FollowLaw leaves out.
      if constexpr (with_law && !coupled)
        goes_on = hn::Or(goes_on, hn::And(hn::Ne(aspect, one), hn::Gt(hn::Abs(follows), small)));
      inexact = hn::And(inexact, goes_on);
    }
    const V d_s = a_s * end_sigma + end_lambda, d_y = a_y * end_sigma + end_lambda * square;
    const V by_s = q_s * d_y, by_y = q_y * d_s, per = hn::Div(end_sigma, d_s * d_y);
    const V v_1 = hn::IfThenElseZero(slides, by_s * per),
            v_2 = hn::IfThenElseZero(slides, by_y * per);
    if constexpr (of_modes)
      return {here(of.turn_c) * v_1 - here(of.turn_s) * v_2,
              here(c.per_aspect) * (here(of.turn_s) * v_1 + here(of.turn_c) * v_2)};
    return {v_1, v_2};
  }

  /// Of lambda = `slow` times the law's factor at the speed of sigma x, by sigma.
  HWY_INLINE void FollowLaw(V x_s, V x_y, V sigma, V slow, V& target, V& target_slope, V& feedback,
                            V& bends) const {
    const SpeedLaw law(c, here);
    V m_s = x_s, m_y = x_y;  // M v / sigma
    if constexpr (of_modes) {
      m_s = here(of.turn_c) * x_s - here(of.turn_s) * x_y;
      m_y = here(of.turn_s) * x_s + here(of.turn_c) * x_y;
    }
    const V per_sigma = Length(m_s, here(c.per_aspect) * m_y);
    const V decay = law.Decay(per_sigma * sigma), factor = law.Factor(decay);
    const V rise = law.Slope(decay) * per_sigma;
    target = factor * slow;
    target_slope = factor * target_slope + rise * slow;
    feedback = factor * feedback;
    bends = (Number(0.5) * hn::Abs(rise)) * (law.rate * per_sigma) * slow;
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
      const Velocity start = Braked<true, false>({zero, zero}, one, p_s[0], p_y[0], weight[0], zero,
                                                 stage_sigma[0], stage_lambda[0]);
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
