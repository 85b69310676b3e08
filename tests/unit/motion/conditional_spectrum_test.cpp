// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/conditional_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/motion/simulation/bssa14.hpp"

namespace glissade {
namespace {

struct Point {
  double period_s, value;
};

// Baker & Jayaram (2008), Fig. 4, digitised by the authors of pygmm
// (arkottke/pygmm, tests/data/baker_jayaram_2008.json).
constexpr Point figure_4_with_half_a_second[] = {
    {0.0100194, 0.681997}, {0.019925, 0.668493}, {0.030029, 0.648061}, {0.049796, 0.59341},
    {0.074607, 0.520139},  {0.099442, 0.47521},  {0.149264, 0.574151}, {0.20032, 0.672082},
    {0.24946, 0.750422},   {0.30082, 0.815054},  {0.39946, 0.917874},  {0.50013, 1.001108},
    {0.74873, 0.854452},   {0.99733, 0.748858},  {1.49322, 0.611007},  {1.9892, 0.516177},
    {2.4865, 0.44579},     {2.9787, 0.391046},   {3.9901, 0.312851},   {4.9616, 0.255183},
    {7.4325, 0.165278},    {9.9058, 0.112522}};
constexpr Point figure_4_with_ten_seconds[] = {
    {0.0099529, 0.05675}, {0.019795, 0.054988}, {0.029838, 0.049233}, {0.0495, 0.0347},
    {0.074206, 0.015245}, {0.098944, 0.004563}, {0.149147, 0.000766}, {0.19785, 0.01063},
    {0.24753, 0.025371},  {0.29677, 0.042056},  {0.39589, 0.076385},  {0.49277, 0.111672},
    {0.74343, 0.188109},  {0.99739, 0.254729},  {1.49722, 0.361497},  {1.9877, 0.445726},
    {2.4883, 0.51624},    {2.9688, 0.575977},   {3.9842, 0.672929},   {4.988, 0.751271},
    {7.4906, 0.8962},     {9.947, 1.001955}};

TEST(epsilon_correlation, is_that_of_figure_4_of_baker_and_jayaram) {
  constexpr double digitised = 0.008;  // as its points at equal periods show: 1.0020 for 1
  for (const auto& [period_s, rho] : figure_4_with_half_a_second)
    EXPECT_NEAR(epsilon_correlation(period_s, 0.5), rho, digitised) << period_s;
  for (const auto& [period_s, rho] : figure_4_with_ten_seconds)
    EXPECT_NEAR(epsilon_correlation(period_s, 10.0), rho, digitised) << period_s;
}

TEST(epsilon_correlation, is_one_of_equal_periods_and_symmetric_and_nowhere_above_one) {
  std::vector<double> periods_s{0.0};
  for (double t = 0.01; t < 10.0; t *= 1.1) periods_s.push_back(t);
  for (const double a : periods_s) {
    EXPECT_EQ(epsilon_correlation(a, a), 1.0);
    for (const double b : periods_s) {
      const double rho = epsilon_correlation(a, b);
      EXPECT_EQ(rho, epsilon_correlation(b, a));
      EXPECT_GE(rho, 0.0);
      EXPECT_LE(rho, 1.0);
    }
  }
}

// The coefficients as bakerjw/GMMs (correlations/bj_2008_corr.m) and OpenQuake
// (hazardlib/cross_correlation.py) have them.
TEST(epsilon_correlation, follows_each_of_its_four_cases) {
  EXPECT_NEAR(epsilon_correlation(1.0, 0.2), 1.0 - std::sin(0.366 * std::log(5.0)), 1e-15);
  EXPECT_NEAR(epsilon_correlation(0.1, 0.05),
              1.0 - 0.105 * (1.0 - 1.0 / (1.0 + std::exp(5.0))) * 0.05 / 0.0901, 1e-15);
  // Between 0.109 and 0.2 s the smaller of C2 and C4: here C4, there C2.
  const double c1_at_0_15 = 1.0 - std::sin(0.366 * std::log(0.15 / 0.109));
  EXPECT_NEAR(epsilon_correlation(0.15, 0.1),
              c1_at_0_15 + 0.5 * (std::sqrt(c1_at_0_15) - c1_at_0_15) *
                               (1.0 + std::cos(std::acos(-1.0) * 0.1 / 0.109)),
              1e-15);
  EXPECT_NEAR(epsilon_correlation(0.15, 0.02),
              1.0 - 0.105 * (1.0 - 1.0 / (1.0 + std::exp(10.0))) * 0.13 / 0.1401, 1e-15);
  const double c1 = 1.0 - std::sin(0.366 * std::log(1.0 / 0.109));
  EXPECT_NEAR(epsilon_correlation(1.0, 0.0545), c1 + 0.5 * (std::sqrt(c1) - c1), 1e-15);
}

// Medians (g) and standard deviations of a scenario, and below its conditional spectra, of pygmm's
// tests (four digits; tests/data/baker_jayaram_2008.json and kishida_2017.json).
const std::vector<double> periods_s{0.010, 0.020, 0.030, 0.050, 0.075, 0.100, 0.150,
                                    0.200, 0.250, 0.300, 0.400, 0.500, 0.750, 1.000,
                                    1.500, 2.000, 3.000, 4.000, 5.000, 7.500, 10.000};
const std::vector<double> medians_g{0.2858, 0.2906, 0.3030, 0.3276, 0.3859, 0.4503, 0.5490,
                                    0.5914, 0.6072, 0.5886, 0.5361, 0.4653, 0.3379, 0.2582,
                                    0.1603, 0.1131, 0.0662, 0.0440, 0.0311, 0.0135, 0.0071};
const std::vector<double> sigmas{0.4985, 0.4963, 0.5003, 0.4941, 0.4935, 0.4985, 0.5157,
                                 0.5326, 0.5500, 0.5662, 0.5896, 0.6078, 0.6316, 0.6430,
                                 0.6548, 0.6628, 0.6677, 0.6699, 0.6812, 0.7093, 0.7295};

SpectrumDistribution published() {
  std::vector<double> mean;
  for (const double sa_g : medians_g) mean.push_back(std::log(sa_g));
  return correlated_spectrum(periods_s, mean, sigmas);
}

std::size_t index_of(double period_s) {
  return static_cast<std::size_t>(std::ranges::find(periods_s, period_s) - periods_s.begin());
}

void expect_spectrum(const SpectrumDistribution& found, const std::vector<double>& sa_g,
                     const std::vector<double>& sigma) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    constexpr double four_digits = 1e-4;
    EXPECT_NEAR(found.sa_g(i), sa_g[i], four_digits + 5e-4 * sa_g[i]) << found.periods_s[i];
    EXPECT_NEAR(found.sigma(i), sigma[i], four_digits + 5e-4 * sigma[i]) << found.periods_s[i];
  }
}

