// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/contact/contact.hpp"
#include "block/contact/line.hpp"
#include "block/slip_record/slide_state.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {

/// Ignores the history: slide() without one compiles to nothing here.
struct NoHistory {
  /// At each sample, start and stop: time, slip, velocity.
  void operator()(double, double, double) const {}
  /// Slid over a length of time under a drive.
  void slides(const SlideState&, const Line&, double, const SlideState&) const {}
};

/// Integrates one block over pieces of time in which the drives are linear.
template <class History>
class SlidingBlock {
 public:
  SlidingBlock(const Contact& contact, SlipDirections directions, History history = {})
      : contact_(contact), directions_(directions), history_(history) {}

  int direction() const { return direction_; }  ///< +1 sliding down, -1 up, 0 at rest
  double speed() const { return speed_; }
  double slip() const { return slip_; }

  // A phase that was computed elsewhere, in parts.
  void start(int direction) {
    direction_ = direction;
    ++phases_;
  }
  void slid(double distance, double duration, double end_speed) {
    pass_over(distance);
    duration_ += duration;
    speed_ = end_speed;
  }
  void stop() {
    direction_ = 0;
    speed_ = 0.0;
    farthest_down_ = std::max(farthest_down_,
                              slip_);  // slip is monotone inside a phase: peaks are at phase ends
    farthest_up_ = std::min(farthest_up_, slip_);
  }

  /// What comes next begins at this time.
  void be_at(double time) { time_ = time; }

  /// Time passes and the block stays where it is.
  void rest_until(double time) {
    time_ = time;
    history_(time_, slip_, 0.0);
  }

  /// One sample interval of `length` that ends at time `end`: the roof's acceleration goes linearly
  /// from r0 to r1. Where the normal force falls below zero there is no friction.
  void interval(double length, double end, const Roof& r0, const Roof& r1) {
    const double n0 = contact_.normal(r0), n1 = contact_.normal(r1);
    if (n0 >= 0.0 && n1 >= 0.0)
      return advance(length, end, contact_.sliding(r0), contact_.sliding(r1));
    uplift_ = true;
    const auto lifted = [&](double duration, double until, const Roof& from, const Roof& to) {
      advance(duration, until, contact_.frictionless(from), contact_.frictionless(to));
    };
    if (n0 < 0.0 && n1 < 0.0) return lifted(length, end, r0, r1);
    // Contact is lost or found again where N passes through zero.
    const double fraction = n0 / (n0 - n1);
    const Roof touch{r0.a + fraction * (r1.a - r0.a), r0.w + fraction * (r1.w - r0.w)};
    const double before = fraction * length, after = (1.0 - fraction) * length;
    const double between = std::min(time_ + before, end);
    if (n0 < 0.0) {
      if (before > 0.0) lifted(before, between, r0, touch);
      if (after > 0.0) advance(after, end, contact_.sliding(touch), contact_.sliding(r1));
    } else {
      if (before > 0.0) advance(before, between, contact_.sliding(r0), contact_.sliding(touch));
      if (after > 0.0) lifted(after, end, touch, r1);
    }
  }

  /// From now to piece_end, `length` later, the drives go linearly from `begin` to `end`.
  void advance(double length, double piece_end, const Drive& begin, const Drive& end) {
    Line down{begin.down, (end.down - begin.down) / length, end.down};
    Line up{begin.up, (end.up - begin.up) / length, end.up};
    if (directions_ == SlipDirections::downslope_only) up = {-1.0, 0.0, -1.0};

    piece_end_ = piece_end;
    double left = length;
    // Starts and stops inside a piece number a few (each drive is linear, so each direction starts
    // and stops at most twice); the bound only guards against rounding.
    for (int events = 0; events < 16; ++events) {
      if (direction_ == 0 && !start(down, up, left)) return rest_until(piece_end);
      Line& own = direction_ > 0 ? down : up;
      const double stop = time_to_stop(speed_, own, left);
      if (stop == never) {
        slide_for(left, own);
        time_ = piece_end;
        return history_(time_, slip_, direction_ * speed_);
      }
      slide_for(stop, own);
      shift(down, up, stop);
      own.value = std::min(own.value, 0.0);  // it stopped, so its drive is not positive
      left -= stop;
      end_phase();
      if (!(left > 0.0)) return rest_until(piece_end);
    }
    throw NotConverged("slide: too many events inside one sample interval");
  }

