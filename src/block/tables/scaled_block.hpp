// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "block/contact/contact.hpp"
#include "block/tables/event_bounds.hpp"
#include "glissade/block/peak_slip.hpp"

namespace glissade::block_detail {

/// A block under the motion as it is tabulated: lengths are divided by the motion's factor, and so
/// is gravity. The surface falls toward +x.
struct Scaled {
  double factor = 1.0;  ///< of the motion
  Block block;
  double a_sign = 1.0, w_ratio = 1.0;

  Scaled(const Block& given, const MotionFactors& factors) : block(given) {
    factor = factors.horizontal[0] != 0.0 ? std::abs(factors.horizontal[0])
             : factors.vertical != 0.0    ? std::abs(factors.vertical)
                                          : 1.0;
    block.gravity_mps2 = given.gravity_mps2 / factor;
    block.slope_rad = std::abs(given.slope_rad);
    a_sign = mirror(given) * (factors.horizontal[0] / factor);
    w_ratio = factors.vertical / factor;
  }

  Lines lines(const Contact& contact) const {
    const auto seen = [&](const DriveLine& line) {
      return DriveLine{line.a * a_sign, line.w * w_ratio, line.constant};
    };
    return {{seen(contact.down()), seen(contact.up())},
            seen(contact.lift()),
            block.directions == SlipDirections::both ? 2 : 1};
  }
};

inline SlipPeak in_metres(SlipPeak slip, double factor) {
  for (double* length : {&slip.peak_displacement_m, &slip.peak_by_axis.along_m,
                         &slip.peak_downslope_m, &slip.peak_upslope_m, &slip.residual.along_m})
    *length *= factor;
  return slip;
}

}  // namespace glissade::block_detail
