// SPDX-License-Identifier: GPL-3.0-or-later
// Pulses that are linear between samples: no error but rounding. Derivations in
// closed_forms/pulses.hpp.
#include <gtest/gtest.h>

#include <cmath>

#include "closed_forms/measured.hpp"
#include "closed_forms/pulses.hpp"
#include "unit/block/each_solver.hpp"

namespace glissade {
namespace closed_form_pulses_test {

using namespace closed_forms;
using test::for_each_solver;
using test::Solver;

constexpr double g = standard_gravity_mps2;
constexpr double rounding = 1e-13;  // relative

const std::vector<Block> blocks = {{.friction = 0.2},
                                   {.friction = 0.5},
                                   {.friction = 0.3, .slope_rad = 4 * rad_per_deg},
                                   {.friction = 0.2, .slope_rad = 10 * rad_per_deg}};

template <class Check>
void for_each_scene(const Check& check) {
  for_each_solver([&](const Solver& solver) {
    for (const Block& block : blocks) {
      SCOPED_TRACE(testing::Message()
                   << "mu " << block.friction.along << ", slope " << block.slope_rad);
      check(solver, block, slider(block));
    }
  });
}

void expect_relative(double value, double expected) {
  EXPECT_NEAR(value, expected, rounding * std::abs(expected));
}

/// One pulse against either way: a single slip of this length along the slope, in plan.
template <class Pulse>
void expect_single_slips(const Pulse& pulse, const Solver& solver, Block block,
                         const Slider& sliding) {
  const std::vector<double> alpha = pulse.alpha();
  const double down = sliding.plan * slip(pulse, sliding.down);
  for (const SlipDirections directions : {SlipDirections::both, SlipDirections::downslope_only}) {
    block.directions = directions;
    const SlipPeak r = under({pulse.dt_s, alpha}, Against::down, block, solver);
    expect_relative(r.residual.along_m, down);
    expect_relative(r.peak_displacement_m, down);
    EXPECT_EQ(r.slip_phases, 1u);
  }
  EXPECT_EQ(under({pulse.dt_s, alpha}, Against::up, block, solver).slip_phases,
            0u);  // does not slide upslope
  block.directions = SlipDirections::both;
  const SlipPeak r = under({pulse.dt_s, alpha}, Against::up, block, solver);
  expect_relative(r.residual.along_m, -sliding.plan * slip(pulse, sliding.up));
  expect_relative(r.peak_upslope_m, sliding.plan * slip(pulse, sliding.up));
  EXPECT_EQ(r.slip_phases, 1u);
}

/// A cycle that slides down and then up; and only down, where up is forbidden.
template <class Cycle>
void expect_both_strokes(const Cycle& cycle, const Solver& solver, Block block,
                         const Strokes& expected) {
  const std::vector<double> alpha = cycle.alpha();
  const double larger = std::max(expected.down_m, expected.up_m);
  const SlipPeak both = under({cycle.first.dt_s, alpha}, Against::down, block, solver);
  EXPECT_NEAR(both.residual.along_m, expected.down_m - expected.up_m, rounding * larger);
  expect_relative(both.peak_downslope_m, expected.down_m);
  EXPECT_NEAR(both.peak_upslope_m, std::max(0.0, expected.up_m - expected.down_m),
              rounding * larger);
  EXPECT_EQ(both.slip_phases, 2u);
  block.directions = SlipDirections::downslope_only;
  const SlipPeak one = under({cycle.first.dt_s, alpha}, Against::down, block, solver);
  expect_relative(one.residual.along_m, expected.down_m);
  EXPECT_EQ(one.slip_phases, 1u);
}

TEST(rectangular_pulse, slides_by_half_k_A_over_y_times_A_less_y_times_its_duration_squared) {
  for_each_scene([](const Solver& solver, const Block& block, const Slider& sliding) {
    for (const double excess : {1.01, 1.5, 4.0})
      for (const int on : {60, 400})
        expect_single_slips(RectangularPulse{excess * sliding.up.yield_mps2, 0.002, on}, solver,
                            block, sliding);
  });
}

TEST(rectangular_cycle, slides_down_and_at_once_back_up) {
  for_each_scene([](const Solver& solver, const Block& block, const Slider& sliding) {
    for (const double excess : {1.1, 2.0})
      for (const int back : {27, 40}) {
        const RectangularCycle cycle{{excess * sliding.up.yield_mps2, 0.02, 20}, back};
        expect_both_strokes(cycle, solver, block, strokes(cycle, sliding));
      }
  });
}

TEST(triangular_pulse, stops_on_its_falling_side_when_low_and_long_after_it_when_high) {
  for_each_scene([](const Solver& solver, const Block& block, const Slider& sliding) {
    for (const double excess : {1.05, 1.2, 1.5, 3.0, 10.0})
      for (const int fall : {2, 5, 30})
        expect_single_slips(TriangularPulse{excess * sliding.up.yield_mps2, 0.03, 5, fall}, solver,
                            block, sliding);
  });
}

TEST(triangular_cycle, slides_down_and_back_up_with_and_without_a_rest_between) {
  int at_once = 0, after_rest = 0;
  for_each_scene([&](const Solver& solver, const Block& block, const Slider& sliding) {
    for (const double excess : {1.02, 1.3, 2.0, 5.0}) {
      const TriangularCycle cycle{{excess * sliding.up.yield_mps2, 0.01, 1, 40}, 12};
      ++(reverses_at_once(cycle, sliding) ? at_once : after_rest);
      expect_both_strokes(cycle, solver, block, strokes(cycle, sliding));
    }
  });
  EXPECT_GT(at_once, 0);
  EXPECT_GT(after_rest, 0);
}

// Newmark (1965), a rectangular pulse of A g over D: V^2 / (2 g N) (1 - N / A), V = A g D.
TEST(rectangular_pulse, gives_newmarks_standardised_displacement) {
  const double D = 0.505, A = 0.5, N = 0.2, V = A * g * D;
  const double newmark = V * V / (2 * g * N) * (1 - N / A);
  const RectangularPulse pulse{A * g, 0.01, 50};
  // the last ramp moves the block A dt^2 / 24 less than a jump
  EXPECT_NEAR(slip(pulse, slider({.friction = N}).down), newmark - A * g * 1e-4 / 24, 1e-15);
}

}  // namespace closed_form_pulses_test
}  // namespace glissade
