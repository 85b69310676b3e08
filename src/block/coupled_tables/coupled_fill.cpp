// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_fill.hpp"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/coupled_tables/coupled_fill.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, 8);
using Floats = hn::Rebind<float, Doubles>;
using Vector = hn::Vec<Doubles>;
constexpr std::size_t tile = 64;

Vector Times(double factor, Vector v) { return hn::Mul(hn::Set(Doubles(), factor), v); }
double Largest(Vector v) { return hn::GetLane(hn::MaxOfLanes(Doubles(), v)); }

/// The oscillators side by side, since each waits for its own last step. They run ahead of what is
/// made of their states by a few nodes only, so that it is done while they wait.
class Responses {
 public:
  using Side = HWY_CAPPED(double, 4);
  static constexpr std::size_t width = hn::MaxLanes(Side()), vectors = 4 / width;
  static constexpr std::size_t count = hn::MaxLanes(Doubles()), kept = 2 * count;
  alignas(64) double x[kept][4], y[kept][4];  ///< of node i in row i % kept, the last nodes

  explicit Responses(const TableFill& fill) : fill_(fill) {
    alignas(64) double rows[10][4] = {};
    for (std::size_t k = 0; k < 3; ++k) {
      const ResponseFill::Step& s = fill.responses[k].step;
      const double of[10] = {s.xx,    s.xy,      s.yx,    s.yy,    s.x_start,
                             s.x_end, s.y_start, s.y_end, s.per_a, s.per_w};
      for (std::size_t row = 0; row < 10; ++row) rows[row][k] = of[row];
    }
    const Side d;
    for (std::size_t v = 0; v < vectors; ++v) {
      for (std::size_t row = 0; row < 10; ++row) c_[v][row] = hn::Load(d, rows[row] + v * width);
      x_[v] = y_[v] = hn::Zero(d);
      forcing_[v] = Forcing(v, 0);
    }
  }

  void Fill(std::size_t first) {
    for (std::size_t v = 0; v < vectors; ++v) Fill(v, first);
  }

 private:
  using V = hn::Vec<Side>;
  V Forcing(std::size_t v, std::size_t i) const {
    const V a = hn::Mul(c_[v][8], hn::Set(Side(), fill_.ground[i].acceleration_mps2));
    if (fill_.vertical == nullptr) return a;
    return hn::Add(a, hn::Mul(c_[v][9], hn::Set(Side(), fill_.vertical[i].acceleration_mps2)));
  }
  void Fill(std::size_t v, std::size_t first) {
    const Side d;
    const V xx = c_[v][0], xy = c_[v][1], yx = c_[v][2], yy = c_[v][3], x_start = c_[v][4],
            x_end = c_[v][5], y_start = c_[v][6], y_end = c_[v][7];
    V x_now = x_[v], y_now = y_[v], p = forcing_[v];
    for (std::size_t j = 0; j < count; ++j) {
      const V next = Forcing(v, first + j);
      if (first + j > 0) {
        const V before = x_now;
        x_now = hn::Sub(hn::Add(hn::Mul(xx, x_now), hn::Mul(xy, y_now)),
                        hn::Add(hn::Mul(x_start, p), hn::Mul(x_end, next)));
        y_now = hn::Sub(hn::Sub(hn::Mul(yy, y_now), hn::Mul(yx, before)),
                        hn::Add(hn::Mul(y_start, p), hn::Mul(y_end, next)));
      }
      p = next;
      hn::Store(x_now, d, x[first % kept + j] + v * width);
      hn::Store(y_now, d, y[first % kept + j] + v * width);
    }
    x_[v] = x_now;
    y_[v] = y_now;
    forcing_[v] = p;
  }

  const TableFill& fill_;
  V c_[vectors][10], x_[vectors], y_[vectors], forcing_[vectors];
};

/// One component of the ground at some nodes, and the change of its acceleration to the next ones.
struct ComponentLanes {
  Vector acceleration, velocity, rise;
  explicit ComponentLanes(const GroundNode* nodes) {
    const Doubles d;
    Vector next, unused;
    hn::LoadInterleaved4(d, &nodes[1].acceleration_mps2, next, unused, unused, unused);
    hn::LoadInterleaved4(d, &nodes[0].acceleration_mps2, acceleration, velocity, unused, unused);
    rise = hn::Sub(next, acceleration);
  }
};
/// The ground at some nodes.
struct GroundLanes {
  ComponentLanes a, w;
  bool vertical;
  GroundLanes(const TableFill& f, std::size_t i)
      : a(f.ground + i),
        w(f.vertical != nullptr ? ComponentLanes(f.vertical + i) : a),
        vertical(f.vertical != nullptr) {}
  Vector Sum(double a_factor, double w_factor, Vector ComponentLanes::*of) const {
    return vertical ? hn::Add(Times(a_factor, a.*of), Times(w_factor, w.*of))
                    : Times(a_factor, a.*of);
  }
  Vector Line(double a_factor, double w_factor) const {
    return Sum(a_factor, w_factor, &ComponentLanes::acceleration);
  }
  Vector Rise(double a_factor, double w_factor) const {
    return Sum(a_factor, w_factor, &ComponentLanes::rise);
  }
};

