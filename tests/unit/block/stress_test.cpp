// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes made to break a solver. Every solver of solvers.hpp must come through each: finite, with
// bounded work, and equal to fifty digits. Roofs that are oscillators: stress_roof_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "unit/block/reference.hpp"
#include "unit/block/solvers.hpp"

namespace glissade {
namespace stress_test {

using test::made_up_record;
using test::Reference;
using test::Solver;
using test::solvers;

constexpr double g = standard_gravity_mps2, eps = std::numeric_limits<double>::epsilon();

/// How near to fifty digits an answer must be, relative to the peak. Where the true answer hangs on
/// the last digit of the input (a block at its critical friction, say), no double can be near it
/// relative to a peak that may be zero. But Coulomb friction only ever brings two histories closer,
/// so an acceleration that is off by its rounding, all the time, is the worst there is: eps A t in
/// velocity, eps A t^2 in slip. Those scenes must stay within that bound, and state why.
constexpr double relative_tolerance = 1e-12;

struct Scene {
  std::string name;
  std::vector<double> a, w = {};
  Block block = {};
  double dt_s = 0.005;
  const char* ill_conditioned = nullptr;  ///< why no relative tolerance is possible
  RoofAcceleration roof() const { return {dt_s, a, w}; }
};

double largest(const std::vector<double>& samples) {
  double peak = 0;
  for (const double x : samples) peak = std::max(peak, std::abs(x));
  return peak;
}

void expect_finite_and_bounded(const Scene& scene, const SlipPeak& r) {
  for (const double value : {r.peak_displacement_m, r.residual.along_m, r.peak_downslope_m,
                             r.peak_upslope_m, r.slip_duration_s}) {
    EXPECT_TRUE(std::isfinite(value));
  }
  EXPECT_EQ(r.peak_displacement_m, std::max(r.peak_downslope_m, r.peak_upslope_m));
  EXPECT_LE(r.residual.along_m, r.peak_downslope_m);
  EXPECT_GE(r.residual.along_m, -r.peak_upslope_m);
  // Drives are lines: each direction starts at most once in a piece of an interval, and lifting off
  // cuts one interval into two pieces.
  EXPECT_LE(r.slip_phases, (r.uplift ? 4 : 2) * scene.a.size());
}

void expect_fifty_digits(const Scene& scene, const SlipPeak& r, const Reference& exact) {
  const double down = static_cast<double>(exact.down), up = static_cast<double>(exact.up),
               slip = static_cast<double>(exact.slip);
  double tolerance = relative_tolerance * std::max(down, up);
  if (scene.ill_conditioned != nullptr) {
    const double acceleration = (1 + scene.block.friction.along) *
                                (scene.block.gravity_mps2 + largest(scene.a) + largest(scene.w));
    const double time_s = scene.dt_s * static_cast<double>(scene.a.size());
    tolerance += 4 * eps * acceleration * time_s * time_s;
  } else {
    EXPECT_EQ(r.uplift, exact.uplift);
    EXPECT_NEAR(r.slip_duration_s, static_cast<double>(exact.duration),
                1e-9 * static_cast<double>(exact.duration));
  }
  EXPECT_NEAR(r.peak_downslope_m, down, tolerance);
  EXPECT_NEAR(r.peak_upslope_m, up, tolerance);
  EXPECT_NEAR(r.residual.along_m, slip, tolerance);
}

/// How many of the scenes made the block slip: none would test nothing.
int expect_all_stand(const std::vector<Scene>& scenes) {
  int slipped = 0;
  for (const Scene& scene : scenes) {
    const Reference exact(scene.roof(), scene.block);
    slipped += exact.down + exact.up > 0 ? 1 : 0;
    for (const Solver& solver : solvers()) {
      SCOPED_TRACE(scene.name + ", " + solver.name);
      const SlipPeak r = solver.solve(scene.roof(), scene.block);
      expect_finite_and_bounded(scene, r);
      expect_fifty_digits(scene, r, exact);
    }
  }
  return slipped;
}

std::vector<double> constant(std::size_t n, double value) { return std::vector<double>(n, value); }

std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Any sample is as likely as any other: energy up to the Nyquist frequency.
std::vector<double> white_noise(std::size_t n, unsigned seed, double peak_mps2) {
  std::mt19937 generator(seed);
  std::vector<double> a(n);
  for (double& x : a) x = peak_mps2 * (static_cast<double>(generator()) / 2147483648.0 - 1);
  return a;
}

std::string text(double value) { return std::to_string(value); }

TEST(stress, no_friction_and_enormous_friction) {
  const auto a = made_up_record(600, 1, 8.0), w = made_up_record(600, 2, 5.0);
  std::vector<Scene> scenes;
  for (const double mu : {0.0, 1e-300, 1e-12, 1e3, 1e12, 1e300}) {
    for (const double slope_deg : {0.0, 4.0, -4.0, 40.0}) {
      const Block block{mu, slope_deg * rad_per_deg};
      // Tiny frictions on a flat roof coast 1e12 s and longer; that is the next test.
      if (mu > 0 && mu < 1 && slope_deg == 0) continue;
      scenes.push_back({"mu " + text(mu) + ", slope " + text(slope_deg), a, {}, block});
      scenes.push_back({scenes.back().name + ", vertical", a, w, block});
    }
  }
  EXPECT_GT(expect_all_stand(scenes), 10);
}

// A block that coasts to a stop under a tiny deceleration d goes v^2/(2 d): far, and computed
// exactly.
TEST(stress, coasting_far_on_almost_no_friction) {
  const std::vector<double> a = {-1.0, -1.0, -1.0, 0.0};
  std::vector<Scene> scenes;
  for (const double mu : {1e-3, 1e-6, 1e-12, 1e-100, 1e-290})
    scenes.push_back({"mu " + std::to_string(std::log10(mu)), a, {}, {.friction = mu}});
  EXPECT_EQ(expect_all_stand(scenes), 5);
}

TEST(stress, critical_friction_and_its_last_digits) {
  std::vector<Scene> scenes;
  for (const double slope_deg : {1.0, 4.0, 30.0, 60.0, -7.0}) {
    const double slope = slope_deg * rad_per_deg, critical = std::tan(std::abs(slope));
    // Ends on braking by half of what would push the block uphill, until it rests.
    auto a = joined(made_up_record(400, 3, 6 * critical), constant(600, g * critical));
    if (slope < 0)
      for (double& x : a) x *= -1;
    for (const double off : {0.0, 1e-15, -1e-15, 1e-12, -1e-12}) {
      scenes.push_back({"slope " + text(slope_deg) + ", off by " + text(off * 1e15) + "e-15",
                        a,
                        {},
                        {critical + off, slope},
                        0.005,
                        "tan(slope) - mu, which pulls the block at rest, is a rounding error"});
    }
  }
  EXPECT_EQ(expect_all_stand(scenes), 25);
}

// Still moving at the end, 1e-12 above critical friction it coasts v^2/(2 g cos 1e-12) = 1e10 m.
// That hangs on tan(slope) - mu, of which a double of 0.07 knows 1.4e-17/1e-12 = 1.4e-5. Nearer
// than 1e-12 of mu, friction is critical (input_rules_test.cpp).
TEST(stress, coasting_just_above_critical_friction_ends_and_below_is_flagged) {
  const auto a = joined(made_up_record(400, 3, 3.0), constant(50, -2.0));
  const double slope = 4 * rad_per_deg;
  const Block above{std::tan(slope) + 1e-12, slope}, below{std::tan(slope) - 1e-12, slope};
  const double exact = static_cast<double>(Reference({0.005, a}, above).slip);
  EXPECT_GT(exact, 1e9);
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    const SlipPeak stops = solver.solve({0.005, a}, above),
                   goes_on = solver.solve({0.005, a}, below);
    EXPECT_NEAR(stops.residual.along_m, exact, 1e-4 * exact);
    EXPECT_FALSE(stops.free_sliding);
    EXPECT_TRUE(goes_on.free_sliding);
    EXPECT_LT(goes_on.peak_displacement_m, 100.0);  // as it was at the last sample
  }
}

TEST(stress, slopes_to_89_9_degrees) {
  std::vector<Scene> scenes;
  for (const double slope_deg : {-89.9, -89.0, -60.0, 60.0, 89.0, 89.9}) {
    const double slope = slope_deg * rad_per_deg, critical = std::tan(std::abs(slope));
    for (const double mu : {0.3, 0.9 * critical, 1.1 * critical}) {
      // Up to 10 g, which lifts the block whenever it pulls away from the roof, and far less.
      for (const double peak : {0.5 * g / critical, 100.0}) {
        scenes.push_back({"slope " + text(slope_deg) + ", mu " + text(mu) + ", peak " + text(peak),
                          made_up_record(300, 4, peak),
                          {},
                          {mu, slope}});
      }
    }
  }
  EXPECT_GT(expect_all_stand(scenes), 24);
}

TEST(stress, samples_on_the_thresholds) {
  std::vector<Scene> scenes;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 generator(seed);
    std::vector<double> a(60);  // multiples of the yield acceleration, exactly
    for (double& x : a) x = 0.25 * g * (static_cast<double>(generator() % 7) - 3);
    scenes.push_back({"seed " + std::to_string(seed), a, {}, {.friction = 0.25}});
  }
  EXPECT_EQ(expect_all_stand(scenes), 40);
}

