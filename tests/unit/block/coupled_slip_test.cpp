// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of the coupled block against its readable reference.
#include "glissade/block/coupled_slip.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "unit/block/reference.hpp"

namespace glissade {
namespace coupled_slip_test {

using test::made_up_record;
using test::uniform;

/// Buildings from a few samples a period to slower than the record, on slopes to either side.
std::vector<CoupledScene> made_up_scenes(std::size_t count, unsigned seed, double vertical) {
  std::mt19937 random(seed);
  std::vector<CoupledScene> scenes(count);
  for (CoupledScene& s : scenes) {
    s.building = {
        {std::exp(uniform(random, std::log(0.04), std::log(3.0))), uniform(random, 0.0, 0.15)},
        uniform(random, 0.0, 0.5)};
    s.block.friction = uniform(random, 0.05, 0.5);
    s.block.slope_rad = uniform(random, -0.95, 0.95) * std::atan(s.block.friction);
    const double factor = std::exp(uniform(random, std::log(0.2), std::log(3.0)));
    s.factors = {random() % 2 == 0 ? factor : -factor, vertical * factor};
  }
  return scenes;
}

/// Every other building is given a spring that yields: without hardening, overdamped while it
/// yields (0.002), and with tables of both stiffnesses.
std::vector<CoupledScene> let_yield(std::vector<CoupledScene> scenes, unsigned seed) {
  std::mt19937 random(seed);
  constexpr std::array<double, 4> hardening{0.0, 0.002, 0.05, 0.3};
  for (std::size_t k = 0; k < scenes.size(); k += 2) {
    if (scenes[k].building.horizontal.period_s < 0.05) continue;  // as good as rigid
    scenes[k].building.yielding = {std::exp(uniform(random, std::log(0.3), std::log(20.0))),
                                   hardening[random() % hardening.size()]};
  }
  return scenes;
}

std::vector<CoupledPeak> solve(const GroundMotion& ground, std::span<const CoupledScene> scenes) {
  std::vector<CoupledPeak> peaks(scenes.size());
  coupled_slip(ground, scenes, peaks);
  return peaks;
}

std::vector<double> numbers(std::span<const CoupledPeak> peaks) {
  std::vector<double> all;
  for (const CoupledPeak& p : peaks) {
    all.insert(all.end(), {p.slip.peak_displacement_m, p.slip.residual_displacement_m,
                           p.slip.peak_downslope_m, p.slip.peak_upslope_m, p.slip.slip_duration_s,
                           static_cast<double>(p.slip.slip_phases)});
  }
  return all;
}

/// @return how many slid
int expect_reference(const GroundMotion& ground, std::span<const CoupledScene> scenes) {
  const std::vector<CoupledPeak> peaks = solve(ground, scenes);
  int slid = 0;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const CoupledScene& s = scenes[k];
    SCOPED_TRACE("scene " + std::to_string(k) + ", T " +
                 std::to_string(s.building.horizontal.period_s));
    const CoupledResult r = slide_coupled(ground, s.factors, s.building, s.block);
    const CoupledPeak& p = peaks[k];
    // 1e-10 of the peak above 1 um.
    const double close = 1e-10 * std::max(r.slip.peak_displacement_m, 1e-6);
    EXPECT_NEAR(p.slip.peak_displacement_m, r.slip.peak_displacement_m, close);
    EXPECT_NEAR(p.slip.residual_displacement_m, r.slip.residual_displacement_m, close);
    EXPECT_NEAR(p.slip.peak_downslope_m, r.slip.peak_downslope_m, close);
    EXPECT_NEAR(p.slip.peak_upslope_m, r.slip.peak_upslope_m, close);
    EXPECT_NEAR(p.slip.slip_duration_s, r.slip.slip_duration_s, 1e-9);
    EXPECT_EQ(p.slip.slip_phases, r.slip.slip_phases);
    EXPECT_EQ(p.slip.uplift, r.slip.uplift);
    EXPECT_EQ(p.slip.free_sliding, r.slip.free_sliding);
    slid += r.slip.slip_phases > 0 ? 1 : 0;
  }
  return slid;
}

TEST(coupled_slip, agrees_with_the_reference) {
  const auto a = made_up_record(1000, 1, 7.0), w = made_up_record(1000, 2, 3.0);
  EXPECT_GT(expect_reference({0.01, a}, made_up_scenes(500, 3, 0.0)), 250);
  EXPECT_GT(expect_reference({0.01, a, w}, made_up_scenes(500, 4, 0.9)), 250);
}

TEST(coupled_slip, agrees_where_the_spring_yields) {
  const auto a = made_up_record(1000, 18, 7.0), w = made_up_record(1000, 19, 3.0);
  const auto flat = let_yield(made_up_scenes(500, 20, 0.0), 21),
             shaken = let_yield(made_up_scenes(500, 22, 0.9), 23);
  EXPECT_GT(expect_reference({0.01, a}, flat), 250);
  EXPECT_GT(expect_reference({0.01, a, w}, shaken), 250);
  int yielded = 0;
  for (const CoupledScene& s : flat)
    yielded += slide_coupled({0.01, a}, s.factors, s.building, s.block).ductility > 1.0 ? 1 : 0;
  EXPECT_GT(yielded, 100);
}

TEST(coupled_slip, agrees_with_static_friction) {
  const auto a = made_up_record(1000, 26, 7.0), w = made_up_record(1000, 27, 3.0);
  auto scenes = let_yield(made_up_scenes(500, 28, 0.9), 29);
  for (std::size_t k = 0; k < scenes.size(); ++k)
    scenes[k].block.law.static_over_sliding = 1.0 + 0.1 * static_cast<double>(1 + k % 5);
  EXPECT_GT(expect_reference({0.01, a, w}, scenes), 200);
  int by_events = 0;
  for (const CoupledPeak& p : solve({0.01, a, w}, scenes)) by_events += p.by_events ? 1 : 0;
  EXPECT_LT(by_events, 100);  // as good as rigid, or lifted
}

TEST(coupled_slip, agrees_where_the_block_lifts) {
  const auto a = made_up_record(600, 5, 30.0), w = made_up_record(600, 6, 3.0);
  auto scenes = made_up_scenes(200, 7, 1.0);
  for (CoupledScene& s : scenes) s.block.slope_rad *= 2.0;  // free sliders among them
  expect_reference({0.01, a, w}, scenes);
  int lifted = 0, free = 0;
  for (const CoupledPeak& p : solve({0.01, a, w}, scenes)) {
    lifted += p.slip.uplift ? 1 : 0;
    free += p.slip.free_sliding ? 1 : 0;
  }
  EXPECT_GT(lifted, 20);
  EXPECT_GT(free, 20);
}

TEST(coupled_slip, what_does_not_fit_the_lanes_is_the_reference) {
  const auto a = made_up_record(500, 8, 7.0), w = made_up_record(500, 9, 12.0);
  std::vector<CoupledScene> scenes(5,
                                   {{{0.4, 0.05}, 0.1}, {.friction = 0.3, .slope_rad = 0.05}, {}});
  scenes[0].building.horizontal.period_s = 0.0;
  scenes[1].block.directions = SlipDirections::downslope_only;
  scenes[2].block.friction = std::tan(scenes[2].block.slope_rad);
  scenes[3].block = {.friction = 4.0, .slope_rad = 0.3};
  scenes[4].factors = {1.0, 1.0};
  for (std::size_t k = 0; k < 4; ++k) scenes[k].factors = {1.0, 0.0};
  expect_reference({0.01, a, w}, scenes);
}

TEST(coupled_slip, zero_motion_moves_nothing) {
  const std::vector<double> rest(100, 0.0);
  for (const CoupledPeak& p : solve({0.01, rest}, made_up_scenes(20, 10, 0.0))) {
    EXPECT_EQ(p.slip.peak_displacement_m, 0.0);
  }
}

// A study searches for capacities from a level of zero on: the ratio of the components is then no
// number. It did not return.
TEST(coupled_slip, components_scaled_to_zero_move_nothing) {
  const auto a = made_up_record(100, 12, 9.0), w = made_up_record(100, 13, 4.0);
  std::vector<CoupledScene> scenes = made_up_scenes(20, 12, 0.0);
  for (std::size_t k = 0; k < scenes.size(); k += 2) scenes[k].factors = {0.0, 0.0};
  expect_reference({0.01, a, w}, scenes);
}

TEST(coupled_slip, short_records_and_extreme_buildings_agree_too) {
  for (const std::size_t samples : {1u, 2u, 3u, 40u}) {
    const auto a = made_up_record(std::max<std::size_t>(samples, 2), 11, 9.0);
    std::vector<CoupledScene> scenes;
    for (const double period_s : {1e-6, 1e-3, 0.02, 0.5, 30.0, 1e4})
      for (const double damping : {0.0, 0.05, 1.0, 3.0})
        scenes.push_back({{{period_s, damping}, 0.3}, {.friction = 0.2, .slope_rad = 0.05}, {}});
    expect_reference({0.01, std::span(a).first(samples)}, scenes);
  }
}

TEST(coupled_slip, company_changes_no_bit) {
  const auto a = made_up_record(700, 12, 7.0), w = made_up_record(700, 13, 3.0);
  const auto scenes = let_yield(made_up_scenes(50, 14, 0.7), 24);
  const std::vector<CoupledPeak> together = solve({0.01, a, w}, scenes);
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const std::vector<CoupledPeak> alone = solve({0.01, a, w}, std::span(scenes).subspan(k, 1));
    EXPECT_EQ(numbers(alone), numbers(std::span(together).subspan(k, 1))) << k;
  }
}

TEST(coupled_slip, all_simd_targets_give_the_same_bits) {
  const auto a = made_up_record(700, 15, 7.0), w = made_up_record(700, 16, 3.0);
  const auto scenes = let_yield(made_up_scenes(100, 17, 0.7), 25);
  const auto use = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  const auto best = numbers(solve({0.01, a, w}, scenes));
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    use(target);
    EXPECT_EQ(numbers(solve({0.01, a, w}, scenes)), best) << hwy::TargetName(target);
  }
  use(0);
}

}  // namespace coupled_slip_test
}  // namespace glissade
