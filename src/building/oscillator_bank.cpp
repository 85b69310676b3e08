// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation is elementwise and
// unfused, so all targets give the same bits.
#include "oscillator_bank.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "building/oscillator_bank.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "core/oscillator_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::building_detail::HWY_NAMESPACE {

namespace lanes = oscillator_lanes::HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;
using lanes::Doubles, lanes::Vector;

/// Some of a bank's oscillators, in registers.
struct BankLanes {
  std::size_t first;
  lanes::StepOfLanes after;
  lanes::StateOfLanes state;

  HWY_INLINE BankLanes(const OscillatorBank& bank, std::size_t first_oscillator)
      : first(first_oscillator),
        after(bank.steps, first),
        state{lanes::Load(bank.x, first), lanes::Load(bank.y, first)} {}

  HWY_INLINE void Step(Vector a0, Vector a1, double* x, double* y) {
    state = after.After(state, a0, a1);
    hn::Store(state.x, Doubles(), x + first);
    hn::Store(state.y, Doubles(), y + first);
  }
  HWY_INLINE void Store(OscillatorBank& bank) const {
    lanes::Store(state.x, bank.x, first);
    lanes::Store(state.y, bank.y, first);
  }
};

void Advance(OscillatorBank& bank, const double* ground, std::size_t from, std::size_t to,
             double* const* x, double* const* y) {
  constexpr std::size_t stretch = 64;
  // As the lanes leave them.
  alignas(64) double xs[stretch][OscillatorBank::size], ys[stretch][OscillatorBank::size];
  const Doubles d;
  const std::size_t n = hn::Lanes(d);
  for (std::size_t begin = from; begin < to; begin += stretch) {
    const std::size_t count = to - begin < stretch ? to - begin : stretch;
    for (std::size_t first = 0; first < OscillatorBank::size; first += 2 * n) {
      BankLanes one(bank, first), other(bank, first + n);  // two, to hide each other's latency
      for (std::size_t t = 0; t < count; ++t) {
        const Vector a0 = hn::Set(d, ground[begin + t]), a1 = hn::Set(d, ground[begin + t + 1]);
        one.Step(a0, a1, xs[t], ys[t]);
        other.Step(a0, a1, xs[t], ys[t]);
      }
      one.Store(bank);
      other.Store(bank);
    }
    for (std::size_t oscillator = 0; oscillator < OscillatorBank::size; ++oscillator) {
      if (x[oscillator] == nullptr) continue;
      double* const x_out = x[oscillator] + begin + 1;
      double* const y_out = y[oscillator] + begin + 1;
      for (std::size_t t = 0; t < count; ++t) {
        x_out[t] = xs[t][oscillator];
        y_out[t] = ys[t][oscillator];
      }
    }
  }
}

