// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_search.hpp"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/coupled_tables/coupled_search.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = HWY_CAPPED(float, 16);
using Vector = hn::Vec<Floats>;
constexpr std::size_t tile = RegimeOscillator::window;

/// Index of the first of count elements from `from` on, whose mask is set; or count.
template <class MaskAt>
std::size_t First(std::size_t from, std::size_t count, const MaskAt& mask_at) {
  const Floats f;
  for (std::size_t i = from; i < count; i += hn::Lanes(f)) {
    const auto found = hn::FindFirstTrue(f, mask_at(i));
    if (found >= 0) {
      const std::size_t at = i + static_cast<std::size_t>(found);
      return at < count ? at : count;
    }
  }
  return count;
}

/// Re(amplitude exp(s t)) at the nodes after `from`, fewer than a tile.
struct VibrationNodes {
  const float *power_re, *power_im;
  Vector re, im;
  std::size_t from;

  VibrationNodes(const RegimeOscillator& regime, const Amplitude& amplitude, std::size_t origin)
      : power_re(regime.power_re.data()),
        power_im(regime.power_im.data()),
        re(hn::Set(Floats(), static_cast<float>(amplitude.re))),
        im(hn::Set(Floats(), static_cast<float>(amplitude.im))),
        from(origin) {}
  Vector at(std::size_t i) const {
    const Floats f;
    return hn::Sub(hn::Mul(re, hn::LoadU(f, power_re + (i - from))),
                   hn::Mul(im, hn::LoadU(f, power_im + (i - from))));
  }
};

std::size_t NextStart(const RestSearch& s, std::size_t from, std::size_t to) {
  const Floats f;
  const RegimeOscillator& r = *s.motion.regime;
  const float deviation = static_cast<float>(0.125 * r.phase * r.phase * (1.0 + 1e-6));
  const float low = static_cast<float>(s.lowest + s.room),
              high = static_cast<float>(s.highest - s.room);
  const Vector intensity = hn::Set(f, s.motion.intensity);
  const std::size_t tiles = (to + tile - 1) / tile;
  Amplitude now = s.motion.amplitude;
  double size = s.motion.size;
  for (std::size_t i = from; i < to;) {
    const std::size_t b = i / tile, end = (b + 1) * tile < to ? (b + 1) * tile : to;
    const float chord =
        deviation * (s.motion.intensity * s.tile_amplitude[b] + static_cast<float>(size));
    const VibrationNodes vibration(r, now, i);
    const Vector lowest = hn::Set(f, low + chord), highest = hn::Set(f, high - chord);
    const std::size_t found = First(i, end, [&](std::size_t at) {
      const Vector free = vibration.at(at);
      const Vector below = hn::Add(hn::Mul(intensity, hn::LoadU(f, s.below + at)), free),
                   above = hn::Add(hn::Mul(intensity, hn::LoadU(f, s.above + at)), free);
      return hn::Or(hn::Lt(below, lowest), hn::Gt(above, highest));
    });
    if (found < end) return found;
    // The free vibration only decays: by tile, it is no larger than now.
    const float room = static_cast<float>(size) * (1.0f + deviation);
    const Vector least = hn::Set(f, low + room), most = hn::Set(f, high - room);
    i = tile * First(b + 1, tiles, [&](std::size_t at) {
          return hn::Or(hn::Lt(hn::Mul(intensity, hn::LoadU(f, s.tile_below + at)), least),
                        hn::Gt(hn::Mul(intensity, hn::LoadU(f, s.tile_above + at)), most));
        });
    now = s.motion.amplitude * r.power(i - from);
    size = now.size();
  }
  return to;
}

std::size_t NextStop(const SpeedSearch& s, std::size_t from, std::size_t to) {
  const Floats f;
  const RegimeOscillator& r = *s.motion.regime;
  const Vector gain = hn::Set(f, s.drive_a * s.motion.intensity), per_step = hn::Set(f, s.per_step);
  const float size = s.drive_a < 0.0f ? -s.drive_a : s.drive_a;
  Amplitude now = static_cast<double>(s.drive_a) * s.motion.amplitude;
  for (std::size_t i = from; i < to;) {
    const std::size_t b = i / tile, end = (b + 1) * tile < to ? (b + 1) * tile : to;
    const VibrationNodes vibration(r, now, i);
    const Vector deviation =
        hn::Set(f, size * s.motion.intensity * s.tile_deviation[b] + s.deviation - s.constant);
    const std::size_t found = First(i, end, [&](std::size_t at) {
      const Vector steps = hn::Iota(f, static_cast<float>(at - from));
      const Vector speed =
          hn::Add(hn::Add(hn::Mul(gain, hn::LoadU(f, s.gain + at)), vibration.at(at)),
                  hn::Mul(per_step, steps));
      return hn::Le(speed, deviation);
    });
    if (found < end) return found;
    now = now * r.power(end - i);
    i = end;
  }
  return to;
}

