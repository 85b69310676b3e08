// SPDX-License-Identifier: GPL-3.0-or-later
// When and how fast a block gets somewhere: closed forms, 50 digits, and both solvers side by side.
#include "glissade/block/crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "closed_forms/pulses.hpp"
#include "glissade/block/peak_slip.hpp"
#include "unit/block/crossings.hpp"
#include "unit/block/oscillator_reference.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace crossing_test {

using test::expect_alike;
using test::made_up_record;
using test::thresholds_of;

struct Crossed {
  double peak_m;
  std::vector<Crossing> at;
};

Crossed by_slide(const RoofAcceleration& roof, const Block& block,
                 const std::vector<double>& thresholds_m) {
  Crossed r{0.0, std::vector<Crossing>(thresholds_m.size())};
  r.peak_m = slide(roof, block, thresholds_m, r.at).peak_displacement_m;
  return r;
}

Crossed by_kernel(const RoofAcceleration& roof, const Block& block,
                  const std::vector<double>& thresholds_m,
                  EventSearch search = EventSearch::bounds) {
  const RoofTable table(roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2);
  Crossed r{0.0, std::vector<Crossing>(thresholds_m.size())};
  r.peak_m = peak_slip(table, block, {roof.horizontal_factor, roof.vertical_factor}, thresholds_m,
                       r.at, search)
                 .peak_displacement_m;
  return r;
}

void expect_same_bits(const Crossed& a, const Crossed& b) {
  EXPECT_EQ(a.peak_m, b.peak_m);
  ASSERT_EQ(a.at.size(), b.at.size());
  for (std::size_t i = 0; i < a.at.size(); ++i) {
    ASSERT_EQ(a.at[i].happens(), b.at[i].happens());
    if (!a.at[i].happens()) continue;
    EXPECT_EQ(a.at[i].time_s, b.at[i].time_s);
    EXPECT_EQ(a.at[i].speed_mps, b.at[i].speed_mps);
  }
}

// Under a rectangular pulse the block gains k (A - y) in speed until about D and loses k y after
// it, so that s = k (A - y) t^2 / 2 on the way up and v^2 = 2 k y (S - s) on the way down.
TEST(crossing, of_a_rectangular_pulse_is_that_of_constant_acceleration_and_deceleration) {
  const closed_forms::RectangularPulse pulse{6.0, 0.01, 40};
  for (const Block& block : {Block{.friction = 0.2}, Block{.friction = 0.3, .slope_rad = 0.07}}) {
    const closed_forms::Slider slider = closed_forms::slider(block);
    const auto [k, y] = slider.down;
    const double gain = k * (pulse.amplitude_mps2 - y), loss = k * y, plan = slider.plan;
    const double all = slip(pulse, slider.down), on_s = pulse.on * pulse.dt_s;
    const double stop_s = pulse.duration_s() * (1.0 + gain / loss);
    const std::vector<double> alpha = pulse.alpha();
    const RoofAcceleration roof{
        .dt_s = pulse.dt_s, .horizontal_mps2 = alpha, .horizontal_factor = -1.0};
    const std::vector<double> before{1e-9, 0.01, 0.5 * gain * on_s * on_s * 0.999},
        after{0.6 * all, 0.8 * all, 0.999 * all};
    std::vector<double> thresholds;
    for (const double s : before) thresholds.push_back(s * plan);
    for (const double s : after) thresholds.push_back(s * plan);
    for (const Crossed& r :
         {by_slide(roof, block, thresholds), by_kernel(roof, block, thresholds)}) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(r.at[i].time_s, std::sqrt(2.0 * before[i] / gain), 1e-14);
        EXPECT_NEAR(r.at[i].speed_mps, plan * std::sqrt(2.0 * gain * before[i]), 1e-13);
      }
      for (std::size_t i = 0; i < after.size(); ++i) {
        const double speed = std::sqrt(2.0 * loss * (all - after[i]));
        EXPECT_NEAR(r.at[before.size() + i].speed_mps, plan * speed, 1e-12);
        EXPECT_NEAR(r.at[before.size() + i].time_s, stop_s - speed / loss, 1e-12);
      }
    }
    // Met only as it stops.
    const double peak_m = slide(roof, block).peak_displacement_m;
    EXPECT_NEAR(by_slide(roof, block, {peak_m}).at[0].time_s, stop_s, 1e-13);
    EXPECT_EQ(by_slide(roof, block, {peak_m}).at[0].speed_mps, 0.0);
    const double kernels_m = by_kernel(roof, block, {1.0}).peak_m;
    EXPECT_NEAR(by_kernel(roof, block, {kernels_m}).at[0].time_s, stop_s, 1e-13);
    EXPECT_NEAR(by_kernel(roof, block, {kernels_m}).at[0].speed_mps, 0.0, 1e-17);
  }
}

