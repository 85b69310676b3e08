// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/tables/event_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/scale.hpp"

namespace glissade::block_detail {
namespace {

/// Allowance for rounding in single precision, relative to the sum of the terms of a bound: a few
/// 2^-24.
constexpr double slack = 0x1p-20;

float to_float(double value) {
  constexpr double largest = 1e37;
  return static_cast<float>(std::clamp(value, -largest, largest));
}

}  // namespace

EventBounds::EventBounds(const MotionTable& a, const MotionTable* w, const Lines& lines,
                         std::size_t last)
    : a_(a), w_(w), lines_(lines), last_(last) {
  const DriveLine& lift = lines.lift;
  const double highest = std::abs(lift.a) * a.acceleration_bound_mps2 +
                         (w != nullptr ? std::abs(lift.w) * w->acceleration_bound_mps2 : 0.0);
  may_lift_ = lift.constant + highest * (1.0 + slack) > 0.0;
  lift_ = bound(lift);
  for (int k = 0; k < lines.directions; ++k) {
    const DriveLine& drive = lines.drive[k];
    speed_size_[k] = std::abs(drive.a) * a.bounds.largest_velocity_mps +
                     (w != nullptr ? std::abs(drive.w) * w->bounds.largest_velocity_mps : 0.0);
    speed_scale_[k] = scale_to_one(speed_size_[k]);
    stop_[k] = stop_search(drive, speed_scale_[k]);
    exits_.line[exits_.lines++] = bound(drive);
  }
  if (may_lift_) exits_.line[exits_.lines++] = lift_;
}

std::size_t EventBounds::next_exit(std::size_t from) const {
  return block_detail::next_exit(exits_, from, last_);
}

void EventBounds::set_reference(int k, std::size_t r, double speed, double v_a, double v_w) {
  const double from = lines_.drive[k].a * v_a + lines_.drive[k].w * v_w;
  const double size = std::abs(speed) + std::abs(from) + speed_size_[k];
  stop_[k].constant = to_float((speed - from - slack * size) * speed_scale_[k]);
  stop_[k].origin = r;
}

std::size_t EventBounds::next_stop(int k, std::size_t from) const {
  return block_detail::next_stop(stop_[k], from, last_);
}

/// The largest value of a line in each interval, in units of its own size (a power of two), so that
/// numbers of any size fit into single precision.
BoundLine EventBounds::bound(const DriveLine& line) const {
  const MotionBounds& a = a_.bounds;
  const double a_size = std::abs(line.a) * a_.acceleration_bound_mps2;
  const double w_size = w_ != nullptr ? std::abs(line.w) * w_->acceleration_bound_mps2 : 0.0;
  const double size = a_size + w_size + std::abs(line.constant), scale = scale_to_one(size);
  BoundLine b;
  b.a = (line.a > 0.0 ? a.highest : a.lowest).data();
  b.a_tile = (line.a > 0.0 ? a.tile_highest : a.tile_lowest).data();
  b.c_a = to_float(line.a * (scale / a.acceleration_scale));
  if (w_ != nullptr) {
    const MotionBounds& w = w_->bounds;
    b.w = (line.w > 0.0 ? w.highest : w.lowest).data();
    b.w_tile = (line.w > 0.0 ? w.tile_highest : w.tile_lowest).data();
    b.c_w = to_float(line.w * (scale / w.acceleration_scale));
  }
  b.constant = to_float((line.constant + slack * size) * scale);
  return b;
}

/// The part of the search for the end of a phase that is the same for all phases in one direction.
StopSearch EventBounds::stop_search(const DriveLine& drive, double scale) const {
  const MotionBounds& a = a_.bounds;
  StopSearch s;
  // The smallest speed possible at a node and around it.
  s.a = (drive.a > 0.0 ? a.velocity_below : a.velocity_above).data();
  s.c_a = to_float(drive.a * (scale / a.velocity_scale));
  if (w_ != nullptr) {
    const MotionBounds& w = w_->bounds;
    s.w = (drive.w > 0.0 ? w.velocity_below : w.velocity_above).data();
    s.c_w = to_float(drive.w * (scale / w.velocity_scale));
  }
  s.per_step = to_float(drive.constant * a_.step_s() * scale);
  s.brake = bound({-drive.a, -drive.w, -drive.constant});
  if (may_lift_) s.lift = &lift_;
  return s;
}

}  // namespace glissade::block_detail