TEST(stress, an_acceleration_that_stays_on_a_threshold) {
  const double yield = 0.3 * g;
  const std::vector<double> push = {0.0, -2 * yield, -2 * yield};
  const char* why =
      "a is the yield acceleration up to its rounding: by that it slides, or does not";
  std::vector<Scene> scenes;
  for (const double sign : {1.0, -1.0}) {
    const auto at_threshold = constant(300, sign * yield);
    scenes.push_back({"from rest", at_threshold, {}, {.friction = 0.3}, 0.005, why});
    scenes.push_back(
        {"pushed first", joined(push, at_threshold), {}, {.friction = 0.3}, 0.005, why});
    scenes.push_back({"then released",
                      joined(joined(push, at_threshold), {0.0, 0.0, 1.0}),
                      {},
                      {.friction = 0.3},
                      0.005,
                      why});
    const double up = g * std::tan(0.1 + std::atan(0.3)), down = g * std::tan(0.1 - std::atan(0.3));
    const auto on_slope = constant(300, sign > 0 ? up : down);
    scenes.push_back({"slope", joined({0.0, -4.0, -4.0}, on_slope), {}, {0.3, 0.1}, 0.005, why});
  }
  EXPECT_GE(expect_all_stand(scenes), 6);
  for (const Solver& solver : solvers())  // at exactly mu g: rests, whatever the rounding
    EXPECT_EQ(solver.solve({0.005, scenes[0].a}, {.friction = 0.3}).slip_phases, 0u) << solver.name;
}

