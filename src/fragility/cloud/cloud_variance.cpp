// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud/cloud_variance.hpp"

#include <cmath>
#include <map>

#include "by_record/intervals.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/jackknife.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/likelihood.hpp"

namespace glissade::fragility {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Scores and information of a line that a record adds.
struct LinePart {
  Vector2d score = Vector2d::Zero();
  Matrix2d information = Matrix2d::Zero();

  void add(double residual, double weight, const Vector2d& x) {
    score += residual * x;
    information += weight * x * x.transpose();
  }
  /// What leaving out the record changes; exact for a regression. NaN where it decides the line.
  Vector2d change(const Matrix2d& all) const {
    const Eigen::FullPivLU<Matrix2d> rest(all - information);
    return rest.isInvertible() ? Vector2d(rest.solve(score)) : Vector2d::Constant(nan);
  }
};

struct RecordPart {
  LinePart any, size, collapse;
  double slips = 0.0, squares = 0.0;  ///< weight of the rows that slip; of their residuals
};

class CloudRecords {
 public:
  CloudRecords(const std::vector<CloudPoint>& points, const CloudFit& fit)
      : fit_(fit), p_(parameters_of(fit)) {
    std::map<std::size_t, RecordPart> parts;
    for (const CloudPoint& point : points)
      if (point.weight > 0) add(point, parts[point.record]);
    for (const auto& [record, part] : parts) parts_.push_back(part);
    for (const RecordPart& part : parts_) {
      any_ += part.any.information;
      size_ += part.size.information;
      collapse_ += part.collapse.information;
      slips_ += part.slips;
      squares_ += part.squares;
    }
  }

  CloudVariance variance(double effective) const {
    CloudVariance found;
    found.freedom = std::max(1.0, effective_slipping() - 2);
    found.any_freedom = std::max(1.0, effective - 2);
    found.log_std_freedom = log_std_freedom(found.freedom);
    found.covariance = covariance();
    found.covariance(4, 4) = p_[4] * p_[4] / (2 * found.log_std_freedom);
    if (has_any()) add_design_effects(found);
    return found;
  }

 private:
  bool has_any() const { return fit_.parts.any_status != FitStatus::upper_bound; }

  void add(const CloudPoint& point, RecordPart& record) const {
    const double y = std::log(point.intensity), w = point.weight;
    const Vector2d x{1, y};
    const auto add_share = [&](LinePart& part, Eigen::Index at, bool exceeds) {
      const LogShares shares = log_shares(Link::probit, p_[at] + p_[at + 1] * y);
      const LogShares::Part& of = exceeds ? shares.above : shares.below;
      part.add(w * (exceeds ? of.hazard : -of.hazard), w * of.curvature, x);
    };
    const bool collapses = std::isinf(point.displacement);
    if (fit_.collapse) add_share(record.collapse, 5, collapses);
    if (collapses) return;
    if (has_any()) add_share(record.any, 0, point.displacement > 0);
    if (point.displacement == 0) return;
    const double r = std::log(point.displacement) - p_[2] - p_[3] * y;
    record.size.add(w * r, w, x);
    record.slips += w;
    record.squares += w * r * r;
  }

  double effective_slipping() const {
    Eigen::VectorXd weights(static_cast<Eigen::Index>(parts_.size()));
    for (std::size_t i = 0; i < parts_.size(); ++i)
      weights[static_cast<Eigen::Index>(i)] = parts_[i].slips;
    return effective_number(weights);
  }

  Eigen::Matrix<double, 7, 7> covariance() const {
    Eigen::Matrix<double, 7, 7> sum = Eigen::Matrix<double, 7, 7>::Zero();
    for (const RecordPart& part : parts_) {
      CloudParameters change = CloudParameters::Zero();
      if (has_any()) change.head<2>() = part.any.change(any_);
      if (part.slips > 0) change.segment<2>(2) = part.size.change(size_);
      if (fit_.collapse) change.tail<2>() = part.collapse.change(collapse_);
      sum += change * change.transpose();
    }
    return sum;
  }

  /// Variance of ln log_std by the jackknife; NaN where too few rows are left.
  double log_std_variance() const {
    std::vector<double> logs;
    for (const RecordPart& part : parts_) {
      if (part.slips == 0) continue;
      const double squares = squares_ - part.squares - part.size.score.dot(part.size.change(size_));
      const double rows = slips_ - part.slips - 2;
      if (!(rows > 0 && squares > 0)) return nan;
      logs.push_back(0.5 * std::log(squares / rows));
    }
    return jackknife_variance(logs);
  }

  /// As many as the jackknife's variance is worth, 1 / (2 v) (Satterthwaite 1946), at most those of
  /// the records; beyond those, if rows of a record have more information, less Student's factor
  /// (z/t)^2.
  double log_std_freedom(double of_records) const {
    const double worth = 0.5 / log_std_variance();
    if (std::isnan(worth)) return of_records;
    const double ratio = normal_quantile(0.975) / student_quantile(of_records, 0.975);
    const double freedom = std::max(ratio * ratio * worth, std::min(of_records, worth));
    return std::max(1.0, std::min(freedom, slips_ - 2));
  }

  void add_design_effects(CloudVariance& found) const {
    Eigen::MatrixXd scores(static_cast<Eigen::Index>(parts_.size()), 2);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      scores.row(static_cast<Eigen::Index>(i)) = parts_[i].any.score.transpose();
    const Matrix2d between = cluster_sandwich(scores, any_), rows = any_.inverse();
    const Vector2d of_median{1 / p_[1], -p_[0] / (p_[1] * p_[1])};
    found.median_design_effect =
        of_median.dot(between * of_median) / of_median.dot(rows * of_median);
    found.log_std_design_effect = between(1, 1) / rows(1, 1);
  }

  const CloudFit& fit_;
  CloudParameters p_;
  std::vector<RecordPart> parts_;
  Matrix2d any_ = Matrix2d::Zero(), size_ = any_, collapse_ = any_;
  double slips_ = 0.0, squares_ = 0.0;
};

}  // namespace

CloudParameters parameters_of(const CloudFit& fit) {
  const TwoPartFit& parts = fit.parts;
  const ProbitLine any = parts.any_status == FitStatus::upper_bound ? ProbitLine(0, 1)
                                                                    : to_line(parts.any, 0.0),
                   collapse = fit.collapse ? to_line(*fit.collapse, 0.0) : ProbitLine(0, 1);
  CloudParameters p;
  p << any[0], any[1], parts.intercept, parts.slope, parts.log_std, collapse[0], collapse[1];
  return p;
}

CloudVariance cloud_variance(const std::vector<CloudPoint>& points, const CloudFit& fit) {
  return CloudRecords(points, fit).variance(effective_number(record_weights(points)));
}

Eigen::VectorXd record_weights(const std::vector<CloudPoint>& points) {
  std::map<std::size_t, double> weights;
  for (const CloudPoint& point : points)
    if (point.weight > 0) weights[point.record] += point.weight;
  Eigen::VectorXd found(std::ssize(weights));
  Eigen::Index i = 0;
  for (const auto& [record, weight] : weights) found[i++] = weight;
  return found;
}

}  // namespace glissade::fragility
