// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/floor_acceleration.hpp"

#include <algorithm>
#include <cmath>

namespace glissade {

double asce7_16_floor_acceleration_g(double sds_g, double height) {
  return 0.4 * sds_g * (1.0 + 2.0 * height);
}

double asce7_22_floor_acceleration_g(double sds_g, double period_s, double height) {
  const double a1 = std::min(1.0 / period_s, 2.5),
               a2 = std::max(1.0 - 0.16 / (period_s * period_s), 0.0);
  return 0.4 * sds_g * (1.0 + a1 * height + a2 * std::pow(height, 10));
}

}  // namespace glissade
