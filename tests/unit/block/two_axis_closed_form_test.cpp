// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glissade/block/two_axis.hpp"

namespace glissade {
namespace two_axis_closed_form_test {

constexpr double g = standard_gravity_mps2;

/// A roof that is moved in a circle: acceleration A at an angle that grows at the rate omega.
std::vector<double> turning(double peak_mps2, int cycles, double phase) {
  constexpr int samples_per_cycle = 2000;
  std::vector<double> a;
  for (int i = 0; i <= cycles * samples_per_cycle; ++i)
    a.push_back(peak_mps2 * std::cos(2.0 * std::numbers::pi * i / samples_per_cycle + phase));
  return a;
}

// Carried round a circle, the block ends up circling too: friction mu g against its velocity, the
// rest of the drive across it and turning it at the rate omega, so A^2 = (mu g)^2 + (omega v)^2.
// One cycle more adds one circle of that speed. (2,000 chords for a circle: off by 1e-6.)
TEST(slide_two_axis, circles_steadily_on_a_roof_that_circles) {
  const double omega = 2.0 * std::numbers::pi / 1.0;  // dt 0.0005 s: a period of 1 s
  for (const double mu : {0.1, 0.3, 0.45}) {
    const double peak_mps2 = 0.5 * g;
    const auto path_m = [&](int cycles) {
      const auto x = turning(peak_mps2, cycles, 0.0),
                 y = turning(peak_mps2, cycles, -0.5 * std::numbers::pi);
      return slide_two_axis({0.0005, {x, y}}, {{mu, mu}}).path_length_m;
    };
    const double speed_mps = std::sqrt(peak_mps2 * peak_mps2 - mu * g * mu * g) / omega;
    EXPECT_NEAR((path_m(21) - path_m(20)) / speed_mps, 1.0, 1e-5) << "mu " << mu;
  }
}

// A slope that is let go of with the block sliding across it: |v| n + v.d is linear in time (see
// two_axis.hpp), n = mu g cos(slope), d = g sin(slope) down, so that the block rests after
// T = n |v0| / (n^2 - d^2) whatever way its path bends, and has gone
//   beta v0 across and gamma d down, beta = 2 n |v0| / (4 n^2 - d^2),
//   gamma = |v0|^2 / (4 (n^2 - d^2)).
// v0 is brought about by a jerk of 0.1 ms across the slope, so large that friction and gravity do
// nothing meanwhile (1e-5 of it).
TEST(slide_two_axis, a_block_thrown_across_a_slope_bends_down_and_stops) {
  const double dt_s = 1e-7, speed_mps = 1.0, slope = 10.0 * rad_per_deg, mu = 0.3;
  const double cosine = std::cos(slope);
  std::vector<double> along(8, 0.0), across(8, 0.0);
  across[1] = -speed_mps / dt_s;  // a triangle of area v0
  const SlipResult r = slide_two_axis({dt_s, {along, across}}, {{mu, mu}, slope}, 1e-9);
  const double n = mu * g * cosine, d = g * std::sin(slope), margin = n * n - d * d;
  EXPECT_NEAR(r.slip_duration_s, n * speed_mps / margin, 1e-5);
  const double beta = 2.0 * n * speed_mps / (4.0 * n * n - d * d);
  EXPECT_NEAR(r.residual.across_m, beta * speed_mps, 1e-5);
  EXPECT_NEAR(r.residual.along_m, cosine * d * speed_mps * speed_mps / (4.0 * margin), 1e-5);
}

// Without friction the drive is all: displacement is minus the roof's.
TEST(slide_two_axis, without_friction_the_block_stays_where_it_is_while_the_roof_moves) {
  const std::vector<double> x = {0.0, 2.0, -1.0, 3.0, 0.0}, y = {0.0, -1.0, 4.0, 0.5, 0.0};
  const double dt_s = 0.1;
  const auto roof_displacement_m = [&](const std::vector<double>& a) {
    double v = 0.0, u = 0.0;
    for (std::size_t i = 1; i < a.size(); ++i) {
      u += dt_s * (v + dt_s * (a[i - 1] / 3.0 + a[i] / 6.0));
      v += 0.5 * dt_s * (a[i - 1] + a[i]);
    }
    return u;
  };
  const SlipResult r = slide_two_axis({dt_s, {x, y}}, {});
  EXPECT_TRUE(r.free_sliding);
  // Trailing zeros are trimmed: the last interval, down to zero, is the record's own.
  EXPECT_NEAR(r.residual.along_m, -roof_displacement_m(x), 1e-14);
  EXPECT_NEAR(r.residual.across_m, -roof_displacement_m(y), 1e-14);
}

}  // namespace two_axis_closed_form_test
}  // namespace glissade
