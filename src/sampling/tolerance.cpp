// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/tolerance.hpp"

#include <boost/math/distributions/non_central_t.hpp>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {

double one_sided_tolerance_factor(const ToleranceBound& bound) {
  GLISSADE_EXPECTS(bound.sample_size >= 2);
  GLISSADE_EXPECTS(bound.coverage > 0.0 && bound.coverage < 1.0);
  GLISSADE_EXPECTS(bound.confidence > 0.0 && bound.confidence < 1.0);
  const double root_n = std::sqrt(static_cast<double>(bound.sample_size));
  const double z = normal_quantile(bound.coverage);
  const boost::math::non_central_t t(static_cast<double>(bound.sample_size - 1), z * root_n);
  return boost::math::quantile(t, bound.confidence) / root_n;
}

}  // namespace glissade
