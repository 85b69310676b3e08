// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// The spectra of the motions of a suite in g, all at the same periods.
using Spectra = std::vector<std::span<const double>>;

/// 5 % SRSS spectrum of the unscaled horizontals, in g.
std::vector<double> srss_spectrum_g(const Motion& motion, std::span<const double> periods_s);

/// The target at each period, > 0.
std::vector<double> target_at(const std::function<double(double)>& target_sa_g,
                              const std::vector<double>& periods_s);

/// The factor for which a spectrum is closest to the target in least squares of ln Sa: the mean log
/// ratio.
double closest_factor(std::span<const double> spectrum_g, std::span<const double> target_g);

/// An average spectrum over the target at one of the periods.
struct AverageRatio {
  std::size_t period = 0;
  double ratio = 0.0;
};

/// Average over the motions of factor x spectrum, over the target, at each period.
std::vector<double> average_ratios(const std::vector<double>& factors, const Spectra& spectra,
                                   std::span<const double> target_g);
/// The lowest of them.
AverageRatio lowest_ratio(const std::vector<double>& factors, const Spectra& spectra,
                          std::span<const double> target_g);

struct LiftedFactors {
  std::vector<double> factors;
  std::size_t controlling_period = 0;
};

/// min(c x closest, max_factor) of each motion, c the least for which the average is nowhere below
/// the target. All at max_factor if the target is not reached.
LiftedFactors lift_to_target(const std::vector<double>& closest_factors, const Spectra& spectra,
                             std::span<const double> target_g, double max_factor);

}  // namespace glissade
