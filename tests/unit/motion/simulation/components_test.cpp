// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/components.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "glissade/motion/simulation/gain_calibration.hpp"

namespace glissade {
namespace {

constexpr Scenario scenario{7.0, 20.0, 400.0, FaultMechanism::strike_slip};
constexpr std::size_t draws = 4000;

std::vector<ComponentParameters> draw_many() {
  std::vector<ComponentParameters> parameters;
  for (std::uint64_t k = 0; k < draws; ++k)
    parameters.push_back(draw_component_parameters(scenario, {3, k}));
  return parameters;
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<double>(i);
  return rank;
}

/// Spearman's rank correlation, which does not see the marginal distributions.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const auto rx = ranks(x), ry = ranks(y);
  const auto n = static_cast<double>(x.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(rx[i] - ry[i], 2);
  return 1.0 - 6.0 * squares / (n * (n * n - 1.0));
}

/// Of a bivariate normal distribution with Pearson correlation rho (Kruskal 1958).
double normal_rank_correlation(double rho) { return 6.0 / std::numbers::pi * std::asin(0.5 * rho); }

// Standard error of Spearman's coefficient is below 1.1 (1 - rho^2) / sqrt(n) here: limits at 4 of
// them (99.99 %).
TEST(component_parameters, correlate_within_and_across_axes_as_published) {
  std::vector<double> arias, duration, middle, frequency, other_frequency, other_duration;
  for (const ComponentParameters& p : draw_many()) {
    arias.push_back(p.major.arias_g2s * p.intermediate.arias_g2s);  // the square of the common mean
    duration.push_back(p.major.significant_duration_s);
    middle.push_back(p.major.middle_time_s);
    frequency.push_back(p.major.middle_frequency_hz);
    other_frequency.push_back(p.intermediate.middle_frequency_hz);
    other_duration.push_back(p.intermediate.significant_duration_s);
  }
  const auto check = [](const std::vector<double>& x, const std::vector<double>& y, double rho) {
    const double error = 1.1 * (1.0 - rho * rho) / std::sqrt(static_cast<double>(draws));
    EXPECT_NEAR(rank_correlation(x, y), normal_rank_correlation(rho), 4.0 * error);
  };
  check(arias, duration, -.3555);
  check(arias, other_duration, -.3555);
  check(duration, middle, .6729);
  check(frequency, other_frequency, .897);
  check(duration, other_duration, .848);
}

// ln(J major / J intermediate) ~ N(.55, .345) at M 7; limits at 99.99 %.
TEST(component_parameters, have_the_arias_ratio_of_the_principal_axes) {
  double sum = 0.0, squares = 0.0;
  for (const ComponentParameters& p : draw_many()) {
    const double log_ratio = std::log(p.major.arias_g2s / p.intermediate.arias_g2s);
    sum += log_ratio;
    squares += log_ratio * log_ratio;
  }
  const double mean = sum / draws, log_std = std::sqrt(squares / draws - mean * mean);
  EXPECT_NEAR(mean, 0.55, 3.89 * 0.345 / std::sqrt(draws));
  EXPECT_NEAR(log_std, 0.345, 3.89 * 0.345 / std::sqrt(2.0 * draws));
}

TEST(raw_motion, is_the_same_whenever_it_is_simulated_and_another_for_another_key) {
  const RawMotion first = simulate_raw_motion(scenario, {1, 7}, 0.01);
  const RawMotion other = simulate_raw_motion(scenario, {1, 8}, 0.01);
  EXPECT_EQ(first.acceleration_mps2, simulate_raw_motion(scenario, {1, 7}, 0.01).acceleration_mps2);
  EXPECT_NE(first.acceleration_mps2[0], other.acceleration_mps2[0]);
  EXPECT_NE(first.acceleration_mps2[0],
            simulate_raw_motion(scenario, {2, 7}, 0.01).acceleration_mps2[0]);
}

TEST(raw_motion, has_three_components_of_equal_length_that_differ) {
  const auto [dt_s, a] = simulate_raw_motion(scenario, {1, 7}, 0.01);
  EXPECT_EQ(a[0].size(), a[1].size());
  EXPECT_EQ(a[0].size(), a[2].size());
  EXPECT_NE(a[0], a[1]);
  EXPECT_NE(a[0], a[2]);
}

// Vertical: J x .35 of the common mean of the axes, the middle frequency x 1.8 of the major one.
TEST(component_parameters, derive_the_vertical_from_the_horizontals) {
  const ComponentParameters p = draw_component_parameters(scenario, {3, 1});
  EXPECT_NEAR(p.vertical.arias_g2s, 0.35 * std::sqrt(p.major.arias_g2s * p.intermediate.arias_g2s),
              1e-12);
  EXPECT_DOUBLE_EQ(p.vertical.middle_frequency_hz, 1.8 * p.major.middle_frequency_hz);
}

// Thirty simulations are enough to see the iteration converge: the ensemble's own median ratio goes
// to one.
TEST(calibrate_gain, brings_the_ensemble_median_to_the_target) {
  std::vector<EnsembleMember> ensemble;
  for (std::uint64_t k = 0; k < 30; ++k)
    ensemble.push_back({scenario, simulate_raw_motion(scenario, {3, k}, 0.01)});
  const SuiteGain gain = calibrate_gain(ensemble);
  const std::vector<double> periods_s = {0.1, 0.2, 0.3, 0.5, 1.0, 2.0};
  std::vector<double> horizontal(periods_s.size(), 0.0), vertical(periods_s.size(), 0.0);
  const auto target_h = target_horizontal_mps2(scenario, periods_s),
             target_v = target_vertical_mps2(scenario, periods_s);
  for (const EnsembleMember& member : ensemble) {
    const RawMotion motion = shape_motion(member.raw, gain);
    const auto h = horizontal_rotd50_mps2(motion, periods_s),
               v = vertical_spectrum_mps2(motion, periods_s);
    for (std::size_t p = 0; p < periods_s.size(); ++p) {
      horizontal[p] += std::log(h[p] / target_h[p]) / 30.0;
      vertical[p] += std::log(v[p] / target_v[p]) / 30.0;
    }
  }
  for (std::size_t p = 0; p < periods_s.size(); ++p) {
    EXPECT_NEAR(horizontal[p], 0.0, 0.1) << periods_s[p] << " s";
    EXPECT_NEAR(vertical[p], 0.0, 0.1) << periods_s[p] << " s";
  }
}

}  // namespace
}  // namespace glissade