TEST(conditional_spectrum, is_that_published_for_pga) {
  expect_spectrum(
      conditional_on(published(), index_of(0.01), 0.4837),
      {0.4837, 0.4894, 0.5104, 0.5371, 0.6176, 0.7215, 0.8936, 0.9704, 0.9855, 0.9467, 0.8455,
       0.7206, 0.5000, 0.3673, 0.2144, 0.1444, 0.0789, 0.0498, 0.0339, 0.0137, 0.0074},
      {0.0000, 0.0492, 0.0787, 0.1578, 0.2119, 0.2216, 0.2300, 0.2521, 0.3032, 0.3432, 0.4016,
       0.4446, 0.5110, 0.5496, 0.5941, 0.6211, 0.6469, 0.6596, 0.6765, 0.7092, 0.7282});
}

TEST(conditional_spectrum, is_that_published_for_a_short_period) {
  expect_spectrum(
      conditional_on(published(), index_of(0.2), 1.1067),
      {0.4791, 0.4842, 0.5041, 0.5333, 0.6149, 0.7122, 0.9449, 1.1067, 1.1001, 1.0383, 0.9014,
       0.7518, 0.5029, 0.3614, 0.2064, 0.1379, 0.0753, 0.0480, 0.0331, 0.0139, 0.0071},
      {0.2360, 0.2406, 0.2512, 0.2696, 0.2944, 0.3111, 0.2301, 0.0000, 0.2176, 0.2963, 0.3906,
       0.4507, 0.5336, 0.5760, 0.6187, 0.6412, 0.6587, 0.6658, 0.6793, 0.7090, 0.7294});
}

