// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/peak_slip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds_search.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/scale.hpp"
#include "linear_piece.hpp"
#include "quartic_piece.hpp"
#include "sliding_block.hpp"

namespace glissade {
namespace {

using block_detail::BoundLine;
using block_detail::Contact;
using block_detail::DriveLine;
using block_detail::ExitSearch;
using block_detail::LinearPiece;
using block_detail::never;
using block_detail::NoHistory;
using block_detail::QuarticPiece;
using block_detail::Roof;
using block_detail::SlidingBlock;
using block_detail::StopSearch;

/// Room for rounding in single precision, relative to the sum of a bound's terms: a few 2^-24.
constexpr double slack = 0x1p-20;
constexpr double largest_float = 1e37;

float to_float(double value) {
  return static_cast<float>(std::clamp(value, -largest_float, largest_float));
}

/// A roof and a block, brought to a motion of size one: times and lengths are the motion's own
/// divided by its factor, and so is gravity. The surface falls toward +x.
struct Scaled {
  double factor = 1.0;  ///< of the motion
  Block block;
  double a_sign = 1.0, w_ratio = 1.0;

  Scaled(const Block& given, const MotionFactors& factors) : block(given) {
    factor = factors.horizontal != 0.0 ? std::abs(factors.horizontal)
             : factors.vertical != 0.0 ? std::abs(factors.vertical)
                                       : 1.0;
    block.gravity_mps2 = given.gravity_mps2 / factor;
    block.slope_rad = std::abs(given.slope_rad);
    a_sign = (given.slope_rad < 0.0 ? -1.0 : 1.0) * (factors.horizontal / factor);
    w_ratio = factors.vertical / factor;
  }

  DriveLine applied(const DriveLine& line) const {
    return {line.a * a_sign, line.w * w_ratio, line.constant};
  }
};

/// One history, event by event.
template <class Piece>
class EventKernel {
 public:
  EventKernel(const RoofTable& roof, const Scaled& scene, EventSearch search)
      : a_(*roof.horizontal),
        w_(roof.vertical.get()),
        a_nodes_(a_.at_nodes()),
        w_nodes_(w_ != nullptr ? w_->at_nodes() : MotionNodes()),
        scene_(scene),
        contact_(scene.block, scene.block.slope_rad),
        drive_{scene.applied(contact_.down()), scene.applied(contact_.up())},
        lift_(scene.applied(contact_.lift())),
        every_interval_(search == EventSearch::every_interval),
        one_way_(scene.block.directions == SlipDirections::downslope_only),
        step_s_(roof.step_s()),
        last_(contact_.slides_at_rest() ? a_.ground->last_sample()
                                        : std::max(a_.end, w_ != nullptr ? w_->end : 0)),
        body_(contact_, scene.block.directions) {
    const double highest = std::abs(lift_.a) * a_.acceleration_bound_mps2 +
                           (w_ != nullptr ? std::abs(lift_.w) * w_->acceleration_bound_mps2 : 0.0);
    may_lift_ = lift_.constant + highest * (1.0 + slack) > 0.0;
    exits_.line[exits_.lines++] = bound(drive_[0]);
    if (!one_way_) exits_.line[exits_.lines++] = bound(drive_[1]);
    lift_bound_ = bound(lift_);
    for (const int k : {0, 1}) {
      speed_scale_[k] = scale_to_one(speed_size(drive_[k]));
      stop_[k] = stop_search(drive_[k], speed_scale_[k]);
    }
    if (may_lift_) exits_.line[exits_.lines++] = lift_bound_;
  }

  SlipResult run() {
    for (std::size_t i = 0; i < last_;) {
      if (body_.direction() == 0) i = next_exit(i);
      if (i < last_) i = may_lift_in(i) ? lifted(i) : events(i);
    }
    const bool lifted_at_end = -lift_.at(roof(last_)) < 0.0;
    bool stops = false;
    if (!contact_.slides_at_rest()) {
      // To zero over one more interval, where the tables do not end at zero.
      const Roof end = turned(roof(last_));
      if (end.a != 0.0 || end.w != 0.0) body_.interval(step_s_, 0.0, end, Roof{});
      stops = body_.coast(step_s_);
    }
    SlipResult result = body_.result(contact_.cos_slope());
    result.uplift = result.uplift || lifted_at_end;
    result.free_sliding = !stops;
    return result;
  }

