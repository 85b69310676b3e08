// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/importance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {

WidenedCoordinate widened_coordinate(double u, double widening) {
  GLISSADE_EXPECTS(u > 0.0 && u < 1.0 && widening >= 1.0);
  const double before = normal_quantile(u), z = widening * before;
  const double below_one = 1.0 - std::numeric_limits<double>::epsilon();
  return {std::clamp(normal_cdf(z), std::numeric_limits<double>::min(), below_one),
          widening * std::exp(-0.5 * (z * z - before * before))};
}

WeightedProbability weighted_probability(const std::vector<double>& share_of,
                                         const std::vector<double>& weight, std::size_t blocks) {
  const std::size_t samples = share_of.size();
  GLISSADE_EXPECTS(blocks >= 2 && samples > 0 && samples % blocks == 0 && weight.size() == samples);
  const std::size_t size = samples / blocks;
  std::vector<double> of_block(blocks);
  double squares = 0.0, sum = 0.0, sum_of_squares = 0.0;
  for (std::size_t k = 0; k < samples; ++k) {
    const double part = weight[k] * share_of[k];
    of_block[k / size] += part / static_cast<double>(size);
    sum += part;
    sum_of_squares += part * part;
    squares += weight[k] * share_of[k] * share_of[k] / static_cast<double>(samples);
  }
  const double count = static_cast<double>(blocks);
  WeightedProbability result;
  for (const double p : of_block) result.probability += p / count;
  double spread = 0.0;
  for (const double p : of_block) spread += (p - result.probability) * (p - result.probability);
  result.standard_error = std::sqrt(spread / (count * (count - 1.0)));
  if (sum > 0.0) result.effective_samples = sum * sum / sum_of_squares;
  if (result.effective_samples >= least_effective_samples) {
    const double t = student_quantile(count - 1.0, 0.975),
                 factor = std::exp(t * result.standard_error / result.probability);
    result.low = result.probability / factor;
    result.high = result.probability * factor;
  }
  result.plain_samples = (squares - result.probability * result.probability) /
                         (result.standard_error * result.standard_error);
  return result;
}

}  // namespace glissade
