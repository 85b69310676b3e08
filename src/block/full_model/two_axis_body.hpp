// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "block/full_model/two_axis_step.hpp"
#include "block/full_model/two_axis_stop.hpp"
#include "block/slip_record/two_axis_track.hpp"

namespace glissade::block_detail {

/// One block on two axes over pieces of time in which its load is linear. Velocities are per
/// cos(slope), displacements in plan.
class TwoAxisBody {
 public:
  TwoAxisBody(const FrictionEllipse& friction, Vector to_plan, double tolerance,
              std::vector<TwoAxisPoint>* history)
      : friction_(friction),
        to_plan_(to_plan),
        tolerance_(tolerance),
        history_(history),
        track_(to_plan, {}, {}) {}

  bool at_rest() const { return !sliding_; }

  /// Time passes and the block stays where it is.
  void rest_until(double time_s) {
    time_s_ = time_s;
    note();
  }

  /// One sample interval that ends at time `end_s`. Where the normal force falls below zero there
  /// is no friction: the interval is split there.
  void interval(double length_s, double end_s, const Load& begin, const Load& end);

  /// The roof at rest under a load on which every motion stops.
  void coast(const Load& load, double step_s);

  TwoAxisResult result() const;

 private:
  void advance(double length_s, double end_s, const Load& begin, const Load& end);
  void start(Vector acceleration);
  /// Returns the time taken: up to `left_s`, at which the load is `end`.
  double step(const Load& now, const Load& end, double left_s);
  /// The stop within `left_s`, at which the load is `end`, if it is known as exactly as asked; else
  /// step_s_ is kept short of it.
  Stop find_stop(const Load& now, const Load& end, double left_s);
  /// The same on a circle under a load that hardly changes, off by `allowed` at most.
  Stop find_curved_stop(const Load& now, const Load& end, double left_s, double allowed) const;
  bool passes_no_peak(Vector drive) const;
  void slide_to(const Sliding& to, double length_s);
  void rest_after(const Stop& stop);
  void note() {
    if (history_ == nullptr) return;
    const Vector at = track_.displacement();
    history_->push_back({time_s_, {at.s, at.y}});
  }

  FrictionEllipse friction_;
  Vector to_plan_;
  double tolerance_;
  std::vector<TwoAxisPoint>* history_;

  bool sliding_ = false;
  Sliding now_;
  double time_s_ = 0.0;
  double step_s_ = never;  // the longest worth trying

  TwoAxisTrack track_;
  double peak_speed_ = 0.0;  // per cos(slope), at the ends of steps
  std::size_t phases_ = 0;
  bool uplift_ = false;
};

}  // namespace glissade::block_detail
