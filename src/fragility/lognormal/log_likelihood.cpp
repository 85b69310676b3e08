// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "glissade/core/distributions.hpp"
#include "glissade/fragility/fit.hpp"
#include "lognormal/likelihood.hpp"
#include "lognormal/point_fit.hpp"

namespace glissade {

using namespace fragility;

std::string to_string(FitStatus status) {
  switch (status) {
    case FitStatus::failed:
      break;
    case FitStatus::maximum_likelihood:
      return "maximum likelihood";
    case FitStatus::extrapolated:
      return "extrapolated beyond the data";
    case FitStatus::jeffreys_penalised:
      return "Jeffreys penalised";
    case FitStatus::lower_bound:
      return "lower bound";
    case FitStatus::upper_bound:
      return "upper bound";
    case FitStatus::no_trend:
      return "no rise with intensity";
    case FitStatus::always_exceeds:
      return "exceeds at any intensity";
    case FitStatus::one_level:
      return "one level";
    case FitStatus::one_capacity:
      return "one capacity";
    case FitStatus::no_information:
      return "no information";
  }
  return "failed";
}

double stripe_log_likelihood(const std::vector<Stripe>& stripes, const FragilityCurve& curve) {
  check(stripes, "stripes");
  const StripeData data = to_data(stripes);
  double sum = fragility::stripe_log_likelihood(data, to_line(curve, data.center));
  for (const Stripe& s : stripes) {
    sum += log_gamma(s.trials + 1) - log_gamma(s.exceedances + 1) -
           log_gamma(s.trials - s.exceedances + 1);
  }
  return sum;
}

double capacity_log_likelihood(const CapacitySample& sample, const FragilityCurve& curve) {
  check(sample, "capacities");
  const double center = mean_log(sample.capacities),
               n = static_cast<double>(sample.capacities.size());
  return capacity_likelihood(to_data(sample, center), to_line(curve, center)).value -
         n * (center + 0.5 * std::log(2 * std::numbers::pi));
}

}  // namespace glissade