 private:
  struct Moment {
    std::size_t interval;
    double y;  ///< share of it that has passed
  };

  /// At node i, untouched by sign and ratio.
  Roof roof(std::size_t i) const {
    return {a_nodes_.acceleration_mps2(i), w_ != nullptr ? w_nodes_.acceleration_mps2(i) : 0.0};
  }
  Roof turned(Roof r) const { return {scene_.a_sign * r.a, scene_.w_ratio * r.w}; }

  static std::size_t index(int direction) { return direction > 0 ? 0 : 1; }

  /// The roof's acceleration in the interval after node i, and a line of it.
  typename Piece::Interval interval(std::size_t i) const;
  Piece piece(const DriveLine& drive, std::size_t i) const { return {drive, interval(i), step_s_}; }

  // -- bounds

  /// The largest a line can be in each interval, in units of its own size (a power of two): numbers
  /// of any size fit into single precision.
  BoundLine bound(const DriveLine& line) const {
    const MotionBounds& a = a_.bounds;
    const double a_size = std::abs(line.a) * a_.acceleration_bound_mps2;
    const double w_size = w_ != nullptr ? std::abs(line.w) * w_->acceleration_bound_mps2 : 0.0;
    const double size = a_size + w_size + std::abs(line.constant), scale = scale_to_one(size);
    BoundLine b;
    b.a = (line.a > 0.0 ? a.highest : a.lowest).data();
    b.a_block = (line.a > 0.0 ? a.block_highest : a.block_lowest).data();
    b.c_a = to_float(line.a * (scale / a.acceleration_scale));
    if (w_ != nullptr) {
      const MotionBounds& w = w_->bounds;
      b.w = (line.w > 0.0 ? w.highest : w.lowest).data();
      b.w_block = (line.w > 0.0 ? w.block_highest : w.block_lowest).data();
      b.c_w = to_float(line.w * (scale / w.acceleration_scale));
    }
    b.constant = to_float((line.constant + slack * size) * scale);
    return b;
  }

  std::size_t next_exit(std::size_t from) const {
    return every_interval_ ? from : block_detail::next_exit(exits_, from, last_);
  }

  bool may_lift_in(std::size_t i) const {
    if (!may_lift_) return false;
    const Piece n = piece(lift_, i);
    return n.may_be_positive();
  }

  // -- events

  /// From node i, at rest or on the way, until the block is at rest at a node or may lift. Returns
  /// the node.
  std::size_t events(std::size_t i) {
    Moment now{i, 0.0};
    if (body_.direction() != 0) now = slide_on({body_.speed(), 0.0, 0.0}, i);
    int stopped = 0;
    // A drive is a quartic at most, so starts and stops in an interval are few: the bound only
    // guards against rounding.
    for (int in_interval = 0; body_.direction() == 0 && in_interval < 16; ++in_interval) {
      if (now.interval >= last_) return last_;
      const std::size_t here = now.interval;
      if (now.y >= 1.0 || !start(now, stopped)) return here + 1;
      stopped = body_.direction();
      now = slide(now);
      if (now.interval != here) in_interval = 0;
    }
    return body_.direction() != 0 ? now.interval : now.interval + 1;
  }

