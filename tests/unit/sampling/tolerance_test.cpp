// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/tolerance.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace glissade {
namespace {

// real-statistics.com, "Tolerance interval example": n = 40, 90 % with 99 % confidence by the
// noncentral t, k = 1.9017.
TEST(tolerance_factor, is_the_published_one) {
  EXPECT_NEAR(one_sided_tolerance_factor({40, 0.90, 0.99}), 1.9017, 5e-5);
}

/// The chance that mean - k s lies below the population's quantile, by its definition: over the
/// distribution of s, that of the mean. No noncentral t.
double chance_of(double k, const ToleranceBound& bound) {
  const double n = static_cast<double>(bound.sample_size);
  const double z = boost::math::quantile(boost::math::normal(), bound.coverage);
  const boost::math::chi_squared chi_squared(n - 1.0);
  const auto at = [&](double root) {  // chi_squared = root^2: its density is finite at 0 then
    const double s = root / std::sqrt(n - 1.0);
    return cdf(boost::math::normal(), std::sqrt(n) * (k * s - z)) * 2.0 * root *
           pdf(chi_squared, root * root);
  };
  const double most = std::sqrt(quantile(complement(chi_squared, 1e-14)));
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(at, 1e-9, most, 12, 1e-12);
}

TEST(tolerance_factor, gives_its_confidence) {
  const double two_sigma = cdf(boost::math::normal(), 2.0);
  for (const std::size_t n : {2u, 3u, 5u, 10u, 30u, 200u}) {
    for (const double coverage : {0.9, two_sigma, 0.99}) {
      const ToleranceBound bound{n, coverage, 0.95};
      EXPECT_NEAR(chance_of(one_sided_tolerance_factor(bound), bound), 0.95, 1e-7)
          << n << " " << coverage;
    }
  }
}

TEST(tolerance_factor, comes_down_to_the_quantile_as_tests_grow_in_number) {
  const double coverage = cdf(boost::math::normal(), 2.0);
  double last = one_sided_tolerance_factor({2, coverage, 0.95});
  for (const std::size_t n : {3u, 10u, 100u, 1000u, 100000u}) {
    const double factor = one_sided_tolerance_factor({n, coverage, 0.95});
    EXPECT_LT(factor, last);
    EXPECT_GT(factor, 2.0);
    last = factor;
  }
  EXPECT_NEAR(last, 2.0, 0.02);
}

}  // namespace
}  // namespace glissade