/// As VibrationNodes, in double precision of single-precision powers.
struct LimitNodes {
  using Doubles = HWY_CAPPED(double, 8);
  using Values = hn::Vec<Doubles>;
  const LimitSearch& s;
  const RegimeOscillator& r;
  Amplitude now;  // at node `first`
  std::size_t first;
  double bend;  // a leaves its chord by no more, and rounding

  static Values Number(double v) { return hn::Set(Doubles(), v); }
  static Values Power(const float* of) {
    const hn::Rebind<float, Doubles> f;
    return hn::PromoteTo(Doubles(), hn::LoadU(f, of));
  }
  static Values Product(Amplitude z, Values re, Values im) {
    return hn::Sub(hn::Mul(Number(z.re), re), hn::Mul(Number(z.im), im));
  }
  hn::Mask<Doubles> MayFail(std::size_t i) const {
    const Doubles d;
    const Values re = Power(r.power_re.data() + (i - first)),
                 im = Power(r.power_im.data() + (i - first)), lambda = Number(s.intensity);
    Values x = hn::Add(hn::Mul(lambda, hn::LoadU(d, s.x + i)), Product(r.omega2 * now, re, im));
    const Values y = hn::Add(hn::Mul(lambda, hn::LoadU(d, s.y + i)),
                             Product(r.omega_radps * (r.s * now), re, im));
    Values gravity = Number(r.gravity_mps2);
    if (s.w != nullptr)
      gravity = hn::Add(gravity, hn::Mul(Number(s.w_factor), hn::LoadU(d, s.w + i)));
    const double weight = r.contact.weight;
    x = hn::Sub(x, Number(weight * r.gravity_mps2));
    const Values resisting =
        hn::Add(hn::Add(x, hn::Mul(Number(r.lag * r.angle), y)), hn::Mul(Number(weight), gravity));
    const Values contact =
        hn::Sub(hn::Mul(gravity, Number(s.cot_slope)), hn::Mul(resisting, Number(r.per_mass)));
    const double bend_x = r.contact.mass * bend;
    auto holds = hn::Gt(contact, Number(bend));
    holds = hn::And(holds, hn::And(hn::Gt(x, Number(s.lowest + bend_x)),
                                   hn::Lt(x, Number(s.highest - bend_x))));
    if (s.side != 0) {
      const double root = std::sqrt(r.contact.mass);
      holds = hn::And(holds, hn::Gt(hn::Mul(Number(s.side), y), Number(root * bend)));
    }
    return hn::Not(holds);
  }
};

std::size_t NextLimit(const LimitSearch& s, std::size_t from, std::size_t to) {
  const LimitNodes::Doubles d;
  const RegimeOscillator& r = *s.regime;
  const double x_at_rest = -r.contact.weight * r.gravity_mps2,
               room_x = std::min(x_at_rest - s.lowest, s.highest - x_at_rest);
  Amplitude now = s.free;
  for (std::size_t i = from; i < to;) {
    const std::size_t b = i / tile, end = std::min((b + 1) * tile, to);
    const double size = now.size(), lowest_w = std::min(s.w_factor * s.tile_lowest_w[b],
                                                        s.w_factor * s.tile_highest_w[b]);
    if (s.side != 0 ||
        s.intensity * s.tile_a[b] + r.s2_size * size >= (r.gravity_mps2 + lowest_w) * s.cot_slope ||
        s.intensity * s.tile_x[b] + r.omega2 * size >= room_x) {
      const double amplitude = s.intensity * s.tile_amplitude[b] + r.s2_size * size;
      const LimitNodes nodes{s, r, now, i,
                             (0.125 * r.phase * r.phase * (1.0 + 1e-6) + 1e-6) * amplitude};
      for (std::size_t at = i; at < end; at += hn::Lanes(d)) {
        const auto found = hn::FindFirstTrue(d, nodes.MayFail(at));
        if (found >= 0 && at + static_cast<std::size_t>(found) < end)
          return at + static_cast<std::size_t>(found);
      }
    }
    now = now * r.power(end - i);
    i = end;
  }
  return to;
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(NextStart);
HWY_EXPORT(NextStop);
HWY_EXPORT(NextLimit);

std::size_t next_start(const RestSearch& search, std::size_t from, std::size_t to) {
  return HWY_DYNAMIC_DISPATCH(NextStart)(search, from, to);
}

std::size_t next_stop(const SpeedSearch& search, std::size_t from, std::size_t to) {
  return HWY_DYNAMIC_DISPATCH(NextStop)(search, from, to);
}

std::size_t next_limit(const LimitSearch& search, std::size_t from, std::size_t to) {
  return HWY_DYNAMIC_DISPATCH(NextLimit)(search, from, to);
}

}  // namespace glissade::block_detail
#endif
