// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/motion_table.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "glissade/building/roof_table.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace {

using test::made_up_record;
using Real = boost::multiprecision::cpp_bin_float_50;

MotionTable response(const std::vector<double>& a, double dt_s, const Modes& building,
                     const RoofMotionOptions& follow = {}) {
  const auto ground =
      std::make_shared<GroundTable>(dt_s, a, std::max(1, parts_needed(building, dt_s)));
  if (building.rigid()) return tabulate_rigid(ground);
  return tabulate_response(ground, building, follow);
}

TEST(ground_table, integrates_to_fifty_digits_however_far_it_drifts) {
  auto a = made_up_record(3000, 4, 5.0);
  for (double& x : a) x += 40.0;  // an absurd baseline: 4.5 km in 15 s
  const GroundTable ground(0.005, a);
  Real v = 0, u = 0, h = 0.005;
  double worst_v = 0, worst_step = 0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Real before = u;
    u += h * v + h * h * (2 * Real(a[i - 1]) + a[i]) / 6;
    v += h * (Real(a[i - 1]) + a[i]) / 2;
    const GroundNode &p = ground.nodes()[i - 1], &q = ground.nodes()[i];
    const double moved =
        (q.displacement_m - p.displacement_m) + (q.displacement_low_m - p.displacement_low_m);
    worst_v = std::max(
        worst_v, std::abs(static_cast<double>(v - Real(q.velocity_mps))) / static_cast<double>(v));
    worst_step = std::max(worst_step, std::abs(static_cast<double>(Real(moved) - (u - before))) /
                                          static_cast<double>(u - before));
  }
  EXPECT_LT(worst_v, 3e-16);
  EXPECT_LT(worst_step, 3e-16);
}

TEST(ground_table, is_not_changed_by_zeros_at_its_end) {
  const auto a = made_up_record(300, 4, 5.0);
  auto padded = a;
  padded.resize(500, 0.0);
  EXPECT_EQ(GroundTable(0.01, a).quiet_from(), GroundTable(0.01, padded).quiet_from());
  EXPECT_EQ(GroundTable(0.01, padded).last_sample(), 499u);
}

TEST(motion_table, has_the_roof_s_acceleration_velocity_and_displacement_at_its_nodes) {
  const auto a = made_up_record(900, 5, 4.0);
  for (const double period : {0.05, 0.3, 2.0}) {
    const MotionTable table = response(a, 0.01, {period, 0.05});
    const MotionNodes at = table.at_nodes();
    // Reference: the sampled roof, 40 times as finely, integrated by trapezes.
    const int finer = 40 * static_cast<int>(std::lround(0.01 / table.step_s()));
    const int per_period = static_cast<int>(std::ceil(finer * period / 0.01 - 1e-6));
    const RoofMotion fine =
        roof_motion({0.01, a}, {.horizontal = {period, 0.05}}, {.steps_per_period = per_period});
    const double h = fine.dt_s;
    const auto stride = static_cast<std::size_t>(std::lround(table.step_s() / h));
    double v = 0, u = 0, worst_a = 0, worst_v = 0, worst_u = 0, size_v = 0, size_u = 0;
    for (std::size_t k = 1; k < fine.horizontal_mps2.size(); ++k) {
      const double a0 = fine.horizontal_mps2[k - 1], a1 = fine.horizontal_mps2[k];
      u += h * v + h * h * (2 * a0 + a1) / 6;
      v += 0.5 * h * (a0 + a1);
      if (k % stride != 0) continue;
      const std::size_t i = k / stride;
      worst_a = std::max(worst_a, std::abs(at.acceleration_mps2(i) - a1));
      worst_v = std::max(worst_v, std::abs(at.velocity_mps(i) - v));
      worst_u = std::max(worst_u, std::abs(at.displacement_from_m(0, i) - u));
      size_v = std::max(size_v, std::abs(v));
      size_u = std::max(size_u, std::abs(u));
    }
    EXPECT_LT(worst_a, 1e-11) << period;
    EXPECT_LT(worst_v, 1e-4 * size_v) << period;  // trapezes of at least 640 a period
    EXPECT_LT(worst_u, 1e-4 * size_u) << period;
  }
}

