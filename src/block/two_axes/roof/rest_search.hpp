// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "block/two_axes/roof/tables.hpp"

namespace glissade::block_detail::two_axes {

/// The roof under a block at rest at eight nodes: factor * a + free vibration
/// along each axis.
struct RestMotion {
  struct Axis {
    const double* a;  ///< at the nodes
    double factor;
    struct Free {
      const double* x_part;  ///< FreeVibration's
      const double* y_part;
      OscillatorState state;  ///< at the first node
    };
    std::array<Free, most_modes> free;
    std::size_t count;
    /// Of a building that yields: of its force, as `a` and Free; and what it stays within.
    struct Spring {
      const double *x, *x_part, *y_part;
      double low, high;
    } spring;
  };
  Axis axis[2];
  const double* w;
  bool springs = false;  ///< the building yields
};

/// The first of eight nodes at which the friction reserve is less than `needed`, or a spring beyond
/// its limits, or 8.
std::size_t first_release(const RestMotion& motion, const Constants<double>& constants,
                          double needed);

}  // namespace glissade::block_detail::two_axes
