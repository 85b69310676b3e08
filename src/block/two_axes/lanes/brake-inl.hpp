// SPDX-License-Identifier: GPL-3.0-or-later
//
// The velocity of a block that friction brakes over an implicit stage. Included once per SIMD
// target.
#if defined(GLISSADE_TWO_AXES_BRAKE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_BRAKE_INL
#undef GLISSADE_TWO_AXES_BRAKE_INL
#else
#define GLISSADE_TWO_AXES_BRAKE_INL
#endif

#include "block/two_axes/lanes/speed_law-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

struct Velocity {
  V s, y;
};
HWY_INLINE V Length(V s, V y) { return hn::Sqrt(s * s + y * y); }

/// Where the iteration of a stage is, or has ended: sigma = |M v|, lambda = t n.
struct Braked {
  V sigma, lambda;
  HWY_INLINE Braked() {}  // as of ModeSeries
  HWY_INLINE Braked(V by_sigma, V by_lambda) : sigma(by_sigma), lambda(by_lambda) {}
};

/// The velocity v = known + t (p - n M e), M v = |M v| e, by which the roof is accelerated too;
/// zero where friction holds the block. In axes in which A is diagonal (of modes those of
/// ModeConstants), A v = q - lambda M e, so that with M v = sigma x
///   x_s = q_s / (A_s sigma + lambda),   x_y = aspect q_y / (A_y sigma + aspect^2 lambda)
/// sigma is the root of |x| = 1, by Newton's method on its inverse (ImplicitEllipse); with it
/// lambda = max(0, lambda_0 - coupling . sigma x), times the law's factor, follows.
/// @tparam with_law of friction by speed; else that of a slow block
template <RoofKind roof, bool with_law>
class BrakedStage {
  static constexpr bool coupled = has_mass(roof), of_modes = roof == RoofKind::coupled_modes;
  static constexpr bool lambda_moves = coupled || with_law;

 public:
  HWY_INLINE BrakedStage(const Constants<Rows>& constants, const ModeConstants<Rows>& modes,
                         Here lanes, Velocity known_part, V t, Velocity load, V n)
      : c(constants), of(modes), here(lanes), known(known_part) {
    const V one = Number(1.0);
    a_s = coupled ? here(c.kappa) : one;
    a_y = coupled ? here(c.per_mass) : one;
    aspect = here(c.aspect);
    coupling = here(c.mu) * here(c.rho_sin_cos);
    lambda_0 = t * n;
    lambda_of_known = hn::Max(lambda_0, hn::Zero(Doubles()));
    V per_aspect = here(c.per_aspect);
    if constexpr (of_modes) {
      lambda_0 = lambda_0 + (coupling * known.s + (here(c.mu) * here(of.rho_sin)) * known.y);
      const V by_s = a_s * known.s + here(of.kappa_sy) * known.y + t * load.s;
      const V by_y =
          per_aspect * (here(of.kappa_sy) * known.s + here(of.kappa_y) * known.y + t * load.y);
      q_s = here(of.turn_c) * by_s + here(of.turn_s) * by_y;
      q_y = here(of.turn_c) * by_y - here(of.turn_s) * by_s;
      a_s = here(of.principal_1);
      a_y = here(of.principal_2);
      coupling = here(c.mu) * here(of.lifts_1);
      coupling_y = here(c.mu) * here(of.lifts_2);
      aspect = per_aspect = one;
    } else if constexpr (coupled) {
      lambda_0 = lambda_0 + coupling * known.s;  // where v_s = 0
      q_s = a_s * known.s + t * load.s;
      q_y = a_y * known.y + t * load.y;
    } else {
      q_s = known.s + t * load.s;
      q_y = known.y + t * load.y;
    }
    aspect2 = aspect * aspect;
    pushed = aspect * q_y;
    const V at_rest = hn::Max(lambda_0, hn::Zero(Doubles())), on_circle = per_aspect * q_y;
    slides = hn::Gt(q_s * q_s + on_circle * on_circle, at_rest * at_rest);
  }

  /// To begin with: lambda of v = known, and sigma to the first order in what is not the same in
  /// both directions.
  HWY_INLINE Braked Guess() const {
    const V zero = hn::Zero(Doubles());
    const V weight_s = q_s * q_s, weight_y = pushed * pushed, weights = weight_s + weight_y;
    const V size = hn::Sqrt(weights);
    V lambda = lambda_of_known;
    if constexpr (with_law) {
      const SpeedLaw law(c, here);
      lambda = lambda * law.Factor(law.Decay(Length(known.s, known.y)));
    }
    if constexpr (coupled)
      return {hn::Max(zero, hn::Div(size * weights - lambda * (weight_s + aspect2 * weight_y),
                                    a_s * weight_s + a_y * weight_y)),
              lambda};
    return {hn::Max(zero, size - lambda), lambda};
  }

  /// The velocity; `to` is where the iteration begins, and then where it has ended.
  /// @param anew from the guess; @param small difference of the velocity that does not matter
  template <bool anew>
  HWY_INLINE Velocity Solve(Braked& to, V small) const {
    Mask inexact = slides;
    if constexpr (anew) {
      to = Guess();  // exact on a circle
      if constexpr (!lambda_moves) inexact = hn::And(slides, hn::Ne(aspect, Number(1.0)));
    }
    constexpr int iterations = 12;
    for (int i = 0; i < iterations && !hn::AllFalse(Doubles(), inexact); ++i)
      inexact = hn::And(inexact, NewtonStep(to, inexact, small));
    return At(to);
  }

 private:
  /// x = M v / sigma, and the inverses of the denominators.
  struct Direction {
    V inverse_s, inverse_y, s, y, square_s, square_y;
  };
  /// How far lambda is from what it is at sigma x, and its slope by sigma; what is left of the
  /// difference after a step falls by `feedback` squared, and by half the second derivative.
  struct Following {
    V change, slope, feedback, bends;
  };

