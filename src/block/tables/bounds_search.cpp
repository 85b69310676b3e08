// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/tables/bounds_search.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "block/tables/bounds_search.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "glissade/building/motion_table.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = HWY_CAPPED(float, 16);

/// Index of the first of count elements from `from` on, whose mask is set; or count.
template <class MaskAt>
std::size_t first(std::size_t from, std::size_t count, MaskAt mask_at) {
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

/// Where the line is positive, by interval or by tile.
template <bool kByTile>
struct LineAt {
  const float *a, *w;
  hn::Vec<Floats> c_a, c_w, constant;

  explicit LineAt(const BoundLine& line)
      : a(kByTile ? line.a_tile : line.a),
        w(kByTile ? line.w_tile : line.w),
        c_a(hn::Set(Floats(), line.c_a)),
        c_w(hn::Set(Floats(), line.c_w)),
        constant(hn::Set(Floats(), line.constant)) {}

  auto operator()(std::size_t i) const {
    const Floats f;
    auto value = hn::Add(hn::Mul(c_a, hn::LoadU(f, a + i)), constant);
    if (w != nullptr) value = hn::Add(value, hn::Mul(c_w, hn::LoadU(f, w + i)));
    return hn::Gt(value, hn::Zero(f));
  }
};

/// The first of the intervals, or tiles, in [from, to) where one of the lines is positive.
template <bool kByTile>
std::size_t FirstExit(const ExitSearch& s, std::size_t from, std::size_t to) {
  using Line = LineAt<kByTile>;
  const Line one(s.line[0]);
  if (s.lines == 1) return first(from, to, one);
  const Line two(s.line[1]);
  if (s.lines == 2) return first(from, to, [&](std::size_t i) { return hn::Or(one(i), two(i)); });
  const Line three(s.line[2]);
  return first(from, to, [&](std::size_t i) { return hn::Or(hn::Or(one(i), two(i)), three(i)); });
}

std::size_t NextExit(const ExitSearch& s, std::size_t from, std::size_t to) {
  constexpr std::size_t tile = MotionBounds::tile;
  const std::size_t tiles = (to + tile - 1) / tile;
  for (std::size_t b = from / tile; b < tiles;) {
    const std::size_t end = (b + 1) * tile < to ? (b + 1) * tile : to;
    const std::size_t found = FirstExit<false>(s, from, end);
    if (found < end) return found;
    b = FirstExit<true>(s, b + 1, tiles);
    from = b * tile;
  }
  return to;
}

std::size_t NextStop(const StopSearch& s, std::size_t from, std::size_t to) {
  const Floats f;
  const auto c_a = hn::Set(f, s.c_a), c_w = hn::Set(f, s.c_w), constant = hn::Set(f, s.constant),
             per_step = hn::Set(f, s.per_step);
  const auto speed = [&](std::size_t i) {
    const auto steps = hn::Iota(f, static_cast<float>(i - s.origin));
    auto v =
        hn::Add(hn::Add(hn::Mul(c_a, hn::LoadU(f, s.a + i)), constant), hn::Mul(per_step, steps));
    if (s.w != nullptr) v = hn::Add(v, hn::Mul(c_w, hn::LoadU(f, s.w + i)));
    return v;
  };
  const LineAt<false> brakes(s.brake);
  const auto stops = [&](std::size_t i) {
    return hn::And(brakes(i), hn::Le(hn::Min(speed(i), speed(i + 1)), hn::Zero(f)));
  };
  if (s.lift == nullptr) return first(from, to, stops);
  const LineAt<false> lifts(*s.lift);
  return first(from, to, [&](std::size_t i) { return hn::Or(stops(i), lifts(i)); });
}

}  // namespace glissade::block_detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glissade::block_detail {
HWY_EXPORT(NextExit);
HWY_EXPORT(NextStop);

std::size_t next_exit(const ExitSearch& search, std::size_t from, std::size_t to) {
  return HWY_DYNAMIC_DISPATCH(NextExit)(search, from, to);
}

std::size_t next_stop(const StopSearch& search, std::size_t from, std::size_t to) {
  return HWY_DYNAMIC_DISPATCH(NextStop)(search, from, to);
}

}  // namespace glissade::block_detail
#endif
