// SPDX-License-Identifier: GPL-3.0-or-later
// The yielding building by itself, against what must not change; closed forms: manual, 9.2.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "glissade/block/coupled.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace coupled_yielding_forms_test {

using test::made_up_record;

const Block slippery{.friction = 0.15, .slope_rad = 0.04};
const auto a = made_up_record(600, 1, 7.0), w = made_up_record(600, 2, 3.0);
const GroundMotion ground{0.01, a, w};
// What the building of the tests would need to stay elastic.
const CoupledBuilding elastic{{0.4, 0.05}, 0.2, {}};

double omega(const CoupledBuilding& b) { return 2.0 * std::numbers::pi / b.horizontal.period_s; }
double elastic_demand_mps2(const Block& block) {
  return slide_coupled(ground, {}, elastic, block).peak_roof_displacement_m * omega(elastic) *
         omega(elastic);
}
CoupledBuilding yielding_at(double acceleration_mps2, double hardening_ratio) {
  return {elastic.horizontal, elastic.mass_ratio, {acceleration_mps2, hardening_ratio}};
}

// Bilinear with kinematic hardening (Chopra 2017, figure 7.1.3): the loop lies between two lines of
// the hardening stiffness, its branches are elastic or on one of them.
TEST(yielding_oscillator, goes_round_the_textbook_loop) {
  for (const double alpha : {0.0, 0.1}) {
    const double level = elastic_demand_mps2(slippery) / 3.0;
    const CoupledBuilding building = yielding_at(level, alpha);
    std::vector<CoupledPoint> history;
    slide_coupled(ground, {}, building, slippery, history);
    const double square = omega(building) * omega(building);
    int elastic_steps = 0, on_line = 0, ways = 0, side_before = 0;
    for (std::size_t i = 1; i < history.size(); ++i) {
      const auto above = [&](std::size_t k) {
        return history[k].spring_acceleration_mps2 -
               alpha * square * history[k].roof_displacement_m;
      };
      const double half_width = (1.0 - alpha) * level, close = 1e-13 * (1.0 + level);
      ASSERT_LE(std::abs(above(i)), half_width + close);
      const double force = history[i].spring_acceleration_mps2 -
                           history[i - 1].spring_acceleration_mps2,
                   way = square *
                         (history[i].roof_displacement_m - history[i - 1].roof_displacement_m);
      if (std::abs(force - way) < 20.0 * close) {
        ++elastic_steps;
        continue;
      }
      ++on_line;
      const int side = above(i) > 0.0 ? 1 : -1;
      ASSERT_NEAR(above(i), side * half_width, 20.0 * close);
      ASSERT_NEAR(above(i - 1), side * half_width, 20.0 * close);
      ways += side != side_before ? 1 : 0;
      side_before = side;
    }
    EXPECT_GT(elastic_steps, 100);
    EXPECT_GT(on_line, 40);
    EXPECT_GT(ways, 5);
  }
}

void expect_same_bits(const CoupledResult& r, const CoupledResult& s) {
  EXPECT_EQ(r.slip.peak_displacement_m, s.slip.peak_displacement_m);
  EXPECT_EQ(r.slip.residual.along_m, s.slip.residual.along_m);
  EXPECT_EQ(r.slip.slip_phases, s.slip.slip_phases);
  EXPECT_EQ(r.peak_base_shear, s.peak_base_shear);
  EXPECT_EQ(r.peak_roof_displacement_m, s.peak_roof_displacement_m);
  EXPECT_EQ(r.peak_roof_acceleration_mps2, s.peak_roof_acceleration_mps2);
  EXPECT_EQ(r.energy.input_m2ps2, s.energy.input_m2ps2);
  EXPECT_EQ(r.energy.friction_m2ps2, s.energy.friction_m2ps2);
}

TEST(coupled_yielding_limits, strength_for_the_elastic_demand_is_the_elastic_building) {
  const double demand = elastic_demand_mps2(slippery);
  const CoupledResult r = slide_coupled(ground, {}, elastic, slippery);
  EXPECT_EQ(r.ductility, 0.0);
  for (const double share : {1.0 + 1e-12, 1.5, 1e9}) {
    const CoupledResult s = slide_coupled(ground, {}, yielding_at(share * demand, 0.0), slippery);
    expect_same_bits(r, s);
    EXPECT_NEAR(s.ductility, 1.0 / share, 1e-14);
    EXPECT_EQ(s.residual_roof_displacement_m, 0.0);
    EXPECT_EQ(s.energy.hysteretic_m2ps2, 0.0);
  }
  // At the demand itself rounding decides whether it yields: it then does by rounding.
  const CoupledResult touched = slide_coupled(ground, {}, yielding_at(demand, 0.1), slippery);
  EXPECT_NEAR(touched.slip.peak_displacement_m, r.slip.peak_displacement_m, 1e-14);
  EXPECT_NEAR(touched.ductility, 1.0, 1e-14);
}