  /// The lanes that need one more.
  HWY_INLINE Mask NewtonStep(Braked& at, Mask moved, V small) const {
    const V zero = hn::Zero(Doubles()), one = Number(1.0), three = Number(3.0);
    const V d_s = a_s * at.sigma + at.lambda, d_y = a_y * at.sigma + at.lambda * aspect2;
    const V per = hn::Div(one, d_s * d_y);
    const V inverse_s = per * d_y, inverse_y = per * d_s;
    const V x_s = q_s * inverse_s, x_y = pushed * inverse_y;
    const Direction x{inverse_s, inverse_y, x_s, x_y, x_s * x_s, x_y * x_y};
    const V size2 = x.square_s + x.square_y;
    // (|x| - 1) |x|^2, with |x| to the third order in |x|^2 - 1: times size2 + 3.
    V gain = (Number(2.0) * (size2 - one)) * size2;
    V slope = a_s * (x.square_s * x.inverse_s) + a_y * (x.square_y * x.inverse_y);
    Following lambda{zero, zero, zero, zero};
    if constexpr (lambda_moves) {
      lambda = FollowLambda(x, at);
      const V per_lambda = x.square_s * x.inverse_s + aspect2 * (x.square_y * x.inverse_y);
      gain = gain - (size2 + three) * (per_lambda * lambda.change);
      slope = slope + per_lambda * lambda.slope;
    }
    const V moves = hn::Div(gain, (size2 + three) * slope);
    const V next = hn::Max(zero, at.sigma + moves);
    at.sigma = hn::IfThenElse(moved, next, at.sigma);
    if constexpr (lambda_moves)
      at.lambda = hn::IfThenElse(
          moved, hn::Max(zero, at.lambda + (lambda.change + lambda.slope * moves)), at.lambda);

    // What is left falls with the square of the change, and of what differs by direction.
    const V differs = a_s * d_y - a_y * d_s, both = a_s * d_y + a_y * d_s;
    const V left = (hn::Abs(moves) + hn::Abs(lambda.change)) * differs;
    Mask goes_on = hn::Gt(left * left, (small * next) * (both * both));
    if constexpr (coupled)
      goes_on = hn::Or(goes_on,
                       hn::Gt((lambda.feedback * lambda.feedback) * hn::Abs(lambda.change), small));
    if constexpr (with_law)
      goes_on = hn::Or(goes_on, hn::Gt(lambda.bends * (moves * moves), small));
    // On an ellipse x turns too, which the law leaves out.
    if constexpr (with_law && !coupled)
      goes_on =
          hn::Or(goes_on, hn::And(hn::Ne(aspect, one), hn::Gt(hn::Abs(lambda.change), small)));
    return goes_on;
  }

  HWY_INLINE Following FollowLambda(const Direction& x, const Braked& at) const {
    const V zero = hn::Zero(Doubles()), one = Number(1.0);
    V slow = lambda_of_known, slope = zero, feedback = zero, bends = zero;
    if constexpr (of_modes) {
      const V along = coupling * x.s, across = coupling_y * x.y;
      const V per_d = along * x.inverse_s + across * x.inverse_y;
      feedback = per_d * at.sigma;
      slow = hn::Max(zero, lambda_0 - (along + across) * at.sigma);
      slope = zero - per_d * at.lambda;
    } else if constexpr (coupled) {
      const V along = coupling * x.s;
      feedback = along * (at.sigma * x.inverse_s);
      slow = hn::Max(zero, lambda_0 - along * at.sigma);
      slope = zero - along * (x.inverse_s * at.lambda);
    }
    V lambda = slow;
    if constexpr (with_law) {
      const SpeedLaw law(c, here);
      V m_s = x.s, m_y = x.y;
      if constexpr (of_modes) {
        m_s = here(of.turn_c) * x.s - here(of.turn_s) * x.y;
        m_y = here(of.turn_s) * x.s + here(of.turn_c) * x.y;
      }
      const V speed = Length(m_s, here(c.per_aspect) * m_y);  // |v| / sigma
      const V decay = law.Decay(speed * at.sigma), factor = law.Factor(decay);
      const V rise = law.Slope(decay) * speed;
      lambda = factor * slow;
      slope = factor * slope + rise * slow;
      feedback = factor * feedback;
      bends = (Number(0.5) * hn::Abs(rise)) * (law.rate * speed) * slow;
    }
    if constexpr (!coupled) return {lambda - at.lambda, slope, feedback, bends};
    return {(lambda - at.lambda) * (one + feedback), slope * (one + feedback), feedback, bends};
  }

  HWY_INLINE Velocity At(const Braked& at) const {
    const V d_s = a_s * at.sigma + at.lambda, d_y = a_y * at.sigma + at.lambda * aspect2;
    const V per = hn::Div(at.sigma, d_s * d_y);
    const V v_1 = hn::IfThenElseZero(slides, (q_s * d_y) * per),
            v_2 = hn::IfThenElseZero(slides, (q_y * d_s) * per);
    if constexpr (of_modes)
      return {here(of.turn_c) * v_1 - here(of.turn_s) * v_2,
              here(c.per_aspect) * (here(of.turn_s) * v_1 + here(of.turn_c) * v_2)};
    return {v_1, v_2};
  }

  const Constants<Rows>& c;
  const ModeConstants<Rows>& of;
  Here here;
  Velocity known;
  V a_s, a_y, aspect, aspect2;
  V q_s, q_y, pushed;  // pushed = aspect q_y
  V lambda_0, lambda_of_known, coupling, coupling_y;
  Mask slides;
};

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_BRAKE_INL
