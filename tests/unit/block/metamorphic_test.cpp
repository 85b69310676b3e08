// SPDX-License-Identifier: GPL-3.0-or-later
// The relations of metamorphic.hpp over random scenes, and what is not a relation.
#include "unit/block/metamorphic.hpp"

#include "unit/block/reference.hpp"

namespace glissade {
namespace metamorphic_test {

using test::made_up_record;
using test::Scene;
using test::solvers;

/// Frictions to 0.8, slopes to 10 degrees both ways and a few flat, peaks to 1.5 g, half of them
/// with a vertical, records of 200 to 1,000 samples at 0.5 to 20 ms.
std::vector<Scene> random_scenes() {
  std::vector<Scene> scenes;
  std::mt19937 generator(20260101);
  const auto uniform = [&](double low, double high) { return test::uniform(generator, low, high); };
  for (unsigned i = 0; i < 400; ++i) {
    Scene scene{"scene " + std::to_string(i), 0.02 * std::pow(10.0, -uniform(0.0, 1.6))};
    const auto n = static_cast<std::size_t>(uniform(200, 1000));
    const double peak_mps2 = uniform(2.0, 15.0);
    scene.a = made_up_record(n, i + 1, peak_mps2);
    if (i % 2 == 1) scene.w = made_up_record(n, i + 1001, 0.6 * peak_mps2);
    scene.a.front() = 0.0;
    if (!scene.w.empty()) scene.w.front() = 0.0;
    scene.block = {uniform(0.0, 0.8), i % 4 < 2 ? 0.0 : uniform(-10.0, 10.0) * rad_per_deg};
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

TEST(metamorphic, slip_scales_with_the_whole_acceleration_field) {
  EXPECT_GT(over(random_scenes(), test::expect_similitude), 200);
}

TEST(metamorphic, mirroring_motion_and_slope_mirrors_the_slip) {
  EXPECT_GT(over(random_scenes(), test::expect_mirror), 200);
}

TEST(metamorphic, inserted_samples_change_nothing_but_rounding) {
  EXPECT_GT(over(random_scenes(), test::expect_inserted_samples_change_nothing), 200);
}

TEST(metamorphic, zeros_before_and_after_change_not_a_bit) {
  EXPECT_GT(over(random_scenes(), test::expect_padding_and_shift_change_nothing), 200);
}

TEST(metamorphic, slip_scales_with_the_square_of_the_clock) {
  EXPECT_GT(over(random_scenes(), test::expect_clock_scaling), 200);
}

TEST(metamorphic, one_way_slip_is_never_behind_two_way_slip) {
  EXPECT_GT(over(random_scenes(), test::expect_one_way_beyond_two_way), 200);
}

TEST(metamorphic, the_one_way_peak_may_be_below_the_two_way_peak) {
  const std::vector<double> pushed_up = {0.0, 9.0, 9.0, 9.0, 0.0};
  const Block both{.friction = 0.2},
      one_way{.friction = 0.2, .directions = SlipDirections::downslope_only};
  for (const auto& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    EXPECT_EQ(solver.solve({0.02, pushed_up}, one_way).peak_displacement_m, 0.0);
    EXPECT_GT(solver.solve({0.02, pushed_up}, both).peak_displacement_m, 0.01);
  }
}

// Found by fuzzing: a speed so small that its product with the drive vanishes seems to last for the
// whole interval, in which the drive would push the block upslope by 6e-23 m.
TEST(metamorphic, one_way_slip_never_goes_upslope_where_the_root_of_a_stop_vanishes) {
  const std::vector<double> pushed_up = {-4e-317, 0.0, 2.3e-10, 0.0};
  const Block block{
      .friction = 0.5, .slope_rad = std::atan(0.5), .directions = SlipDirections::downslope_only};
  for (const auto& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    const auto slip = solver.solve({1.2e-6, pushed_up}, block);
    EXPECT_EQ(slip.slip_phases, 1u);
    EXPECT_EQ(slip.peak_upslope_m, 0.0);
    EXPECT_GE(slip.residual.along_m, 0.0);
  }
}

// Two seconds at 97 % of the yield acceleration, which would push the block to -x, then half a
// second at twice it, which pushes it to +x. At 1 the first does nothing and the block ends
// 2 x 2 x 0.5^2/2 = 0.5 m away; at 1.1 the first takes it about 0.13 x 2^2/2 = 0.27 m back before
// the second brings it 0.66 m on. More shaking, or less friction, and less slip: neither the peak
// nor the residual is monotone, and nothing may assume it.
TEST(metamorphic, slip_is_not_monotone_in_intensity_or_friction) {
  const double dt_s = 0.01, g = 10.0, mu = 0.2;
  std::vector<double> a(201, 0.97 * mu * g);
  a.insert(a.end(), 100, 0.0);
  a.insert(a.end(), 51, -2.0 * mu * g);
  const auto outcome = [&](const test::Solver& solver, double factor, double friction) {
    return solver.solve({dt_s, a, {}, factor}, {.friction = friction, .gravity_mps2 = g});
  };
  for (const auto& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    const auto less = outcome(solver, 1.0, mu), more = outcome(solver, 1.1, mu);
    EXPECT_NEAR(less.peak_displacement_m, 0.5, 0.03);
    EXPECT_LT(more.peak_displacement_m, 0.9 * less.peak_displacement_m);
    EXPECT_LT(more.residual.along_m, 0.9 * less.residual.along_m);
    EXPECT_GT(outcome(solver, 2.0, mu).peak_displacement_m, less.peak_displacement_m);
    // By similitude the same with friction: slip(1, mu/1.1) = slip(1.1, mu)/1.1 on a flat roof.
    const auto smoother = outcome(solver, 1.0, mu / 1.1);
    EXPECT_LT(smoother.peak_displacement_m, 0.9 * less.peak_displacement_m);
    EXPECT_NEAR(smoother.peak_displacement_m, more.peak_displacement_m / 1.1, 1e-13);
  }
}

}  // namespace metamorphic_test
}  // namespace glissade
