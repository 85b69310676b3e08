// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compiled once per SIMD target (Highway chooses at run time); every operation is elementwise and
// unfused, so all targets give the same bits.
#include "coupled_bank.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/coupled_bank.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = HWY_CAPPED(double, CoupledBank::lanes);
using Vector = hn::Vec<Doubles>;

/// Some lanes over one interval: their states at its end, and who is flagged.
template <bool vertical>
void Step(CoupledBank& bank, std::size_t first, const BankGround& ground, std::size_t i,
          Flags& flags) {
  const Doubles d;
  const CoupledBank::State& from = bank.state[bank.now];
  CoupledBank::State& to = bank.state[1 - bank.now];
  const auto load = [d, first](const double* values) { return hn::Load(d, values + first); };
  const auto times = [&](const double* factors, Vector v) { return hn::Mul(load(factors), v); };

  const Vector a = hn::Set(d, ground.a[i + 1]);
  const Vector a_sum = hn::Set(d, ground.a[i] + ground.a[i + 1]);
  Vector forcing = hn::Add(times(bank.ground, a), load(bank.constant));
  Vector lowest = load(bank.lowest), highest = load(bank.highest);
  Vector gain = load(bank.speed_g);
  if constexpr (vertical) {
    const Vector w = hn::Set(d, ground.w[i + 1]);
    forcing = hn::Add(forcing, times(bank.vertical, w));
    lowest = hn::Add(lowest, times(bank.lowest_w, w));
    highest = hn::Add(highest, times(bank.highest_w, w));
    gain = hn::Add(gain, times(bank.speed_w, hn::Set(d, ground.w[i] + ground.w[i + 1])));
  }
  const Vector x0 = load(from.x), y0 = load(from.y), forcing0 = load(from.forcing);
  const Vector x = hn::Sub(hn::Add(times(bank.xx, x0), times(bank.xy, y0)),
                           hn::Add(times(bank.x_start, forcing0), times(bank.x_end, forcing)));
  const Vector y = hn::Sub(hn::Sub(times(bank.yy, y0), times(bank.yx, x0)),
                           hn::Add(times(bank.y_start, forcing0), times(bank.y_end, forcing)));
  const Vector elastic = hn::Add(x, times(bank.twice_zeta, y));
  const Vector turn =
      hn::Sub(y, times(bank.twice_zeta, hn::Add(times(bank.per_mass, elastic), forcing)));
  const Vector speed = hn::Add(hn::Add(load(from.speed), hn::Add(gain, times(bank.speed_a, a_sum))),
                               times(bank.speed_y, hn::Sub(y, y0)));

  // A peak between the nodes: the rate changes sign near the largest value so far.
  const Vector zero = hn::Zero(d), sag = load(bank.sag);
  const auto turns = [&](const double* rate0, Vector rate, Vector value, const double* peak0,
                         double* peak) {
    const Vector size = hn::Abs(value), before = load(peak0);
    hn::Store(hn::Max(before, size), d, peak + first);
    return hn::And(hn::Le(hn::Mul(load(rate0), rate), zero), hn::Gt(hn::Add(size, sag), before));
  };
  const auto peak_elastic = turns(from.turn, turn, elastic, from.peak, to.peak);
  const auto peak_x = turns(from.y, y, x, from.peak_x, to.peak_x);
  const auto moves =
      hn::Or(hn::Or(hn::Lt(elastic, lowest), hn::Gt(elastic, highest)),
             hn::Or(hn::Lt(speed, load(bank.least_speed)), hn::Gt(hn::Abs(y), load(bank.y_bound))));
  hn::Store(x, d, to.x + first);
  hn::Store(y, d, to.y + first);
  hn::Store(elastic, d, to.elastic + first);
  hn::Store(turn, d, to.turn + first);
  hn::Store(forcing, d, to.forcing + first);
  hn::Store(speed, d, to.speed + first);
  const auto peaks = hn::Or(peak_elastic, peak_x);
  if (HWY_LIKELY(hn::AllFalse(d, hn::Or(moves, peaks)))) return;
  const auto bits = [&](auto mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return (bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8) << first;
  };
  flags.moves |= bits(moves);
  flags.peaks |= bits(peaks);
}

template <bool vertical>
std::size_t WalkWith(CoupledBank& bank, const BankGround& ground, std::size_t from, std::size_t to,
                     Flags& flags) {
  const std::size_t n = hn::Lanes(Doubles());
  flags = {};
  std::size_t i = from;
  while (i < to && !flags.any()) {
    for (std::size_t first = 0; first < CoupledBank::lanes; first += n)
      Step<vertical>(bank, first, ground, i, flags);
    bank.now = 1 - bank.now;
    ++i;
  }
  return i;
}

std::size_t Walk(CoupledBank& bank, const BankGround& ground, std::size_t from, std::size_t to,
                 Flags& flags) {
  return ground.w != nullptr ? WalkWith<true>(bank, ground, from, to, flags)
                             : WalkWith<false>(bank, ground, from, to, flags);
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(Walk);

std::size_t walk(CoupledBank& bank, const BankGround& ground, std::size_t from, std::size_t to,
                 Flags& flags) {
  return HWY_DYNAMIC_DISPATCH(Walk)(bank, ground, from, to, flags);
}

}  // namespace glissade::block_detail
#endif
