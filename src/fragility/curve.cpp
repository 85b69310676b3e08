// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/curve.hpp"

#include <gsl/gsl_sf_erf.h>

#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {

double FragilityCurve::probability(double intensity) const {
  if (!(intensity > 0) || floor == 1) return floor;
  return floor + (1 - floor) * normal_cdf(std::log(intensity / median) / log_std);
}

double FragilityCurve::intensity_at(double probability) const {
  GLISSADE_EXPECTS(probability > 0 && probability < 1);
  if (probability <= floor) return 0;
  const double z = normal_quantile((probability - floor) / (1 - floor));
  return z == 0 ? median : median * std::exp(log_std * z);
}

double log_normal_cdf(double z) {
  if (z > 0) return std::log1p(-0.5 * std::erfc(z / std::numbers::sqrt2));
  return gsl_sf_log_erfc(-z / std::numbers::sqrt2) - std::numbers::ln2;
}

double log_normal_between(double low, double high) {
  if (low > 0) return log_normal_between(-high, -low);
  const double above = log_normal_cdf(high);
  if (std::isinf(low)) return above;
  return above + std::log1p(-std::exp(log_normal_cdf(low) - above));
}

}  // namespace glissade
