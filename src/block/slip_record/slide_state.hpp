// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "glissade/block/slip_result.hpp"

namespace glissade::block_detail {

/// State of a sliding block.
struct SlideState {
  double time = 0.0;
  double slip = 0.0;   ///< along the slope, down positive
  double speed = 0.0;  ///< >= 0, along the slope
  int direction = 0;   ///< +1 sliding down, -1 up
};

/// Of one axis, in plan: the farthest positions, up < 0, and the last.
inline void set_peaks(double down, double up, double last, SlipPeak& slip) {
  slip.peak_downslope_m = down;
  slip.peak_upslope_m = -up + 0.0;  // no negative zero
  slip.peak_displacement_m = slip.peak_by_axis.along_m = std::max(down, slip.peak_upslope_m);
  slip.residual.along_m = last;
}

}  // namespace glissade::block_detail
