// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "block/two_axes/lane_states.hpp"

namespace glissade::block_detail::two_axes {

/// The roof under a block at rest at eight nodes: factor * a + free vibration
/// along each axis.
struct RestMotion {
  struct Axis {
    const double* a;  ///< at the nodes
    double factor;
    const double* x_part;  ///< of the free vibration (FreeVibration)
    const double* y_part;
    double x, y;  ///< the free vibration's state at the first node
  };
  Axis axis[2];
  const double* w;
};

/// The first of eight nodes at which the friction reserve is less than
/// `needed`, or 8.
std::size_t first_release(const RestMotion& motion, const Constants<double>& constants,
                          double needed);

}  // namespace glissade::block_detail::two_axes
