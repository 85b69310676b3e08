// SPDX-License-Identifier: GPL-3.0-or-later
// Half sines and harmonics. A record is linear between its samples and a sine is not, so a result
// is of second order in the step, which is tested, and the value extrapolated from two steps is
// compared. Derivations in closed_forms/sine.hpp.
#include <gtest/gtest.h>

#include <cmath>

#include "closed_forms/measured.hpp"
#include "closed_forms/sine.hpp"
#include "unit/block/each_solver.hpp"

namespace glissade {
namespace closed_form_sine_test {

using namespace closed_forms;
using test::for_each_solver;
using test::Solver;

constexpr double g = standard_gravity_mps2;

/// Of second order: the error falls to a quarter when the step is halved (to half a per cent, for
/// the third order), and what is extrapolated is right to `tolerance`, relative.
template <class Result>
void expect_tends_to(double expected, const Result& result, int parts, double tolerance) {
  EXPECT_NEAR(extrapolated(result, parts), expected, tolerance * std::abs(expected));
  EXPECT_NEAR((result(parts) - expected) / (result(2 * parts) - expected), 4.0, 0.02);
}

TEST(half_sine, slides_from_the_arcsine_and_stops_inside_it_or_coasts) {
  const Block block{.friction = 0.3, .slope_rad = 5 * rad_per_deg};
  const Slider sliding = slider(block);
  for_each_solver([&](const Solver& solver) {
    for (const double eta : {0.1, 0.4, 0.7, 0.8, 0.9})  // 0.7246 parts the two
      for (const Against against : {Against::down, Against::up}) {
        const bool down = against == Against::down;
        const Way& way = down ? sliding.down : sliding.up;
        const HalfSine pulse{way.yield_mps2 / eta, 0.8};
        const auto residual = [&](int parts) {
          return under({0.8 / parts, pulse.alpha(parts)}, against, block, solver).residual.along_m;
        };
        SCOPED_TRACE(testing::Message() << "eta " << eta << (down ? " down" : " up"));
        expect_tends_to((down ? 1 : -1) * sliding.plan * slip(pulse, way), residual, 1000, 1e-8);
      }
  });
}

void expect_steady_drift(const Shaken& scene, Regime regime) {
  const SteadyState expected = scene.steady();
  ASSERT_EQ(expected.regime, regime);
  for_each_solver([&](const Solver& solver) {
    expect_tends_to(
        expected.drift_m(), [&](int parts) { return scene.drift_m(solver, parts); }, 500, 1e-7);
    EXPECT_NEAR(scene.sliding_s(solver, 1000), expected.sliding_s, 1e-5 * expected.sliding_s);
    EXPECT_FALSE(scene.after(solver, 2, 500).uplift);
  });
}

TEST(newmark_sine, slides_down_the_same_length_in_every_cycle_from_the_first) {
  for (const double slope_deg : {0.0, 4.0})
    for (const double amplitude_g : {0.35, 0.6, 2.0}) {
      const Block block{.friction = 0.3,
                        .slope_rad = slope_deg * rad_per_deg,
                        .directions = SlipDirections::downslope_only};
      const Shaken scene{{amplitude_g * g, 0.7}, block};
      Slider one_way = scene.sliding();
      one_way.up.yield_mps2 = 1e9;  // never
      const SteadyState expected = steady_state(scene.motion, one_way);
      ASSERT_EQ(expected.regime, Regime::one_way);
      SCOPED_TRACE(testing::Message() << slope_deg << " deg, " << amplitude_g << " g");
      for_each_solver([&](const Solver& solver) {
        // The record ends as slip of the last cycle may still go on, so cycles are differences.
        const auto cycle = [&](int n) {
          return [&, n](int parts) {
            return scene.after(solver, 2 * n + 2, parts).residual.along_m -
                   scene.after(solver, 2 * n, parts).residual.along_m;
          };
        };
        for (const int n : {1, 2, 7}) expect_tends_to(expected.drift_m(), cycle(n), 1000, 1e-7);
        EXPECT_EQ(scene.after(solver, 20, 100).slip_phases, 10u);
      });
    }
}

TEST(flat_roof_without_stops, has_westermo_and_udwadias_stroke_when_released_at_its_phase) {
  const Block block{.friction = 0.3};
  for (const double eta : {0.05, 0.2, 0.4, 0.52}) {
    Shaken scene{{0.3 * g / eta, 1.1}, block};
    ASSERT_EQ(scene.steady().regime, Regime::no_stop);
    scene.motion.phase = scene.steady().down_start;  // at rest there: steady from the beginning
    const double w = 2 * std::numbers::pi / 1.1;
    const double stroke = 2 * scene.motion.amplitude_mps2 / (w * w) *
                          std::sqrt(1 - std::pow(std::numbers::pi * eta / 2, 2));
    EXPECT_NEAR(scene.steady().strokes.down_m, stroke, 1e-13 * stroke);
    EXPECT_NEAR(scene.steady().strokes.up_m, stroke, 1e-13 * stroke);
    SCOPED_TRACE(eta);
    for_each_solver([&](const Solver& solver) {
      for (const int cycles : {1, 40})
        expect_tends_to(
            stroke,
            [&](int parts) { return scene.after(solver, 2 * cycles, parts).peak_downslope_m; },
            1000, 1e-7);
    });
  }
}

// The middle of the stroke depends on the start; two records, half a cycle apart in length, end on
// opposite sides of it.
TEST(flat_roof_without_stops, is_reached_from_rest_at_any_phase) {
  const Block block{.friction = 0.3};
  for (const double eta : {0.1, 0.3, 0.5}) {
    const Shaken scene{{0.3 * g / eta, 1.1}, block};
    ASSERT_EQ(scene.steady().regime, Regime::no_stop);
    SCOPED_TRACE(eta);
    for_each_solver([&](const Solver& solver) {
      const auto apart = [&](int parts) {
        return scene.after(solver, 201, parts).residual.along_m -
               scene.after(solver, 200, parts).residual.along_m;
      };
      expect_tends_to(2 * rest_beyond_middle(scene.motion, scene.sliding()), apart, 500, 1e-7);
    });
  }
}

TEST(flat_roof_with_stops, goes_one_stroke_down_and_the_same_back) {
  const Block block{.friction = 0.3};
  for (const double eta : {0.55, 0.7, 0.9}) {
    const Shaken scene{{0.3 * g / eta, 1.1}, block};
    const SteadyState expected = scene.steady();
    ASSERT_EQ(expected.regime, Regime::two_stops);
    EXPECT_NEAR(expected.strokes.up_m, expected.strokes.down_m, 1e-14);
    SCOPED_TRACE(eta);
    for_each_solver([&](const Solver& solver) {
      for (const int cycles : {1, 30})
        expect_tends_to(
            expected.strokes.down_m,
            [&](int parts) { return scene.after(solver, 2 * cycles, parts).peak_downslope_m; },
            1000, 1e-7);
      EXPECT_NEAR(scene.drift_m(solver, 1000), 0.0, 1e-13);
      EXPECT_EQ(scene.after(solver, 60, 1000).slip_phases, 60u);
      EXPECT_NEAR(scene.sliding_s(solver, 1000), expected.sliding_s, 1e-5);
    });
  }
}

// Whether it rests on either side: manual, 1.3.
TEST(flat_roof, stops_above_the_ratio_of_westermo_and_udwadia) {
  EXPECT_NEAR(flat_roof_stops_above(), 0.5370, 5e-5);  // 1 / sqrt(1 + pi^2 / 4)
}

TEST(slope_under_a_harmonic, drifts_down_one_way_while_the_upslope_yield_is_not_reached) {
  expect_steady_drift({{0.3 * g, 0.9}, {.friction = 0.3, .slope_rad = 5 * rad_per_deg}},
                      Regime::one_way);
}

TEST(slope_under_a_harmonic, drifts_down_one_way_while_it_slides_through_the_upslope_excursion) {
  expect_steady_drift({{0.7 * g, 0.9}, {.friction = 0.3, .slope_rad = 16 * rad_per_deg}},
                      Regime::one_way);
}

TEST(slope_under_a_harmonic, drifts_down_with_two_stops_a_cycle) {
  expect_steady_drift({{0.48 * g, 0.9}, {.friction = 0.3, .slope_rad = 5 * rad_per_deg}},
                      Regime::two_stops);
}

TEST(slope_under_a_harmonic, drifts_down_with_one_stop_a_cycle) {
  expect_steady_drift({{0.55 * g, 0.9}, {.friction = 0.3, .slope_rad = 5 * rad_per_deg}},
                      Regime::one_stop);
}

TEST(slope_under_a_harmonic, drifts_down_without_stops) {
  expect_steady_drift({{1.2 * g, 0.9}, {.friction = 0.3, .slope_rad = 5 * rad_per_deg}},
                      Regime::no_stop);
}

TEST(flat_roof_with_vertical_in_phase, drifts_to_where_it_is_lighter) {
  expect_steady_drift({{0.35 * g, 0.9}, {.friction = 0.3}, 0.667}, Regime::one_way);
  expect_steady_drift({{0.45 * g, 0.9}, {.friction = 0.3}, 0.667}, Regime::two_stops);
  expect_steady_drift({{1.2 * g, 0.9}, {.friction = 0.3}, 0.667}, Regime::no_stop);
}

TEST(slope_with_vertical_in_phase, drifts_as_its_two_ways_say) {
  expect_steady_drift({{0.9 * g, 0.9}, {.friction = 0.4, .slope_rad = 7 * rad_per_deg}, 0.5},
                      Regime::one_stop);
  expect_steady_drift({{0.9 * g, 0.9}, {.friction = 0.4, .slope_rad = 7 * rad_per_deg}, -0.5},
                      Regime::no_stop);
}

}  // namespace closed_form_sine_test
}  // namespace glissade
