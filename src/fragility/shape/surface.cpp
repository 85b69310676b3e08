// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "by_record/intervals.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/newton_maximum.hpp"
#include "lognormal/point_fit.hpp"
#include "shape/shape.hpp"

namespace glissade {
namespace fragility {
namespace {

/// Value, gradient and information in (b0 of each threshold, b1 of all).
struct SurfaceEvaluation {
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;

  explicit SurfaceEvaluation(Eigen::Index thresholds)
      : gradient(Eigen::VectorXd::Zero(thresholds + 1)),
        information(Eigen::MatrixXd::Zero(thresholds + 1, thresholds + 1)) {}

  void add(Eigen::Index t, const Evaluation& one) {
    const Eigen::Index last = gradient.size() - 1;
    value += one.value;
    gradient[t] += one.gradient[0];
    gradient[last] += one.gradient[1];
    information(t, t) += one.information(0, 0);
    information(t, last) += one.information(0, 1);
    information(last, t) += one.information(0, 1);
    information(last, last) += one.information(1, 1);
  }
};

SurfaceEvaluation evaluate(const std::vector<LogRows>& data, const Eigen::VectorXd& point) {
  const auto thresholds = static_cast<Eigen::Index>(data.size());
  SurfaceEvaluation sum(thresholds);
  for (Eigen::Index t = 0; t < thresholds; ++t)
    sum.add(t, likelihood(data[static_cast<std::size_t>(t)], {point[t], point[thresholds]}));
  return sum;
}

LogRows sum_of(const std::vector<LogRows>& records, std::size_t without) {
  LogRows sum;
  for (std::size_t i = 0; i < records.size(); ++i)
    if (i != without) sum += records[i];
  return sum;
}

}  // namespace

SurfaceData::SurfaceData(const ShapeData& data) {
  for (std::size_t t = 0; t < data.capacities.size(); ++t) {
    std::vector<LogRows> records(record_count(data.capacities[t]));
    for (const Bracket& row : data.capacities[t])
      if (row.high > 0)
        records[row.record].add_bracket(std::log(row.low), std::log(row.high), row.weight);
    if (sum_of(records, none).exact.count == 0) continue;
    by_threshold_.push_back(std::move(records));
    thresholds_m_.push_back(data.thresholds_m[t]);
  }
}

std::optional<FragilitySurface> SurfaceData::fit(std::size_t without) const {
  if (by_threshold_.size() < 2) return std::nullopt;
  const auto last = static_cast<Eigen::Index>(by_threshold_.size());
  std::vector<LogRows> pooled;
  Eigen::VectorXd start(last + 1);
  double steepness = std::numeric_limits<double>::infinity();
  for (const std::vector<LogRows>& records : by_threshold_) {
    pooled.push_back(sum_of(records, without));
    if (pooled.back().exact.count == 0) return std::nullopt;
    steepness = std::min(steepness, first_guess(pooled.back())[1]);
  }
  for (Eigen::Index t = 0; t < last; ++t) {
    const ExactRows& of = pooled[static_cast<std::size_t>(t)].exact;
    start[t] = -steepness * of.sum / of.count;
  }
  start[last] = steepness;
  const auto point =
      newton_maximum([&](const Eigen::VectorXd& at) { return evaluate(pooled, at); }, start);
  if (!point || !((*point)[last] > 0) || !point->allFinite()) return std::nullopt;
  FragilitySurface surface{.thresholds_m = thresholds_m_, .log_std = 1 / (*point)[last]};
  for (Eigen::Index t = 0; t < last; ++t)
    surface.medians.push_back(std::exp(-(*point)[t] / (*point)[last]));
  if (without == none) add_intervals(*point, evaluate(pooled, *point).information, surface);
  return surface;
}

void SurfaceData::add_intervals(const Eigen::VectorXd& point, const Eigen::MatrixXd& information,
                                FragilitySurface& surface) const {
  const auto records = static_cast<Eigen::Index>(by_threshold_.front().size());
  const Eigen::Index last = point.size() - 1;
  surface.median_intervals.assign(by_threshold_.size(), Interval{});
  if (records < 2) return;
  Eigen::MatrixXd scores(records, point.size());
  for (Eigen::Index i = 0; i < records; ++i) {
    std::vector<LogRows> record;
    for (const std::vector<LogRows>& of : by_threshold_)
      record.push_back(of[static_cast<std::size_t>(i)]);
    scores.row(i) = evaluate(record, point).gradient.transpose();
  }
  const Eigen::MatrixXd covariance = cluster_sandwich(scores, information);
  const double slope = point[last], n = static_cast<double>(records);
  const auto in_x = [&](double value, double variance) {
    return exponentials(t_interval(value, std::sqrt(std::max(0.0, variance)), n));
  };
  for (Eigen::Index t = 0; t < last; ++t) {
    const Eigen::Vector2d gradient{-1 / slope, point[t] / (slope * slope)};
    Eigen::Matrix2d part;
    part << covariance(t, t), covariance(t, last), covariance(last, t), covariance(last, last);
    surface.median_intervals[static_cast<std::size_t>(t)] =
        in_x(-point[t] / slope, gradient.dot(part * gradient));
  }
  surface.log_std_interval = in_x(-std::log(slope), covariance(last, last) / (slope * slope));
}

}  // namespace fragility

double FragilitySurface::median_at(double displacement_m) const {
  GLISSADE_EXPECTS(displacement_m >= thresholds_m.front() && displacement_m <= thresholds_m.back());
  const auto above = std::ranges::lower_bound(thresholds_m, displacement_m);
  const auto i =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - thresholds_m.begin()));
  const double share = std::log(displacement_m / thresholds_m[i - 1]) /
                       std::log(thresholds_m[i] / thresholds_m[i - 1]);
  return medians[i - 1] * std::pow(medians[i] / medians[i - 1], share);
}

double FragilitySurface::probability(double intensity, double displacement_m) const {
  if (!(intensity > 0)) return 0;
  return normal_cdf(std::log(intensity / median_at(displacement_m)) / log_std);
}

std::optional<FragilitySurface> fit_surface(const ShapeData& data) {
  return fragility::SurfaceData(data).fit();
}

std::optional<CurveCrossing> crossing_of(const FragilityCurve& a, const FragilityCurve& b) {
  if (a.log_std == b.log_std) return std::nullopt;
  const double log_x =
      (std::log(a.median) * b.log_std - std::log(b.median) * a.log_std) / (b.log_std - a.log_std);
  const double z = (log_x - std::log(a.median)) / a.log_std;
  return CurveCrossing{std::exp(log_x), a.floor + (1 - a.floor) * normal_cdf(z)};
}

}  // namespace glissade
