// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "glissade/fragility/fit.hpp"
#include "lognormal/likelihood.hpp"
#include "lognormal/point_fit.hpp"
#include "lognormal/profile.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// Curve, likelihood and profile intervals of a point fit.
FitSummary summarise(const std::vector<Stripe>& stripes, const StripeData& data,
                     const PointFit& fit) {
  if (fit.is_bound()) return summarise_bound(data);
  FitSummary summary;
  summary.status = fit.status;
  summary.note = fit.note;
  if (!summary.converged()) return summary;
  const bool penalised = fit.status == FitStatus::jeffreys_penalised;
  const auto log_likelihood = [&](const ProbitLine& line) {
    return (penalised ? stripe_jeffreys(data, line) : stripe_likelihood(data, line)).value;
  };
  summary.curve = to_curve(fit.line, data.center);
  const ProfileIntervals intervals = profile_intervals(log_likelihood, fit.line, data.center);
  summary.median_interval = summary.p50_interval = intervals.median;
  summary.log_std_interval = intervals.log_std;
  summary.log_likelihood = stripe_log_likelihood(stripes, summary.curve);
  summary.method = penalised ? "Jeffreys penalised probit likelihood on stripes"
                             : "probit maximum likelihood on stripes";
  summary.interval_method = penalised ? "penalised profile likelihood" : "profile likelihood";
  if (shape_of(data) == StripeShape::separated) {
    summary.note =
        "the stripes are separated by intensity: the likelihood alone has no finite maximum";
  }
  return summary;
}

}  // namespace

std::string to_string(FitStatus status) {
  switch (status) {
    case FitStatus::failed:
      break;
    case FitStatus::maximum_likelihood:
      return "maximum likelihood";
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
  double sum = stripe_likelihood(data, to_line(curve, data.center)).value;
  for (const Stripe& s : stripes) {
    sum += std::lgamma(s.trials + 1) - std::lgamma(s.exceedances + 1) -
           std::lgamma(s.trials - s.exceedances + 1);
  }
  return sum;
}

FitSummary fit_stripes(const std::vector<Stripe>& stripes) {
  check(stripes, "stripes");
  const StripeData data = to_data(stripes);
  return summarise(stripes, data, fit_point(data, first_guess(data)));
}

FitSummary fit_stripes_jeffreys(const std::vector<Stripe>& stripes) {
  check(stripes, "stripes");
  const StripeData data = to_data(stripes);
  return summarise(stripes, data, fit_point_jeffreys(data, first_guess(data)));
}

}  // namespace glissade
