// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "glissade/motion/simulation/scenario.hpp"

namespace glissade {

/// The six parameters of the stochastic model of Rezaeian & Der Kiureghian (2010), EESD
/// 39:1155-1180 ("RDK10").
struct Rdk10Parameters {
  double arias_g2s = 0.0;               ///< J, the integral of a^2 in g^2 s
  double significant_duration_s = 0.0;  ///< D5-95: from 5 % to 95 % of J
  double middle_time_s = 0.0;           ///< time at which 45 % of J is reached
  double middle_frequency_hz = 0.0;     ///< of the filter, at the middle time
  double frequency_slope_hzps = 0.0;    ///< its rate of change
  double damping_ratio = 0.0;           ///< of the filter
};

using Rdk10Scores =
    std::array<double, 6>;  ///< standard normal scores of the six parameters, in that order

/// Predictive equations: mean scores given magnitude, distance, Vs30 and mechanism. Calibrated on
/// firm ground, R > 10 km (about M >= 6, Vs30 >= 600 m/s); used outside that range only together
/// with the suite gain.
Rdk10Scores rdk10_mean_scores(const Scenario& scenario);

/// Total standard deviations of the scores (between and within earthquakes) and the correlation of
/// their residuals.
Rdk10Scores rdk10_score_deviations();
std::array<Rdk10Scores, 6> rdk10_score_correlation();

/// The parameters whose marginal distributions have these scores: theta_i = F_i^-1(Phi(nu_i)).
Rdk10Parameters rdk10_parameters(const Rdk10Scores& scores);

}  // namespace glissade