  /// From rest at `now`: the block begins to slide, now or later in the interval. `stopped` is the
  /// direction it has just stopped sliding in: that drive is not positive, whatever rounding says.
  bool start(Moment& now, int stopped) {
    const typename Piece::Interval here = interval(now.interval);
    double first = 1.0;
    int direction = 0;
    // The drive it did not stop under first: the two are never positive at once, so where that one
    // pushes already the other need not be looked at.
    for (const int candidate : {stopped > 0 ? -1 : 1, stopped > 0 ? 1 : -1}) {
      if (candidate < 0 && one_way_) continue;
      Piece& drive = rest_[index(candidate)];
      drive.set(drive_[index(candidate)], here, step_s_);
      if (now.y > 0.0) drive.cut(now.y);
      if (candidate == stopped) drive.begin_at_most_zero();
      const double rise = drive.rise();
      if (rise < first) {
        first = rise;
        direction = candidate;
        if (first == 0.0) break;
      }
    }
    if (direction == 0) return false;
    Piece& own = rest_[index(direction)];
    if (first > 0.0) {
      own.cut(first);
      own.begin_at_zero();  // exactly on its threshold: no spurious stop
    }
    now.y += first * (1.0 - now.y);
    body_.start(direction);
    return true;
  }

  /// Slides from rest at `now`, under rest_, to the end of the phase, or to the node where it is
  /// still on its way and the search ends.
  Moment slide(const Moment& now) {
    const Piece& own = rest_[index(body_.direction())];
    if (const double y = own.stop(0.0); y != never) {
      body_.slid(own.travel(y), y * own.length_s, 0.0);
      body_.stop();
      return {now.interval, now.y + y * (1.0 - now.y)};
    }
    return slide_on({own.gain(1.0), own.travel(1.0), own.length_s}, now.interval + 1);
  }

  /// At the node a phase is reckoned from.
  struct Reference {
    double speed, distance, duration;
  };

  /// Slides on from node r.
  Moment slide_on(const Reference& ref, std::size_t r) {
    const DriveLine& drive = drive_[index(body_.direction())];
    const double v_a = a_nodes_.velocity_mps(r),
                 v_w = w_ != nullptr ? w_nodes_.velocity_mps(r) : 0.0;
    const auto speed = [&](std::size_t i) {
      double v = ref.speed + drive.a * (a_nodes_.velocity_mps(i) - v_a);
      if (w_ != nullptr) v += drive.w * (w_nodes_.velocity_mps(i) - v_w);
      return std::max(0.0, v + drive.constant * step_s_ * static_cast<double>(i - r));
    };
    const auto distance = [&](std::size_t i) {
      const double t = step_s_ * static_cast<double>(i - r);
      double s = ref.speed * t + drive.a * (a_nodes_.displacement_from_m(r, i) - v_a * t);
      if (w_ != nullptr) s += drive.w * (w_nodes_.displacement_from_m(r, i) - v_w * t);
      return ref.distance + (s + 0.5 * drive.constant * t * t);
    };
    const auto duration = [&](std::size_t i, double y) {
      return ref.duration + step_s_ * (static_cast<double>(i - r) + y);
    };
    const auto still_sliding = [&](std::size_t i) -> Moment {
      body_.slid(distance(i), duration(i, 0.0), speed(i));
      return {i, 0.0};
    };

    StopSearch& search = stop_[index(body_.direction())];
    reckon_from(r, ref.speed, drive, v_a, v_w, search);
    for (std::size_t i = r; i < last_; ++i) {
      if (!every_interval_) i = block_detail::next_stop(search, i, last_);
      if (i == last_) break;
      if (may_lift_in(i)) return still_sliding(i);
      const Piece p = piece(drive, i);
      const double v = speed(i);
      if (const double y = p.stop(v); y != never) {
        body_.slid(distance(i) + v * p.length_s * y + p.travel(y), duration(i, y), 0.0);
        body_.stop();
        return {i, y};
      }
    }
    return still_sliding(last_);
  }

  /// What of the search for the end of a phase is the same for all phases in one direction.
  StopSearch stop_search(const DriveLine& drive, double scale) const {
    const MotionBounds& a = a_.bounds;
    StopSearch s;
    // The least the speed can be at a node and around it.
    s.a = (drive.a > 0.0 ? a.velocity_below : a.velocity_above).data();
    s.c_a = to_float(drive.a * (scale / a.velocity_scale));
    if (w_ != nullptr) {
      const MotionBounds& w = w_->bounds;
      s.w = (drive.w > 0.0 ? w.velocity_below : w.velocity_above).data();
      s.c_w = to_float(drive.w * (scale / w.velocity_scale));
    }
    s.per_step = to_float(drive.constant * step_s_ * scale);
    s.brake = bound({-drive.a, -drive.w, -drive.constant});
    if (may_lift_) s.lift = &lift_bound_;
    return s;
  }

