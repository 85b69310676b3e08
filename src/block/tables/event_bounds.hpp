// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "block/contact/contact.hpp"
#include "block/tables/bounds_search.hpp"
#include "glissade/building/motion_table.hpp"

namespace glissade::block_detail {

/// The equations of one history as lines of the roof's acceleration.
struct Lines {
  DriveLine drive[2];  ///< of sliding down, and up
  DriveLine lift;      ///< minus the normal force
  int directions = 2;  ///< 1: down only
};

/// Intervals of the tables of a roof in which an event is possible and that peak_slip examines
/// exactly. The tables outlive it.
class EventBounds {
 public:
  /// @param w null: no vertical
  /// @param last the node at which the search ends
  EventBounds(const MotionTable& a, const MotionTable* w, const Lines& lines, std::size_t last);
  EventBounds(const EventBounds&) = delete;
  EventBounds& operator=(const EventBounds&) = delete;

  /// False: the normal force is positive for any phase between the components.
  bool may_lift() const { return may_lift_; }

  /// The first interval from `from` on in which a block at rest may begin to slide, or uplift
  /// occur.
  std::size_t next_exit(std::size_t from) const;

  /// A phase in direction k (0 down, 1 up) has this speed at node r, where the roof's velocities
  /// are v_a and v_w.
  void set_reference(int k, std::size_t r, double speed, double v_a, double v_w);
  /// The first interval from `from` >= r on in which it may end, or uplift occur.
  std::size_t next_stop(int k, std::size_t from) const;

 private:
  BoundLine bound(const DriveLine& line) const;
  StopSearch stop_search(const DriveLine& drive, double scale) const;

  const MotionTable& a_;
  const MotionTable* w_;
  Lines lines_;
  std::size_t last_;
  bool may_lift_;
  ExitSearch exits_;
  BoundLine lift_;
  StopSearch stop_[2];
  double speed_size_[2], speed_scale_[2];  ///< of the speeds under a drive
};

}  // namespace glissade::block_detail