struct Scene {
  RoofAcceleration roof;
  Block block;
};

/// Scales, frictions and slopes both ways, without uplift and with it.
template <class Visit>
void for_each_scene(const std::vector<double>& slopes_deg, Visit visit) {
  for (const unsigned seed : {11u, 12u}) {
    const auto a = made_up_record(500, seed, 6.0), w = made_up_record(500, seed + 100, 8.0);
    for (const bool vertical : {false, true}) {
      for (const double scale : {0.6, 2.5}) {
        for (const double mu : {0.05, 0.4}) {
          for (const double slope_deg : slopes_deg) {
            RoofAcceleration roof{0.01, a, {}, scale, 0.7 * scale};
            if (vertical) roof.vertical_mps2 = w;
            visit(Scene{roof, {.friction = mu, .slope_rad = slope_deg * rad_per_deg}});
          }
        }
      }
    }
  }
}

TEST(crossing, agrees_with_fifty_digits) {
  int crossed = 0, lifted = 0;
  for_each_scene({-7.0, 0.0, 1.19}, [&](const Scene& s) {
    const SlipResult r = slide(s.roof, s.block);
    if (r.peak_displacement_m < 1e-6) return;
    lifted += r.uplift ? 1 : 0;
    const std::vector<double> thresholds = thresholds_of(r.peak_displacement_m);
    const test::Reference exact(s.roof, s.block, thresholds);
    const Crossed scalar = by_slide(s.roof, s.block, thresholds),
                  kernel = by_kernel(s.roof, s.block, thresholds);
    for (std::size_t i = 0; i < exact.crossing_s.size(); ++i) {
      if (thresholds[i] == r.peak_displacement_m) continue;  // a matter of the last bit
      const Crossing expected{static_cast<double>(exact.crossing_s[i]),
                              static_cast<double>(exact.crossing_mps[i])};
      expect_alike(scalar.at[i], expected, 1e-12 * r.peak_displacement_m);
      expect_alike(kernel.at[i], expected, 1e-12 * r.peak_displacement_m);
      ++crossed;
    }
  });
  EXPECT_GT(crossed, 250);
  EXPECT_GT(lifted, 3);
}

TEST(crossing, happens_exactly_where_the_peak_is_at_least_the_threshold) {
  for_each_scene({-7.0, 0.0, 30.0}, [&](const Scene& s) {
    for (const bool scalar : {false, true}) {
      const auto solve = [&](const std::vector<double>& thresholds) {
        return scalar ? by_slide(s.roof, s.block, thresholds)
                      : by_kernel(s.roof, s.block, thresholds);
      };
      const double peak_m = solve({}).peak_m, above_m = std::nextafter(peak_m, 1e9);
      if (peak_m == 0.0) continue;
      const Crossed r = solve({std::nextafter(peak_m, 0.0), peak_m, above_m});
      EXPECT_EQ(r.peak_m, peak_m);
      EXPECT_TRUE(r.at[0].happens() && r.at[1].happens());
      EXPECT_FALSE(r.at[2].happens());
      EXPECT_TRUE(std::isnan(r.at[2].speed_mps));
      const Crossed below = solve(thresholds_of(peak_m));
      EXPECT_TRUE(
          std::is_sorted(below.at.begin(), below.at.end() - 1,
                         [](const Crossing& x, const Crossing& y) { return x.time_s < y.time_s; }));
    }
  });
}

