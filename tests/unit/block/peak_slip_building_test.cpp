// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "glissade/block/peak_slip.hpp"
#include "unit/block/oscillator_reference.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace peak_slip_building_test {

using test::made_up_record;
using test::OscillatorReference;

struct Errors {
  double largest = 0.0;
  int count = 0;
};

/// The kernel on an oscillator against the closed form between samples.
Errors errors(double dt_s, double period_s, double damping) {
  Errors found;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const auto a = made_up_record(700, seed, 5.0);
    const RoofMotionOptions follow{.quiet_horizontal_mps2 = 0.2, .settle_deceleration_mps2 = 0.5};
    const RoofTable roof = tabulate_roof({dt_s, a}, {.horizontal = {period_s, damping}}, follow);
    const MotionTable& table = *roof.horizontal;
    const double ring_down_s =
        static_cast<double>(table.end - table.ground->quiet_from()) * table.step_s();
    for (const double mu : {0.1, 0.3}) {
      for (const double slope_deg : {0.0, 4.0}) {
        const Block block{.friction = mu, .slope_rad = slope_deg * rad_per_deg};
        const OscillatorReference exact(dt_s, a, period_s, damping, 1.5, block, ring_down_s, 24);
        if (exact.down == 0.0 && exact.up == 0.0) continue;
        const double size = std::max({exact.down, exact.up, 1e-3});
        const SlipPeak r = peak_slip(roof, block, {1.5, 0.0});
        found.largest = std::max({found.largest, std::abs(r.peak_downslope_m - exact.down) / size,
                                  std::abs(r.peak_upslope_m - exact.up) / size});
        ++found.count;
      }
    }
  }
  return found;
}

// The goal: below 1e-6 at dt = 0.01 s and T = 0.2 s.
TEST(peak_slip_on_a_building, agrees_with_the_closed_form_between_samples_to_1e_6) {
  for (const double period : {0.17, 0.2, 0.5, 1.5}) {
    const Errors e = errors(0.01, period, 0.05);
    EXPECT_GE(e.count, 6) << period;
    EXPECT_LT(e.largest, 1e-6) << period;
    RecordProperty("largest_at_" + std::to_string(static_cast<int>(1000 * period)) + "_ms",
                   std::to_string(e.largest));
  }
}

TEST(peak_slip_on_a_building, refines_its_tables_only_where_the_period_is_short) {
  EXPECT_EQ(parts_needed({0.2, 0.05}, 0.01), 1);
  EXPECT_EQ(parts_needed({0.1, 0.05}, 0.01), 2);
  EXPECT_EQ(parts_needed({0.02, 0.05}, 0.01), 8);
  EXPECT_EQ(parts_needed({1e-4, 0.05}, 0.01), 0);  // no cut does
  for (const double period : {0.02, 0.05, 0.1}) {
    const Errors e = errors(0.01, period, 0.05);
    EXPECT_GE(e.count, 6) << period;
    EXPECT_LT(e.largest, 1e-6) << period;
  }
}

TEST(peak_slip_on_a_building, agrees_for_any_damping) {
  for (const double damping : {0.005, 0.3, 0.9, 1.0, 2.0}) {
    EXPECT_LT(errors(0.01, 0.4, damping).largest, 1e-6) << damping;
  }
}

TEST(peak_slip_on_a_building, misses_no_excursion_between_samples) {
  // Twenty samples a period: the peak of a free vibration falls between two of them. The threshold
  // is above every sample and below the peak.
  const std::vector<double> pulse{0.0, 3.0, 0.0};
  const RoofTable roof =
      tabulate_roof({0.01, pulse}, {.horizontal = {0.2, 0.02}}, {.quiet_horizontal_mps2 = 0.01});
  const MotionTable& table = *roof.horizontal;
  const MotionNodes at = table.at_nodes();
  double at_samples = 0;
  for (std::size_t i = 0; i <= table.end; ++i)
    at_samples = std::max(at_samples, std::abs(at.acceleration_mps2(i)));
  const double peak = peak_acceleration_mps2(table);
  ASSERT_GT(peak, at_samples * (1 + 1e-5));
  const double g = standard_gravity_mps2;
  for (const double share : {0.01, 0.5, 0.99}) {
    const Block block{.friction = (at_samples + share * (peak - at_samples)) / g};
    const SlipPeak slip = peak_slip(roof, block);
    EXPECT_GT(slip.peak_displacement_m, 0.0);
    EXPECT_EQ(slip.slip_phases, 1u);
  }
  EXPECT_EQ(peak_slip(roof, {.friction = peak * (1 + 1e-9) / g}).slip_phases, 0u);
}

TEST(peak_slip_on_a_building, passes_nothing_over_that_looking_into_every_interval_would_find) {
  const auto a = made_up_record(700, 5, 5.0), w = made_up_record(700, 6, 9.0);
  const RoofMotionOptions follow{.quiet_horizontal_mps2 = 0.1, .settle_deceleration_mps2 = 0.2};
  int lifted = 0;
  for (const double up_period : {0.0, 0.1}) {
    const RoofTable roof = tabulate_roof(
        {0.01, a, w}, {.horizontal = {0.35, 0.05}, .vertical = {up_period, 0.05}}, follow);
    for (const double factor : {0.2, 1.0, 3.0}) {
      for (const double mu : {0.0, 0.1, 0.5}) {
        for (const double slope_deg : {-20.0, 0.0, 3.0}) {
          const Block block{.friction = mu, .slope_rad = slope_deg * rad_per_deg};
          const SlipPeak one = peak_slip(roof, block, {factor, factor});
          const SlipPeak other =
              peak_slip(roof, block, {factor, factor}, EventSearch::every_interval);
          EXPECT_EQ(one.peak_displacement_m, other.peak_displacement_m);
          EXPECT_EQ(one.residual.along_m, other.residual.along_m);
          EXPECT_EQ(one.slip_phases, other.slip_phases);
          EXPECT_EQ(one.uplift, other.uplift);
          lifted += one.uplift ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(lifted, 5);
}

}  // namespace peak_slip_building_test
}  // namespace glissade
