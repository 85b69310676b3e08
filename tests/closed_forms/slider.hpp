// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "glissade/block/slide.hpp"

namespace glissade::closed_forms {

/// Sliding one way, the speed grows as gain (alpha - yield), where alpha is the roof's horizontal
/// acceleration against that way: the block is left behind.
struct Way {
  double gain;        ///< k
  double yield_mps2;  ///< y
};

/// All the closed forms need to know of a block: its two ways, and what slip along the slope is in
/// plan.
struct Slider {
  Way down, up;
  double plan;  ///< cos(slope)
};

/// With the vertical in proportion to the horizontal, w = ratio a, the drives (theory.md, 1.2) are
///   down, a = -alpha:  v' = alpha [c + mu s + ratio (mu c - s)] - g (mu c - s)
///   up,   a = +alpha:  v' = alpha [c - mu s - ratio (mu c + s)] - g (mu c + s)
/// with c, s = cos, sin(slope): two ways again, with other gains and yields.
inline Slider slider(const Block& block, double vertical_ratio = 0.0) {
  const double c = std::cos(block.slope_rad), s = std::sin(block.slope_rad),
               mu = block.friction.along;
  const double held_down = mu * c - s, held_up = mu * c + s;
  const double down = c + mu * s + vertical_ratio * held_down,
               up = c - mu * s - vertical_ratio * held_up;
  return {.down = {down, block.gravity_mps2 * held_down / down},
          .up = {up, block.gravity_mps2 * held_up / up},
          .plan = c};
}

/// What a motion does to a block: how far it slides down and then up, in plan.
struct Strokes {
  double down_m, up_m;
};

}  // namespace glissade::closed_forms
