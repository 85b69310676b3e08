// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/normal.hpp"

#include <boost/math/distributions/normal.hpp>

namespace glissade {
namespace {

using namespace boost::math::policies;
using Normal = boost::math::normal_distribution<
    double, policy<domain_error<ignore_error>, overflow_error<ignore_error>>>;

}  // namespace

double normal_cdf(double z) { return cdf(Normal(), z); }

double normal_quantile(double probability) { return quantile(Normal(), probability); }

}  // namespace glissade
