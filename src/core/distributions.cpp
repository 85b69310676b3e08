// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/distributions.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace glissade {

using boost::math::binomial, boost::math::chi_squared, boost::math::students_t;

double student_quantile(double freedom, double probability) {
  return quantile(students_t(freedom), probability);
}

double student_upper_tail(double freedom, double t) {
  return cdf(complement(students_t(freedom), t));
}

double chi_squared_quantile(double freedom, double probability) {
  return quantile(chi_squared(freedom), probability);
}

double binomial_lower_end(double trials, double successes, double tail) {
  return binomial::find_lower_bound_on_p(trials, successes, tail);
}

double binomial_upper_end(double trials, double successes, double tail) {
  return binomial::find_upper_bound_on_p(trials, successes, tail);
}

double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

}  // namespace glissade