  /// The size of the speeds the motion gives under a drive.
  double speed_size(const DriveLine& drive) const {
    const double w = w_ != nullptr ? std::abs(drive.w) * w_->bounds.largest_velocity_mps : 0.0;
    return std::abs(drive.a) * a_.bounds.largest_velocity_mps + w;
  }

  /// Sets the search off from node r.
  void reckon_from(std::size_t r, double speed, const DriveLine& drive, double v_a, double v_w,
                   StopSearch& s) const {
    const double from = drive.a * v_a + drive.w * v_w;
    const double size = std::abs(speed) + std::abs(from) + speed_size(drive);
    s.constant = to_float((speed - from - slack * size) * speed_scale_[index(body_.direction())]);
    s.origin = r;
  }

  /// An interval in which the block may lift: the roof motion linear over parts of it.
  std::size_t lifted(std::size_t i);

  const MotionTable& a_;
  const MotionTable* w_;  ///< null: no vertical
  MotionNodes a_nodes_, w_nodes_;
  Scaled scene_;
  Contact contact_;
  DriveLine drive_[2], lift_;
  bool every_interval_, one_way_, may_lift_ = false;
  double step_s_;
  std::size_t last_;  ///< node
  SlidingBlock<NoHistory> body_;
  ExitSearch exits_;
  BoundLine lift_bound_;
  StopSearch stop_[2];
  double speed_scale_[2];
  Piece rest_[2] = {};  ///< the drives over what is left of the interval
};

template <>
LinearPiece::Interval EventKernel<LinearPiece>::interval(std::size_t i) const {
  return {roof(i), roof(i + 1)};
}

template <>
QuarticPiece::Interval EventKernel<QuarticPiece>::interval(std::size_t i) const {
  if (w_ == nullptr) return {a_nodes_.acceleration_after(i), {}, false};
  return {a_nodes_.acceleration_after(i), w_nodes_.acceleration_after(i), true};
}

template <>
std::size_t EventKernel<LinearPiece>::lifted(std::size_t i) {
  body_.interval(step_s_, 0.0, turned(roof(i)), turned(roof(i + 1)));
  return i + 1;
}

template <>
std::size_t EventKernel<QuarticPiece>::lifted(std::size_t i) {
  constexpr int parts = 64;
  const auto [a_after, w_after, vertical] = interval(i);
  const QuarticPiece a(a_after, step_s_), w(w_after, step_s_);
  Roof left = turned({a.at(0.0), vertical ? w.at(0.0) : 0.0});
  for (int part = 1; part <= parts; ++part) {
    const double y = static_cast<double>(part) / parts;
    const Roof right = turned({a.at(y), vertical ? w.at(y) : 0.0});
    body_.interval(step_s_ / parts, 0.0, left, right);
    left = right;
  }
  return i + 1;
}

}  // namespace

PeakSlip peak_slip(const RoofTable& roof, const Block& block, const MotionFactors& factors,
                   EventSearch search) {
  GLISSADE_EXPECTS(block.friction >= 0.0 && std::abs(block.slope_rad) < std::numbers::pi / 2);
  const Scaled scene(block, factors);
  const bool linear = roof.horizontal->rigid() && (!roof.vertical || roof.vertical->rigid());
  const SlipResult r = linear ? EventKernel<LinearPiece>(roof, scene, search).run()
                              : EventKernel<QuarticPiece>(roof, scene, search).run();
  return {.peak_displacement_m = scene.factor * r.peak_displacement_m,
          .residual_displacement_m = scene.factor * r.residual_displacement_m,
          .peak_downslope_m = scene.factor * r.peak_downslope_m,
          .peak_upslope_m = scene.factor * r.peak_upslope_m,
          .slip_duration_s = r.slip_duration_s,
          .slip_phases = r.slip_phases,
          .uplift = r.uplift,
          .free_sliding = r.free_sliding};
}

}  // namespace glissade
