// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>

#include "by_record/check.hpp"
#include "by_record/intervals.hpp"
#include "cloud/cloud_variance.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/root.hpp"
#include "lognormal/likelihood.hpp"
#include "lognormal/line_region.hpp"

namespace glissade {
namespace {

using namespace fragility;

using Quantity = std::function<double(const CloudFit&)>;

CloudFit fit_of(const CloudParameters& p, const CloudFit& like) {
  CloudFit fit = like;
  fit.parts.any = to_curve({p[0], p[1]}, 0.0);
  fit.parts.intercept = p[2];
  fit.parts.slope = p[3];
  fit.parts.log_std = p[4];
  if (fit.collapse) fit.collapse = to_curve({p[5], p[6]}, 0.0);
  return fit;
}

/// By the delta method, with central differences. None where the variance is not known.
Interval interval_of(const Quantity& quantity, const CloudFit& fit, const CloudVariance& errors) {
  const CloudParameters p = parameters_of(fit);
  double variance = 0.0;
  CloudParameters gradient;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const double step = 1e-5 * std::max(1.0, std::abs(p[i]));
    CloudParameters up = p, down = p;
    up[i] += step;
    down[i] -= step;
    gradient[i] = (quantity(fit_of(up, fit)) - quantity(fit_of(down, fit))) / (2 * step);
    for (Eigen::Index j = 0; j <= i; ++j) {  // what it does not depend on may have no variance
      const double product = gradient[i] * gradient[j];
      if (product != 0) variance += (i == j ? 1 : 2) * product * errors.covariance(i, j);
    }
  }
  if (!std::isfinite(variance)) return {};
  return t_interval(quantity(fit), std::sqrt(std::max(0.0, variance)), errors.freedom + 1);
}

/// ln of the intensity at which half exceed.
double log_p50(const CloudFit& fit, double threshold) {
  const TwoPartFit& parts = fit.parts;
  const auto excess = [&](double y) { return fit.probability(std::exp(y), threshold) - 0.5; };
  double low = (std::log(threshold) - parts.intercept) / parts.slope,
         high = low;  // of the size alone
  const double step = parts.log_std / parts.slope;
  for (int i = 0; i < 200 && excess(low) > 0; ++i) low -= step;
  for (int i = 0; i < 200 && excess(high) < 0; ++i) high += 0.5 * step * (1 << std::min(i, 20));
  if (low == high) return low;
  return root_between(excess, low, high, 48);
}

void check(const std::vector<CloudPoint>& points, const std::vector<double>& thresholds) {
  ProblemList problems;
  const auto is_number = [](double x, bool or_zero) {
    return std::isfinite(x) && (x > 0 || (or_zero && x == 0));
  };
  for (const CloudPoint& point : points) {
    if (is_number(point.intensity, false) &&
        (is_number(point.displacement, true) || point.displacement == infinity))
      continue;
    problems.add({"cloud",
                  "intensity " + std::to_string(point.intensity) + ", displacement " +
                      std::to_string(point.displacement),
                  "give an intensity above 0 and a displacement of 0 or more, inf of a collapse",
                  ""});
  }
  for (const double threshold : thresholds) {
    if (!is_number(threshold, false))
      problems.add(
          {"threshold", std::to_string(threshold) + " is not a finite number above 0", "", ""});
  }
  problems.throw_if_any();
  check_weights(points);
}

/// With weights that sum to as many as they are worth, so that log_std is over n - 2.
std::vector<CloudPoint> scaled(std::vector<CloudPoint> points) {
  const double unit = largest_weight(points);
  double sum = 0, squares = 0;
  for (CloudPoint& point : points) {
    point.weight /= unit;
    sum += point.weight;
    squares += point.weight * point.weight;
  }
  for (CloudPoint& point : points) point.weight *= sum / squares;
  return points;
}

std::vector<SlipSums> sums_of(const std::vector<CloudPoint>& points) {
  std::vector<SlipSums> rows;
  for (const CloudPoint& point : points) {
    if (point.weight == 0 || std::isinf(point.displacement)) continue;
    rows.push_back({.intensity = point.intensity});
    rows.back().add(point.displacement, point.weight);
  }
  return rows;
}

/// Of any slip, by the profile likelihood: the rows count for less where records share their errors
/// (`effect`), and Student's t takes the place of the normal distribution.
LineRegion any_region(const LogRows& counts, const TwoPartFit& fit, double effect,
                      const CloudVariance& errors) {
  const ProbitLine line = to_line(fit.any, counts.center);
  const double t = student_quantile(std::max(1.0, errors.any_freedom), 0.975);
  const double allowed = t * t * std::max(1.0, effect);
  const Eigen::Matrix2d covariance = likelihood(counts, line).information.inverse();
  return {[&counts](const ProbitLine& other) { return likelihood(counts, other).value; }, line,
          covariance.llt().matrixL(), [allowed](const ProbitLine&) { return allowed; }};
}

LogRows any_counts(const std::vector<CloudPoint>& points) {
  std::vector<double> intensities;
  for (const CloudPoint& point : points) intensities.push_back(point.intensity);
  LogRows counts;
  counts.center = mean_log(intensities);
  for (const CloudPoint& point : points) {
    if (point.weight == 0 || std::isinf(point.displacement)) continue;
    const bool slips = point.displacement > 0;
    counts.add_counts(std::log(point.intensity) - counts.center, slips ? point.weight : 0.0,
                      slips ? 0.0 : point.weight);
  }
  return counts;
}

/// None where no row collapses.
std::optional<FitSummary> collapse_of(const std::vector<CloudPoint>& points) {
  std::vector<Stripe> rows;
  bool any = false;
  for (const CloudPoint& point : points) {
    const bool collapses = std::isinf(point.displacement);
    any = any || (collapses && point.weight > 0);
    rows.push_back({point.intensity, 1.0, collapses ? 1.0 : 0.0, point.weight, point.record});
  }
  if (!any) return std::nullopt;
  return fit_stripes(rows, Independent::records);
}

}  // namespace

