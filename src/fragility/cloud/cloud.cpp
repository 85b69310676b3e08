// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>

#include "by_record/clusters.hpp"
#include "by_record/sandwich.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/fragility/weighted_fit.hpp"
#include "lognormal/point_fit.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// (b0, b1) of any slip with y = ln x; intercept, slope and log_std of its size.
using Parameters = Eigen::Matrix<double, 5, 1>;
using Quantity = std::function<double(const TwoPartFit&)>;

Parameters parameters_of(const TwoPartFit& fit) {
  Parameters p;
  const ProbitLine any =
      fit.any_status == FitStatus::upper_bound ? ProbitLine(0, 1) : to_line(fit.any, 0.0);
  p << any[0], any[1], fit.intercept, fit.slope, fit.log_std;
  return p;
}

TwoPartFit fit_of(const Parameters& p, const TwoPartFit& like) {
  TwoPartFit fit = like;
  fit.any = to_curve({p[0], p[1]}, 0.0);
  fit.intercept = p[2];
  fit.slope = p[3];
  fit.log_std = p[4];
  return fit;
}

/// Scores by record, and the information, of the two parts; they share no parameter.
class CloudScores {
 public:
  CloudScores(const std::vector<CloudPoint>& points, const Clusters& clusters,
              const TwoPartFit& fit)
      : fit_(fit), p_(parameters_of(fit)), scores_(Eigen::MatrixXd::Zero(clusters.count(), 5)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (clusters.has(i)) add(points[i], clusters.of(i));
    }
    if (fit.any_status == FitStatus::upper_bound) information_.topLeftCorner<2, 2>().setIdentity();
  }
  Eigen::MatrixXd covariance() const { return cluster_sandwich(scores_, information_); }

 private:
  void add(const CloudPoint& point, Eigen::Index record) {
    const double y = std::log(point.intensity), w = point.weight;
    const Eigen::Vector2d x{1, y};
    if (fit_.any_status != FitStatus::upper_bound) {
      const LogShares shares = log_shares(Link::probit, p_[0] + p_[1] * y);
      const bool slips = point.displacement > 0;
      const LogShares::Part& part = slips ? shares.above : shares.below;
      scores_.row(record).head<2>() += w * (slips ? part.hazard : -part.hazard) * x.transpose();
      information_.topLeftCorner<2, 2>() += w * part.curvature * x * x.transpose();
    }
    if (point.displacement == 0) return;
    const double s = p_[4], r = std::log(point.displacement) - p_[2] - p_[3] * y;
    scores_.row(record).segment<2>(2) += w * r / (s * s) * x.transpose();
    scores_(record, 4) += w * (r * r / (s * s) - 1) / s;
    information_.block<2, 2>(2, 2) += w / (s * s) * x * x.transpose();
    information_(4, 4) += 2 * w / (s * s);
  }

  const TwoPartFit& fit_;
  Parameters p_;
  Eigen::MatrixXd scores_;
  Eigen::Matrix<double, 5, 5> information_ = Eigen::Matrix<double, 5, 5>::Zero();
};

/// By the delta method, with central differences.
Interval interval_of(const Quantity& quantity, const TwoPartFit& fit,
                     const Eigen::MatrixXd& covariance, double effective) {
  const Parameters p = parameters_of(fit);
  Parameters gradient;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const double step = 1e-5 * std::max(1.0, std::abs(p[i]));
    Parameters up = p, down = p;
    up[i] += step;
    down[i] -= step;
    gradient[i] = (quantity(fit_of(up, fit)) - quantity(fit_of(down, fit))) / (2 * step);
  }
  return t_interval(quantity(fit), std::sqrt(std::max(0.0, gradient.dot(covariance * gradient))),
                    effective);
}

Interval exponentials(const Interval& logs) { return {std::exp(logs.low), std::exp(logs.high)}; }