/// Acceleration bounds are those of the quartic's Bernstein coefficients: it stays in their hull.
/// In an interval where a ranges over r, V leaves its chord by r h / 4 at most.
template <bool several>
ResponsePeaks BoundOf(const Response& r, float* lowest, float* highest, float* below, float* above,
                      double* excess) {
  const Doubles d;
  const hn::Rebind<float, Doubles> f;
  const std::size_t n = hn::Lanes(d), intervals = r.nodes - 1;
  const Vector twice = hn::Set(d, 2.0 * r.damping_ratio), omega = hn::Set(d, r.omega_radps);
  const Vector per_omega = hn::Set(d, 1.0 / r.omega_radps);
  const Vector quarter_step = hn::Set(d, 0.25 * r.step_s), quarter = hn::Set(d, 0.25),
               half = hn::Set(d, 0.5);
  const Vector five_per_step = hn::Set(d, 5.0 / r.step_s);
  const Vector a_scale = hn::Set(d, r.acceleration_scale), v_scale = hn::Set(d, r.velocity_scale);
  // Rounding to single precision moves a number by 2^-24 of it; these move it back past where it
  // was.
  const auto slack = hn::Set(f, 0x1p-22f), least = hn::Set(f, 0x1p-100f);
  const auto widen = [&](auto value) { return hn::Add(hn::Mul(hn::Abs(value), slack), least); };
  Vector largest_a = hn::Zero(d), largest_v = hn::Zero(d);

  const Vector share = hn::Set(d, r.ground_share), moving = hn::Set(d, 1.0 - r.ground_share);
  struct Node {
    Vector a, jerk, v;  // several: but for what moves with the ground
    Vector ground;      // that; one mass: not read
    Vector velocity;    // of the roof
  };
  const auto node = [&](std::size_t i) {
    if constexpr (several) {
      const Vector v = hn::LoadU(d, r.y + i), ground_v = hn::LoadU(d, r.ground_mps + i);
      return Node{hn::LoadU(d, r.a + i), hn::LoadU(d, r.jerk + i),
                  hn::Add(hn::Mul(moving, ground_v), v),
                  hn::Mul(share, hn::LoadU(d, r.ground_mps2 + i)), hn::Add(ground_v, v)};
    }
    const Vector x = hn::LoadU(d, r.x + i), y = hn::LoadU(d, r.y + i);
    const Vector resisting = hn::Add(x, hn::Mul(twice, y));
    const Vector ground = hn::LoadU(d, r.ground_mps2 + i);
    const Vector jerk = hn::Mul(omega, hn::Sub(hn::Mul(twice, hn::Add(resisting, ground)), y));
    const Vector v = hn::Add(hn::LoadU(d, r.ground_mps + i), hn::Mul(y, per_omega));
    return Node{hn::Neg(resisting), jerk, v, v, v};
  };
  // The last vector starts early enough to end with the last interval.
  for (std::size_t i = 0; i < intervals; i += n) {
    if (i + n > intervals) i = intervals > n ? intervals - n : 0;
    Node p = node(i), q = node(i + 1);
    Vector b1 = hn::Add(p.a, hn::Mul(quarter_step, p.jerk));
    Vector b3 = hn::Sub(q.a, hn::Mul(quarter_step, q.jerk));
    Vector b2 = hn::Sub(hn::Mul(five_per_step, hn::Sub(q.v, p.v)),
                        hn::Add(hn::Add(p.a, q.a), hn::Add(b1, b3)));
    if constexpr (several) {  // a line, in Bernstein form
      const Vector rise = hn::Mul(quarter, hn::Sub(q.ground, p.ground));
      b1 = hn::Add(b1, hn::Add(p.ground, rise));
      b2 = hn::Add(b2, hn::Mul(half, hn::Add(p.ground, q.ground)));
      b3 = hn::Add(b3, hn::Sub(q.ground, rise));
      p.a = hn::Add(p.a, p.ground);
      q.a = hn::Add(q.a, q.ground);
    }
    const Vector low = hn::Min(hn::Min(p.a, q.a), hn::Min(b1, hn::Min(b2, b3)));
    const Vector high = hn::Max(hn::Max(p.a, q.a), hn::Max(b1, hn::Max(b2, b3)));
    largest_a = hn::Max(largest_a, hn::Max(high, hn::Neg(low)));
    largest_v = hn::Max(largest_v, hn::Max(hn::Abs(p.velocity), hn::Abs(q.velocity)));
    const auto low_f = hn::DemoteTo(f, hn::Mul(low, a_scale));
    const auto high_f = hn::DemoteTo(f, hn::Mul(high, a_scale));
    hn::StoreU(hn::Sub(low_f, widen(low_f)), f, lowest + i);
    hn::StoreU(hn::Add(high_f, widen(high_f)), f, highest + i);
    hn::StoreU(hn::Mul(hn::Mul(hn::Sub(high, low), quarter), hn::Set(d, r.step_s)), d,
               excess + 1 + i);
  }
  // excess[i] and excess[i + 1] are those of the intervals before and after node i.
  for (std::size_t i = 0; i < r.nodes; i += n) {
    if (i + n > r.nodes) i = r.nodes > n ? r.nodes - n : 0;
    const Vector v =
        hn::Add(hn::LoadU(d, r.ground_mps + i), hn::Mul(hn::LoadU(d, r.y + i), per_omega));
    const Vector departure = hn::Max(hn::LoadU(d, excess + i), hn::LoadU(d, excess + 1 + i));
    const auto below_f = hn::DemoteTo(f, hn::Mul(hn::Sub(v, departure), v_scale));
    const auto above_f = hn::DemoteTo(f, hn::Mul(hn::Add(v, departure), v_scale));
    hn::StoreU(hn::Sub(below_f, widen(below_f)), f, below + i);
    hn::StoreU(hn::Add(above_f, widen(above_f)), f, above + i);
  }
  return {hn::GetLane(hn::MaxOfLanes(d, largest_a)), hn::GetLane(hn::MaxOfLanes(d, largest_v))};
}

