// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace glissade::block_detail {

// Search of the bounds of a table for the next interval in which an event is possible. Bounds are
// in single precision and on the safe side: an interval that is found must be examined exactly, and
// one that is excluded has no event. Compiled once per SIMD target, chosen at run time.

/// c_a A + c_w W + constant, where A and W are bounds on the accelerations in each interval.
struct BoundLine {
  const float *a = nullptr, *a_tile = nullptr;  ///< by interval, and by tile of them
  const float *w = nullptr, *w_tile = nullptr;  ///< null: no vertical
  float c_a = 0.0f, c_w = 0.0f, constant = 0.0f;
};

/// An event is possible where one of these is positive.
struct ExitSearch {
  BoundLine line[3];
  int lines = 0;
};
/// The first interval in [from, to) with a possible event, else to.
std::size_t next_exit(const ExitSearch& search, std::size_t from, std::size_t to);

/// The speed at node i, less its largest departure from the chords in the intervals on either side,
/// is at least c_a A[i] + c_w W[i] + constant + per_step (i - origin).
struct StopSearch {
  const float *a = nullptr, *w = nullptr;  ///< by node; w null: no vertical
  float c_a = 0.0f, c_w = 0.0f, constant = 0.0f, per_step = 0.0f;
  std::size_t origin = 0;
  BoundLine brake;                  ///< positive where speed may decrease: minus the drive
  const BoundLine* lift = nullptr;  ///< null: no uplift possible
};
/// The first interval in [from, to) in which the speed may return to zero or uplift may occur, else
/// to.
std::size_t next_stop(const StopSearch& search, std::size_t from, std::size_t to);

}  // namespace glissade::block_detail
