// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/hazard.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "glissade/core/error.hpp"
#include "worked_examples.hpp"

namespace glissade {
namespace {

using worked_examples::baker_hazard;

/// k0 theta^-k exp(k^2 beta^2 / 2).
double closed_form(double k0, double k, const FragilityCurve& fragility) {
  const double spread = k * fragility.log_std;
  return k0 * std::pow(fragility.median, -k) * std::exp(0.5 * spread * spread);
}

/// The mean of the hazard curve over the capacities, by quadrature between its points.
double by_quadrature(const HazardCurve& hazard, const FragilityCurve& fragility) {
  const auto integrand = [&](double z) {
    const double x = fragility.median * std::exp(fragility.log_std * z);
    return hazard.annual_rate(x) * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::acos(-1.0));
  };
  std::vector<double> ends = {-40.0};
  for (const HazardPoint& p : hazard.points()) {
    const double z = std::log(p.intensity / fragility.median) / fragility.log_std;
    if (z > -40.0 && z < 40.0) ends.push_back(z);
  }
  ends.push_back(40.0);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, ends[i],
                                                                         ends[i + 1], 15, 1e-14);
  return sum;
}

// The worked example of the project: 9.326575926e-4.
TEST(annual_rate, of_a_power_law_is_its_closed_form) {
  const FragilityCurve fragility{0.5, 0.4};
  const HazardCurve hazard = HazardCurve::power_law(1e-4, 2.5);
  EXPECT_NEAR(annual_rate(hazard, fragility) / 9.326575926e-4, 1.0, 1e-9);
  for (const double k : {0.1, 1.0, 3.0, 12.0})
    for (const double beta : {0.01, 0.4, 2.0})
      EXPECT_NEAR(annual_rate(HazardCurve::power_law(2e-3, k), {0.7, beta}) /
                      closed_form(2e-3, k, {0.7, beta}),
                  1.0, 1e-11)
          << k << " " << beta;
}

// A structure with 10 % at MCE and log_std 0.6 has its median at exp(0.6 x 1.2815516) MCE.
TEST(hazard_curve, of_the_risk_target_makes_collapse_1_percent_in_50_years) {
  const double mce = 1.5, median = mce * std::exp(0.6 * 1.2815515655446004);
  for (const double k : {1.0, 2.5, 4.0}) {
    const HazardCurve hazard = HazardCurve::of_risk_target(mce, k);
    EXPECT_NEAR(probability_in(50.0, annual_rate(hazard, {median, 0.6})), 0.01, 1e-12) << k;
    EXPECT_NEAR(hazard.annual_rate(1.0) / hazard.annual_rate(2.0), std::pow(2.0, k), 1e-9);
  }
  // Return periods of MCE_R of 1,000 to 3,000 years are those of the maps.
  const double period = 1.0 / HazardCurve::of_risk_target(mce, 2.0).annual_rate(mce);
  EXPECT_GT(period, 1000.0);
  EXPECT_LT(period, 3000.0);
}

TEST(annual_rate, of_a_power_law_cut_in_points_is_that_of_the_law) {
  const HazardCurve law = HazardCurve::power_law(3e-5, 2.2);
  std::vector<HazardPoint> points;
  for (double x = 0.01; x < 5.0; x *= 1.3) points.push_back({x, law.annual_rate(x)});
  for (const FragilityCurve fragility : {FragilityCurve{0.4, 0.3}, {1e-3, 0.6}, {30.0, 0.5}})
    EXPECT_NEAR(annual_rate(HazardCurve(points), fragility) / annual_rate(law, fragility), 1.0,
                1e-11)
        << fragility.median;
}

TEST(annual_rate, agrees_with_quadrature_on_tabulated_curves) {
  const HazardCurve baker(baker_hazard());
  const HazardCurve coarse({{0.05, 0.04}, {0.2, 0.01}, {0.5, 1.5e-3}, {1.0, 1e-4}, {3.0, 1e-7}});
  for (const HazardCurve& hazard : {baker, coarse})
    for (const FragilityCurve fragility : {FragilityCurve{0.5, 0.4}, {0.1, 0.2}, {1.5, 0.7}})
      EXPECT_NEAR(annual_rate(hazard, fragility) / by_quadrature(hazard, fragility), 1.0, 1e-9)
          << fragility.median;
}