TEST(motion_table, has_the_same_bits_alone_and_among_others) {
  const auto a = made_up_record(500, 6, 4.0);
  const auto ground = std::make_shared<GroundTable>(0.01, a);
  std::vector<Modes> oscillators;
  for (int k = 0; k < 37; ++k) oscillators.push_back({0.2 + 0.05 * k, 0.03});
  const std::vector<RoofMotionOptions> follow(37, {.quiet_horizontal_mps2 = 0.01});
  std::vector<MotionTable> together(37);
  tabulate_responses(ground, oscillators, follow, together);
  for (const std::size_t k : {0u, 15u, 16u, 36u}) {
    const MotionTable alone = response(a, 0.01, oscillators[k], follow[k]);
    ASSERT_EQ(alone.end, together[k].end);
    for (std::size_t i = 0; i < alone.nodes; ++i) {
      ASSERT_EQ(alone.x[i], together[k].x[i]);
      ASSERT_EQ(alone.y[i], together[k].y[i]);
    }
  }
}

/// Bernstein form, term by term.
double value(const Quartic& q, double y) {
  const double z = 1 - y;
  return q.b[0] * z * z * z * z + 4 * q.b[1] * y * z * z * z + 6 * q.b[2] * y * y * z * z +
         4 * q.b[3] * y * y * y * z + q.b[4] * y * y * y * y;
}

/// Their participations are 0.9 together: a tenth of the roof's motion is the ground's.
Modes three_modes() {
  return Modes(std::array{Mode{0.6, 1.3, 0.8, 0.05}, Mode{0.2, -0.6, 0.12, 0.03},
                          Mode{0.11, 0.2, 0.05, 0.02}});
}

TEST(motion_table, of_modes_is_the_sum_of_theirs) {
  const auto a = made_up_record(700, 12, 4.0);
  const auto ground = std::make_shared<GroundTable>(0.01, a, 4);
  const MotionTable sum = tabulate_response(ground, three_modes(), {.quiet_horizontal_mps2 = 0.01});
  std::vector<MotionTable> each;
  for (const Mode& mode : three_modes()) {
    each.push_back(tabulate_response(ground, mode.oscillator(), {}));
    extend(each.back(), sum.nodes);
  }
  const MotionTable rigid = [&] {
    MotionTable table = tabulate_rigid(ground);
    extend(table, sum.nodes);
    return table;
  }();
  const auto summed = [&](auto quantity) {
    double total = three_modes().ground_share() * quantity(rigid.at_nodes());
    for (std::size_t n = 0; n < each.size(); ++n)
      total += three_modes()[n].participation * quantity(each[n].at_nodes());
    return total;
  };
  for (std::size_t i = 3; i < sum.end; ++i) {
    const auto expect_sum = [&](auto quantity, double rounding) {
      EXPECT_NEAR(quantity(sum.at_nodes()), summed(quantity), rounding) << i;
    };
    expect_sum([&](const MotionNodes& at) { return at.acceleration_mps2(i); }, 1e-13);
    expect_sum([&](const MotionNodes& at) { return at.velocity_mps(i); }, 1e-13);
    expect_sum([&](const MotionNodes& at) { return at.displacement_from_m(3, i); }, 1e-12);
    for (const double y : {0.2, 0.5, 0.9})
      expect_sum([&](const MotionNodes& at) { return value(at.acceleration_after(i), y); }, 1e-10);
  }
}

// One mass is the mode of participation 1; its table and its history have the same bits.
TEST(motion_table, of_one_mode_that_is_all_of_the_building_is_that_of_one_mass) {
  const auto a = made_up_record(300, 13, 4.0);
  const MotionTable mass = response(a, 0.01, {0.4, 0.03}),
                    mode = response(a, 0.01, Modes(std::array{Mode{0.4, 1.0, 1.0, 0.03}}));
  EXPECT_EQ(mass.x, mode.x);
  EXPECT_EQ(mass.bounds.lowest, mode.bounds.lowest);
}

// The whole sum rings until its modes' bounds are together below what can start a block.
TEST(motion_table, of_modes_rings_until_none_of_it_can_start_a_block) {
  const auto a = made_up_record(300, 14, 4.0);
  const MotionTable ended = response(a, 0.01, three_modes(), {.quiet_horizontal_mps2 = 0.05});
  const MotionTable longer = response(a, 0.01, three_modes(), {.quiet_horizontal_mps2 = 1e-6});
  ASSERT_GT(longer.end, ended.end);
  for (std::size_t i = ended.end; i < longer.end; ++i)
    ASSERT_LE(std::abs(longer.at_nodes().acceleration_mps2(i)), 0.05);
  double last = 0.0;  // and not much longer
  for (std::size_t i = ended.end - 200; i < ended.end; ++i)
    last = std::max(last, std::abs(ended.at_nodes().acceleration_mps2(i)));
  EXPECT_GT(last, 0.02);
}