ResponsePeaks Bound(const Response& r, float* lowest, float* highest, float* below, float* above,
                    double* excess) {
  return r.a != nullptr ? BoundOf<true>(r, lowest, highest, below, above, excess)
                        : BoundOf<false>(r, lowest, highest, below, above, excess);
}

/// Extremes of the bounds by tile.
void Coarsen(const float* lowest, const float* highest, std::size_t tiles, float* tile_lowest,
             float* tile_highest) {
  const HWY_CAPPED(float, 16) f;
  const std::size_t n = hn::Lanes(f);
  for (std::size_t b = 0; b < tiles; ++b) {
    const std::size_t begin = b * MotionBounds::tile, end = begin + MotionBounds::tile;
    auto low = hn::LoadU(f, lowest + begin), high = hn::LoadU(f, highest + begin);
    for (std::size_t i = begin + n; i < end; i += n) {
      low = hn::Min(low, hn::LoadU(f, lowest + i));
      high = hn::Max(high, hn::LoadU(f, highest + i));
    }
    tile_lowest[b] = hn::GetLane(hn::MinOfLanes(f, low));
    tile_highest[b] = hn::GetLane(hn::MaxOfLanes(f, high));
  }
}

/// Largest less smallest of ground velocity + y / omega and zero.
double VelocityRange(const double* ground_mps, const double* y, double per_omega_s,
                     std::size_t count) {
  const Doubles d;
  const std::size_t n = hn::Lanes(d);
  const Vector per_omega = hn::Set(d, per_omega_s);
  Vector least = hn::Zero(d), most = hn::Zero(d);
  const auto look = [&](std::size_t i) {
    const Vector v = hn::Add(hn::LoadU(d, ground_mps + i), hn::Mul(hn::LoadU(d, y + i), per_omega));
    least = hn::Min(least, v);
    most = hn::Max(most, v);
  };
  std::size_t i = 0;
  for (; i + n <= count; i += n) look(i);
  double low = hn::GetLane(hn::MinOfLanes(d, least)), high = hn::GetLane(hn::MaxOfLanes(d, most));
  for (; i < count; ++i) {
    const double v = ground_mps[i] + y[i] * per_omega_s;
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  return high - low;
}

}  // namespace glissade::building_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

#include "glissade/core/scale.hpp"

