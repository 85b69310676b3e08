// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>

#include "block/coupled_tables/coupled_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/coupled_tables/lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#ifndef GLISSADE_INLINE_LAMBDA
#define GLISSADE_INLINE_LAMBDA __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using V = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
using Indices = hn::RebindToSigned<Doubles>;
using I = hn::Vec<Indices>;

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

/// The lanes' regimes.
template <bool yields>
struct Regimes {
  static constexpr std::size_t count = yields ? 6 : 3;
  const LaneTables& tables;
  Mask is[count];

  HWY_INLINE Regimes(const LaneTables& of, V index) : tables(of) {
    for (std::size_t k = 1; k < count; ++k) is[k] = hn::Eq(index, Number(static_cast<double>(k)));
  }
  HWY_INLINE V Get(double LaneRegime::*field) const {
    V v = Number(tables.regimes[0]->*field);
    for (std::size_t k = 1; k < count; ++k)
      v = hn::IfThenElse(is[k], Number(tables.regimes[k]->*field), v);
    return v;
  }
  /// Of the same spring, whatever the contact.
  HWY_INLINE V OfSpring(double LaneRegime::*field) const {
    V v = Number(tables.regimes[0]->*field);
    if constexpr (yields) v = hn::IfThenElse(Yielding(), Number(tables.regimes[3]->*field), v);
    return v;
  }
  /// Of a table of each regime.
  HWY_INLINE V At(const double* LaneRegime::*table, I node) const {
    const Indices di;
    const double* base = tables.regimes[0]->*table;
    I at = hn::ShiftLeft<3>(node);
    for (std::size_t k = 1; k < count; ++k) {
      const auto far = reinterpret_cast<std::uintptr_t>(tables.regimes[k]->*table) -
                       reinterpret_cast<std::uintptr_t>(base);
      at = hn::Add(at, hn::IfThenElseZero(hn::RebindMask(di, is[k]),
                                          hn::Set(di, static_cast<std::int64_t>(far))));
    }
    return hn::GatherOffset(Doubles(), base, at);
  }
  HWY_INLINE Mask Down() const {
    if constexpr (yields) return hn::Or(is[1], is[4]);
    return is[1];
  }
  HWY_INLINE Mask Up() const {
    if constexpr (yields) return hn::Or(is[2], is[5]);
    return is[2];
  }
  HWY_INLINE Mask Yielding() const {
    if constexpr (yields) return hn::Or(is[3], hn::Or(is[4], is[5]));
    return hn::And(is[1], is[2]);
  }
};

struct Regime {
  V mass, weight, lag, angle, per_angle, decay, turn, sigma_re, sigma_im, sigma, per_im, phase,
      per_omega, per_omega2, a_1, w_1, a_2, w_2;
};
template <bool yields>
HWY_INLINE Regime Get(const Regimes<yields>& of) {
  using R = LaneRegime;
  return {of.Get(&R::mass),
          of.Get(&R::weight),
          of.OfSpring(&R::lag),
          of.OfSpring(&R::angle),
          of.OfSpring(&R::per_angle),
          of.Get(&R::decay),
          of.Get(&R::turn),
          of.Get(&R::sigma_re),
          of.Get(&R::sigma_im),
          of.Get(&R::sigma),
          of.Get(&R::per_im),
          of.Get(&R::phase),
          of.OfSpring(&R::per_omega),
          of.OfSpring(&R::per_omega2),
          of.Get(&R::a_1),
          of.Get(&R::w_1),
          of.Get(&R::a_2),
          of.Get(&R::w_2)};
}

/// 1 / n!
constexpr double inverse_factorial[] = {1.0,
                                        1.0,
                                        1.0 / 2.0,
                                        1.0 / 6.0,
                                        1.0 / 24.0,
                                        1.0 / 120.0,
                                        1.0 / 720.0,
                                        1.0 / 5040.0,
                                        1.0 / 40320.0,
                                        1.0 / 362880.0,
                                        1.0 / 3628800.0,
                                        1.0 / 39916800.0,
                                        1.0 / 479001600.0,
                                        1.0 / 6227020800.0,
                                        1.0 / 87178291200.0,
                                        1.0 / 1307674368000.0,
                                        1.0 / 20922789888000.0,
                                        1.0 / 355687428096000.0,
                                        1.0 / 6402373705728000.0,
                                        1.0 / 121645100408832000.0};
