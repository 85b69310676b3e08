// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glissade/motion/simulation/scenario.hpp"

namespace glissade {

/// Correlation of the epsilons of ln Sa (RotD50 or geometric mean, 5 %) at two periods: Baker &
/// Jayaram (2008), Earthquake Spectra 24(1):299-317, equation 9. Its range is 0.01 to 10 s; shorter
/// periods, and PGA (0), are taken as 0.01 s.
double epsilon_correlation(double period_s, double other_period_s);

/// ln Sa (Sa in g) at some periods, jointly normal.
struct SpectrumDistribution {
  std::vector<double> periods_s;
  std::vector<double> mean;
  std::vector<double> covariance;  ///< by row

  std::size_t size() const { return periods_s.size(); }
  double covariance_of(std::size_t i, std::size_t j) const { return covariance[i * size() + j]; }
  double sigma(std::size_t i) const;
  /// exp(mean + deviations x sigma), in g.
  double sa_g(std::size_t i, double deviations = 0.0) const;
};

/// Of means and standard deviations by period, correlated by epsilon_correlation().
SpectrumDistribution correlated_spectrum(std::vector<double> periods_s, std::vector<double> mean,
                                         const std::vector<double>& sigma);

/// Of an earthquake and a site, after BSSA14 (RotD50).
SpectrumDistribution bssa14_spectrum(const Scenario& scenario, std::vector<double> periods_s);

/// The same with Sa at one of its periods known: the conditional spectrum, whose mean is the
/// conditional mean spectrum (Baker 2011, J. Struct. Eng. 137(3):322-331; Jayaram, Lin & Baker
/// 2011, Earthquake Spectra 27(3):797-815). At that period sigma is 0.
SpectrumDistribution conditional_on(const SpectrumDistribution& all, std::size_t period,
                                    double sa_g);

/// By how many standard deviations ln(sa_g) is above the mean at a period.
double epsilon_of(const SpectrumDistribution& all, std::size_t period, double sa_g);

/// `count` periods of equal ratios from one to the other; in place of the nearest `period_s`.
std::vector<double> spectrum_periods_s(double from_s, double to_s, std::size_t count,
                                       double period_s);

}  // namespace glissade
