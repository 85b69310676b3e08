// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/block/each_solver.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace closed_form_test {

using test::for_each_solver;
using test::Solver;

constexpr double g = standard_gravity_mps2;

// Rodriguez-Nikl et al. (2019), "Physical checks", with the paper's numbers.

TEST(physical_check, one_holds_on_thirty_degrees_with_friction_one_until_shaken_loose) {
  for_each_solver([](const Solver& solver) {
    const Block block{1.0, 30 * rad_per_deg};
    EXPECT_EQ(solver.solve({0.01, std::vector<double>(100, 0.0)}, block).slip_phases, 0u);
    EXPECT_GT(solver.solve({0.01, std::vector<double>{0, -0.3 * g, 0}}, block).slip_phases,
              0u);  // a_d = g tan(30 - 45 deg) = -0.268 g
    EXPECT_EQ(solver.solve({0.01, std::vector<double>{0, -0.26 * g, 0}}, block).slip_phases, 0u);
  });
}

TEST(physical_check,
     two_slides_down_a_still_plane_by_half_the_net_acceleration_times_time_squared) {
  for_each_solver([](const Solver& solver) {
    const Block block{0.1, 7 * rad_per_deg};
    const SlipPeak r = solver.solve({0.01, std::vector<double>(1001, 0.0)}, block);  // 10 s
    const double along_slope =
        0.5 * g * (std::sin(block.slope_rad) - 0.1 * std::cos(block.slope_rad)) * 100.0;
    EXPECT_NEAR(r.residual.along_m, along_slope * std::cos(block.slope_rad), 1e-11);
    EXPECT_TRUE(r.free_sliding);
    EXPECT_EQ(r.slip_phases, 1u);
  });
}

TEST(physical_check, three_differs_between_slopes_of_plus_and_minus_four_degrees) {
  const auto a = test::made_up_record(1000, 1, g);  // not symmetric, peak 1 g as the paper's
  for_each_solver([&](const Solver& solver) {
    const SlipPeak plus = solver.solve({0.01, a}, {0.4, 4 * rad_per_deg});
    const SlipPeak minus = solver.solve({0.01, a}, {0.4, -4 * rad_per_deg});
    EXPECT_GT(std::min(plus.peak_displacement_m, minus.peak_displacement_m), 0.0);
    EXPECT_GT(std::abs(plus.peak_displacement_m / minus.peak_displacement_m - 1.0), 1e-3);
  });
}

TEST(physical_check, four_slides_just_below_the_critical_friction_and_not_at_it) {
  for_each_solver([](const Solver& solver) {
    const double slope = 0.5 * rad_per_deg;
    const std::vector<double> still(1000, 0.0);
    EXPECT_GT(solver.solve({0.01, still}, {0.999 * std::tan(slope), slope}).peak_displacement_m,
              0.0);
    EXPECT_EQ(solver.solve({0.01, still}, {std::tan(slope), slope}).peak_displacement_m, 0.0);
  });
}

// A ramp to A, a plateau and a ramp to zero on a flat roof: while it slides upslope (-x), v' = -(a
// - mu g). Slip starts at the yield crossing, and the block stops long after the pulse under mu g
// alone. All pieces are polynomials.
TEST(closed_form, trapezoidal_pulse_on_a_flat_roof) {
  for_each_solver([](const Solver& solver) {
    const double mu = 0.2, A = 4.0, dt = 0.1, yield = mu * g;
    const std::vector<double> pulse = {0.0, A, A, A, A, A, 0.0};
    const SlipPeak r = solver.solve({dt, pulse}, {.friction = mu});
    const double t_start = dt * yield / A;  // into the first interval
    const double rise = dt - t_start;       // drive goes from 0 to A - yield
    const double n = A - yield;
    double v = 0.5 * n * rise, s = n * rise * rise / 6;
    const double plateau = 4 * dt;
    s += v * plateau + 0.5 * n * plateau * plateau;
    v += n * plateau;
    const double k = -A / dt;  // the last ramp: drive from n to -yield
    s += v * dt + 0.5 * n * dt * dt + k * dt * dt * dt / 6;
    v += n * dt + 0.5 * k * dt * dt;
    ASSERT_GT(v, 0);
    s += v * v / (2 * yield);  // coasting
    EXPECT_NEAR(r.peak_upslope_m, s, 1e-14);
    EXPECT_NEAR(r.residual.along_m, -s, 1e-14);
    EXPECT_EQ(r.slip_phases, 1u);
    EXPECT_NEAR(r.slip_duration_s, rise + plateau + dt + v / yield, 1e-13);
  });
}

// The same pulse, of which slide() gives the velocity too: it gains n / 2 over the rise, n over the
// plateau and n^2 / (2 A / dt) until the last ramp passes the yield acceleration.
TEST(closed_form, trapezoidal_pulse_is_fastest_where_it_falls_through_the_yield) {
  const double A = 4.0, dt = 0.1, n = A - 0.2 * g, rise = dt * n / A;
  const std::vector<double> pulse = {0.0, A, A, A, A, A, 0.0};
  EXPECT_NEAR(slide({dt, pulse}, {.friction = 0.2}).peak_velocity_mps,
              0.5 * n * rise + n * 4 * dt + 0.5 * n * n / (A / dt), 1e-14);
}

// The same with the roof pressing the block down: w scales gravity, so yield grows to mu (g + w).
TEST(closed_form, constant_vertical_acceleration_acts_as_gravity) {
  for_each_solver([](const Solver& solver) {
    const std::vector<double> pulse = {0.0, 6.0, 6.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const std::vector<double> w(pulse.size(), 0.25 * g);
    Block heavy{.friction = 0.2, .slope_rad = 0.05};
    const SlipPeak lifted = solver.solve({0.01, pulse, w}, heavy);
    heavy.gravity_mps2 = 1.25 * g;
    const SlipPeak heavier = solver.solve({0.01, pulse}, heavy);
    EXPECT_NEAR(lifted.peak_displacement_m, heavier.peak_displacement_m, 1e-15);
  });
}

TEST(closed_form, a_frictionless_block_stays_where_it_is_in_space) {
  for_each_solver([](const Solver& solver) {
    // mu = 0, flat: displacement relative to the roof is minus the roof's own displacement, here
    // one full sine of velocity.
    const int n = 200;
    const double dt = 0.01;
    std::vector<double> a(n + 1);
    for (int i = 0; i <= n; ++i) a[i] = std::cos(2 * std::numbers::pi * i / n);
    double v = 0, u = 0;
    for (int i = 0; i <= n; ++i) {  // exact integration of the piecewise-linear record, the last
                                    // interval to zero included
      const double next = i < n ? a[i + 1] : 0.0;
      u += v * dt + dt * dt * (2 * a[i] + next) / 6;
      v += 0.5 * dt * (a[i] + next);
    }
    const SlipPeak r = solver.solve({dt, a}, {.friction = 0.0});
    EXPECT_NEAR(r.residual.along_m, -u, 1e-13);
    EXPECT_TRUE(r.free_sliding);
  });
}

}  // namespace closed_form_test
}  // namespace glissade
