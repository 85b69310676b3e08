// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// Of Walters et al. (2012), who scale from 0 to here.
inline constexpr double longest_scaled_period_s = 2.0;
/// To where a suite is judged for buildings of up to this period (1.5 times it: ASCE 7-16, 16.2,
/// recalled), where that is beyond longest_scaled_period_s.
constexpr double judged_to_s(double longest_period_s) { return 1.5 * longest_period_s; }
/// Of a suite that is scaled to 1.5 times a building period.
inline constexpr double longest_possible_scaled_s = 30.0;
/// The least average SRSS spectrum over the target of a suite that meets it: up to there (nowhere
/// below, but for rounding of the factors), and beyond (ASCE 7-16, 16.2, recalled).
inline constexpr double least_over_target = 0.98, least_over_target_beyond = 0.9;

/// The periods at which the suite average must not be below the target (0 to 2 s, Walters et al.
/// 2012; the steps are not from there): to 0.2 s by 0.001, to 0.5 s by 0.0025, to 2 s by 0.005.
std::vector<double> walters_periods_s();
/// From 2 s to `to_s` (> 2), by 0.5 %.
std::vector<double> periods_beyond_scaled_s(double to_s);

/// 5 % SRSS spectra of the unscaled horizontals in g: by motion, then by period.
using SpectrumRows = std::vector<std::vector<double>>;

/// The one factor on the whole suite (each motion's own `scale` applied first) for which the
/// average over motions of the SRSS spectra of their horizontals (5 %) is nowhere below
/// `target_sa_g` over `periods_s` and equal to it at one period at least (Walters et al. 2012).
/// Period 0 compares the SRSS of the peak accelerations of the components. `target_sa_g` gives g, >
/// 0, at each of `periods_s` (>= 0, one at least). Throws InputError for a suite without motions or
/// with one that is zero throughout.
double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const std::vector<double>& periods_s);
/// The same over walters_periods_s(), at which the spectra of the motions are given.
double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const SpectrumRows& walters_spectra_g);

/// Multiplies the scale of each motion by the median PGV of the suite over its own, so that motions
/// differ by their nature and not by how strong their earthquakes were (FEMA P-695, 2009, A.8,
/// recalled). PGV: geometric mean of both horizontals, times the motion's scale. Throws InputError
/// as suite_average_factor does.
void normalise_by_pgv(Suite& suite);

/// An average spectrum over its target, at a period.
struct SpectralRatio {
  double ratio = std::numeric_limits<double>::quiet_NaN();
  double period_s = std::numeric_limits<double>::quiet_NaN();
};

/// Where the average over motions of factor x SRSS spectrum (5 %) is lowest and highest relative to
/// the target. NaN without a target.
struct SpectralRatios {
  SpectralRatio lowest, highest;
};

/// From 0 to 2 s: at walters_periods_s(), and between them where they may come near the extreme, to
/// a hundredth of their step. `factors`: one per motion, in place of Motion::scale.
SpectralRatios ratios_to_target(const Suite& suite, const std::vector<double>& factors,
                                const std::function<double(double)>& target_sa_g);
/// The same with the spectra of the motions at walters_periods_s() given.
SpectralRatios ratios_to_target(const Suite& suite, const std::vector<double>& factors,
                                const std::function<double(double)>& target_sa_g,
                                const SpectrumRows& walters_spectra_g);

/// The same over `periods_s` (>= 0, one at least), and at these only: the lowest.
SpectralRatio lowest_ratio_to_target(const Suite& suite, const std::vector<double>& factors,
                                     const std::function<double(double)>& target_sa_g,
                                     const std::vector<double>& periods_s);

struct SuiteScaling {
  std::vector<double> factors;  ///< per motion, on all its components
  double largest_factor = 0.0;
  double controlling_period_s = 0.0;  ///< where the average is equal to the target
};

/// One factor per motion, as in Walters et al. (2012): the SRSS spectrum of each motion is first
/// scaled closest to the target (least squares in ln Sa over the periods), then one common factor
/// raises the average until it is nowhere below the target. Motions that would exceed `max_factor`
/// (> 0) are limited to it, and the factors of the others are increased. The factors replace
/// Motion::scale, which is ignored. Throws InputError as suite_average_factor does, and if all
/// motions at `max_factor` do not reach the target.
SuiteScaling scale_suite_to_target(const Suite& suite,
                                   const std::function<double(double)>& target_sa_g,
                                   const std::vector<double>& periods_s, double max_factor);

}  // namespace glissade