TEST(motion_table, bounds_the_acceleration_and_the_velocity_s_chord_everywhere) {
  const auto a = made_up_record(700, 7, 4.0);
  for (const Modes& building : {Modes(), Modes(0.17, 0.05), Modes(0.5, 0.05), three_modes()}) {
    const MotionTable t = response(a, 0.01, building, {.quiet_horizontal_mps2 = 0.01});
    const MotionNodes at = t.at_nodes();
    const MotionBounds& b = t.bounds;
    double peak = 0;
    for (std::size_t i = 0; i < t.end; ++i) {
      const Quartic q = at.acceleration_after(i);
      const double v0 = at.velocity_mps(i), v1 = at.velocity_mps(i + 1);
      for (int k = 0; k <= 20; ++k) {
        const double y = k / 20.0, accel = value(q, y);
        peak = std::max(peak, std::abs(accel));
        ASSERT_LE(accel * b.acceleration_scale, b.highest[i]);
        ASSERT_GE(accel * b.acceleration_scale, b.lowest[i]);
        ASSERT_GE(b.tile_highest[i / MotionBounds::tile], b.highest[i]);
        ASSERT_LE(b.tile_lowest[i / MotionBounds::tile], b.lowest[i]);
        // V at y: its value at the node and the integral of the left part.
        double v = v0;
        for (int m = 0; m < 64; ++m) v += t.step_s() * y / 64 * value(q, y * (m + 0.5) / 64);
        const double chord = v0 + y * (v1 - v0), size = b.velocity_scale;
        const double above =
            std::max(b.velocity_above[i] - v0 * size, b.velocity_above[i + 1] - v1 * size);
        const double below =
            std::min(b.velocity_below[i] - v0 * size, b.velocity_below[i + 1] - v1 * size);
        ASSERT_LE((v - chord) * size, above + 1e-5);  // 1e-5: the midpoint rule above
        ASSERT_GE((v - chord) * size, below - 1e-5);
      }
    }
    EXPECT_GE(t.acceleration_bound_mps2, peak);
    EXPECT_NEAR(peak_acceleration_mps2(t), peak, 1e-3 * peak);
    EXPECT_GE(peak_acceleration_mps2(t), peak * (1 - 1e-12));
  }
}

TEST(motion_table, rings_on_where_it_is_extended) {
  const auto a = made_up_record(300, 8, 4.0);
  for (const Modes& building : {Modes(0.4, 0.02), three_modes()}) {
    MotionTable shorter = response(a, 0.01, building);
    const MotionTable longer = response(a, 0.01, building, {.quiet_horizontal_mps2 = 1e-3});
    ASSERT_GT(longer.nodes, shorter.nodes + 100);
    extend(shorter, longer.nodes);
    EXPECT_EQ(shorter.x, longer.x);
    EXPECT_EQ(shorter.modes.a, longer.modes.a);
    EXPECT_EQ(shorter.bounds.lowest, longer.bounds.lowest);
  }
}

// T from far below the step to far above the record, damping from none to far beyond critical.
TEST(motion_table, stands_any_period_and_damping) {
  const auto a = made_up_record(400, 9, 4.0);
  for (const double period : {1e-9, 1e-3, 0.0011, 0.01, 4.0, 400.0, 1e6}) {
    for (const double zeta : {0.0, 0.05, 0.999999, 1.0, 1.000001, 3.0, 100.0}) {
      const RoofTable roof =
          tabulate_roof({0.01, a}, {.horizontal = {period, zeta}},
                        {.quiet_horizontal_mps2 = 0.01, .longest_ring_down_s = 5});
      const MotionTable& t = *roof.horizontal;
      const double peak = peak_acceleration_mps2(t);
      EXPECT_TRUE(std::isfinite(peak));
      EXPECT_GT(peak, 0.0);
      EXPECT_LT(peak, 40.0);  // a resonant, undamped one
      EXPECT_LT(t.nodes, 2'000'000u);
      if (period < 1e-3) {
        EXPECT_TRUE(t.rigid());
      }
      // Near rigid: the ground's own motion; far above: none but what the dashpot carries.
      if (period < 0.0012 && zeta > 0.0) {
        EXPECT_NEAR(peak, 4.0, 0.1) << period << " " << zeta;
      }
      if (period > 1e5 && zeta < 0.1) {
        EXPECT_LT(peak, 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace glissade