  /// No more roof motion: slides on under constant deceleration until it stops. False if it never
  /// does.
  bool coast(double dt) {
    if (direction_ == 0) return true;
    const Drive at_rest = contact_.sliding({});
    const double drive = direction_ > 0 ? at_rest.down : at_rest.up;
    if (drive >= 0.0) return false;
    while (direction_ != 0) {
      const double length = std::max(dt, 0.25 * speed_ / -drive);
      advance(length, time_ + length, at_rest, at_rest);
    }
    return true;
  }

  SlipResult result(double cos_slope) const {
    SlipResult r;
    set_peaks(std::max(farthest_down_, slip_) * cos_slope,
              std::min(farthest_up_, slip_) * cos_slope, slip_ * cos_slope, r);
    r.path_length_m = path_ * cos_slope;
    r.peak_velocity_mps = peak_speed_ * cos_slope;
    r.slip_duration_s = duration_;
    r.slip_phases = phases_;
    r.uplift = uplift_;
    return r;
  }

 private:
  /// From rest: begins to slide, now or later in the piece. Moves time to the start.
  bool start(Line& down, Line& up, double& left) {
    const auto start_time = [left](const Line& drive) {
      if (drive.value > 0.0) return 0.0;
      if (!(drive.end > 0.0 && drive.rate > 0.0)) return never;
      const double wait = -drive.value / drive.rate;
      return wait < left ? wait
                         : never;  // within rounding of the piece's end: the next piece starts it
    };
    const double down_start = start_time(down), up_start = start_time(up);
    const double wait = std::min(down_start, up_start);
    if (wait == never) return false;
    direction_ = down_start <= up_start ? 1 : -1;
    if (wait > 0.0) {
      shift(down, up, wait);
      (direction_ > 0 ? down : up).value = 0.0;  // exactly on its threshold: no spurious stop
      left -= wait;
    }
    pass(wait);
    ++phases_;
    history_(time_, slip_, 0.0);
    return true;
  }

  static void shift(Line& down, Line& up, double t) {
    down.value = down.at(t);
    up.value = up.at(t);
  }

  void slide_for(double t, const Line& drive) {
    const double end_drive = drive.at(t);
    const double end_speed = speed_ + t * (drive.value + 0.5 * drive.rate * t);
    const double fastest = drive.value > 0.0 && end_drive < 0.0
                               ? speed_ - 0.5 * drive.value * drive.value / drive.rate
                               : std::max(speed_, end_speed);
    const double distance = t * (speed_ + t * (0.5 * drive.value + drive.rate * t / 6.0));
    const SlideState from = state();
    pass_over(distance);
    peak_speed_ = std::max(peak_speed_, fastest);
    speed_ = std::max(end_speed, 0.0);
    duration_ += t;
    pass(t);
    history_.slides(from, drive, t, state());
  }

  /// Where the numbers are so small that their squares vanish, a distance may come out below zero.
  void pass_over(double distance) {
    slip_ += direction_ * std::max(distance, 0.0);
    path_ += std::max(distance, 0.0);
  }

  SlideState state() const { return {time_, slip_, speed_, direction_}; }

  /// Never beyond the piece's end by rounding: the next piece begins there.
  void pass(double t) { time_ = std::min(time_ + t, piece_end_); }

  void end_phase() {
    stop();
    history_(time_, slip_, 0.0);
  }

  Contact contact_;
  SlipDirections directions_;
  History history_;
  int direction_ = 0;   // +1 sliding down, -1 up, 0 at rest
  double speed_ = 0.0;  // |v| along the slope
  double slip_ = 0.0;   // along the slope, down positive
  double time_ = 0.0, piece_end_ = 0.0;
  double farthest_down_ = 0.0, farthest_up_ = 0.0, path_ = 0.0, peak_speed_ = 0.0, duration_ = 0.0;
  std::size_t phases_ = 0;
  bool uplift_ = false;
};

}  // namespace glissade::block_detail