/// ln of the intensity at which half exceed.
double log_p50(const TwoPartFit& fit, double threshold) {
  const auto excess = [&](double y) { return fit.probability(std::exp(y), threshold) - 0.5; };
  double low = (std::log(threshold) - fit.intercept) / fit.slope, high = low;  // of the size alone
  const double step = fit.log_std / fit.slope;
  for (int i = 0; i < 200 && excess(low) > 0; ++i) low -= step;
  for (int i = 0; i < 200 && excess(high) < 0; ++i) high += 0.5 * step * (1 << std::min(i, 20));
  if (low == high) return low;
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(48), iterations);
  return 0.5 * (a + b);
}

void check(const std::vector<CloudPoint>& points, const std::vector<double>& thresholds) {
  ProblemList problems;
  const auto is_number = [](double x, bool or_zero) {
    return std::isfinite(x) && (x > 0 || (or_zero && x == 0));
  };
  for (const CloudPoint& point : points) {
    if (is_number(point.intensity, false) && is_number(point.displacement, true)) continue;
    problems.add({"cloud",
                  "intensity " + std::to_string(point.intensity) + ", displacement " +
                      std::to_string(point.displacement),
                  "give an intensity above 0 and a displacement of 0 or more", ""});
  }
  for (const double threshold : thresholds) {
    if (!is_number(threshold, false))
      problems.add(
          {"threshold", std::to_string(threshold) + " is not a finite number above 0", "", ""});
  }
  problems.throw_if_any();
}

/// With weights that sum to as many as they are worth, so that log_std is over n - 2.
std::vector<SlipSums> sums_of(const std::vector<CloudPoint>& points,
                              const std::vector<double>& weights) {
  const Eigen::Map<const Eigen::VectorXd> w(weights.data(),
                                            static_cast<Eigen::Index>(weights.size()));
  const double scale = effective_number(w) / w.sum();
  std::vector<SlipSums> rows;
  for (const CloudPoint& point : points) {
    if (point.weight == 0) continue;
    rows.push_back({.intensity = point.intensity});
    rows.back().add(point.displacement, scale * point.weight);
  }
  return rows;
}

}  // namespace

CloudSummary fit_cloud(const std::vector<CloudPoint>& points,
                       const std::vector<double>& thresholds) {
  check(points, thresholds);
  CloudSummary summary;
  for (const double threshold : thresholds) summary.medians.push_back({.threshold = threshold});
  if (points.empty()) return summary;
  std::vector<std::size_t> records;
  std::vector<double> weights;
  for (const CloudPoint& point : points) {
    records.push_back(point.record);
    weights.push_back(point.weight);
  }
  const Clusters clusters(records, weights);
  summary.fit = fit_two_part(sums_of(points, weights));
  summary.effective_records = clusters.effective();
  if (!summary.fit.has_curve()) return summary;
  for (CloudMedian& row : summary.medians) row.p50 = std::exp(log_p50(summary.fit, row.threshold));
  if (clusters.count() < 2) return summary;
  const Eigen::MatrixXd covariance = CloudScores(points, clusters, summary.fit).covariance();
  const auto interval = [&](const Quantity& quantity) {
    return interval_of(quantity, summary.fit, covariance, summary.effective_records);
  };
  summary.intercept_interval = interval([](const TwoPartFit& f) { return f.intercept; });
  summary.slope_interval = interval([](const TwoPartFit& f) { return f.slope; });
  summary.log_std_interval =
      exponentials(interval([](const TwoPartFit& f) { return std::log(f.log_std); }));
  if (summary.fit.any_status == FitStatus::maximum_likelihood) {
    summary.any_median_interval =
        exponentials(interval([](const TwoPartFit& f) { return std::log(f.any.median); }));
    summary.any_log_std_interval =
        exponentials(interval([](const TwoPartFit& f) { return std::log(f.any.log_std); }));
  }
  // Separated records do not show how much they differ: neither part of such a median has one.
  if (summary.fit.any_status == FitStatus::jeffreys_penalised) return summary;
  for (CloudMedian& row : summary.medians)
    row.p50_interval =
        exponentials(interval([&](const TwoPartFit& f) { return log_p50(f, row.threshold); }));
  return summary;
}

}  // namespace glissade