TEST(coupled_yielding_limits, similitude_holds_to_the_last_bit) {
  Block heavy = slippery;
  heavy.gravity_mps2 *= 4.0;
  for (const double alpha : {0.0, 0.1}) {
    const CoupledResult r = slide_coupled(ground, {}, yielding_at(2.0, alpha), slippery),
                        s = slide_coupled(ground, {4.0, 4.0}, yielding_at(8.0, alpha), heavy);
    ASSERT_GT(r.ductility, 1.5);
    EXPECT_EQ(4.0 * r.slip.peak_displacement_m, s.slip.peak_displacement_m);
    EXPECT_EQ(4.0 * r.slip.residual.along_m, s.slip.residual.along_m);
    EXPECT_EQ(4.0 * r.residual_roof_displacement_m, s.residual_roof_displacement_m);
    EXPECT_EQ(16.0 * r.energy.hysteretic_m2ps2, s.energy.hysteretic_m2ps2);
    EXPECT_EQ(r.ductility, s.ductility);
    EXPECT_EQ(r.peak_base_shear, s.peak_base_shear);
  }
}

TEST(coupled_yielding_limits, mirrors_mirror_and_zeros_after_the_record_change_nothing) {
  std::vector<double> mirrored(a), padded(a), padded_w(w);
  for (double& value : mirrored) value = -value;
  padded.resize(900, 0.0);
  padded_w.resize(900, 0.0);
  const CoupledBuilding building = yielding_at(2.0, 0.05);
  Block other = slippery;
  other.slope_rad = -slippery.slope_rad;
  const CoupledResult r = slide_coupled(ground, {}, building, slippery),
                      m = slide_coupled({0.01, mirrored, w}, {}, building, other),
                      p = slide_coupled({0.01, padded, padded_w}, {}, building, slippery);
  expect_same_bits(r, m);
  expect_same_bits(r, p);
  ASSERT_NE(r.residual_roof_displacement_m, 0.0);
  EXPECT_EQ(r.residual_roof_displacement_m, -m.residual_roof_displacement_m);
  EXPECT_EQ(r.residual_roof_displacement_m, p.residual_roof_displacement_m);
}

/// A bilinear oscillator by central differences, its hysteretic part set to its limit: an
/// independent scheme, off by (omega h)^2 / 24.
std::vector<double> stepped_roof(const CoupledBuilding& b, int per_sample, double follow_s) {
  const double w0 = omega(b), zeta = b.horizontal.damping_ratio, h = ground.dt_s / per_sample;
  const double level = b.yielding.yield_acceleration_mps2, alpha = b.yielding.hardening_ratio;
  const auto n = static_cast<int>((static_cast<double>(a.size()) * ground.dt_s + follow_s) / h);
  const auto ground_at = [&](int i) {
    const auto k = static_cast<std::size_t>(i / per_sample);
    const double y = static_cast<double>(i % per_sample) / per_sample;
    const double from = k < a.size() ? a[k] : 0.0, to = k + 1 < a.size() ? a[k + 1] : 0.0;
    return from + y * (to - from);
  };
  std::vector<double> roof;
  double u = 0.0, z = 0.0, before = 0.5 * h * h * -ground_at(0);  // at rest: u(-h) = u''(0) h^2/2
  for (int i = 0; i < n; ++i) {
    const double force = alpha * w0 * w0 * u + (1.0 - alpha) * z;
    const double c = zeta * w0 * h;
    const double after =
        (2.0 * u - (1.0 - c) * before - h * h * (force + ground_at(i))) / (1.0 + c);
    roof.push_back(-(force + zeta * w0 * (after - before) / h));
    z = std::clamp(z + w0 * w0 * (after - u), -level, level);
    before = u;
    u = after;
  }
  return roof;
}

