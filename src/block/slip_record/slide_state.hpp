// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade::block_detail {

/// State of a sliding block.
struct SlideState {
  double time = 0.0;
  double slip = 0.0;   ///< along the slope, down positive
  double speed = 0.0;  ///< >= 0, along the slope
  int direction = 0;   ///< +1 sliding down, -1 up
};

}  // namespace glissade::block_detail