static_assert(std::size(inverse_factorial) == 2 * (LaneTables::most_terms + 1));

/// cosh(sqrt(u)) - 1 and sinh(sqrt(u)) / sqrt(u) - 1; of -u those of the circle.
struct EvenOdd {
  V even, odd;
};
HWY_INLINE EvenOdd Series(V u, std::size_t terms) {
  V even = Number(inverse_factorial[2 * terms]), odd = Number(inverse_factorial[2 * terms + 1]);
  for (std::size_t k = terms - 1; k > 0; --k) {
    even = even * u + Number(inverse_factorial[2 * k]);
    odd = odd * u + Number(inverse_factorial[2 * k + 1]);
  }
  return {even * u, odd * u};
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
  Growth g;
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

/// The cubic's root, nearly, in the piece's own fraction.
HWY_INLINE V RootOfCubic(const Curve& f) {
  const V rise = f.end - f.begin;
  const V b = Number(3.0) * rise - Number(2.0) * f.begin_slope - f.end_slope,
          c = f.begin_slope + f.end_slope - Number(2.0) * rise;
  V tau = hn::Neg(hn::Div(f.begin, rise));
  for (int i = 0; i < 2; ++i) {
    const V value = f.begin + tau * (f.begin_slope + tau * (b + tau * c)),
            slope = f.begin_slope + tau * (Number(2.0) * b + tau * (Number(3.0) * c));
    tau = hn::Min(hn::Max(tau - hn::Div(value, slope), hn::Zero(Doubles())), Number(1.0));
  }
  return tau;
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
  Growth after;
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
    const V next = hn::Min(hn::Max(at - newton * (Number(1.0) + newton * bent), zero), length);
    const V step = next - at, taken = hn::Abs(step);
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
struct State {
  V x, y;
  V a, a_rate;  // of the roof, and its rate per interval
};

/// A piece: the roof and the ground, linear.
struct Ground {
  V a, a_rise, gravity, gravity_rise;  // at a piece's begin, and over an interval; g + w
};
struct Step {
  const LaneTables& tables;
  const Regime& r;
  const Ground& ground;
  V x, y, speed;
  V rise;                // of H, over an interval
  V x_forced, y_forced;  // without the vibration, at the piece's begin
  Complex z, sigma_z, sigma2_z, jerk;
  V size;  // |Z|

  HWY_INLINE Step(const LaneTables& of, const Regime& regime, const Ground& linear, V x_begin,
                  V y_begin, V speed_begin)
      : tables(of), r(regime), ground(linear), x(x_begin), y(y_begin), speed(speed_begin) {
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

  HWY_INLINE State At(V t, Complex power) const {
    return {x_forced - t * rise + RealOfProduct(z, power), y_forced + RealOfProduct(sigma_z, power),
            ground.a + t * ground.a_rise + RealOfProduct(sigma2_z, power),
            ground.a_rise + RealOfProduct(jerk, power)};
  }
  HWY_INLINE Curve Bounded(Curve f, V amplitude, V length) const {
    const V phase = r.phase * length, second = amplitude * (phase * phase);
    f.deviation = Number(0.125) * (second + Number(2.0) * (hn::Abs(f.c_2) * (length * length)));
    f.slope_deviation = Number(0.125) * (second * phase);
    return f;
  }
  /// A line of the roof's acceleration and g + w.
  HWY_INLINE Curve Drive(V per_a, V per_w, const State& begin, const State& end, V length) const {
    Curve f;
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
    Curve f;
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
  HWY_INLINE Curve Spring(V per_x, V per_y, V c, const State& begin, const State& end,
                          V length) const {
    const V forced = ground.a_rise * length, rate = r.angle * length;
    Curve f;
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
  HWY_INLINE Mask Stays(const State& begin, const State& end, V length) const {
    const V phase = r.phase * length,
            bend = Number(0.125) * (phase * phase) * (r.sigma * r.sigma * size);
    const V cot_slope = Number(tables.cot_slope);
    const V least = hn::Min(ground.gravity * cot_slope + begin.a,
                            (ground.gravity + length * ground.gravity_rise) * cot_slope + end.a);
    return hn::Gt(least, bend);
  }
};

/// Adds a curve to those of which only one may rise.
struct Rising {
  Mask one, bad;  ///< just one rises; neither that nor that all stay below zero
  Curve curve;
  V event;

  HWY_INLINE void Add(const Curve& f, Mask begins_at_zero, double number) {
    const Mask stays = f.StaysBelow(begins_at_zero), rises = hn::AndNot(begins_at_zero, f.Rises());
    bad = hn::Or(bad, hn::Or(hn::Not(hn::Or(stays, rises)), hn::And(one, rises)));
    one = hn::Or(one, rises);
    curve = Select(rises, f, curve);
    event = hn::IfThenElse(rises, Number(number), event);
  }
};

/// What each lane of a vector is, from the rows.
struct Rows {
  CoupledLanes& lanes;
  std::size_t first;

  HWY_INLINE V operator()(const CoupledLanes::Row& row) const {
    return hn::Load(Doubles(), row + first);
  }
  HWY_INLINE void Set(CoupledLanes::Row& row, V v) const { hn::Store(v, Doubles(), row + first); }
  HWY_INLINE void Set(CoupledLanes::Row& row, Mask mask, V v) const {
    Set(row, hn::IfThenElse(mask, v, (*this)(row)));
  }
  HWY_INLINE I Node() const { return hn::Load(Indices(), lanes.node + first); }
};

/// The ground at the lanes' nodes.
struct NodeValues {
  V acceleration, velocity, displacement, displacement_low;
};
HWY_INLINE NodeValues ValuesAt(const GroundNode* nodes, const std::int64_t* node,
                               std::int64_t ahead, std::int64_t last) {
  static_assert(sizeof(GroundNode) == 4 * sizeof(double));
  const Doubles d;
  alignas(64) GroundNode here[8];
  for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
    const std::int64_t i = node[k] + ahead;
    here[k] = nodes[i < last ? i : last];
  }
  NodeValues v;
  hn::LoadInterleaved4(d, &here[0].acceleration_mps2, v.acceleration, v.velocity, v.displacement,
                       v.displacement_low);
  return v;
}
/// At both ends of the lanes' intervals; w: of the vertical, if there is one.
struct Ends {
  NodeValues a, a_next, w, w_next;
};
HWY_INLINE Ends EndsOf(const LaneTables& tables, const std::int64_t* node) {
  Ends e;
  e.a = e.w = ValuesAt(tables.ground, node, 0, tables.quiet);
  e.a_next = e.w_next = ValuesAt(tables.ground, node, 1, tables.quiet);
  if (tables.vertical != nullptr) {
    e.w = ValuesAt(tables.vertical, node, 0, tables.quiet);
    e.w_next = ValuesAt(tables.vertical, node, 1, tables.quiet);
  }
  return e;
}
/// V - V(from), and U - U(from) - V(from) t.
struct Gains {
  V velocity, displacement;
};
HWY_INLINE Gains Since(const NodeValues& from, const NodeValues& now, V t) {
  return {now.velocity - from.velocity, ((now.displacement - from.displacement) +
                                         (now.displacement_low - from.displacement_low)) -
                                            from.velocity * t};
}

/// Takes lanes with a new interval from their reference node to its begin.
template <bool yields>
HWY_INLINE void Begin(const Rows& rows, const LaneTables& tables, const Regimes<yields>& regimes,
                      const Regime& r, const Ends& ends, V intensity, V w_factor, Mask begins) {
  const CoupledLanes& l = rows.lanes;
  const V zero = hn::Zero(Doubles());
  const Complex free =
      Complex{rows(l.free_re), rows(l.free_im)} * Complex{rows(l.power_re), rows(l.power_im)};
  const V x = intensity * rows(l.x_table) + (free.re - r.weight * Number(tables.gravity_mps2)),
          y = intensity * rows(l.y_table) + RealOfProduct(Complex{r.sigma_re, r.sigma_im}, free);
  rows.Set(rows.lanes.x, begins, x);
  rows.Set(rows.lanes.y, begins, y);
  rows.Set(rows.lanes.began, begins, zero);
  const Mask slides = hn::And(begins, hn::Or(regimes.Down(), regimes.Up()));
  if (hn::AllFalse(Doubles(), slides)) return;

  const V t = rows(l.steps) * Number(tables.step_s), speed_from = rows(l.speed_from),
          x_from = rows(l.x_from), y_from = rows(l.y_from);
  const Gains a =
      Since({zero, rows(l.velocity_from), rows(l.displacement_from), rows(l.displacement_low_from)},
            ends.a, t);
  const V motion = intensity * Number(tables.sign);
  const V roof_gain = (y - y_from) * r.per_omega + motion * a.velocity,
          roof_displacement =
              ((x - x_from) * r.per_omega2 - (y_from * r.per_omega) * t) + motion * a.displacement;
  V gravity_gain = Number(tables.gravity_mps2) * t,
    gravity_displacement = Number(0.5 * tables.gravity_mps2) * (t * t);
  if (tables.vertical != nullptr) {
    const Gains w = Since({zero, rows(l.w_velocity_from), rows(l.w_displacement_from),
                           rows(l.w_displacement_low_from)},
                          ends.w, t);
    gravity_gain = gravity_gain + w_factor * w.velocity;
    gravity_displacement = gravity_displacement + w_factor * w.displacement;
  }
  // Line 1 is minus the drive.
  rows.Set(rows.lanes.speed, slides, speed_from - (r.a_1 * roof_gain + r.w_1 * gravity_gain));
  const V travel =
      hn::Max(speed_from * t - (r.a_1 * roof_displacement + r.w_1 * gravity_displacement), zero);
  rows.Set(rows.lanes.slip, slides,
           hn::IfThenElse(regimes.Down(), rows(l.slip) + travel, rows(l.slip) - travel));
  rows.Set(rows.lanes.duration_s, slides, rows(l.duration_s) + t);
}

/// Makes the node after an interval the reference of what follows in the regime of now.
template <bool yields>
HWY_INLINE void SetReference(const Rows& rows, const LaneTables& tables, V index, I node,
                             const Ends& ends, V intensity, Mask ended) {
  CoupledLanes& l = rows.lanes;
  const Regimes<yields> regimes(tables, index);
  const V x = rows(l.x), y = rows(l.y);
  const V re = (x + regimes.Get(&LaneRegime::weight) * Number(tables.gravity_mps2)) -
               intensity * regimes.At(&LaneRegime::x, node),
          rate = y - intensity * regimes.At(&LaneRegime::y, node),
          im = (regimes.Get(&LaneRegime::sigma_re) * re - rate) * regimes.Get(&LaneRegime::per_im);
  rows.Set(l.free_re, ended, re);
  rows.Set(l.free_im, ended, im);
  rows.Set(l.free_size, ended, hn::Sqrt(Square(re) + Square(im)));
  rows.Set(l.x_from, ended, x);
  rows.Set(l.y_from, ended, y);
  rows.Set(l.speed_from, ended, rows(l.speed));
  const NodeValues &a = ends.a_next, &w = ends.w_next;
  rows.Set(l.velocity_from, ended, a.velocity);
  rows.Set(l.displacement_from, ended, a.displacement);
  rows.Set(l.displacement_low_from, ended, a.displacement_low);
  if (tables.vertical == nullptr) return;
  rows.Set(l.w_velocity_from, ended, w.velocity);
  rows.Set(l.w_displacement_from, ended, w.displacement);
  rows.Set(l.w_displacement_low_from, ended, w.displacement_low);
}

/// The ground of the lanes' intervals, from the fraction tau on.
HWY_INLINE Ground GroundAt(const LaneTables& tables, const Ends& ends, V intensity, V w_factor,
                           V tau) {
  const V factor = intensity * Number(tables.sign), gravity = Number(tables.gravity_mps2);
  const V a = factor * ends.a.acceleration;
  Ground g;
  g.a_rise = factor * ends.a_next.acceleration - a;
  g.a = a + tau * g.a_rise;
  g.gravity = gravity;
  g.gravity_rise = hn::Zero(Doubles());
  if (tables.vertical != nullptr) {
    const V w = w_factor * ends.w.acceleration;
    g.gravity_rise = w_factor * ends.w_next.acceleration - w;
    g.gravity = gravity + (w + tau * g.gravity_rise);
  }
  return g;
}

HWY_INLINE std::uint64_t Bits(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

/// Of an interval. Where bounds decide nothing about pieces this short, curves touch zero, or two
/// events are as good as one.
constexpr double shortest_piece = 1.0 / 512;

template <bool yields>
HWY_INLINE LanesDone StepVector(CoupledLanes& lanes, const LaneTables& tables, std::size_t first) {
  const Doubles d;
  const Indices di;
  const V zero = hn::Zero(d), one = Number(1.0);
  const Mask never = hn::Lt(zero, zero);
  const Rows rows{lanes, first};
  const V index = rows(lanes.regime);
  const Regimes<yields> regimes(tables, index);
  const Regime r = Get(regimes);
  const I node = rows.Node(), last = hn::Set(di, tables.quiet);
  const Mask in_record = hn::RebindMask(d, hn::Not(hn::Gt(node, last)));
  const V intensity = OrZero(in_record, rows(lanes.intensity)),
          w_factor = OrZero(in_record, rows(lanes.w_factor));
  const Ends ends = EndsOf(tables, lanes.node + first);
  const Mask begins = hn::Gt(rows(lanes.begins), zero);
  if (!hn::AllFalse(d, begins)) {
    Begin(rows, tables, regimes, r, ends, intensity, w_factor, begins);
    rows.Set(lanes.begins, zero);
  }

  const V left = rows(lanes.left), length = rows(lanes.length), speed_begin = rows(lanes.speed);
  const Ground ground = GroundAt(tables, ends, intensity, w_factor, one - left);
  const Step step(tables, r, ground, rows(lanes.x), rows(lanes.y), speed_begin);
  const Mask slides = hn::Or(regimes.Down(), regimes.Up()),
             starts = hn::Gt(rows(lanes.starts), zero);
  const Growth to_end = GrowthAfter(tables, r, length);
  const State begin = step.At(zero, {one, zero}), end = step.At(length, to_end.power);

  const Curve drive = step.Drive(r.a_1, r.w_1, begin, end, length),
              minus_speed = step.MinusSpeed(drive, to_end, length);
  Rising rising;
  rising.bad = hn::Not(step.Stays(begin, end, length));
  rising.one = never;
  rising.curve = minus_speed;
  rising.event = zero;
  rising.Add(Select(hn::AndNot(starts, slides), minus_speed, drive), starts, 1.0);
  rising.Add(step.Drive(r.a_2, r.w_2, begin, end, length), never, 2.0);
  const V side = yields ? rows(lanes.side) : zero, unloads = yields ? rows(lanes.unloads) : zero,
          highest = yields ? rows(lanes.highest) : zero,
          lowest = yields ? rows(lanes.lowest) : zero;
  if constexpr (yields) {
    // Elastic: above the highest force, and below the lowest. Yielding, or just unloaded: its rate.
    const Mask yielding = regimes.Yielding(), unloaded = hn::Ne(unloads, zero),
               rate = hn::Or(yielding, unloaded);
    const Mask above = hn::And(unloaded, hn::Lt(unloads, zero));
    rising.Add(step.Spring(hn::IfThenElse(rate, zero, one), OrZero(rate, unloads - side),
                           hn::Neg(OrZero(hn::Not(rate), highest)), begin, end, length),
               unloaded, 3.0);
    rising.Add(
        step.Spring(
            hn::IfThenElse(above, one, hn::Neg(OrZero(hn::Not(yielding), one))), zero,
            hn::IfThenElse(yielding, Number(-1.0), hn::IfThenElse(above, hn::Neg(highest), lowest)),
            begin, end, length),
        never, 4.0);
  }
  // Of no length: only what is at its end.
  const Mask closes = hn::Eq(left, zero);
  Mask decided = hn::Or(hn::Not(rising.bad), closes);
  V t = length;
  Growth growth = to_end;
  Mask found = hn::AndNot(closes, hn::And(decided, rising.one));
  if (!hn::AllFalse(d, found)) {
    const Mask wanted = found;
    Root(tables, r, rising.curve, length, found, t, growth);
    decided = hn::AndNot(hn::AndNot(found, wanted), decided);
  }
  const State at = step.At(t, growth.power);
  const V dt = Number(tables.step_s);
  const V gained = (minus_speed.c_1 + minus_speed.c_2 * t) * t +
                   RealOfProduct(minus_speed.b, growth.minus_one),
          lost = (dt * (t * t)) *
                     (Number(0.5) * minus_speed.c_1 + Number(1.0 / 3.0) * (minus_speed.c_2 * t)) +
                 (r.a_1 * r.per_omega2) * RealOfProduct(step.z, growth.minus_line);
  V speed = OrZero(slides, speed_begin - gained);
  const V distance = OrZero(slides, (speed_begin * dt) * t - lost);
  // A phase that begins goes on.
  const Mask fails = hn::And(starts, hn::Or(hn::Le(speed, zero), hn::Lt(distance, zero)));
  decided = hn::Or(closes, hn::AndNot(fails, decided));
  // Without tables of the yielding spring all that it does is left to the scalar scheme.
  const Mask beyond =
      tables.has_yielding ? never : hn::And(found, hn::Gt(rising.event, Number(2.0)));
  decided = hn::AndNot(beyond, decided);
  found = hn::And(found, decided);

  // The piece is passed.
  const V direction = hn::Sub(OrZero(regimes.Down(), one), OrZero(regimes.Up(), one));
  const V slip = rows(lanes.slip) + direction * hn::Max(distance, zero);
  rows.Set(lanes.slip, decided, slip);
  rows.Set(lanes.duration_s, decided, rows(lanes.duration_s) + OrZero(slides, t * dt));
  const V rest = left - t;
  rows.Set(lanes.left, decided, rest);
  rows.Set(lanes.length, hn::IfThenElse(decided, rest, Number(0.5) * length));
  const Mask undecided =
      hn::AndNot(decided, hn::Or(beyond, hn::Lt(Number(0.5) * length, Number(shortest_piece))));

  // What has happened.
  const V event = OrZero(found, rising.event);
  const Mask first_rose = hn::Eq(event, one), up = hn::Eq(event, Number(2.0));
  const Mask stops = hn::And(first_rose, slides), down = hn::AndNot(slides, first_rose);
  V x = at.x, y = at.y, now = direction;
  speed = hn::IfThenElseZero(hn::Not(stops), speed);
  rows.Set(lanes.farthest_down, stops, hn::Max(rows(lanes.farthest_down), slip));
  rows.Set(lanes.farthest_up, stops, hn::Min(rows(lanes.farthest_up), slip));
  // Where it stopped: the other direction's drive decides, never that of the one it stopped in.
  const LaneRegime& stuck = *tables.regimes[0];
  const V a_stuck = hn::Neg(x + (r.lag * r.angle) * y) * Number(1.0 / stuck.mass),
          gravity = ground.gravity + t * ground.gravity_rise;
  const Mask was_down = regimes.Down();
  const V other = hn::IfThenElse(was_down, Number(stuck.a_2), Number(stuck.a_1)) * a_stuck +
                  hn::IfThenElse(was_down, Number(stuck.w_2), Number(stuck.w_1)) * gravity;
  const Mask reverses = hn::And(stops, hn::Gt(other, zero)),
             started = hn::Or(hn::Or(down, up), reverses);
  now = hn::IfThenElse(down, one, hn::IfThenElse(up, Number(-1.0), now));
  now = hn::IfThenElse(stops, OrZero(reverses, hn::Neg(direction)), now);
  rows.Set(lanes.phases, started, rows(lanes.phases) + one);
  rows.Set(lanes.began, started, one);
  const V jumps = tables.static_friction ? Number(2.0) : one;
  rows.Set(lanes.starts, decided, OrZero(started, hn::IfThenElse(reverses, Number(2.0), jumps)));
  rows.Set(lanes.stopped, decided, OrZero(hn::AndNot(reverses, stops), direction));
  V next = hn::IfThenElse(hn::Eq(now, Number(-1.0)), Number(2.0), now);
  if constexpr (yields) {
    const Mask third = hn::Eq(event, Number(3.0)), fourth = hn::Eq(event, Number(4.0));
    const Mask unloads_now = hn::And(third, regimes.Yielding()),
               yields_up = hn::Or(hn::AndNot(regimes.Yielding(), third),
                                  hn::And(fourth, hn::Lt(unloads, zero))),
               yields_down = hn::AndNot(hn::Lt(unloads, zero), fourth),
               yields_now = hn::Or(yields_up, yields_down);
    x = hn::IfThenElse(yields_up, highest, hn::IfThenElse(yields_down, lowest, x));
    y = hn::IfThenElse(yields_now, y * Number(tables.yielding_to_elastic), y);
    y = hn::IfThenElseZero(hn::Not(unloads_now), y);
    const V limit = rows(lanes.yield_mps2), range = limit + limit;
    const V top = hn::IfThenElse(hn::Gt(side, zero), x, x + range);
    rows.Set(lanes.highest, unloads_now, top);
    rows.Set(lanes.lowest, unloads_now, top - range);
    V side_now = hn::IfThenElse(yields_up, one, hn::IfThenElse(yields_down, Number(-1.0), side));
    side_now = hn::IfThenElseZero(hn::Not(unloads_now), side_now);
    rows.Set(lanes.side, side_now);
    rows.Set(lanes.unloads, decided, OrZero(unloads_now, side));
    next = next + OrZero(hn::Ne(side_now, zero), Number(3.0));
  }
  next = hn::IfThenElse(decided, next, index);
  rows.Set(lanes.regime, next);
  rows.Set(lanes.x, decided, x);
  rows.Set(lanes.y, decided, y);
  rows.Set(lanes.speed, decided, speed);

  LanesDone done{0, Bits(undecided), Bits(hn::And(started, decided))};
  const Mask ended = hn::And(decided, hn::Le(rest, zero));
  if (hn::AllFalse(d, ended)) return done;
  const I after = hn::Add(node, hn::Set(di, std::int64_t{1}));
  const V to_come = OrZero(hn::RebindMask(d, hn::Lt(node, last)), rows(lanes.intensity));
  SetReference<yields>(rows, tables, next, hn::Min(after, last), ends, to_come, ended);
  hn::Store(hn::IfThenElse(hn::RebindMask(di, ended), after, node), di, lanes.node + first);
  // The speed of a phase that has just begun is too small for a search.
  const Mask goes_on = hn::And(hn::And(ended, hn::Gt(rows(lanes.began), zero)),
                               hn::RebindMask(d, hn::Lt(after, hn::Set(di, tables.end))));
  rows.Set(lanes.began, ended, zero);
  rows.Set(lanes.left, goes_on, one);
  rows.Set(lanes.length, goes_on, one);
  done.searching = Bits(hn::AndNot(goes_on, ended));
  return done;
}

LanesDone StepLanes(CoupledLanes& lanes, const LaneTables& tables, std::uint64_t active) {
  const std::size_t n = hn::Lanes(Doubles());
  LanesDone all;
  for (std::size_t first = 0; first < CoupledLanes::count; first += n) {
    if (((active >> first) & ((std::uint64_t{1} << n) - 1)) == 0) continue;
    const LanesDone some = tables.yields ? StepVector<true>(lanes, tables, first)
                                         : StepVector<false>(lanes, tables, first);
    all.searching |= some.searching << first;
    all.undecided |= some.undecided << first;
    all.started |= some.started << first;
  }
  return {all.searching & active, all.undecided & active, all.started & active};
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(StepLanes);

std::size_t terms_for(double x) {
  constexpr double last_term = 1e-17;  // of the first: below rounding
  std::size_t terms = 0;
  for (double term = 1.0; term > last_term && terms < LaneTables::most_terms; ++terms) {
    const double n = 2.0 * static_cast<double>(terms + 1);
    term *= x * x / ((n + 1.0) * (n + 2.0));
  }
  return terms;
}

LanesDone step(CoupledLanes& lanes, const LaneTables& tables, std::uint64_t active) {
  return HWY_DYNAMIC_DISPATCH(StepLanes)(lanes, tables, active);
}

}  // namespace glissade::block_detail
#endif
