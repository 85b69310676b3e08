// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same bits on every SIMD target this machine has, from tables to slip.
#include "simd_targets.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "glissade/block/peak_slip.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace simd_targets_test {

using test::made_up_record;

/// Everything a table and the kernel on it give.
std::vector<double> everything() {
  const auto a = made_up_record(777, 21, 6.0), w = made_up_record(777, 22, 4.0);
  const auto ground = std::make_shared<GroundTable>(0.01, a);
  std::vector<Modes> oscillators;
  for (int k = 0; k < 21; ++k) oscillators.push_back({0.17 + 0.11 * k, 0.01 + 0.01 * k});
  const std::vector<RoofMotionOptions> follow(oscillators.size(), {.quiet_horizontal_mps2 = 0.05});
  std::vector<MotionTable> tables(oscillators.size());
  tabulate_responses(ground, oscillators, follow, tables);

  std::vector<double> all;
  const auto up_ground = std::make_shared<GroundTable>(0.01, w);
  const auto append = [&](const RoofTable& roof) {
    const MotionBounds& b = roof.horizontal->bounds;
    all.insert(all.end(), roof.horizontal->x.begin(), roof.horizontal->x.end());
    all.insert(all.end(), b.lowest.begin(), b.lowest.begin() + 700);
    all.insert(all.end(), b.velocity_above.begin(), b.velocity_above.begin() + 700);
    all.push_back(roof.horizontal->acceleration_bound_mps2);
    for (const double factor : {0.3, 1.0, 4.0}) {
      for (const double slope_deg : {0.0, -5.0}) {
        const SlipPeak r = peak_slip(roof, {.friction = 0.3, .slope_rad = slope_deg * rad_per_deg},
                                     {factor, factor});
        all.insert(all.end(), {r.peak_downslope_m, r.peak_upslope_m, r.residual.along_m,
                               r.slip_duration_s, static_cast<double>(r.slip_phases)});
      }
    }
  };
  append(RoofTable(0.01, a, w));
  for (MotionTable& table : tables) {
    auto up = std::make_shared<MotionTable>(tabulate_rigid(up_ground));
    extend(*up, table.end + 1);
    append({std::make_shared<MotionTable>(table), nullptr});
    extend(table, up->end + 1);
    append({std::make_shared<MotionTable>(table), up});
  }
  return all;
}

TEST(simd_targets, all_give_the_same_bits) {
  const std::vector<double> best = everything();
  RecordProperty("targets", test::on_each_target([&] { EXPECT_EQ(everything(), best); }));
}

}  // namespace simd_targets_test
}  // namespace glissade