TEST(stress, plateaus_spikes_alternation_and_noise_to_nyquist) {
  std::vector<double> plateaus, spikes(400, 0.0), alternating(400), square;
  for (int i = 0; i < 20; ++i) plateaus = joined(plateaus, constant(17, i % 2 ? 4.0 : -(1.0 + i)));
  for (std::size_t i = 7; i < spikes.size(); i += 31) spikes[i] = i % 2 ? 3e3 : -2e3;
  for (std::size_t i = 0; i < alternating.size(); ++i) alternating[i] = i % 2 ? 9.0 : -9.0;
  for (int i = 0; i < 50; ++i) square = joined(square, constant(4, i % 2 ? 20.0 : -20.0));
  std::vector<Scene> scenes;
  for (const auto& [name, a] : std::vector<std::pair<std::string, std::vector<double>>>{
           {"plateaus", plateaus},
           {"spikes", spikes},
           {"alternating", alternating},
           {"square", square},
           {"one spike", joined(constant(50, 0.0), {500.0})},
           {"noise", white_noise(600, 5, 12.0)}}) {
    for (const double slope_deg : {0.0, 5.0}) {
      for (const double mu : {0.1, 0.4}) {
        const Block block{mu, slope_deg * rad_per_deg};
        scenes.push_back({name, a, {}, block});
        scenes.push_back({name + " with noise upright", a, white_noise(a.size(), 6, 8.0), block});
      }
    }
  }
  EXPECT_GT(expect_all_stand(scenes), 44);
}

TEST(stress, steps_from_a_microsecond_to_a_second_and_few_samples) {
  std::vector<Scene> scenes;
  for (const double dt_s : {1e-6, 1e-4, 0.01, 1.0}) {
    for (const Block& block : {Block{.friction = 0.3}, Block{0.2, 0.1}, Block{0.05, 0.1}}) {
      for (const std::vector<double>& a : {made_up_record(500, 7, 8.0),
                                           std::vector<double>{-9.0},
                                           {-9.0, 0.0},
                                           {0.0, 7.0},
                                           {-9.0, 9.0}})
        scenes.push_back(
            {"dt " + text(dt_s) + ", " + std::to_string(a.size()), a, {}, block, dt_s});
    }
  }
  EXPECT_GT(expect_all_stand(scenes), 45);
}

TEST(stress, peaks_from_1e_12_to_1e4_g) {
  std::vector<Scene> scenes;
  for (const double peak_g : {1e-12, 1e-6, 1.0, 1e2, 1e4}) {
    const auto a = made_up_record(500, 8, peak_g * g), w = made_up_record(500, 9, 0.4 * peak_g * g);
    for (const double mu : {0.4, 0.3 * peak_g}) {
      scenes.push_back({"peak " + text(peak_g) + ", mu " + text(mu), a, {}, {.friction = mu}});
      scenes.push_back({scenes.back().name + ", vertical", a, w, {.friction = mu}});
    }
  }
  EXPECT_GE(expect_all_stand(scenes), 14);
}

