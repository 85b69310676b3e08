// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/conditional_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/motion/simulation/bssa14.hpp"

namespace glissade {

double epsilon_correlation(double period_s, double other_period_s) {
  constexpr double shortest_s = 0.01, hinge_s = 0.109, long_s = 0.2;
  const double t_min = std::max(std::min(period_s, other_period_s), shortest_s),
               t_max = std::max({period_s, other_period_s, shortest_s});
  if (t_min == t_max) return 1.0;
  const auto c1 = [&] {
    return 1.0 - std::sin(0.366 * std::log(t_max / std::max(t_min, hinge_s)));
  };
  const auto c2 = [&] {
    return 1.0 - 0.105 * (1.0 - 1.0 / (1.0 + std::exp(100.0 * t_max - 5.0))) * (t_max - t_min) /
                     (t_max - 0.0099);
  };
  const auto c4 = [&] {
    return c1() +
           0.5 * (std::sqrt(c1()) - c1()) * (1.0 + std::cos(std::numbers::pi * t_min / hinge_s));
  };
  if (t_max <= hinge_s) return c2();
  if (t_min > hinge_s) return c1();
  return t_max < long_s ? std::min(c2(), c4()) : c4();
}

double SpectrumDistribution::sigma(std::size_t i) const { return std::sqrt(covariance_of(i, i)); }

double SpectrumDistribution::sa_g(std::size_t i, double deviations) const {
  return std::exp(mean[i] + deviations * sigma(i));
}

SpectrumDistribution correlated_spectrum(std::vector<double> periods_s, std::vector<double> mean,
                                         const std::vector<double>& sigma) {
  GLISSADE_EXPECTS(periods_s.size() == mean.size() && mean.size() == sigma.size());
  SpectrumDistribution all{std::move(periods_s), std::move(mean), {}};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j)
      all.covariance.push_back(epsilon_correlation(all.periods_s[i], all.periods_s[j]) * sigma[i] *
                               sigma[j]);
  return all;
}

SpectrumDistribution bssa14_spectrum(const Scenario& scenario, std::vector<double> periods_s) {
  std::vector<double> mean, sigma;
  for (const double period_s : periods_s) {
    mean.push_back(std::log(bssa14_median_sa_g(scenario, period_s)));
    sigma.push_back(bssa14_dispersion(scenario, period_s).total());
  }
  return correlated_spectrum(std::move(periods_s), std::move(mean), sigma);
}

double epsilon_of(const SpectrumDistribution& all, std::size_t period, double sa_g) {
  return (std::log(sa_g) - all.mean[period]) / all.sigma(period);
}

SpectrumDistribution conditional_on(const SpectrumDistribution& all, std::size_t period,
                                    double sa_g) {
  GLISSADE_EXPECTS(period < all.size() && sa_g > 0.0 && all.sigma(period) > 0.0);
  const double variance = all.covariance_of(period, period),
               difference = std::log(sa_g) - all.mean[period];
  SpectrumDistribution given = all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double with_known = all.covariance_of(i, period);
    given.mean[i] += with_known / variance * difference;
    for (std::size_t j = 0; j < all.size(); ++j) {
      double& covariance = given.covariance[i * all.size() + j];
      covariance -= with_known * all.covariance_of(period, j) / variance;
      if (i == period || j == period) covariance = 0.0;
      if (i == j) covariance = std::max(covariance, 0.0);
    }
  }
  given.mean[period] = std::log(sa_g);
  return given;
}

std::vector<double> spectrum_periods_s(double from_s, double to_s, std::size_t count,
                                       double period_s) {
  GLISSADE_EXPECTS(0.0 < from_s && from_s < to_s && count >= 2 && period_s > 0.0);
  std::vector<double> periods_s;
  for (std::size_t i = 0; i < count; ++i)
    periods_s.push_back(
        from_s * std::pow(to_s / from_s, static_cast<double>(i) / static_cast<double>(count - 1)));
  *std::ranges::min_element(
      periods_s, {}, [&](double t_s) { return std::abs(std::log(t_s / period_s)); }) = period_s;
  return periods_s;
}

}  // namespace glissade
