// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/slide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/block/reference.hpp"

namespace glissade {
namespace slide_test {

using test::made_up_record;
using test::Reference;

constexpr double g = standard_gravity_mps2;

void expect_same(const SlipResult& a, const SlipResult& b) {
  EXPECT_EQ(a.peak_displacement_m, b.peak_displacement_m);
  EXPECT_EQ(a.residual.along_m, b.residual.along_m);
  EXPECT_EQ(a.peak_downslope_m, b.peak_downslope_m);
  EXPECT_EQ(a.peak_upslope_m, b.peak_upslope_m);
  EXPECT_EQ(a.peak_velocity_mps, b.peak_velocity_mps);
  EXPECT_EQ(a.slip_duration_s, b.slip_duration_s);
  EXPECT_EQ(a.slip_phases, b.slip_phases);
  EXPECT_EQ(a.uplift, b.uplift);
  EXPECT_EQ(a.free_sliding, b.free_sliding);
}

/// Largest difference of any result from fifty digits, relative to the largest slip (velocity and
/// duration to their own size). NaN stays NaN. Zero where nothing moves.
double error_against_fifty_digits(const RoofAcceleration& roof, const Block& block) {
  const SlipResult r = slide(roof, block);
  const Reference exact(roof, block);
  EXPECT_EQ(r.uplift, exact.uplift);
  const double down = static_cast<double>(exact.down), up = static_cast<double>(exact.up);
  const double size = std::max(down, up);
  if (size == 0) return r.peak_displacement_m;
  double worst = 0;
  for (const double difference :
       {(r.residual.along_m - static_cast<double>(exact.slip)) / size,
        (r.peak_downslope_m - down) / size, (r.peak_upslope_m - up) / size,
        r.peak_velocity_mps / static_cast<double>(exact.peak_velocity) - 1}) {
    if (!(std::abs(difference) <= worst)) worst = std::abs(difference);
  }
  return worst;
}

TEST(slide, agrees_with_fifty_digits_to_1e_12_over_scales_frictions_slopes_and_vertical) {
  int slid = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto a = made_up_record(1200, seed, 6.0), w = made_up_record(1200, seed + 100, 3.0);
    for (const double scale : {0.4, 1.0, 2.0}) {
      for (const double mu : {0.0, 0.1, 0.3, 0.5, 0.7}) {
        for (const double slope_deg : {0.0, 1.19, 4.0, 7.0, 30.0}) {
          for (const bool vertical : {false, true}) {
            const RoofAcceleration roof{
                0.005, a, vertical ? std::span<const double>(w) : std::span<const double>(), scale,
                scale};
            const Block block{mu, slope_deg * rad_per_deg};
            EXPECT_LE(error_against_fifty_digits(roof, block), 1e-12);
            slid += slide(roof, block).slip_phases > 0 ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(slid, 300);
}

TEST(slide, agrees_with_fifty_digits_where_the_block_lifts_off_and_lands) {
  int lifted = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const auto a = made_up_record(600, seed, 15.0), w = made_up_record(600, seed + 100, 25.0);
    for (const double mu : {0.1, 0.5}) {
      for (const double slope_deg : {0.0, 7.0, 40.0}) {
        const RoofAcceleration roof{0.005, a, w};
        const Block block{mu, slope_deg * rad_per_deg};
        EXPECT_LE(error_against_fifty_digits(roof, block), 1e-12);
        lifted += slide(roof, block).uplift ? 1 : 0;
      }
    }
  }
  EXPECT_GT(lifted, 20);
}

// Records rounded to 0.01 g with mu a multiple of 0.05: samples lie exactly on the thresholds,
// where a phase may start at the last instant of an interval and end at the first of the next.
TEST(slide, agrees_with_fifty_digits_where_samples_lie_on_the_thresholds) {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    std::mt19937 generator(seed);
    std::vector<double> a(40);
    for (double& sample : a) sample = g * (static_cast<double>(generator() % 61) - 30) / 100;
    for (const double mu : {0.05, 0.1, 0.2}) {
      EXPECT_LE(error_against_fifty_digits({0.01, a}, {.friction = mu}), 1e-12)
          << "seed " << seed << ", mu " << mu;
    }
  }
  // A case that once gave NaN: a sample on the threshold, held by the next.
  const std::vector<double> a = {0.45 * g, -0.1 * g, 0.1 * g,  0.0,      -0.5 * g,
                                 -0.5 * g, -0.5 * g, -0.5 * g, -0.5 * g, 0.0};
  const SlipResult r = slide({0.01, a}, {.friction = 0.1});
  EXPECT_NEAR(r.peak_displacement_m, 0.0234, 5e-5);  // its neighbour off the threshold
}

TEST(slide, stays_put_when_the_peak_is_below_yield) {
  const auto a = made_up_record(500, 3, 0.299 * g);
  const SlipResult r = slide({0.01, a}, {.friction = 0.3});
  EXPECT_EQ(r.peak_displacement_m, 0.0);
  EXPECT_EQ(r.slip_phases, 0u);
  const auto b = made_up_record(500, 3, 0.301 * g);
  EXPECT_GT(slide({0.01, b}, {.friction = 0.3}).peak_displacement_m, 0.0);
}

TEST(slide, flags_uplift_and_takes_no_friction_from_a_lifted_block) {
  // The roof falls faster than g for half a second while it accelerates sideways: relative
  // acceleration is -a exactly.
  std::vector<double> a(51, 1.0), w(51, -2 * g);
  const SlipResult r = slide({0.01, a, w}, {.friction = 0.5});
  EXPECT_TRUE(r.uplift);
  EXPECT_GT(r.peak_upslope_m, 0.5 * 1.0 * 0.5 * 0.5 * (1 - 1e-12));
  EXPECT_FALSE(slide({0.01, a}, {.friction = 0.5}).uplift);
  // On a steep slope a horizontal acceleration alone can lift: N/m = g cos + a sin < 0.
  const std::vector<double> away = {0.0, -1.01 * g / std::tan(0.5), 0.0};
  EXPECT_TRUE(slide({0.01, away}, {0.9, 0.5}).uplift);
  const std::vector<double> nearly = {0.0, -0.99 * g / std::tan(0.5), 0.0};
  EXPECT_FALSE(slide({0.01, nearly}, {0.9, 0.5}).uplift);
}

TEST(slide, records_a_history_that_ends_where_the_result_says) {
  const auto a = made_up_record(900, 15, 8.0);
  std::vector<SlipPoint> history;
  const SlipResult r = slide({0.01, a}, {0.2, 3 * rad_per_deg}, history);
  expect_same(r, slide({0.01, a}, {0.2, 3 * rad_per_deg}));
  EXPECT_EQ(history.front().time_s, 0.0);
  EXPECT_EQ(history.back().velocity_mps, 0.0);
  EXPECT_DOUBLE_EQ(history.back().displacement_m, r.residual.along_m);
  double peak = 0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    EXPECT_GE(history[i].time_s, history[i - 1].time_s);
    peak = std::max(peak, std::abs(history[i].displacement_m));
  }
  EXPECT_DOUBLE_EQ(peak, r.peak_displacement_m);
}

TEST(cannot_slip, never_says_so_of_a_block_that_slips) {
  int sticking = 0, slipped = 0;
  for (unsigned seed = 1; seed < 30; ++seed) {
    const auto a = made_up_record(300, seed, 3.0), w = made_up_record(300, seed + 50, 1.5);
    for (const double mu : {0.2, 0.3, 0.4, 0.6}) {
      const Block block{mu, 2 * rad_per_deg};
      const SlipResult r = slide({0.01, a, w}, block);
      if (cannot_slip(block, 3.0, 1.5)) {
        ++sticking;
        EXPECT_EQ(r.slip_phases, 0u);
      } else if (r.slip_phases > 0) {
        ++slipped;
      }
    }
  }
  EXPECT_GT(sticking, 10);
  EXPECT_GT(slipped, 10);
}

TEST(yield_acceleration, is_where_slip_begins) {
  const Block block{0.4, 4 * rad_per_deg};
  const double yield = yield_acceleration_mps2(block);
  EXPECT_NEAR(yield, g * std::tan(std::atan(0.4) - 4 * rad_per_deg), 1e-12);
  const std::vector<double> pulse = {0.0, -1.0,
                                     0.0};  // the roof jerks upslope: the block slips down
  EXPECT_EQ(slide({0.01, pulse, {}, yield * (1 - 1e-9)}, block).slip_phases, 0u);
  EXPECT_EQ(slide({0.01, pulse, {}, yield * (1 + 1e-9)}, block).slip_phases, 1u);
}

// Both found by fuzzing.
TEST(slide, history_never_goes_back_in_time) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto a = made_up_record(300, seed, 8.0), w = made_up_record(300, seed + 50, 14.0);
    for (const double slope : {0.0, 0.3}) {
      std::vector<SlipPoint> history;
      slide({0.0123, a, w}, {.friction = 0.1, .slope_rad = slope}, history);
      for (std::size_t i = 1; i < history.size(); ++i)
        ASSERT_GE(history[i].time_s, history[i - 1].time_s) << seed;
    }
  }
}

TEST(slide, one_way_never_goes_upslope_however_small_the_motion) {
  for (const double peak : {1e-150, 1e-160, 1e-200, 1e-300}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const auto a = made_up_record(200, seed, peak);
      const SlipResult r =
          slide({0.01, a}, {.friction = 0.0, .directions = SlipDirections::downslope_only});
      EXPECT_EQ(r.peak_upslope_m, 0.0);
      EXPECT_GE(r.residual.along_m, 0.0);
    }
  }
}

}  // namespace slide_test
}  // namespace glissade