TEST(stress, a_large_baseline_offset) {
  std::vector<Scene> scenes;
  for (const double offset : {-500.0, -4.0, 4.0, 500.0}) {
    std::vector<double> a = made_up_record(2000, 10, 8.0);
    for (double& x : a) x += offset;
    for (const double slope : {0.0, 0.05})
      scenes.push_back({"offset " + text(offset), a, {}, {0.3, slope}});
  }
  EXPECT_EQ(expect_all_stand(scenes), 8);
}

TEST(stress, a_roof_that_falls_as_fast_as_the_block) {
  const auto a = made_up_record(400, 11, 6.0);
  std::vector<Scene> scenes;
  for (const double share : {0.5, 1 - 1e-6, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-6, 2.0}) {
    std::vector<double> w = constant(400, 0.0);
    for (std::size_t i = 100; i < 300; ++i) w[i] = -share * g;
    for (const double slope : {0.0, 0.2, -0.2})
      scenes.push_back(
          {"w = -g times 1 + " + text((share - 1) * 1e12) + "e-12", a, w, {0.3, slope}});
  }
  EXPECT_EQ(expect_all_stand(scenes), 21);
}

// An event's time is the root of a quadratic, whose square underflows for accelerations below
// 1e-154 m/s2, so slip that they alone cause has no digits, only a size. Nothing else may go wrong.
TEST(stress, subnormal_samples) {
  std::vector<double> a = made_up_record(300, 12, 1.0);
  for (double& x : a) x *= 1e-310;
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    for (const double slope : {0.0, 0.1}) {
      const SlipPeak sticking = solver.solve({0.005, a}, {.friction = 0.3, .slope_rad = slope});
      EXPECT_EQ(sticking.peak_displacement_m, 0.0);
      EXPECT_EQ(sticking.slip_phases, 0u);
    }
    const SlipPeak loose = solver.solve({0.005, a}, {.friction = 0.0});
    expect_finite_and_bounded({"", a}, loose);
    EXPECT_LE(loose.peak_displacement_m, 0.5 * 1e-310 * 1.5 * 1.5);  // of 1e-310 all the time
    // Among ordinary samples they are zeros.
    std::vector<double> mixed = made_up_record(300, 13, 8.0), zeros = mixed;
    for (std::size_t i = 0; i < mixed.size(); i += 3) mixed[i] = i % 2 ? 5e-324 : -1e-310;
    for (std::size_t i = 0; i < zeros.size(); i += 3) zeros[i] = 0.0;
    const SlipPeak r = solver.solve({0.005, mixed}, {.friction = 0.3}),
                   s = solver.solve({0.005, zeros}, {.friction = 0.3});
    EXPECT_EQ(r.peak_displacement_m, s.peak_displacement_m);
    EXPECT_EQ(r.residual.along_m, s.residual.along_m);
  }
}

// Ten million samples: a motif of 40 that the block outlives at rest, 250,000 times. Its slip is
// known to fifty digits, and the whole record's is that many times it; adding it up so often may
// round each time by half an eps of the sum.
TEST(stress, ten_million_samples) {
  constexpr std::size_t cycles = 250000;
  std::vector<double> motif(40, 0.0);
  for (std::size_t i = 2; i < 6; ++i) motif[i] = -5.0;  // slips downslope
  for (std::size_t i = 8; i < 28; ++i) motif[i] = 1.0;  // brings the roof back to rest: no slip
  const Block block{.friction = 0.25};
  const Reference once({0.01, motif}, block);
  std::vector<double> a;
  a.reserve(cycles * motif.size());
  for (std::size_t i = 0; i < cycles; ++i) a.insert(a.end(), motif.begin(), motif.end());
  const double exact = static_cast<double>(once.slip * cycles);
  EXPECT_GT(once.slip, 0.0);
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    const SlipPeak r = solver.solve({0.01, a}, block);
    EXPECT_EQ(r.slip_phases, cycles);
    EXPECT_NEAR(r.residual.along_m, exact, 0.5 * eps * cycles * exact);
    EXPECT_NEAR(r.slip_duration_s, static_cast<double>(once.duration * cycles),
                0.5 * eps * cycles * r.slip_duration_s);
  }
}

}  // namespace stress_test
}  // namespace glissade
