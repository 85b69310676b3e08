// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/lognormal.hpp"

#include <gsl/gsl_sf_erf.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"

namespace glissade {

double LognormalCurve::probability(double intensity) const {
  if (!(intensity > 0)) return 0;
  return 0.5 * std::erfc(-std::log(intensity / median) / (log_std * std::numbers::sqrt2));
}

double LognormalCurve::intensity_at(double probability) const {
  GLISSADE_EXPECTS(probability > 0 && probability < 1);
  return median * std::exp(log_std * boost::math::quantile(boost::math::normal(), probability));
}

double log_normal_cdf(double z) {
  if (z > 0) return std::log1p(-0.5 * std::erfc(z / std::numbers::sqrt2));
  return gsl_sf_log_erfc(-z / std::numbers::sqrt2) - std::numbers::ln2;
}

}  // namespace glissade