CloudSummary fit_cloud(const std::vector<CloudPoint>& points,
                       const std::vector<double>& thresholds) {
  check(points, thresholds);
  CloudSummary summary;
  for (const double threshold : thresholds) summary.medians.push_back({.threshold = threshold});
  if (points.empty()) return summary;
  const std::vector<CloudPoint> rows = scaled(points);
  summary.fit = fit_two_part(sums_of(rows));
  summary.effective_records = effective_number(record_weights(rows));
  summary.collapse = collapse_of(rows);
  if (!summary.fit.has_curve() || (summary.collapse && !summary.collapse->converged()))
    return summary;
  CloudFit fit{summary.fit};
  if (summary.collapse) fit.collapse = summary.collapse->curve;
  for (CloudMedian& row : summary.medians) row.p50 = std::exp(log_p50(fit, row.threshold));
  if (record_weights(rows).size() < 2) return summary;
  const CloudVariance errors = cloud_variance(rows, fit);
  const auto interval = [&](const Quantity& quantity) {
    return interval_of(quantity, fit, errors);
  };
  summary.intercept_interval = interval([](const CloudFit& f) { return f.parts.intercept; });
  summary.slope_interval = interval([](const CloudFit& f) { return f.parts.slope; });
  summary.log_std_interval = chi_square_interval(summary.fit.log_std, errors.log_std_freedom);
  if (summary.fit.any_status == FitStatus::maximum_likelihood) {
    const LogRows all = any_counts(rows),
                  counts = summed(all, to_line(summary.fit.any, all.center));
    const Interval y =
        any_region(counts, summary.fit, errors.median_design_effect, errors).range(log_median);
    summary.any_median_interval = exponentials({counts.center + y.low, counts.center + y.high});
    summary.any_log_std_interval =
        any_region(counts, summary.fit, errors.log_std_design_effect, errors)
            .range(fragility::log_std);
  }
  // Separated records do not show how much they differ: neither part of such a median has one.
  if (summary.fit.any_status == FitStatus::jeffreys_penalised ||
      (summary.collapse && summary.collapse->status == FitStatus::jeffreys_penalised))
    return summary;
  for (CloudMedian& row : summary.medians)
    row.p50_interval =
        exponentials(interval([&](const CloudFit& f) { return log_p50(f, row.threshold); }));
  return summary;
}

}  // namespace glissade
