// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/block/crossing.hpp"

namespace glissade::test {

/// Shares of a peak, and one beyond it.
inline std::vector<double> thresholds_of(double peak_m) {
  std::vector<double> thresholds;
  for (const double share : {1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0, 1.01})
    thresholds.push_back(share * peak_m);
  return thresholds;
}

/// Crossings of one history differ by no more than rounding of slip does: time by that over speed,
/// speed by what is gained in that time.
inline void expect_alike(const Crossing& actual, const Crossing& expected, double slip_error_m) {
  ASSERT_TRUE(actual.happens());
  constexpr double acceleration_mps2 = 20.0;  // none is larger here
  // Where the block all but stops, the time left is the root of the way left.
  const double time_error_s =
      1e-13 * expected.time_s +
      std::min(slip_error_m / expected.speed_mps, std::sqrt(2.0 * slip_error_m / 0.01));
  EXPECT_NEAR(actual.time_s, expected.time_s, time_error_s);
  EXPECT_NEAR(actual.speed_mps, expected.speed_mps,
              acceleration_mps2 * time_error_s + 1e-13 * expected.speed_mps);
}

}  // namespace glissade::test