/// The largest of a tile's values and of the one before.
struct TileMaximum {
  Vector largest, last;
  double before = 0.0;
  TileMaximum() : largest(hn::Zero(Doubles())), last(largest) {}
  void Begin() { largest = hn::Zero(Doubles()); }
  void Add(Vector v) {
    last = v;
    largest = hn::Max(largest, v);
  }
  double End() {
    const double here = Largest(largest), most = here > before ? here : before;
    before = hn::ExtractLane(last, hn::Lanes(Doubles()) - 1);
    return most;
  }
};
float Rounded(double most) { return static_cast<float>(most * (1.0 + 0x1p-20)); }

struct ResponseMaxima {
  TileMaximum amplitude, resisting, x_size;
  ResponseMaxima() { Begin(); }
  void Begin() {
    amplitude.Begin();
    resisting.Begin();
    x_size.Begin();
  }
  void Add(const ResponseFill& f, double twice_zeta, const GroundLanes& ground, Vector x,
           Vector y) {
    const Vector p = ground.Line(f.step.per_a, f.step.per_w),
                 rise = ground.Rise(f.step.per_a, f.step.per_w);
    const Vector re = hn::Sub(hn::Add(x, p), Times(f.lag, rise)),
                 rate = hn::Add(y, Times(f.per_step, rise)),
                 im = hn::Add(Times(f.c_x, re), Times(f.c_y, rate));
    amplitude.Add(hn::Add(hn::Mul(re, re), hn::Mul(im, im)));
    resisting.Add(hn::Abs(hn::Add(x, Times(twice_zeta, y))));
    x_size.Add(hn::Abs(x));
  }
  void End(const ResponseFill& f, std::size_t b) {
    f.amplitude[b] = Rounded(f.per_mass * std::sqrt(amplitude.End()));
    f.resisting[b] = Rounded(resisting.End());
    f.x_size[b] = Rounded(x_size.End());
  }
};

struct LineExtremes {
  hn::Vec<Floats> lowest, highest;
  TileMaximum change;
  LineExtremes() { Begin(); }
  void Begin() {
    lowest = hn::Set(Floats(), HUGE_VALF);
    highest = hn::Neg(lowest);
    change.Begin();
  }
  void Add(const LineFill& f, std::size_t i, Vector value) {
    const auto v = hn::DemoteTo(Floats(), value);
    hn::StoreU(v, Floats(), f.values + i);
    lowest = hn::Min(lowest, v);
    highest = hn::Max(highest, v);
  }
  void End(const LineFill& f, std::size_t b) const {
    f.tile_lowest[b] = hn::GetLane(hn::MinOfLanes(Floats(), lowest));
    f.tile_highest[b] = hn::GetLane(hn::MaxOfLanes(Floats(), highest));
  }
};

Vector OfRoof(const LineFill& f, Vector x, Vector y) {
  return hn::Add(Times(f.x_factor, x), Times(f.y_factor, y));
}

void FillTables(const TableFill& fill) {
  const Doubles d;
  Responses responses(fill);
  responses.Fill(0);
  ResponseMaxima maxima[3];
  LineExtremes rest[2], speeds[2];
  for (std::size_t b = 0; b * tile < fill.nodes; ++b) {
    for (ResponseMaxima& m : maxima) m.Begin();
    for (LineExtremes& e : rest) e.Begin();
    for (LineExtremes& e : speeds) e.Begin();
    for (std::size_t j = 0; j < tile; j += hn::Lanes(d)) {
      const std::size_t i = b * tile + j;
      responses.Fill(i + Responses::count);
      Vector x[4], y[4];
      hn::LoadInterleaved4(d, responses.x[i % Responses::kept], x[0], x[1], x[2], x[3]);
      hn::LoadInterleaved4(d, responses.y[i % Responses::kept], y[0], y[1], y[2], y[3]);
      const GroundLanes ground(fill, i);
      for (std::size_t k = 0; k < 3; ++k) {
        const ResponseFill& f = fill.responses[k];
        if (f.x == nullptr) continue;
        hn::StoreU(x[k], d, f.x + i);
        hn::StoreU(y[k], d, f.y + i);
        maxima[k].Add(f, fill.twice_zeta, ground, x[k], y[k]);
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const LineFill& f = fill.rest[k];
        if (f.values == nullptr) continue;
        Vector value = OfRoof(f, x[0], y[0]);
        if (ground.vertical) value = hn::Add(value, Times(f.w_factor, ground.w.acceleration));
        rest[k].Add(f, i, value);
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const LineFill& f = fill.speeds[k];
        if (f.values == nullptr) continue;
        Vector value = hn::Add(OfRoof(f, x[1 + k], y[1 + k]), Times(f.a_factor, ground.a.velocity));
        if (ground.vertical) value = hn::Add(value, Times(f.w_factor, ground.w.velocity));
        speeds[k].Add(f, i, value);
        speeds[k].change.Add(hn::Abs(ground.Rise(f.a_factor, f.w_factor)));
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (fill.responses[k].x != nullptr) maxima[k].End(fill.responses[k], b);
    for (std::size_t k = 0; k < 2; ++k)
      if (fill.rest[k].values != nullptr) rest[k].End(fill.rest[k], b);
    for (std::size_t k = 0; k < 2; ++k) {
      if (fill.speeds[k].values == nullptr) continue;
      speeds[k].End(fill.speeds[k], b);
      fill.speeds[k].tile_change[b] = Rounded(speeds[k].change.End());
    }
  }
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(FillTables);

void fill_tables(const TableFill& fill) { HWY_DYNAMIC_DISPATCH(FillTables)(fill); }

}  // namespace glissade::block_detail
#endif
