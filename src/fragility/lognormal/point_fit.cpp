// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/point_fit.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "lognormal/line_region.hpp"

namespace glissade::fragility {
namespace {

/// Of one-sided bounds: a usual dispersion of sliding capacities.
constexpr double assumed_log_std = 0.4;

const PointFit no_trend{FitStatus::no_trend, ProbitLine::Zero(),
                        "the share of exceedances does not rise with intensity"};

PointFit of_line(FitStatus status, const std::optional<ProbitLine>& line, double center) {
  if (!line) return {FitStatus::failed, ProbitLine::Zero(), "no greatest likelihood was found"};
  if (!((*line)[1] > 0)) return no_trend;
  const double median = to_curve(*line, center).median;
  if (!std::isnormal(median)) {
    return {FitStatus::no_trend, ProbitLine::Zero(),
            "the share of exceedances rises so little with intensity that it has no median"};
  }
  return {status, *line, ""};
}

bool positive_and_finite(double x) { return x > 0 && std::isfinite(x); }

}  // namespace

PointFit fit_point(const StripeData& data, const ProbitLine& start) {
  if (shape_of(data) != StripeShape::overlapping) return fit_point_jeffreys(data, start);
  return of_line(
      FitStatus::maximum_likelihood,
      maximise([&](const ProbitLine& line) { return stripe_likelihood(data, line); }, start),
      data.center);
}

PointFit fit_point_jeffreys(const StripeData& data, const ProbitLine& start) {
  const ProbitLine none = ProbitLine::Zero();
  switch (shape_of(data)) {
    case StripeShape::empty:
      return {FitStatus::failed, none, "there are no trials"};
    case StripeShape::single_level:
      return {FitStatus::one_level, none,
              "only one intensity level has trials: log_std cannot be determined"};
    case StripeShape::none_exceeded:
      return {FitStatus::lower_bound, none, ""};
    case StripeShape::all_exceeded:
      return {FitStatus::upper_bound, none, ""};
    case StripeShape::not_rising:
      return no_trend;
    default:
      return of_line(
          FitStatus::jeffreys_penalised,
          maximise([&](const ProbitLine& line) { return stripe_jeffreys(data, line); }, start),
          data.center);
  }
}

PointFit fit_point(const CapacityData& data, const ProbitLine& start) {
  const ProbitLine none = ProbitLine::Zero();
  if (data.count + data.censored == 0) return {FitStatus::failed, none, "there are no capacities"};
  if (data.count == 0) return {FitStatus::lower_bound, none, ""};
  if (data.censored > 0) {
    const auto line =
        maximise([&](const ProbitLine& l) { return capacity_likelihood(data, l); }, start);
    return line ? PointFit{FitStatus::maximum_likelihood, *line, ""}
                : PointFit{FitStatus::failed, none,
                           "the capacities do not differ: log_std cannot be determined"};
  }
  const double mean = data.sum / data.count;
  const double variance = (data.sum_squares - mean * data.sum) / (data.count - 1);
  if (data.count < 2 || !(variance > 1e-24)) {
    return {FitStatus::one_capacity, ProbitLine(-mean, 1),
            "the capacities are equal: log_std and intervals cannot be determined"};
  }
  return {FitStatus::maximum_likelihood, ProbitLine(-mean, 1) / std::sqrt(variance), ""};
}

ProbitLine first_guess(const StripeData& data) {
  if (data.y.size() == 0) return {0.0, 1.0};
  return {0.0, 2.0 / std::max(0.1, data.y.maxCoeff() - data.y.minCoeff())};
}

ProbitLine first_guess(const CapacityData& data) {
  const double count = std::max(1.0, data.count), mean = data.sum / count;
  const double log_std =
      std::max(0.1, std::sqrt(std::max(0.0, data.sum_squares / count - mean * mean)));
  return ProbitLine(-mean, 1) / log_std;
}

void check(const std::vector<Stripe>& stripes, const std::string& where) {
  ProblemList problems;
  for (const Stripe& s : stripes) {
    if (!positive_and_finite(s.intensity)) {
      problems.add(
          {where, "intensity = " + std::to_string(s.intensity) + " is not a finite number above 0",
           "", ""});
    }
    if (!(std::isfinite(s.trials) && s.exceedances >= 0 && s.exceedances <= s.trials)) {
      problems.add({where,
                    std::to_string(s.exceedances) + " exceedances of " + std::to_string(s.trials) +
                        " trials at intensity " + std::to_string(s.intensity),
                    "give exceedances between 0 and trials", ""});
    }
  }
  problems.throw_if_any();
}

void check(const CapacitySample& sample, const std::string& where) {
  ProblemList problems;
  for (double capacity : sample.capacities) {
    if (!positive_and_finite(capacity)) {
      problems.add({where,
                    "capacity = " + std::to_string(capacity) + " is not a finite number above 0",
                    "count a history that never reached the threshold as censored", ""});
    } else if (capacity > sample.censored_at) {
      problems.add({where,
                    "capacity = " + std::to_string(capacity) +
                        " is above the censoring intensity " + std::to_string(sample.censored_at),
                    "count it as censored, or censor higher", ""});
    }
  }
  for (const auto& [name, count] :
       {std::pair("censored", sample.censored), std::pair("free", sample.free)}) {
    if (!(count >= 0 && std::isfinite(count))) {
      problems.add(
          {where, std::string(name) + " = " + std::to_string(count) + " is not a count", "", ""});
    }
  }
  if (sample.censored > 0 && !positive_and_finite(sample.censored_at)) {
    problems.add(
        {where,
         "censored_at = " + std::to_string(sample.censored_at) + " is not a finite number above 0",
         "give the highest intensity the censored histories were run at", ""});
  }
  problems.throw_if_any();
}

StripeData to_data(const std::vector<Stripe>& stripes) {
  const auto levels = static_cast<Eigen::Index>(stripes.size());
  StripeData data{Eigen::ArrayXd(levels), Eigen::ArrayXd(levels), Eigen::ArrayXd(levels), 0.0};
  for (Eigen::Index j = 0; j < levels; ++j) {
    const Stripe& stripe = stripes[static_cast<std::size_t>(j)];
    data.y[j] = std::log(stripe.intensity);
    data.trials[j] = stripe.trials;
    data.exceedances[j] = stripe.exceedances;
  }
  if (levels > 0) data.center = data.y.mean();
  data.y -= data.center;
  return data;
}

CapacityData to_data(const CapacitySample& sample, double center) {
  CapacityData data{.censored = sample.censored, .center = center};
  if (sample.censored > 0) data.censored_at = std::log(sample.censored_at) - center;
  for (double capacity : sample.capacities) {
    const double y = std::log(capacity) - center;
    data.count += 1;
    data.sum += y;
    data.sum_squares += y * y;
  }
  return data;
}

double mean_log(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += std::log(value);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

FitSummary summarise_bound(const StripeData& data) {
  const bool none = data.exceedances.sum() == 0;
  const auto log_probability = [&](const ProbitLine& line) {
    return stripe_log_likelihood(data, line);
  };
  const double bound = median_bound(log_probability, assumed_log_std, data.center);
  FitSummary summary;
  summary.status = none ? FitStatus::lower_bound : FitStatus::upper_bound;
  summary.curve = {bound, assumed_log_std};
  summary.median_interval = none ? Interval{bound, infinity} : Interval{0.0, bound};
  summary.p50_interval = summary.median_interval;
  summary.log_likelihood = log_probability(to_line(summary.curve, data.center));
  summary.method = "one-sided 95 % bound of the median for an assumed log_std";
  summary.interval_method = "one-sided bound";
  summary.note = none ? "no exceedance at all: the median is a lower bound"
                      : "every trial exceeded: the median is an upper bound";
  summary.note += " at 95 % for an assumed log_std of 0.4";
  return summary;
}

void add_sentence(std::string& note, const std::string& sentence) {
  if (!note.empty() && !sentence.empty()) note += "; ";
  note += sentence;
}

FitSummary summarise_always() {
  FitSummary summary;
  summary.status = FitStatus::always_exceeds;
  summary.curve.floor = 1.0;
  summary.note = "every history exceeds without any shaking: the probability is 1";
  return summary;
}

}  // namespace glissade::fragility
