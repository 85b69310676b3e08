// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/coupled_tables/lane_step.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "block/coupled_tables/lane_curves-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

using Indices = hn::RebindToSigned<Doubles>;
using I = hn::Vec<Indices>;

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

/// What each lane of a vector is, from the rows.
struct Rows {
  CoupledLanes& lanes;
  std::size_t first;

  HWY_INLINE V operator()(const CoupledLanes::Row& row) const {
    return hn::Load(Doubles(), row + first);
  }
  HWY_INLINE void Set(CoupledLanes::Row& row, V v) const { hn::Store(v, Doubles(), row + first); }
  HWY_INLINE void Set(CoupledLanes::Row& row, Mask mask, V v) const {
    hn::BlendedStore(v, mask, Doubles(), row + first);
  }
  HWY_INLINE I Node() const { return hn::Load(Indices(), lanes.node + first); }
};

/// The responses at the lanes' nodes, each by the table of its regime.
struct LaneResponses {
  V x, y;
};
HWY_INLINE LaneResponses ResponsesAt(const LaneTables& tables, V index, I node) {
  const Doubles d;
  alignas(64) double regime[8], x[8], y[8];
  alignas(64) std::int64_t at[8];
  hn::Store(index, d, regime);
  hn::Store(node, Indices(), at);
  for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
    const LaneRegime& of_lane = *tables.regimes[static_cast<unsigned>(regime[k])];
    x[k] = of_lane.x[at[k]];
    y[k] = of_lane.y[at[k]];
  }
  return {hn::Load(d, x), hn::Load(d, y)};
}

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
  NodeValues v{};
  hn::LoadInterleaved4(d, &here[0].acceleration_mps2, v.acceleration, v.velocity, v.displacement,
                       v.displacement_low);
  return v;
}
/// At both ends of the lanes' intervals; w: of the vertical, if there is one.
struct Ends {
  NodeValues a, a_next, w, w_next;
};
HWY_INLINE Ends EndsOf(const LaneTables& tables, const std::int64_t* node) {
  Ends e{};
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

/// Where the lanes are.
struct Present {
  V x, y, speed, slip, duration_s;
};
/// Takes lanes with a new interval from their reference node to its begin.
template <bool yields>
HWY_INLINE void Begin(const Rows& rows, const LaneTables& tables, const Regimes<yields>& regimes,
                      const Regime& r, const Ends& ends, V intensity, V w_factor, Mask begins,
                      Present& now) {
  const CoupledLanes& l = rows.lanes;
  const V zero = hn::Zero(Doubles());
  const Complex free =
      Complex{rows(l.free_re), rows(l.free_im)} * Complex{rows(l.power_re), rows(l.power_im)};
  const V x = intensity * rows(l.x_table) + (free.re - r.weight * Number(tables.gravity_mps2)),
          y = intensity * rows(l.y_table) + RealOfProduct(Complex{r.sigma_re, r.sigma_im}, free);
  now.x = hn::IfThenElse(begins, x, now.x);
  now.y = hn::IfThenElse(begins, y, now.y);
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
  now.speed =
      hn::IfThenElse(slides, speed_from - (r.a_1 * roof_gain + r.w_1 * gravity_gain), now.speed);
  const V travel =
      hn::Max(speed_from * t - (r.a_1 * roof_displacement + r.w_1 * gravity_displacement), zero);
  now.slip = now.slip + OrZero(hn::And(slides, regimes.Down()), travel) -
             OrZero(hn::And(slides, regimes.Up()), travel);
  now.duration_s = now.duration_s + OrZero(slides, t);
}

/// Makes the node after an interval the reference of what follows in the regime of now.
template <bool yields>
HWY_INLINE void SetReference(const Rows& rows, const LaneTables& tables, V index, I node,
                             const Ends& ends, const Present& now, V intensity, Mask ended) {
  CoupledLanes& l = rows.lanes;
  const Regimes<yields> regimes(tables, index);
  const LaneResponses response = ResponsesAt(tables, index, node);
  const V re = (now.x + regimes.Get(&LaneRegime::weight) * Number(tables.gravity_mps2)) -
               intensity * response.x,
          rate = now.y - intensity * response.y,
          im = (regimes.Get(&LaneRegime::sigma_re) * re - rate) * regimes.Get(&LaneRegime::per_im);
  rows.Set(l.free_re, ended, re);
  rows.Set(l.free_im, ended, im);
  rows.Set(l.free_size, ended, hn::Sqrt(Square(re) + Square(im)));
  rows.Set(l.x_from, ended, now.x);
  rows.Set(l.y_from, ended, now.y);
  rows.Set(l.speed_from, ended, now.speed);
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
  Ground g{};
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

/// A vector of lanes in a step.
template <bool yields>
struct LaneVector {
  Rows rows;
  const LaneTables& tables;
  V index;  // of the regime
  Regimes<yields> regimes;
  Regime r;
  I node;
  Ends ends;
  V left, length;
  Mask slides, starts, yielding;
  V side, unloads, highest, lowest;  // of the spring
  Present now;
  Ground ground;

  HWY_INLINE LaneVector(CoupledLanes& lanes, const LaneTables& of, std::size_t first)
      : rows{lanes, first},
        tables(of),
        index(rows(lanes.regime)),
        regimes(of, index),
        r(Get(regimes)),
        node(rows.Node()),
        ends(EndsOf(of, lanes.node + first)),
        left(rows(lanes.left)),
        length(rows(lanes.length)),
        slides(hn::Or(regimes.Down(), regimes.Up())),
        starts(hn::Gt(rows(lanes.starts), hn::Zero(Doubles()))),
        yielding(regimes.Yielding()),
        now{},
        ground{} {
    side = unloads = highest = lowest = hn::Zero(Doubles());
    if constexpr (yields) {
      side = rows(lanes.side);
      unloads = rows(lanes.unloads);
      highest = rows(lanes.highest);
      lowest = rows(lanes.lowest);
    }
    now = {rows(lanes.x), rows(lanes.y), rows(lanes.speed), rows(lanes.slip),
           rows(lanes.duration_s)};
    const Mask in_record =
        hn::RebindMask(Doubles(), hn::Not(hn::Gt(node, hn::Set(Indices(), of.quiet))));
    const V intensity = OrZero(in_record, rows(lanes.intensity)),
            w_factor = OrZero(in_record, rows(lanes.w_factor));
    const Mask begins = hn::Gt(rows(lanes.begins), hn::Zero(Doubles()));
    if (!hn::AllFalse(Doubles(), begins)) {
      Begin(rows, of, regimes, r, ends, intensity, w_factor, begins, now);
      rows.Set(lanes.begins, hn::Zero(Doubles()));
    }
    ground = GroundAt(of, ends, intensity, w_factor, Number(1.0) - left);
  }

  HWY_INLINE Rising Bound(const PieceMotion& m, const RoofInstant& begin, const RoofInstant& end,
                          const Curve& drive, const Curve& minus_speed, Mask second) const;
  HWY_INLINE void BoundSpring(const PieceMotion& m, const RoofInstant& begin,
                              const RoofInstant& end, Rising& rising) const;
  HWY_INLINE LanesDone Step();
};

/// What a step has found.
struct Passed {
  Mask decided, found;  // an event
  V event, t;
  RoofInstant at;
  V speed, distance;
};

/// The curves that end a piece where they rise.
/// @param second lanes at rest whose second drive is the higher one at the piece's end
template <bool yields>
HWY_INLINE Rising LaneVector<yields>::Bound(const PieceMotion& m, const RoofInstant& begin,
                                            const RoofInstant& end, const Curve& drive,
                                            const Curve& minus_speed, Mask second) const {
  Rising rising(Select(hn::AndNot(starts, slides), minus_speed, drive), starts,
                hn::IfThenElse(second, Number(2.0), Number(1.0)), length);
  const V other_a = hn::IfThenElse(second, r.a_1, r.a_2),
          other_w = hn::IfThenElse(second, r.w_1, r.w_2);
  rising.AddBelow(other_a * begin.a + other_w * ground.gravity,
                  other_a * end.a + other_w * (ground.gravity + length * ground.gravity_rise),
                  m.Deviation(hn::Abs(other_a) * (r.sigma * r.sigma * m.size), length), slides);
  rising.bad = hn::Or(rising.bad, hn::Not(m.Stays(begin, end, length)));
  if constexpr (yields) BoundSpring(m, begin, end, rising);
  return rising;
}

/// Elastic: the force that is nearer to its limit at the end. Yielding, or just unloaded: the rate,
/// and then the other limit.
template <bool yields>
HWY_INLINE void LaneVector<yields>::BoundSpring(const PieceMotion& m, const RoofInstant& begin,
                                                const RoofInstant& end, Rising& rising) const {
  const V zero = hn::Zero(Doubles()), one = Number(1.0), minus_one = Number(-1.0);
  const Mask unloaded = hn::Ne(unloads, zero), rate = hn::Or(yielding, unloaded),
             lower = hn::Gt(lowest - end.x, end.x - highest);
  const V outward = hn::IfThenElse(lower, minus_one, one),
          limit = hn::IfThenElse(lower, lowest, hn::Neg(highest));
  rising.Add(m.Spring(OrZero(hn::Not(rate), outward), OrZero(rate, unloads - side),
                      OrZero(hn::Not(rate), limit), begin, end, length),
             unloaded, hn::IfThenElse(lower, Number(4.0), Number(3.0)));
  const Mask above = hn::Or(hn::Lt(unloads, zero), hn::AndNot(unloaded, lower));
  const V back = hn::IfThenElse(above, one, minus_one),
          other = hn::IfThenElse(above, hn::Neg(highest), lowest);
  rising.AddBelow(back * m.x + other, back * end.x + other, m.Deviation(m.size, length), yielding);
}

/// To the first event, or the piece's end.
template <bool yields>
HWY_INLINE Passed PassPiece(const LaneVector<yields>& l, const PieceMotion& m, const Growth& to_end,
                            const Curve& minus_speed, const Rising& rising) {
  const V zero = hn::Zero(Doubles()), dt = Number(l.tables.step_s);
  const Mask closes = hn::Eq(l.left, zero);  // of no length: only what is at its end
  Passed p{hn::Or(hn::Not(rising.bad), closes), closes, rising.event, l.length, {}, zero, zero};
  p.found = hn::AndNot(closes, hn::And(p.decided, rising.one));
  Growth growth = to_end;
  if (!hn::AllFalse(Doubles(), p.found)) {
    const Mask wanted = p.found;
    Root(l.tables, l.r, rising.curve, l.length, p.found, p.t, growth);
    p.decided = hn::AndNot(hn::AndNot(p.found, wanted), p.decided);
  }
  p.at = m.At(p.t, growth.power);
  const V t = p.t;
  const V lost_speed = (minus_speed.c_1 + minus_speed.c_2 * t) * t +
                       RealOfProduct(minus_speed.b, growth.minus_one),
          lost = (dt * (t * t)) *
                     (Number(0.5) * minus_speed.c_1 + Number(1.0 / 3.0) * (minus_speed.c_2 * t)) +
                 (l.r.a_1 * l.r.per_omega2) * RealOfProduct(m.z, growth.minus_line);
  p.speed = OrZero(l.slides, m.speed - lost_speed);
  p.distance = OrZero(l.slides, (m.speed * dt) * t - lost);
  // A phase that begins goes on.
  const Mask fails = hn::And(l.starts, hn::Or(hn::Le(p.speed, zero), hn::Lt(p.distance, zero)));
  p.decided = hn::Or(closes, hn::AndNot(fails, p.decided));
  return p;
}

/// What happens where the spring's curves rise: forces do not jump, only their rates.
/// @return the side on which it yields then
template <bool yields>
HWY_INLINE V Yield(const LaneVector<yields>& l, V event, Passed& p) {
  CoupledLanes& lanes = l.rows.lanes;
  const V zero = hn::Zero(Doubles());
  const Mask rises = hn::Ge(event, Number(3.0)), lower = hn::Eq(event, Number(4.0)),
             unloads = hn::And(rises, l.yielding), down = hn::AndNot(l.yielding, lower),
             up = hn::AndNot(hn::Or(l.yielding, lower), rises);
  p.at.x = hn::IfThenElse(up, l.highest, hn::IfThenElse(down, l.lowest, p.at.x));
  p.at.y = hn::IfThenElse(hn::Or(up, down), p.at.y * Number(l.tables.yielding_to_elastic), p.at.y);
  p.at.y = OrZero(hn::Not(unloads), p.at.y);
  const V limit = l.rows(lanes.yield_mps2), range = limit + limit,
          top = hn::IfThenElse(hn::Gt(l.side, zero), p.at.x, p.at.x + range);
  l.rows.Set(lanes.highest, unloads, top);
  l.rows.Set(lanes.lowest, unloads, top - range);
  l.rows.Set(lanes.unloads, p.decided, OrZero(unloads, l.side));
  V side = hn::IfThenElse(up, Number(1.0), hn::IfThenElse(down, Number(-1.0), l.side));
  side = OrZero(hn::Not(unloads), side);
  l.rows.Set(lanes.side, side);
  return side;
}

/// Where it stopped: the other direction's drive at rest is positive. Never that of the one it
/// stopped in.
template <bool yields>
HWY_INLINE Mask Reverses(const LaneVector<yields>& l, const Passed& p) {
  const LaneRegime& stuck = *l.tables.regimes[0];
  const V a = hn::Neg(p.at.x + (l.r.lag * l.r.angle) * p.at.y) * Number(1.0 / stuck.mass),
          gravity = l.ground.gravity + p.t * l.ground.gravity_rise;
  const Mask down = l.regimes.Down();
  return hn::Gt(hn::IfThenElse(down, Number(stuck.a_2), Number(stuck.a_1)) * a +
                    hn::IfThenElse(down, Number(stuck.w_2), Number(stuck.w_1)) * gravity,
                hn::Zero(Doubles()));
}

/// Takes the record and the regime through what a piece has found.
/// @return the lanes in which a phase starts
template <bool yields>
HWY_INLINE Mask Happen(LaneVector<yields>& l, Passed& p) {
  CoupledLanes& lanes = l.rows.lanes;
  const V zero = hn::Zero(Doubles()), one = Number(1.0);
  const V event = OrZero(p.found, p.event);
  const V direction = OrZero(l.regimes.Down(), one) - OrZero(l.regimes.Up(), one);
  const V slip = l.now.slip + direction * hn::Max(OrZero(p.decided, p.distance), zero);
  l.rows.Set(lanes.slip, slip);
  l.rows.Set(lanes.duration_s, l.now.duration_s + OrZero(hn::And(p.decided, l.slides),
                                                         p.t * Number(l.tables.step_s)));
  const Mask rises = hn::Eq(event, one), up = hn::Eq(event, Number(2.0)),
             stops = hn::And(rises, l.slides), down = hn::AndNot(l.slides, rises),
             reverses = hn::And(stops, Reverses(l, p)), starts = hn::Or(hn::Or(down, up), reverses);
  p.speed = OrZero(hn::Not(stops), p.speed);
  l.rows.Set(lanes.farthest_down, stops, hn::Max(l.rows(lanes.farthest_down), slip));
  l.rows.Set(lanes.farthest_up, stops, hn::Min(l.rows(lanes.farthest_up), slip));
  l.rows.Set(lanes.phases, starts, l.rows(lanes.phases) + one);
  const V jumps = l.tables.static_friction ? Number(2.0) : one;
  l.rows.Set(lanes.starts, p.decided, OrZero(starts, hn::IfThenElse(reverses, Number(2.0), jumps)));
  l.rows.Set(lanes.stopped, p.decided, OrZero(hn::AndNot(reverses, stops), direction));
  V heading = hn::IfThenElse(down, one, hn::IfThenElse(up, Number(-1.0), direction));
  heading = hn::IfThenElse(stops, OrZero(reverses, hn::Neg(direction)), heading);
  V next = hn::IfThenElse(hn::Lt(heading, zero), Number(2.0), heading);
  if constexpr (yields) next = next + OrZero(hn::Ne(Yield(l, event, p), zero), Number(3.0));
  l.index = hn::IfThenElse(p.decided, next, l.index);
  l.now.x = hn::IfThenElse(p.decided, p.at.x, l.now.x);
  l.now.y = hn::IfThenElse(p.decided, p.at.y, l.now.y);
  l.now.speed = hn::IfThenElse(p.decided, p.speed, l.now.speed);
  l.rows.Set(lanes.regime, l.index);
  l.rows.Set(lanes.x, l.now.x);
  l.rows.Set(lanes.y, l.now.y);
  l.rows.Set(lanes.speed, l.now.speed);
  return starts;
}

/// The next interval at once where an event may follow there, else from a new reference node.
/// @return the lanes that are searched from there
template <bool yields>
HWY_INLINE Mask EndInterval(const LaneVector<yields>& l, Mask ended, Mask soon) {
  const Doubles d;
  const Indices di;
  CoupledLanes& lanes = l.rows.lanes;
  const I last = hn::Set(di, l.tables.quiet), after = hn::Add(l.node, hn::Set(di, std::int64_t{1}));
  const V intensity = OrZero(hn::RebindMask(d, hn::Lt(l.node, last)), l.rows(lanes.intensity));
  SetReference<yields>(l.rows, l.tables, l.index, hn::Min(after, last), l.ends, l.now, intensity,
                       ended);
  hn::Store(hn::IfThenElse(hn::RebindMask(di, ended), after, l.node), di,
            lanes.node + l.rows.first);
  const Mask goes_on =
      hn::And(hn::And(ended, soon), hn::RebindMask(d, hn::Lt(after, hn::Set(di, l.tables.end))));
  l.rows.Set(lanes.left, goes_on, Number(1.0));
  l.rows.Set(lanes.length, goes_on, Number(1.0));
  return hn::AndNot(goes_on, ended);
}

template <bool yields>
HWY_INLINE LanesDone LaneVector<yields>::Step() {
  const V half = Number(0.5) * length;
  const PieceMotion m(tables, r, ground, now.x, now.y, now.speed);
  const Growth to_end = GrowthAfter(tables, r, length);
  const RoofInstant begin = m.Begin(), end = m.At(length, to_end.power);
  const V gravity_end = ground.gravity + length * ground.gravity_rise;
  const Mask second = hn::AndNot(
      slides, hn::Gt(r.a_2 * end.a + r.w_2 * gravity_end, r.a_1 * end.a + r.w_1 * gravity_end));
  const Curve drive = m.Drive(hn::IfThenElse(second, r.a_2, r.a_1),
                              hn::IfThenElse(second, r.w_2, r.w_1), begin, end, length),
              minus_speed = m.MinusSpeed(drive, to_end, length);
  const Rising rising = Bound(m, begin, end, drive, minus_speed, second);
  Passed p = PassPiece(*this, m, to_end, minus_speed, rising);
  // Without tables of the yielding spring all that it does is left to the scalar scheme.
  Mask too_short = hn::Lt(half, Number(shortest_piece));
  if (yields && !tables.has_yielding) {
    const Mask beyond = hn::And(p.found, hn::Gt(p.event, Number(2.0)));
    p.decided = hn::AndNot(beyond, p.decided);
    too_short = hn::Or(too_short, beyond);
  }
  p.found = hn::And(p.found, p.decided);
  const V rest = left - p.t;
  rows.Set(rows.lanes.left, p.decided, rest);
  rows.Set(rows.lanes.length, hn::IfThenElse(p.decided, rest, half));
  const Mask starts_now = Happen(*this, p);
  LanesDone done{0, Bits(hn::AndNot(p.decided, too_short)), Bits(starts_now)};
  const Mask ended = hn::And(p.decided, hn::Le(rest, hn::Zero(Doubles())));
  if (!hn::AllFalse(Doubles(), ended))
    done.searching = Bits(EndInterval(*this, ended, rising.soon));
  return done;
}

LanesDone StepLanes(CoupledLanes& lanes, const LaneTables& tables, std::uint64_t active) {
  const std::size_t n = hn::Lanes(Doubles());
  LanesDone all;
  for (std::size_t first = 0; first < CoupledLanes::count; first += n) {
    if (((active >> first) & ((std::uint64_t{1} << n) - 1)) == 0) continue;
    const LanesDone some = tables.yields ? LaneVector<true>(lanes, tables, first).Step()
                                         : LaneVector<false>(lanes, tables, first).Step();
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
  for (double term = 1.0; (term > last_term || terms % 2 != 0) && terms < LaneTables::most_terms;
       ++terms) {
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
