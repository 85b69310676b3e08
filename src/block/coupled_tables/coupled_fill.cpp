// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_fill.hpp"

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

Vector At(const GroundLine& g, std::size_t i) {
  const Doubles d;
  const Vector a = Times(g.a_factor, hn::LoadU(d, g.a + i));
  return g.w == nullptr ? a : hn::Add(a, Times(g.w_factor, hn::LoadU(d, g.w + i)));
}

double Largest(Vector v) { return hn::GetLane(hn::MaxOfLanes(Doubles(), v)); }

/// By tile, the largest of what `at` gives for its nodes and the one before, through `size`.
template <class At_, class Size>
void ByTile(std::size_t nodes, float* most, const At_& at, const Size& size) {
  const Doubles d;
  const std::size_t n = hn::Lanes(d);
  double before = 0.0;
  for (std::size_t b = 0; b * tile < nodes; ++b) {
    Vector largest = hn::Zero(d), v = largest;
    for (std::size_t j = 0; j < tile; j += n) {
      v = at(b * tile + j);
      largest = hn::Max(largest, v);
    }
    const double here = Largest(largest);
    most[b] = static_cast<float>(size(here > before ? here : before) * (1.0 + 0x1p-20));
    before = hn::ExtractLane(v, n - 1);
  }
}

void FillAmplitude(const AmplitudeFill& f, std::size_t nodes) {
  const Doubles d;
  ByTile(
      nodes, f.amplitude,
      [&](std::size_t i) {
        const Vector x = hn::LoadU(d, f.x + i), y = hn::LoadU(d, f.y + i);
        const Vector p = At(f.forcing, i), rise = hn::Sub(At(f.forcing, i + 1), p);
        const Vector re = hn::Sub(hn::Add(x, p), Times(f.lag, rise)),
                     rate = hn::Add(y, Times(f.per_step, rise)),
                     im = hn::Add(Times(f.c_x, re), Times(f.c_y, rate));
        return hn::Add(hn::Mul(re, re), hn::Mul(im, im));
      },
      [&](double square) { return f.per_mass * std::sqrt(square); });
  const auto same = [](double size) { return size; };
  const auto x = [&](std::size_t i) { return hn::LoadU(d, f.x + i); };
  ByTile(
      nodes, f.resisting,
      [&](std::size_t i) {
        return hn::Abs(hn::Add(x(i), Times(f.twice_zeta, hn::LoadU(d, f.y + i))));
      },
      same);
  ByTile(
      nodes, f.x_size, [&](std::size_t i) { return hn::Abs(x(i)); }, same);
}

void FillLine(const LineFill& f, std::size_t nodes) {
  const Doubles d;
  const Floats to_float;
  const std::size_t n = hn::Lanes(d);
  for (std::size_t b = 0; b * tile < nodes; ++b) {
    auto lowest = hn::Set(to_float, HUGE_VALF), highest = hn::Neg(lowest);
    for (std::size_t i = b * tile; i < (b + 1) * tile; i += n) {
      const Vector of_roof = hn::Add(Times(f.x_factor, hn::LoadU(d, f.x + i)),
                                     Times(f.y_factor, hn::LoadU(d, f.y + i)));
      const auto value = hn::DemoteTo(to_float, hn::Add(of_roof, At(f.ground, i)));
      hn::StoreU(value, to_float, f.values + i);
      lowest = hn::Min(lowest, value);
      highest = hn::Max(highest, value);
    }
    f.tile_lowest[b] = hn::GetLane(hn::MinOfLanes(to_float, lowest));
    f.tile_highest[b] = hn::GetLane(hn::MaxOfLanes(to_float, highest));
  }
}

void FillChange(const GroundLine& g, float* largest, std::size_t nodes) {
  ByTile(
      nodes, largest, [&](std::size_t i) { return hn::Abs(hn::Sub(At(g, i + 1), At(g, i))); },
      [](double change) { return change; });
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(FillAmplitude);
HWY_EXPORT(FillLine);
HWY_EXPORT(FillChange);

void fill_amplitude(const AmplitudeFill& fill, std::size_t nodes) {
  HWY_DYNAMIC_DISPATCH(FillAmplitude)(fill, nodes);
}
void fill_line(const LineFill& fill, std::size_t nodes) {
  HWY_DYNAMIC_DISPATCH(FillLine)(fill, nodes);
}
void fill_change(const GroundLine& ground, float* largest, std::size_t nodes) {
  HWY_DYNAMIC_DISPATCH(FillChange)(ground, largest, nodes);
}

}  // namespace glissade::block_detail
#endif