// The worked example sums P at the left of each interval, which is less than the integral.
TEST(annual_rate, is_above_the_published_left_sum_by_its_discretisation_error) {
  const FragilityCurve fragility{0.5, 0.4};
  const std::vector<HazardPoint> points = baker_hazard();
  double left = 0.0, right = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double events = points[i].annual_rate - points[i + 1].annual_rate;
    left += fragility.probability(points[i].intensity) * events;
    right += fragility.probability(points[i + 1].intensity) * events;
  }
  EXPECT_NEAR(left, 5.5684640934e-05, 5e-16);
  const double rate = annual_rate(HazardCurve(points), fragility);
  EXPECT_GT(rate, left);
  EXPECT_LT(rate, right + points.back().annual_rate);
}

TEST(annual_rate, doubles_with_the_hazard_and_falls_with_the_median) {
  const FragilityCurve fragility{0.5, 0.4};
  EXPECT_NEAR(annual_rate(HazardCurve::power_law(2e-4, 2.5), fragility) /
                  annual_rate(HazardCurve::power_law(1e-4, 2.5), fragility),
              2.0, 1e-13);
  const HazardCurve baker(baker_hazard());
  EXPECT_GT(annual_rate(baker, {0.5, 0.4}), annual_rate(baker, {0.6, 0.4}));
}

TEST(annual_rate, is_infinite_where_a_share_exceeds_without_shaking) {
  EXPECT_TRUE(std::isinf(annual_rate(HazardCurve::power_law(1e-4, 2.5), {0.5, 0.4, 0.01})));
}

TEST(hazard_curve, passes_its_points_is_a_power_law_between_and_goes_on_beyond) {
  const HazardCurve hazard({{0.1, 1e-2}, {0.4, 1e-3}, {0.8, 1e-5}});
  for (const HazardPoint& p : hazard.points()) {
    EXPECT_NEAR(hazard.annual_rate(p.intensity) / p.annual_rate, 1.0, 1e-14);
    EXPECT_NEAR(hazard.intensity_at(p.annual_rate) / p.intensity, 1.0, 1e-14);
  }
  EXPECT_NEAR(hazard.annual_rate(0.2), std::sqrt(1e-5), 1e-16);
  EXPECT_NEAR(hazard.annual_rate(1.6), 1e-7, 1e-20);  // two decades for a factor of two
  EXPECT_NEAR(hazard.annual_rate(0.025), 1e-1, 1e-15);
  for (const double x : {0.001, 0.13, 0.7, 9.0})
    EXPECT_NEAR(hazard.intensity_at(hazard.annual_rate(x)) / x, 1.0, 1e-13);
  EXPECT_TRUE(std::isinf(hazard.annual_rate(0.0)));
}

TEST(hazard_curve, refuses_what_is_no_curve) {
  using Points = std::vector<HazardPoint>;
  for (const Points& points :
       {Points{}, Points{{1, 1e-3}}, Points{{1, 1e-3}, {2, 1e-3}}, Points{{1, 1e-3}, {1, 1e-4}},
        Points{{2, 1e-3}, {1, 1e-4}}, Points{{0, 1e-3}, {1, 1e-4}}, Points{{1, 1e-3}, {2, 0}},
        Points{{1, 1e-3}, {NAN, 1e-4}}})
    EXPECT_THROW(HazardCurve{points}, InputError);
  EXPECT_THROW(HazardCurve::power_law(0.0, 2.5), InputError);
  EXPECT_THROW(HazardCurve::power_law(1e-4, -1.0), InputError);
}

// 1 % in 50 years is 2.0101e-4 a year (ln(100/99)/50).
TEST(probability_in, is_that_of_a_poisson_process) {
  EXPECT_NEAR(rate_of(0.01, 50.0), std::log(100.0 / 99.0) / 50.0, 1e-17);
  EXPECT_NEAR(probability_in(50.0, rate_of(0.01, 50.0)), 0.01, 1e-16);
  EXPECT_EQ(probability_in(25.0, 0.0), 0.0);
  EXPECT_EQ(probability_in(25.0, INFINITY), 1.0);
}

}  // namespace
}  // namespace glissade
