// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/peak_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/block/reference.hpp"
#include "unit/block/solvers.hpp"

namespace glissade {
namespace peak_slip_test {

using test::made_up_record;
using test::Reference;

struct Scene {
  RoofAcceleration roof;
  Block block;
};

/// Records of the given seeds at several scales on flat and sloping roofs, both ways.
template <class Visit>
void for_each_scene(bool vertical, Visit visit) {
  for (const unsigned seed : {11u, 12u}) {
    const auto a = made_up_record(900, seed, 6.0), w = made_up_record(900, seed + 100, 3.0);
    for (const double scale : {0.3, 1.0, 2.5}) {
      for (const double mu : {0.05, 0.3, 0.7}) {
        for (const double slope_deg : {-7.0, 0.0, 1.19, 30.0}) {
          RoofAcceleration roof{0.005, a, {}, scale, 0.7 * scale};
          if (vertical) roof.vertical_mps2 = w;
          visit(Scene{roof, {.friction = mu, .slope_rad = slope_deg * rad_per_deg}});
        }
      }
    }
  }
}

SlipPeak kernel(const Scene& s, EventSearch search = EventSearch::bounds) {
  return test::by_kernel(s.roof, s.block, search);
}

// Goal of the kernel: 1e-10. What is left is a hundred times less.
TEST(peak_slip, agrees_with_fifty_digits_on_a_rigid_roof) {
  double worst = 0;
  int slid = 0;
  for (const bool vertical : {false, true}) {
    for_each_scene(vertical, [&](const Scene& s) {
      const auto r = kernel(s);
      if (r.uplift || r.peak_displacement_m < 1e-6) return;
      const Reference exact(s.roof, s.block);
      const double down = static_cast<double>(exact.down), up = static_cast<double>(exact.up);
      const double size = std::max(down, up);
      worst = std::max({worst, std::abs(r.peak_downslope_m - down) / size,
                        std::abs(r.peak_upslope_m - up) / size,
                        std::abs(r.residual.along_m - static_cast<double>(exact.slip)) / size});
      ++slid;
    });
  }
  EXPECT_GT(slid, 80);
  EXPECT_LT(worst, 1e-12);
  RecordProperty("largest", std::to_string(worst));
}

TEST(peak_slip, walks_the_same_events_as_the_scalar_reference) {
  for (const bool vertical : {false, true}) {
    for_each_scene(vertical, [&](const Scene& s) {
      const auto r = kernel(s);
      const SlipResult reference = slide(s.roof, s.block);
      EXPECT_EQ(r.slip_phases, reference.slip_phases);
      EXPECT_EQ(r.uplift, reference.uplift);
      EXPECT_EQ(r.free_sliding, reference.free_sliding);
      EXPECT_NEAR(r.slip_duration_s, reference.slip_duration_s, 1e-10);
      EXPECT_NEAR(r.residual.along_m, reference.residual.along_m,
                  1e-12 * reference.peak_displacement_m);
    });
  }
}

void expect_same_bits(const SlipPeak& a, const SlipPeak& b) {
  EXPECT_EQ(a.peak_downslope_m, b.peak_downslope_m);
  EXPECT_EQ(a.peak_upslope_m, b.peak_upslope_m);
  EXPECT_EQ(a.residual.along_m, b.residual.along_m);
  EXPECT_EQ(a.slip_duration_s, b.slip_duration_s);
  EXPECT_EQ(a.slip_phases, b.slip_phases);
  EXPECT_EQ(a.uplift, b.uplift);
}

TEST(peak_slip, passes_nothing_over_that_looking_into_every_interval_would_find) {
  for (const bool vertical : {false, true}) {
    for_each_scene(vertical, [&](const Scene& s) {
      expect_same_bits(kernel(s), kernel(s, EventSearch::every_interval));
    });
  }
}

TEST(peak_slip, scales_exactly_with_motion_and_gravity) {
  for_each_scene(true, [&](const Scene& s) {
    const auto r = kernel(s);
    // slip(lambda a, lambda w, g) = lambda slip(a, w, g / lambda), here lambda = 0.3, 1 and 2.5.
    Scene scaled = s;
    scaled.block.gravity_mps2 = s.block.gravity_mps2 / s.roof.horizontal_factor;
    scaled.roof.vertical_factor = s.roof.vertical_factor / s.roof.horizontal_factor;
    scaled.roof.horizontal_factor = 1.0;
    EXPECT_EQ(kernel(scaled).peak_downslope_m * s.roof.horizontal_factor, r.peak_downslope_m);
  });
}

// Found by fuzzing: the search's single precision must hold numbers of any size beside each other.
TEST(peak_slip, searches_well_where_one_component_is_far_below_the_other) {
  for (const double tiny : {1e-30, 1e-40, 1e-200, 1e-310}) {
    std::vector<double> a(12, tiny), w(12, 0.0);
    a[0] = a[1] = 0.0;
    w[0] = w[1] = -7.0;
    const Block block{
        .friction = 0.45, .slope_rad = 0.46769, .directions = SlipDirections::downslope_only};
    for (const bool swapped : {false, true}) {
      const Scene s{{0.01, swapped ? w : a, swapped ? a : w}, block};
      expect_same_bits(kernel(s), kernel(s, EventSearch::every_interval));
      const SlipResult reference = slide(s.roof, s.block);
      EXPECT_NEAR(kernel(s).peak_displacement_m, reference.peak_displacement_m,
                  1e-12 * reference.peak_displacement_m);
    }
  }
}

TEST(peak_slip, needs_no_more_than_two_samples) {
  const std::vector<double> a{0.0, 6.0};
  const RoofAcceleration roof{0.1, a};
  const Block block{.friction = 0.3};
  EXPECT_NEAR(kernel({roof, block}).peak_displacement_m, slide(roof, block).peak_displacement_m,
              1e-15);
  const std::vector<double> one{6.0};
  EXPECT_NEAR(kernel({{0.1, one}, block}).peak_displacement_m,
              slide({0.1, one}, block).peak_displacement_m, 1e-15);
}

}  // namespace peak_slip_test
}  // namespace glissade