namespace glissade::building_detail {
HWY_EXPORT(Advance);
HWY_EXPORT(Bound);
HWY_EXPORT(Coarsen);
HWY_EXPORT(VelocityRange);

namespace {

void size_bounds(MotionTable& table) {
  MotionBounds& b = table.bounds;
  const std::size_t room = table.nodes + MotionBounds::tile + padding;
  for (std::vector<float>* v : {&b.lowest, &b.highest, &b.velocity_below, &b.velocity_above})
    v->resize(room);
  b.acceleration_scale = scale_to_one(table.ground->peak_acceleration_mps2());
  b.velocity_scale = b.acceleration_scale * scale_to_one(table.step_s());
}

void coarsen(MotionTable& table) {
  MotionBounds& b = table.bounds;
  const std::size_t intervals = table.nodes - 1;
  const std::size_t tiles = (intervals + MotionBounds::tile - 1) / MotionBounds::tile;
  b.tile_lowest.assign(tiles + padding, 0.0f);
  b.tile_highest.assign(tiles + padding, 0.0f);
  // Beyond the last interval the last tile sees zeros, which only widen its bounds.
  std::fill(b.lowest.begin() + static_cast<std::ptrdiff_t>(intervals), b.lowest.end(), 0.0f);
  std::fill(b.highest.begin() + static_cast<std::ptrdiff_t>(intervals), b.highest.end(), 0.0f);
  HWY_DYNAMIC_DISPATCH(Coarsen)
  (b.lowest.data(), b.highest.data(), tiles, b.tile_lowest.data(), b.tile_highest.data());
}

float below(double value) {
  const auto f = static_cast<float>(value);
  return f - (std::abs(f) * 0x1p-22f + 0x1p-100f);
}
float above(double value) { return -below(-value); }

}  // namespace

void advance(OscillatorBank& bank, std::span<const double> ground_mps2, std::size_t from,
             std::size_t to, double* const* x, double* const* y) {
  HWY_DYNAMIC_DISPATCH(Advance)(bank, ground_mps2.data(), from, to, x, y);
}

double velocity_range_mps(const MotionTable& table, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(VelocityRange)(table.ground->velocity_mps().data(), table.y.data(),
                                             1.0 / table.omega_radps, end + 1);
}

void bound_response(MotionTable& table) {
  size_bounds(table);
  MotionBounds& b = table.bounds;
  // Room for whole vectors, whatever the target's width.
  thread_local std::vector<double> excess;
  excess.assign(table.nodes + 2 + padding, 0.0);
  const bool several = !table.is_one_mass();
  const auto found = HWY_DYNAMIC_DISPATCH(Bound)(
      {table.x.data(), table.y.data(), table.ground->acceleration_mps2().data(),
       table.ground->velocity_mps().data(), table.omega_radps, table.building[0].damping_ratio,
       table.step_s(), b.acceleration_scale, b.velocity_scale, table.nodes,
       several ? table.modes.a.data() : nullptr, several ? table.modes.jerk.data() : nullptr,
       several ? table.building.ground_share() : 0.0},
      b.lowest.data(), b.highest.data(), b.velocity_below.data(), b.velocity_above.data(),
      excess.data());
  table.acceleration_bound_mps2 = found.peak_acceleration;
  b.largest_velocity_mps = found.largest_velocity;
  coarsen(table);
}

void bound_ground(MotionTable& table) {
  size_bounds(table);
  MotionBounds& b = table.bounds;
  const std::span<const double> a = table.ground->acceleration_mps2(),
                                v = table.ground->velocity_mps();
  const std::size_t intervals = table.nodes - 1;
  table.acceleration_bound_mps2 = b.largest_velocity_mps = 0.0;
  // Where a falls by r over an interval, V rises above its chord by r h / 8 at most; where it
  // rises, V is below it.
  const auto excess = [&](std::size_t i) { return (a[i + 1] - a[i]) * table.step_s() / 8.0; };
  for (std::size_t i = 0; i < table.nodes; ++i) {
    table.acceleration_bound_mps2 = std::max(table.acceleration_bound_mps2, std::abs(a[i]));
    b.largest_velocity_mps = std::max(b.largest_velocity_mps, std::abs(v[i]));
    const double before = i > 0 ? excess(i - 1) : 0.0, after = i < intervals ? excess(i) : 0.0;
    b.velocity_below[i] = below((v[i] - std::max({before, after, 0.0})) * b.velocity_scale);
    b.velocity_above[i] = above((v[i] - std::min({before, after, 0.0})) * b.velocity_scale);
    if (i == intervals) break;
    b.lowest[i] = below(std::min(a[i], a[i + 1]) * b.acceleration_scale);
    b.highest[i] = above(std::max(a[i], a[i + 1]) * b.acceleration_scale);
  }
  coarsen(table);
}

}  // namespace glissade::building_detail
#endif
