// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/rdk10_parameters.hpp"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

// Coefficients of RDK10 as in rzz2015_gmpe.py of the SCEC Broadband Platform and in J. Du's Python
// code (2023): the first row with four decimals, as in rzz2015_gmpe.py, the others with three.
struct Predictor {
  double constant, reverse, magnitude, distance, vs30;  // of the mean score
  double between_events, within_event;                  // standard deviations
};
constexpr std::array<Predictor, 6> predictors = {{
    {-2.2962, -.0707, 2.9440, -1.3564, -.2654, .2738, .5937},
    {-6.195, -.703, 6.792, .219, -.523, .4574, .5688},
    {-5.011, -.345, 4.638, .348, -.185, .5114, .4145},
    {2.253, -.081, -1.810, -.211, .012, .6918, .7228},
    {-2.489, .044, 2.408, .065, -.081, .1286, .9529},
    {-.258, -.477, .905, -.289, .316, .6815, .7601},
}};
constexpr std::array<Rdk10Scores, 6> correlation = {{
    {1, -.3555, .0066, -.1545, .1341, -.0078},
    {-.3555, 1, .6729, -.1303, -.1576, -.1958},
    {.0066, .6729, 1, -.2761, -.1977, -.2188},
    {-.1545, -.1303, -.2761, 1, -.2034, .2814},
    {.1341, -.1576, -.1977, -.2034, 1, -.0137},
    {-.0078, -.1958, -.2188, .2814, -.0137, 1},
}};

double scaled_beta(double probability, double alpha, double beta, double low, double high) {
  return low + (high - low) * quantile(boost::math::beta_distribution(alpha, beta), probability);
}

/// Two-sided exponential on [-2, 0.5] Hz/s: density c exp(b x) below zero and c exp(-a x) above.
double frequency_slope_quantile(double probability) {
  constexpr double a = 17.095, b = 6.7729, c = 4.8512, low = -2.0;
  const double below_zero = c / b * (1.0 - std::exp(b * low));
  if (probability < below_zero) return std::log(probability * b / c + std::exp(b * low)) / b;
  // By rounding of the constants a probability of about 1e-4 is above the upper bound: it is
  // assigned to the bound.
  const double remaining = std::max(1.0 - (probability - below_zero) * a / c, std::exp(-a * 0.5));
  return -std::log(remaining) / a;
}

}  // namespace

Rdk10Scores rdk10_mean_scores(const Scenario& scenario) {
  GLISSADE_EXPECTS(scenario.distance_km > 0.0 && scenario.vs30_mps > 0.0);
  const double reverse = scenario.mechanism == FaultMechanism::reverse ? 1.0 : 0.0;
  const double distance = scenario.distance_km / 25.0, vs30 = scenario.vs30_mps / 750.0;
  Rdk10Scores scores;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const Predictor& p = predictors[i];
    const bool logarithmic = i == 0;  // Arias intensity alone takes ln R and ln Vs30
    scores[i] = p.constant + p.reverse * reverse + p.magnitude * scenario.magnitude / 7.0 +
                p.distance * (logarithmic ? std::log(distance) : distance) +
                p.vs30 * (logarithmic ? std::log(vs30) : vs30);
  }
  return scores;
}

Rdk10Scores rdk10_score_deviations() {
  Rdk10Scores deviations;
  for (std::size_t i = 0; i < deviations.size(); ++i)
    deviations[i] = std::hypot(predictors[i].between_events, predictors[i].within_event);
  return deviations;
}

std::array<Rdk10Scores, 6> rdk10_score_correlation() { return correlation; }

Rdk10Parameters rdk10_parameters(const Rdk10Scores& scores) {
  const auto probability = [&](std::size_t i) { return normal_cdf(scores[i]); };
  return {.arias_g2s = std::exp(-4.8255 + 1.4318 * scores[0]),
          .significant_duration_s = scaled_beta(probability(1), 1.1314, 2.4474, 5.0, 45.0),
          .middle_time_s = scaled_beta(probability(2), 1.5792, 3.6405, 0.5, 40.0),
          .middle_frequency_hz =
              quantile(boost::math::gamma_distribution(4.0982, 1.4330), probability(3)),
          .frequency_slope_hzps = frequency_slope_quantile(probability(4)),
          .damping_ratio = scaled_beta(probability(5), 1.4250, 5.7208, 0.02, 1.0)};
}

}  // namespace glissade