TEST(conditional_spectrum, is_that_published_for_a_long_period) {
  expect_spectrum(
      conditional_on(published(), index_of(2.0), 0.2678),
      {0.3584, 0.3608, 0.3716, 0.3858, 0.4320, 0.4896, 0.6226, 0.7049, 0.7580, 0.7672, 0.7537,
       0.6985, 0.5757, 0.4829, 0.3435, 0.2678, 0.1388, 0.0844, 0.0564, 0.0222, 0.0108},
      {0.4671, 0.4675, 0.4750, 0.4779, 0.4858, 0.4944, 0.5066, 0.5152, 0.5228, 0.5282, 0.5282,
       0.5213, 0.4807, 0.4260, 0.2922, 0.0000, 0.3494, 0.4438, 0.5052, 0.5993, 0.6535});
}

// Known at six periods, one after the other: right only where every covariance is.
TEST(conditional_spectrum, has_the_covariances_that_kishida_s_spectrum_of_six_known_periods_needs) {
  SpectrumDistribution given = published();
  for (const auto& [period_s, sa_g] : {Point{0.1, 0.7842},
                                       {0.15, 0.9842},
                                       {0.2, 1.1067},
                                       {0.5, 0.9540},
                                       {0.75, 0.7181},
                                       {1.0, 0.5627}})
    given = conditional_on(given, index_of(period_s), sa_g);
  expect_spectrum(
      given,
      {0.5436, 0.5489, 0.5704, 0.5965, 0.6789, 0.7842, 0.9842, 1.1067, 1.1561, 1.1413, 1.0708,
       0.9540, 0.7181, 0.5627, 0.3055, 0.1967, 0.1016, 0.0623, 0.0419, 0.0168, 0.0084},
      {0.1377, 0.1331, 0.1323, 0.1270, 0.1089, 0.0000, 0.0000, 0.0000, 0.1939, 0.2313, 0.2079,
       0.0000, 0.0000, 0.0000, 0.3403, 0.4345, 0.5227, 0.5666, 0.6020, 0.6623, 0.6985});
}

TEST(conditional_spectrum, of_bssa14_is_mu_plus_rho_epsilon_sigma) {
  const Scenario scenario{7.0, 12.0, 400.0};
  const SpectrumDistribution all = bssa14_spectrum(scenario, {0.2, 0.5, 1.0});
  const double sa_g = 1.3, epsilon = epsilon_of(all, 1, sa_g);
  EXPECT_NEAR(
      epsilon,
      std::log(sa_g / bssa14_median_sa_g(scenario, 0.5)) / bssa14_dispersion(scenario, 0.5).total(),
      1e-14);
  const SpectrumDistribution given = conditional_on(all, 1, sa_g);
  for (std::size_t i = 0; i < 3; ++i) {
    const double rho = epsilon_correlation(all.periods_s[i], 0.5),
                 sigma = bssa14_dispersion(scenario, all.periods_s[i]).total();
    EXPECT_NEAR(given.mean[i],
                std::log(bssa14_median_sa_g(scenario, all.periods_s[i])) + rho * epsilon * sigma,
                1e-14);
    EXPECT_NEAR(given.sigma(i), sigma * std::sqrt(1.0 - rho * rho), 1e-14);
  }
}

TEST(spectrum_periods, have_the_stated_one_in_place_of_the_nearest) {
  EXPECT_EQ(spectrum_periods_s(0.1, 10.0, 3, 0.5), (std::vector{0.1, 0.5, 10.0}));
}

}  // namespace
}  // namespace glissade
