// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion of block and roof over a piece of an interval, in SIMD lanes, and what bounds on its
// derivatives prove. Included once per SIMD target.
#if defined(GLISSADE_LANE_CURVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_LANE_CURVES_INL
#undef GLISSADE_LANE_CURVES_INL
#else
#define GLISSADE_LANE_CURVES_INL
#endif

#include <hwy/highway.h>

#include <array>

#include "block/coupled_tables/coupled_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using V = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;

HWY_INLINE V Number(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE V Square(V v) { return v * v; }
HWY_INLINE V OrZero(Mask mask, V v) { return hn::IfThenElseZero(mask, v); }

struct Complex {
  V re, im;
};
HWY_INLINE Complex operator*(Complex p, Complex q) {
  return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}
HWY_INLINE Complex operator*(V f, Complex p) { return {f * p.re, f * p.im}; }
HWY_INLINE V RealOfProduct(Complex p, Complex q) { return p.re * q.re - p.im * q.im; }
HWY_INLINE Complex Select(Mask mask, Complex yes, Complex no) {
  return {hn::IfThenElse(mask, yes.re, no.re), hn::IfThenElse(mask, yes.im, no.im)};
}

/// LaneRegime of each lane.
struct Regime {
  V mass, weight, lag, angle, per_angle, decay, turn, sigma_re, sigma_im, sigma, per_im, phase,
      per_omega, per_omega2, a_1, w_1, a_2, w_2;
};
/// 1 / n!
constexpr auto inverse_factorial = [] {
  std::array<double, 2 * (LaneTables::most_terms + 1)> values{1.0};
  double factorial = 1.0;
  for (std::size_t n = 1; n < values.size(); ++n)
    values[n] = 1.0 / (factorial *= static_cast<double>(n));
  return values;
}();

/// cosh(sqrt(u)) - 1 and sinh(sqrt(u)) / sqrt(u) - 1; of -u those of the circle.
struct EvenOdd {
  V even, odd;
};
HWY_INLINE EvenOdd Series(V u, std::size_t terms) {
  // Every other term by itself, since each waits for the one before.
  const double* c = inverse_factorial.data() + 2;
  const V u2 = u * u;
  std::size_t k = 2 * (terms - 1);  // terms: an even number
  V even_1 = Number(c[k]), odd_1 = Number(c[k + 1]), even_0 = Number(c[k - 2]),
    odd_0 = Number(c[k - 1]);
  while (k > 2) {
    k -= 4;
    even_1 = even_1 * u2 + Number(c[k]);
    odd_1 = odd_1 * u2 + Number(c[k + 1]);
    even_0 = even_0 * u2 + Number(c[k - 2]);
    odd_0 = odd_0 * u2 + Number(c[k - 1]);
  }
  return {u * even_0 + u2 * even_1, u * odd_0 + u2 * odd_1};
}

/// p = exp(q), p - 1 and p - 1 - q for q = (-decay + i turn) t, without cancellation.
struct Growth {
  Complex power, minus_one, minus_line;
};
HWY_INLINE Growth GrowthAfter(const LaneTables& tables, const Regime& r, V t) {
  const V a = r.decay * t, b = r.turn * t;
  const EvenOdd decay = Series(a * a, tables.decay_terms),
                turn = Series(hn::Neg(b * b), tables.turn_terms);
  const V decayed = decay.even - a * decay.odd;  // exp(-a) - 1 + a
  const V shrunk = decayed - a, sine = b + b * turn.odd;
  Growth g{};
  g.minus_line.re = decayed + (Number(1.0) + shrunk) * turn.even;
  g.minus_line.im = b * turn.odd + shrunk * sine;
  g.minus_one = {g.minus_line.re - a, g.minus_line.im + b};
  g.power = {Number(1.0) + g.minus_one.re, g.minus_one.im};
  return g;
}

/// A curve over a piece: begin + c_1 t + c_2 t^2 + Re(b (p - 1)), with its end, its slopes per
/// piece, and how far it and its slope may leave their chords.
struct Curve {
  V begin, c_1, c_2;
  Complex b;
  V end, begin_slope, end_slope, deviation, slope_deviation;

  HWY_INLINE Mask NeverFalls() const {
    return hn::Gt(hn::Min(begin_slope, end_slope), slope_deviation);
  }
  HWY_INLINE Mask NeverRises() const {
    return hn::Lt(hn::Max(begin_slope, end_slope), hn::Neg(slope_deviation));
  }
  HWY_INLINE Mask BelowZero() const {
    return hn::Lt(hn::Max(begin, end) + deviation, hn::Zero(Doubles()));
  }
  /// Throughout, or from a begin that is known to be zero.
  HWY_INLINE Mask StaysBelow(Mask begins_at_zero) const {
    const V zero = hn::Zero(Doubles());
    const Mask ends = hn::Lt(hn::Max(begin, end), zero);
    return hn::Or(BelowZero(), hn::Or(hn::And(ends, hn::Or(NeverFalls(), NeverRises())),
                                      hn::And(begins_at_zero, NeverRises())));
  }
  /// From below zero to above, and never falls.
  HWY_INLINE Mask Rises() const {
    const V zero = hn::Zero(Doubles());
    return hn::And(hn::And(hn::Lt(begin, zero), hn::Gt(end, zero)), NeverFalls());
  }
};
HWY_INLINE Curve Select(Mask mask, const Curve& yes, const Curve& no) {
  return {hn::IfThenElse(mask, yes.begin, no.begin),
          hn::IfThenElse(mask, yes.c_1, no.c_1),
          hn::IfThenElse(mask, yes.c_2, no.c_2),
          Select(mask, yes.b, no.b),
          hn::IfThenElse(mask, yes.end, no.end),
          hn::IfThenElse(mask, yes.begin_slope, no.begin_slope),
          hn::IfThenElse(mask, yes.end_slope, no.end_slope),
          hn::IfThenElse(mask, yes.deviation, no.deviation),
          hn::IfThenElse(mask, yes.slope_deviation, no.slope_deviation)};
}

/// A step of Chebyshev's method, which trebles the right digits: of half curve over slope `bent`.
/// Where the curve bends too much for it, it still leads the way that Newton's does.
HWY_INLINE V Chebyshev(V newton, V bent) {
  const V factor = Number(1.0) + newton * bent;
  return newton * hn::Min(hn::Max(factor, Number(0.5)), Number(2.0));
}

/// The cubic's root, nearly, in the piece's own fraction.
HWY_INLINE V RootOfCubic(const Curve& f) {
  const V rise = f.end - f.begin;
  const V b = Number(3.0) * rise - Number(2.0) * f.begin_slope - f.end_slope,
          c = f.begin_slope + f.end_slope - Number(2.0) * rise;
  const V tau = hn::Neg(hn::Div(f.begin, rise));
  const V value = f.begin + tau * (f.begin_slope + tau * (b + tau * c)),
          slope = f.begin_slope + tau * (Number(2.0) * b + tau * (Number(3.0) * c)),
          half_curve = b + tau * (Number(3.0) * c);
  const V per_slope = hn::Div(Number(1.0), slope), newton = value * per_slope;
  const V next = tau - Chebyshev(newton, half_curve * per_slope);
  return hn::Min(hn::Max(next, hn::Zero(Doubles())), Number(1.0));
}

/// The growth after a small step more, |d| <= most_step.
constexpr double most_step = 1e-3;
HWY_INLINE Growth After(const Growth& g, Complex q) {
  // exp(q) - 1 - q
  const Complex half{Number(0.5) * q.re, Number(0.5) * q.im};
  const Complex third{
      Number(1.0) + Number(1.0 / 3.0) * (q.re + Number(0.25) * (q.re * q.re - q.im * q.im)),
      Number(1.0 / 3.0) * (q.im + Number(0.5) * (q.re * q.im))};
  const Complex more = (q * half) * third;
  const Complex turned = g.minus_one * q, grown = g.power * more;
  Growth after{};
  after.minus_line = {g.minus_line.re + (turned.re + grown.re),
                      g.minus_line.im + (turned.im + grown.im)};
  after.minus_one = {g.minus_one.re + (q.re + (turned.re + grown.re)),
                     g.minus_one.im + (q.im + (turned.im + grown.im))};
  after.power = {Number(1.0) + after.minus_one.re, after.minus_one.im};
  return after;
}
HWY_INLINE Growth Select(Mask mask, const Growth& yes, const Growth& no) {
  return {Select(mask, yes.power, no.power), Select(mask, yes.minus_one, no.minus_one),
          Select(mask, yes.minus_line, no.minus_line)};
}

/// The root of a curve that rises, by Chebyshev's method: it trebles the right digits.
/// @param wanted on return, those found
/// @param t, growth of those found: the root, and p there
HWY_INLINE void Root(const LaneTables& tables, const Regime& r, const Curve& f, V length,
                     Mask& wanted, V& t, Growth& growth) {
  constexpr double error = 1e-15;  // of an interval
  constexpr int most = 20;
  const V zero = hn::Zero(Doubles());
  const Complex s_dt{hn::Neg(r.decay), r.turn};
  const V third = hn::Sqrt(Square(f.b.re) + Square(f.b.im)) * (r.phase * (r.phase * r.phase));
  V at = RootOfCubic(f) * length;
  Mask open = wanted;
  for (int i = 0; i < most && !hn::AllFalse(Doubles(), open); ++i) {
    const Growth g = GrowthAfter(tables, r, at);
    const Complex rate = f.b * (g.power * s_dt);
    const V value = f.begin + ((f.c_1 + f.c_2 * at) * at + RealOfProduct(f.b, g.minus_one)),
            slope = (f.c_1 + Number(2.0) * (f.c_2 * at)) + rate.re,
            curve = Number(2.0) * f.c_2 + RealOfProduct(rate, s_dt);
    const V per_slope = hn::Div(Number(1.0), slope);
    const V newton = value * per_slope, bent = Number(0.5) * (curve * per_slope);
    const V wanted_step = Chebyshev(newton, bent), taken = hn::Abs(wanted_step);
    const V next = hn::Min(hn::Max(at - wanted_step, zero), length), step = next - at;
    const V left =
        (taken * (taken * taken)) * (Number(2.0) * (bent * bent) + third * hn::Abs(per_slope));
    const Mask found =
        hn::And(open, hn::And(hn::Le(left, Number(error)), hn::Le(taken, Number(most_step))));
    t = hn::IfThenElse(found, next, t);
    growth = Select(found, After(g, step * s_dt), growth);
    at = next;
    open = hn::AndNot(found, open);
  }
  wanted = hn::AndNot(open, wanted);
}

/// The roof at an instant of a piece.
struct RoofInstant {
  V x, y;
  V a, a_rate;  // of the roof, and its rate per interval
};

/// Linear; at a piece's begin, and its change over an interval; gravity is g + w.
struct Ground {
  V a, a_rise, gravity, gravity_rise;
};

/// The motion from a piece's begin on, in the regime that it has there.
struct PieceMotion {
  const LaneTables& tables;
  const Regime& r;
  const Ground& ground;
  V x, y, speed;
  V rise;                // of H, over an interval
  V x_forced, y_forced;  // without the vibration, at the piece's begin
  Complex z, sigma_z, sigma2_z, jerk;
  V size;  // |Z|

  HWY_INLINE PieceMotion(const LaneTables& of, const Regime& regime, const Ground& linear,
                         V x_begin, V y_begin, V speed_begin)
      : tables(of),
        r(regime),
        ground(linear),
        x(x_begin),
        y(y_begin),
        speed(speed_begin),
        z{},
        sigma_z{},
        sigma2_z{},
        jerk{} {
    rise = r.mass * ground.a_rise + r.weight * ground.gravity_rise;
    x_forced = r.lag * rise - (r.mass * ground.a + r.weight * ground.gravity);
    y_forced = hn::Neg(rise * r.per_angle);
    const Complex sigma_1{r.sigma_re, r.sigma_im};
    z.re = x - x_forced;
    z.im = (r.sigma_re * z.re - (y - y_forced)) * r.per_im;
    sigma_z = sigma_1 * z;
    sigma2_z = sigma_1 * sigma_z;
    jerk = sigma2_z * Complex{hn::Neg(r.decay), r.turn};
    size = hn::Sqrt(Square(z.re) + Square(z.im));
  }

  HWY_INLINE RoofInstant At(V t, Complex power) const {
    return {x_forced - t * rise + RealOfProduct(z, power), y_forced + RealOfProduct(sigma_z, power),
            ground.a + t * ground.a_rise + RealOfProduct(sigma2_z, power),
            ground.a_rise + RealOfProduct(jerk, power)};
  }
  HWY_INLINE RoofInstant Begin() const {
    return {x, y, ground.a + sigma2_z.re, ground.a_rise + jerk.re};
  }
  HWY_INLINE V Deviation(V amplitude, V length) const {
    return Number(0.125) * (amplitude * Square(r.phase * length));
  }
  HWY_INLINE Curve Bounded(Curve f, V amplitude, V length) const {
    const V phase = r.phase * length, second = amplitude * (phase * phase);
    f.deviation = Number(0.125) * (second + Number(2.0) * (hn::Abs(f.c_2) * (length * length)));
    f.slope_deviation = Number(0.125) * (second * phase);
    return f;
  }
  /// A line of the roof's acceleration and g + w.
  HWY_INLINE Curve Drive(V per_a, V per_w, const RoofInstant& begin, const RoofInstant& end,
                         V length) const {
    Curve f{};
    f.begin = per_a * begin.a + per_w * ground.gravity;
    f.end = per_a * end.a + per_w * (ground.gravity + length * ground.gravity_rise);
    f.begin_slope = length * (per_a * begin.a_rate + per_w * ground.gravity_rise);
    f.end_slope = length * (per_a * end.a_rate + per_w * ground.gravity_rise);
    f.c_1 = per_a * ground.a_rise + per_w * ground.gravity_rise;
    f.c_2 = hn::Zero(Doubles());
    f.b = per_a * sigma2_z;
    return Bounded(f, hn::Abs(per_a) * (r.sigma * r.sigma * size), length);
  }
  /// Minus the speed: its rate is line 1.
  HWY_INLINE Curve MinusSpeed(const Curve& drive, const Growth& growth, V length) const {
    const V dt = Number(tables.step_s);
    Curve f{};
    f.begin = hn::Neg(speed);
    f.c_1 = dt * (r.a_1 * ground.a + r.w_1 * ground.gravity);
    f.c_2 = (Number(0.5) * dt) * drive.c_1;
    f.b = (r.a_1 * r.per_omega) * sigma_z;
    f.end = f.begin + ((f.c_1 + f.c_2 * length) * length + RealOfProduct(f.b, growth.minus_one));
    f.begin_slope = (dt * length) * drive.begin;
    f.end_slope = (dt * length) * drive.end;
    return Bounded(f, hn::Abs(r.a_1 * r.per_omega) * (r.sigma * size), length);
  }
  /// x_3 x + y_3 y + c_3.
  HWY_INLINE Curve Spring(V per_x, V per_y, V c, const RoofInstant& begin, const RoofInstant& end,
                          V length) const {
    const V forced = ground.a_rise * length, rate = r.angle * length;
    Curve f{};
    f.begin = per_x * x + per_y * y + c;
    f.end = per_x * end.x + per_y * end.y + c;
    f.begin_slope = rate * (per_x * y + per_y * (begin.a - ground.a));
    f.end_slope = rate * (per_x * end.y + per_y * (end.a - (ground.a + forced)));
    f.c_1 = hn::Neg(per_x * rise);
    f.c_2 = hn::Zero(Doubles());
    f.b = {per_x * z.re + per_y * sigma_z.re, per_x * z.im + per_y * sigma_z.im};
    return Bounded(f, (hn::Abs(per_x) + hn::Abs(per_y) * r.sigma) * size, length);
  }
  /// In contact: the normal force is positive.
  HWY_INLINE Mask Stays(const RoofInstant& begin, const RoofInstant& end, V length) const {
    const V phase = r.phase * length,
            bend = Number(0.125) * (phase * phase) * (r.sigma * r.sigma * size);
    const V cot_slope = Number(tables.cot_slope);
    const V least = hn::Min(ground.gravity * cot_slope + begin.a,
                            (ground.gravity + length * ground.gravity_rise) * cot_slope + end.a);
    return hn::Gt(least, bend);
  }
};

/// Curves of which only one may rise.
struct Rising {
  Curve curve;  ///< the one that does
  V event;      ///< its number
  V length;
  Mask one, bad;  ///< one rises; neither that nor that all stay below zero
  Mask soon;      ///< one may in the next interval, by its slope at the end

  HWY_INLINE Rising(const Curve& f, Mask begins_at_zero, V number, V of_length)
      : curve(f), event(number), length(of_length) {
    one = hn::AndNot(begins_at_zero, f.Rises());
    bad = hn::Not(hn::Or(one, f.StaysBelow(begins_at_zero)));
    soon = Soon(f);
  }
  HWY_INLINE void Add(const Curve& f, Mask begins_at_zero, V number) {
    const Mask rises = hn::AndNot(begins_at_zero, f.Rises()),
               decided = hn::Or(rises, f.StaysBelow(begins_at_zero));
    bad = hn::Or(bad, hn::Or(hn::Not(decided), hn::And(one, rises)));
    soon = hn::Or(soon, Soon(f));
    one = hn::Or(one, rises);
    curve = Select(rises, f, curve);
    event = hn::IfThenElse(rises, number, event);
  }
  /// One that is below zero by far, except where it does not matter.
  HWY_INLINE void AddBelow(V begin, V end, V deviation, Mask but) {
    const Mask below = hn::Lt(hn::Max(begin, end) + deviation, hn::Zero(Doubles()));
    bad = hn::Or(bad, hn::Not(hn::Or(below, but)));
  }
  /// A search would stop there, too.
  HWY_INLINE Mask Soon(const Curve& f) const {
    constexpr double intervals = 1.0;
    return hn::Gt(f.end * length + Number(intervals) * hn::Abs(f.end_slope), hn::Zero(Doubles()));
  }
};

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