TEST(crossing, is_the_same_to_the_bit_looking_into_every_interval) {
  for_each_scene({-7.0, 0.0, 1.19, 30.0}, [&](const Scene& s) {
    const std::vector<double> thresholds = thresholds_of(by_kernel(s.roof, s.block, {}).peak_m);
    if (thresholds.front() == 0.0) return;
    expect_same_bits(by_kernel(s.roof, s.block, thresholds),
                     by_kernel(s.roof, s.block, thresholds, EventSearch::every_interval));
  });
}

TEST(crossing, of_the_mirror_image_is_the_same) {
  for_each_scene({0.0, 4.0}, [&](const Scene& s) {
    const std::vector<double> thresholds = thresholds_of(by_kernel(s.roof, s.block, {}).peak_m);
    if (thresholds.front() == 0.0) return;
    Scene mirror = s;
    mirror.roof.horizontal_factor *= -1.0;
    mirror.block.slope_rad *= -1.0;
    expect_same_bits(by_slide(mirror.roof, mirror.block, thresholds),
                     by_slide(s.roof, s.block, thresholds));
    expect_same_bits(by_kernel(mirror.roof, mirror.block, thresholds),
                     by_kernel(s.roof, s.block, thresholds));
  });
}

// Accelerations, gravity and thresholds times lambda: speeds too, at the same times.
TEST(crossing, scales_with_the_whole_acceleration_field) {
  for_each_scene({0.0, 4.0}, [&](const Scene& s) {
    for (const auto solve : {+[](const Scene&of, const std::vector<double>&thresholds) {
                               return by_slide(of.roof, of.block, thresholds);
                             },
                             +[](const Scene&of, const std::vector<double>&thresholds) {
                               return by_kernel(of.roof, of.block, thresholds);
                             }}) {
      std::vector<double> thresholds = thresholds_of(solve(s, {}).peak_m);
      if (thresholds.front() == 0.0) continue;
      Crossed expected = solve(s, thresholds);
      constexpr double lambda = 16.0;
      for (Crossing& c : expected.at) c.speed_mps *= lambda;
      expected.peak_m *= lambda;
      for (double& threshold : thresholds) threshold *= lambda;
      Scene scaled = s;
      scaled.roof.horizontal_factor *= lambda;
      scaled.roof.vertical_factor *= lambda;
      scaled.block.gravity_mps2 *= lambda;
      expect_same_bits(solve(scaled, thresholds), expected);
    }
  });
}

// As peak_slip's own: what is left is the tables' quintic between nodes.
TEST(crossing, on_a_building_agrees_with_the_closed_form_between_samples) {
  int crossed = 0;
  for (const double period_s : {0.2, 0.5}) {
    const auto a = made_up_record(700, 1, 5.0);
    const RoofMotionOptions follow{.quiet_horizontal_mps2 = 0.2, .settle_deceleration_mps2 = 0.5};
    const RoofTable roof = tabulate_roof({0.01, a}, {.horizontal = {period_s, 0.05}}, follow);
    const MotionTable& table = *roof.horizontal;
    const double ring_down_s =
        static_cast<double>(table.end - table.ground->quiet_from()) * table.step_s();
    for (const double mu : {0.1, 0.3}) {
      const Block block{.friction = mu, .slope_rad = 0.05};
      const double peak_m = peak_slip(roof, block, {1.5, 0.0}).peak_displacement_m;
      if (peak_m < 1e-3) continue;
      const std::vector<double> thresholds = thresholds_of(peak_m);
      const test::OscillatorReference exact(0.01, a, period_s, 0.05, 1.5, block, ring_down_s, 24,
                                            thresholds);
      std::vector<Crossing> bounds(thresholds.size()), every = bounds;
      peak_slip(roof, block, {1.5, 0.0}, thresholds, bounds);
      peak_slip(roof, block, {1.5, 0.0}, thresholds, every, EventSearch::every_interval);
      expect_same_bits({peak_m, bounds}, {peak_m, every});
      for (std::size_t i = 0; i < exact.crossings.size(); ++i) {
        if (thresholds[i] == peak_m) continue;
        expect_alike(bounds[i], exact.crossings[i], 1e-6 * peak_m);
        ++crossed;
      }
    }
  }
  EXPECT_GE(crossed, 24);
}

}  // namespace crossing_test
}  // namespace glissade