TEST(coupled_yielding_limits, without_mass_the_block_slides_on_an_independently_stepped_roof) {
  for (const double alpha : {0.0, 0.1}) {
    const CoupledBuilding building{{0.5, 0.05}, 0.0, {2.5, alpha}};
    const Block level{.friction = 0.12};
    const CoupledResult r = slide_coupled({0.01, a}, {}, building, level);
    const int per_sample = 200;
    const std::vector<double> roof = stepped_roof(building, per_sample, 4.0);
    const SlipResult uncoupled = slide({ground.dt_s / per_sample, roof}, level);
    ASSERT_GT(r.ductility, 1.5);
    ASSERT_GT(uncoupled.peak_displacement_m, 1e-3);
    EXPECT_NEAR(r.slip.peak_displacement_m, uncoupled.peak_displacement_m,
                1e-5 * uncoupled.peak_displacement_m);
    EXPECT_NEAR(r.slip.residual.along_m, uncoupled.residual.along_m,
                1e-5 * uncoupled.peak_displacement_m);
  }
}

/// Ground, strengths and friction in round numbers, so that much happens at the same instant, on
/// buildings with and without damping and hardening.
TEST(coupled_yielding_limits, ties_and_extremes_end_and_keep_the_balance) {
  std::mt19937 random(4);
  const auto pick = [&](std::initializer_list<double> of) {
    return of.begin()[random() % of.size()];
  };
  int yielded = 0;
  for (int k = 0; k < 600; ++k) {
    std::vector<double> steps(40), vertical(40);
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i] = i % 4 == 0 ? pick({-2.0, -1.0, 0.0, 0.0, 1.0, 2.0}) : steps[i - 1];
    const double lift = pick({0.0, 0.0, 4.0, 16.0});
    for (std::size_t i = 0; i < steps.size(); ++i) vertical[i] = lift * pick({-1.0, 0.0, 1.0});
    const CoupledBuilding building{{pick({0.125, 0.25, 1.0, 8.0}), pick({0.0, 0.05, 1.0, 2.0})},
                                   pick({0.0, 0.25, 1.0}),
                                   {pick({1e-6, 0.5, 1.0, 2.0, 4.0}), pick({0.0, 0.0, 0.1, 0.9})}};
    const Block block{.friction = pick({0.0, 0.125, 0.5}),
                      .slope_rad = std::atan(pick({0.0, 0.125, 0.0625, 0.5})),
                      .gravity_mps2 = 8.0,
                      .law = {.static_over_sliding = pick({1.0, 1.0, 1.5})}};
    const CoupledResult r = slide_coupled({0.0625, steps, vertical}, {}, building, block);
    const CoupledEnergy& e = r.energy;
    // Where less is left of the input, it is what is left of far larger parts.
    const double least = 1e-5;
    const double most = std::max({std::abs(e.input_m2ps2), e.gravity_m2ps2, e.damped_m2ps2,
                                  e.friction_m2ps2, e.hysteretic_m2ps2, e.kinetic_m2ps2, least});
    EXPECT_NEAR(
        e.input_m2ps2 + e.gravity_m2ps2,
        e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2 + e.hysteretic_m2ps2,
        1e-10 * most)
        << k;
    // The spring's force stays between its lines.
    const double bound =
        building.yielding.yield_acceleration_mps2 *
        (1.0 + building.yielding.hardening_ratio * std::max(r.ductility - 1.0, 0.0));
    if (building.horizontal.damping_ratio == 0.0) {
      EXPECT_LE(r.peak_base_shear * 8.0, bound * (1.0 + 1e-12)) << k;
    }
    yielded += r.ductility > 1.0 ? 1 : 0;
  }
  EXPECT_GT(yielded, 250);
}

TEST(yielding_for, is_a_share_of_the_weight_or_of_the_elastic_demand) {
  EXPECT_EQ(yielding_for(YieldCoefficient{.force_over_weight = 0.25, .gravity_mps2 = 10.0}, 0.1)
                .yield_acceleration_mps2,
            2.5);
  EXPECT_EQ(
      yielding_for(ReducedDemand{.elastic_mps2 = 12.0, .reduction = 4.0}).yield_acceleration_mps2,
      3.0);
  EXPECT_EQ(yielding_for(YieldCoefficient{.force_over_weight = 0.25}, 0.1).hardening_ratio, 0.1);
  EXPECT_TRUE(yielding_for(ReducedDemand{.elastic_mps2 = 12.0}).yields());
}

}  // namespace coupled_yielding_forms_test
}  // namespace glissade
