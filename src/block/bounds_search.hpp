// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace glissade::block_detail {

// Searching a table's bounds for the next place where something can happen. Bounds are in single
// precision and on the safe side, so what is found is to be looked at exactly, and what is passed
// over cannot matter. Compiled once per SIMD target, chosen at run time.

/// c_a A + c_w W + constant, where A and W are bounds on the accelerations in each interval.
struct BoundLine {
  const float *a = nullptr, *a_block = nullptr;  ///< by interval, and by block of them
  const float *w = nullptr, *w_block = nullptr;  ///< null: no vertical
  float c_a = 0.0f, c_w = 0.0f, constant = 0.0f;
};

/// Something begins where one of these is positive.
struct ExitSearch {
  BoundLine line[3];
  int lines = 0;
};
/// The first interval in [from, to) that an exit is possible in, else to.
std::size_t next_exit(const ExitSearch& search, std::size_t from, std::size_t to);

/// The speed at node i, and as far as the intervals on either side of it can leave the chord
/// between nodes, is at least c_a A[i] + c_w W[i] + constant + per_step (i - origin).
struct StopSearch {
  const float *a = nullptr, *w = nullptr;  ///< by node; w null: no vertical
  float c_a = 0.0f, c_w = 0.0f, constant = 0.0f, per_step = 0.0f;
  std::size_t origin = 0;
  BoundLine brake;                  ///< positive where speed may be lost: minus the drive
  const BoundLine* lift = nullptr;  ///< null: no lift-off to look for
};
/// The first interval in [from, to) in which the speed may return to zero or the block may lift,
/// else to.
std::size_t next_stop(const StopSearch& search, std::size_t from, std::size_t to);

}  // namespace glissade::block_detail
