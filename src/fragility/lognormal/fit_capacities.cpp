// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "glissade/core/distributions.hpp"
#include "glissade/fragility/fit.hpp"
#include "lognormal/likelihood.hpp"
#include "lognormal/point_fit.hpp"
#include "lognormal/profile.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// Student t for ln median, chi-square for log_std: exact for a lognormal sample of n.
ProfileIntervals sample_intervals(const FragilityCurve& curve, double n) {
  const double t = student_quantile(n - 1, 0.975);
  const double factor = std::exp(t * curve.log_std / std::sqrt(n));
  return {{curve.median / factor, curve.median * factor},
          {curve.log_std * std::sqrt((n - 1) / chi_squared_quantile(n - 1, 0.975)),
           curve.log_std * std::sqrt((n - 1) / chi_squared_quantile(n - 1, 0.025))}};
}

/// The fit of those that need shaking.
FitSummary fit_shaken(const CapacitySample& sample) {
  const CapacityData data = to_data(sample, mean_log(sample.capacities));
  const PointFit fit = fit_point(data, first_guess(data));
  if (fit.is_bound()) return summarise_bound(to_data({{sample.censored_at, sample.censored, 0.0}}));
  FitSummary summary;
  summary.status = fit.status;
  summary.note = fit.note;
  if (fit.status == FitStatus::one_capacity) summary.curve.median = std::exp(data.center);
  if (!summary.converged()) return summary;
  summary.curve = to_curve(fit.line, data.center);
  const auto log_likelihood = [&](const ProbitLine& line) {
    return capacity_likelihood(data, line).value;
  };
  const bool complete = sample.censored == 0;
  const ProfileIntervals intervals = complete
                                         ? sample_intervals(summary.curve, data.count)
                                         : profile_intervals(log_likelihood, fit.line, data.center);
  summary.median_interval = summary.p50_interval = intervals.median;
  summary.log_std_interval = intervals.log_std;
  summary.log_likelihood = capacity_log_likelihood(sample, summary.curve);
  summary.method = complete ? "lognormal sample of capacities (n - 1)"
                            : "lognormal maximum likelihood on right-censored capacities";
  summary.interval_method = complete ? "Student t and chi-square" : "profile likelihood";
  return summary;
}

}  // namespace

double capacity_log_likelihood(const CapacitySample& sample, const FragilityCurve& curve) {
  check(sample, "capacities");
  const double center = mean_log(sample.capacities),
               n = static_cast<double>(sample.capacities.size());
  return capacity_likelihood(to_data(sample, center), to_line(curve, center)).value -
         n * (center + 0.5 * std::log(2 * std::numbers::pi));
}

FitSummary fit_capacities(const CapacitySample& sample) {
  check(sample, "capacities");
  if (sample.free == 0) return fit_shaken(sample);
  const double rest = static_cast<double>(sample.capacities.size()) + sample.censored;
  FitSummary summary = rest > 0 ? fit_shaken(sample) : summarise_always();
  const double all = rest + sample.free;
  summary.curve.floor = sample.free / all;
  summary.p50_interval = {};
  summary.floor_interval = {binomial_lower_end(all, sample.free, 0.025),
                            binomial_upper_end(all, sample.free, 0.025)};
  add_sentence(summary.interval_method, "Clopper-Pearson for the floor");
  if (rest > 0) add_sentence(summary.note, note_on_floor);
  return summary;
}

}  // namespace glissade
