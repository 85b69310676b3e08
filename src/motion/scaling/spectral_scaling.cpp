// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectral_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

/// Order in which motions reach their limit.
std::vector<std::size_t> largest_first(const std::vector<double>& factors) {
  std::vector<std::size_t> order(factors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    return factors[i] != factors[j] ? factors[i] > factors[j] : i < j;
  });
  return order;
}

/// The least common factor c with (1/n) sum_j min(c f_j, f_max) S_j >= target at one period, if all
/// motions at f_max suffice. The left side is concave and piecewise linear in c, with a corner
/// at each c = f_max / f_j; `order` is that of the corners.
double common_factor(const std::vector<double>& factors, const std::vector<std::size_t>& order,
                     const std::vector<double>& sa_g, double max_factor, double target_g) {
  double needed = target_g * static_cast<double>(factors.size());  // from motions below max_factor
  double slope = 0.0;
  for (const std::size_t j : order) slope += factors[j] * sa_g[j];
  for (const std::size_t j : order) {
    if (needed <= slope * (max_factor / factors[j])) return needed / slope;
    needed -= max_factor * sa_g[j];
    slope -= factors[j] * sa_g[j];
  }
  return max_factor / factors[order.back()];
}

/// The spectra of the motions at one period.
void set_column(const Spectra& spectra, std::size_t period, std::vector<double>& sa_g) {
  for (std::size_t j = 0; j < spectra.size(); ++j) sa_g[j] = spectra[j][period];
}

}  // namespace

std::vector<double> srss_spectrum_g(const Motion& motion, std::span<const double> periods_s) {
  std::vector<double> spectrum =
      horizontal_spectrum_mps2(motion, periods_s, HorizontalCombination::srss);
  for (double& sa : spectrum) sa /= standard_gravity_mps2;
  return spectrum;
}

std::vector<double> target_at(const std::function<double(double)>& target_sa_g,
                              const std::vector<double>& periods_s) {
  std::vector<double> target(periods_s.size());
  std::ranges::transform(periods_s, target.begin(), target_sa_g);
  GLISSADE_EXPECTS(
      std::ranges::all_of(target, [](double sa) { return std::isfinite(sa) && sa > 0.0; }));
  return target;
}

double closest_factor(std::span<const double> spectrum_g, std::span<const double> target_g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < target_g.size(); ++i) sum += std::log(target_g[i] / spectrum_g[i]);
  return std::exp(sum / static_cast<double>(target_g.size()));
}

std::vector<double> average_ratios(const std::vector<double>& factors, const Spectra& spectra,
                                   std::span<const double> target_g) {
  std::vector<double> ratios(target_g.size());
  std::vector<double> sa_g(spectra.size());
  for (std::size_t i = 0; i < target_g.size(); ++i) {
    set_column(spectra, i, sa_g);
    const double sum = std::inner_product(factors.begin(), factors.end(), sa_g.begin(), 0.0);
    ratios[i] = sum / static_cast<double>(factors.size()) / target_g[i];
  }
  return ratios;
}

AverageRatio lowest_ratio(const std::vector<double>& factors, const Spectra& spectra,
                          std::span<const double> target_g) {
  const std::vector<double> ratios = average_ratios(factors, spectra, target_g);
  const auto lowest = std::ranges::min_element(ratios);
  return {static_cast<std::size_t>(lowest - ratios.begin()), *lowest};
}

LiftedFactors lift_to_target(const std::vector<double>& closest_factors, const Spectra& spectra,
                             std::span<const double> target_g, double max_factor) {
  LiftedFactors lifted{closest_factors};
  const std::vector<std::size_t> order = largest_first(closest_factors);
  std::vector<double> sa_g(spectra.size());
  double common = 0.0;
  for (std::size_t i = 0; i < target_g.size(); ++i) {
    set_column(spectra, i, sa_g);
    const double factor = common_factor(closest_factors, order, sa_g, max_factor, target_g[i]);
    if (factor > common) {
      common = factor;
      lifted.controlling_period = i;
    }
  }
  for (double& factor : lifted.factors) factor = std::min(common * factor, max_factor);
  return lifted;
}

}  // namespace glissade
