// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/bootstrap.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "records.hpp"
#include "resampling.hpp"

namespace glissade {
namespace {

using namespace fragility;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A fit of weighted records with the cluster sandwich covariance of its line, n/(n - 1) A^-1 (sum
/// s s^T) A^-1 (Liang & Zeger 1986, Biometrika 73(1):13-22); NaN unless it is a maximum of the
/// likelihood.
struct ClusterFit {
  PointFit point;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(nan);

  bool has_line() const {
    return point.status == FitStatus::maximum_likelihood ||
           point.status == FitStatus::jeffreys_penalised;
  }
  bool is_bound() const { return point.is_bound(); }
  double error_of(double by_b0, double by_b1) const {
    const Eigen::Vector2d gradient{by_b0, by_b1};
    return std::sqrt(gradient.dot(covariance * gradient));
  }

  /// ln median - center; infinite where none or all exceeded.
  EstimateWithError log_median() const {
    if (is_bound()) return {point.status == FitStatus::lower_bound ? infinity : -infinity, nan};
    const double b0 = point.line[0], b1 = point.line[1];
    return has_line() ? EstimateWithError{-b0 / b1, error_of(-1 / b1, b0 / (b1 * b1))}
                      : EstimateWithError{nan, nan};
  }
  /// ln log_std
  EstimateWithError log_log_std() const {
    return has_line() ? EstimateWithError{-std::log(point.line[1]), error_of(0, -1 / point.line[1])}
                      : EstimateWithError{nan, nan};
  }
  /// Phi^-1 of the probability of exceedance at y.
  EstimateWithError probit_at(double y) const {
    if (is_bound()) return {point.status == FitStatus::lower_bound ? -infinity : infinity, nan};
    return has_line() ? EstimateWithError{point.line[0] + point.line[1] * y, error_of(1, y)}
                      : EstimateWithError{nan, nan};
  }
};

ClusterFit fit_weighted(const Records& records, const Eigen::VectorXd& weights,
                        const ProbitLine& start) {
  ClusterFit fit{records.fit(weights, start)};
  if (fit.point.status != FitStatus::maximum_likelihood) return fit;
  const Eigen::Matrix2d inverse = records.information(weights, fit.point.line).inverse();
  const Records::Scores scores = records.scores(fit.point.line);
  const double n = static_cast<double>(records.count());
  fit.covariance =
      n / (n - 1) * inverse * (scores.transpose() * weights.asDiagonal() * scores) * inverse;
  return fit;
}

/// The pooled fit and its resamples, which give an interval for any quantity of the fit.
class Resamples {
 public:
  Resamples(const Records& records, const ClusterFit& pooled, const BootstrapOptions& options)
      : records_(static_cast<std::size_t>(records.count())),
        pooled_(pooled),
        level_(options.level) {
    for (int r = 0; r < options.replicates; ++r) {
      const std::vector<double> drawn = draw_records(records_, options, r);
      const Eigen::Map<const Eigen::VectorXd> weights(drawn.data(), records.count());
      replicates_.push_back(fit_weighted(records, weights, pooled.point.line));
      if (replicates_.back().point.status != FitStatus::maximum_likelihood) ++without_maximum_;
    }
  }

  /// Where the likelihood has a maximum in nearly every replicate the t statistics say more than
  /// the estimates.
  bool studentised() const {
    return pooled_.point.status == FitStatus::maximum_likelihood &&
           100 * without_maximum_ <= replicates_.size();
  }
  Interval log_median() const {
    return symmetric([](const ClusterFit& fit) { return fit.log_median(); });
  }
  Interval log_log_std() const {
    const auto quantity = [](const ClusterFit& fit) { return fit.log_log_std(); };
    if (!studentised()) return percentile(quantity);
    return log_std_interval(quantity(pooled_), estimates(quantity), records_, level_);
  }
  Interval probit_at(double y) const {
    return symmetric([y](const ClusterFit& fit) { return fit.probit_at(y); });
  }

  std::string method() const {
    return studentised() ? "bootstrap over records (bootstrap-t)"
                         : "bootstrap over records (expanded percentile)";
  }
  std::string note() const {
    if (without_maximum_ == 0) return "";
    return std::to_string(without_maximum_) + " of " + std::to_string(replicates_.size()) +
           " resamples of the records have no finite maximum of the likelihood";
  }

 private:
  using Quantity = std::function<EstimateWithError(const ClusterFit&)>;

  std::vector<EstimateWithError> estimates(const Quantity& quantity) const {
    std::vector<EstimateWithError> result;
    for (const ClusterFit& replicate : replicates_) result.push_back(quantity(replicate));
    return result;
  }
  Interval percentile(const Quantity& quantity) const {
    std::vector<double> values;
    for (const ClusterFit& replicate : replicates_) values.push_back(quantity(replicate).value);
    return percentile_interval(values, expanded_tail(records_, level_));
  }
  Interval symmetric(const Quantity& quantity) const {
    return studentised() ? symmetric_t_interval(quantity(pooled_), estimates(quantity), level_)
                         : percentile(quantity);
  }

  std::size_t records_;
  ClusterFit pooled_;
  double level_;
  std::vector<ClusterFit> replicates_;
  std::size_t without_maximum_ = 0;
};

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

void add_sentence(std::string& note, const std::string& sentence) {
  if (!note.empty() && !sentence.empty()) note += "; ";
  note += sentence;
}

FitSummary fit_by_record(const Records& records, const BootstrapOptions& options,
                         const std::vector<double>& band_intensities, std::vector<Interval>* band) {
  GLISSADE_EXPECTS(options.replicates >= 100);
  GLISSADE_EXPECTS(options.level > 0 && options.level < 1);
  if (band != nullptr) band->assign(band_intensities.size(), Interval{});
  const ClusterFit pooled =
      fit_weighted(records, Eigen::VectorXd::Ones(records.count()), records.first_guess());
  if (pooled.is_bound()) {
    FitSummary summary = records.bound();
    add_sentence(summary.note, "each record counts as one trial");
    return summary;
  }
  FitSummary summary;
  summary.status = pooled.point.status;
  summary.note = pooled.point.note;
  if (!pooled.has_line()) return summary;
  summary.curve = to_curve(pooled.point.line, records.center());
  summary.log_likelihood = records.log_likelihood(summary.curve);
  summary.method = records.method() +
                   (summary.status == FitStatus::maximum_likelihood ? "" : ", Jeffreys penalised") +
                   ", records pooled";
  if (records.count() < 2) {
    add_sentence(summary.note, "one record: no interval");
    return summary;
  }
  const Resamples resamples(records, pooled, options);
  const Interval log_median = resamples.log_median(), log_log_std = resamples.log_log_std();
  summary.median_interval = {std::exp(records.center() + log_median.low),
                             std::exp(records.center() + log_median.high)};
  summary.log_std_interval = {std::exp(log_log_std.low), std::exp(log_log_std.high)};
  summary.interval_method = resamples.method();
  add_sentence(summary.note, resamples.note());
  if (band != nullptr) {
    for (std::size_t i = 0; i < band_intensities.size(); ++i) {
      const Interval probit = resamples.probit_at(std::log(band_intensities[i]) - records.center());
      (*band)[i] = {normal_cdf(probit.low), normal_cdf(probit.high)};
    }
  }
  return summary;
}

}  // namespace

FitSummary fit_stripes_by_record(const std::vector<double>& intensities,
                                 const std::vector<RecordStripes>& records,
                                 const BootstrapOptions& options,
                                 const std::vector<double>& band_intensities,
                                 std::vector<Interval>* band) {
  return fit_by_record(StripeRecords(intensities, records), options, band_intensities, band);
}

FitSummary fit_capacities_by_record(const std::vector<RecordCapacities>& records,
                                    double censored_at, const BootstrapOptions& options,
                                    const std::vector<double>& band_intensities,
                                    std::vector<Interval>* band) {
  return fit_by_record(CapacityRecords(records, censored_at), options, band_intensities, band);
}

}  // namespace glissade
