// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/bootstrap.hpp"

#include <cmath>
#include <limits>

#include "by_record/records.hpp"
#include "by_record/resampling.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"

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
  double floor = 0.0;
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

  /// ln x - center where the line is z, of the median where z = 0; infinite where none or all
  /// exceeded.
  EstimateWithError log_intensity_at(double z) const {
    if (is_bound()) return {point.status == FitStatus::lower_bound ? infinity : -infinity, nan};
    const double b0 = point.line[0], b1 = point.line[1];
    return has_line() ? EstimateWithError{(z - b0) / b1, error_of(-1 / b1, (b0 - z) / (b1 * b1))}
                      : EstimateWithError{nan, nan};
  }
  /// ... where half of all exceed, at a given floor below one half.
  EstimateWithError log_p50(double known_floor) const {
    return log_intensity_at(normal_quantile((0.5 - known_floor) / (1 - known_floor)));
  }
  /// ln log_std
  EstimateWithError log_log_std() const {
    return has_line() ? EstimateWithError{-std::log(point.line[1]), error_of(0, -1 / point.line[1])}
                      : EstimateWithError{nan, nan};
  }
  /// Phi^-1 of the probability of exceedance at y, of those that need shaking.
  EstimateWithError probit_at(double y) const {
    if (is_bound()) return {point.status == FitStatus::lower_bound ? -infinity : infinity, nan};
    return has_line() ? EstimateWithError{point.line[0] + point.line[1] * y, error_of(1, y)}
                      : EstimateWithError{nan, nan};
  }
};

ClusterFit fit_weighted(const Records& records, const Eigen::VectorXd& weights,
                        const ProbitLine& start) {
  ClusterFit fit{{}, records.floor(weights)};
  if (fit.floor == 1) return {{FitStatus::always_exceeds}, 1};
  fit.point = records.fit(weights, start);
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
        floor_varies_(records.floor_varies()),
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
    return interval_of([](const ClusterFit& fit) { return fit.log_intensity_at(0); });
  }
  /// Where half of all exceed; NaN where the floor is one half or more in all resamples.
  Interval log_p50() const {
    if (floor_varies_) {
      return percentile([](const ClusterFit& fit) {
        return fit.floor < 0.5 ? fit.log_p50(fit.floor) : EstimateWithError{-infinity, nan};
      });
    }
    if (pooled_.floor >= 0.5) return {};
    return interval_of([&](const ClusterFit& fit) { return fit.log_p50(pooled_.floor); });
  }
  Interval floor() const {
    if (!floor_varies_) return {};
    return percentile([](const ClusterFit& fit) { return EstimateWithError{fit.floor, nan}; });
  }
  Interval log_log_std() const {
    const auto quantity = [](const ClusterFit& fit) { return fit.log_log_std(); };
    if (!studentised()) return percentile(quantity);
    return log_std_interval(quantity(pooled_), estimates(quantity), records_, level_);
  }
  Interval probability_at(double y) const {
    const auto mixed = [](double floor, double probit) {
      return floor + (1 - floor) * normal_cdf(probit);
    };
    if (floor_varies_) {
      return percentile([&](const ClusterFit& fit) {
        return EstimateWithError{fit.floor == 1 ? 1 : mixed(fit.floor, fit.probit_at(y).value),
                                 nan};
      });
    }
    const Interval probit = interval_of([y](const ClusterFit& fit) { return fit.probit_at(y); });
    return {mixed(pooled_.floor, probit.low), mixed(pooled_.floor, probit.high)};
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
  Interval interval_of(const Quantity& quantity) const {
    return studentised() ? t_interval(quantity(pooled_), estimates(quantity),
                                      widened_tail(records_, normal_quantile(0.5 + 0.5 * level_)))
                         : percentile(quantity);
  }

  std::size_t records_;
  bool floor_varies_;
  ClusterFit pooled_;
  double level_;
  std::vector<ClusterFit> replicates_;
  std::size_t without_maximum_ = 0;
};

FitSummary fit_by_record(const Records& records, const BootstrapOptions& options,
                         const std::vector<double>& band_intensities, std::vector<Interval>* band) {
  GLISSADE_EXPECTS(options.replicates >= 100);
  GLISSADE_EXPECTS(options.level > 0 && options.level < 1);
  if (band != nullptr) band->assign(band_intensities.size(), Interval{});
  const ClusterFit pooled =
      fit_weighted(records, Eigen::VectorXd::Ones(records.count()), records.first_guess());
  FitSummary summary;
  if (pooled.floor == 1) return summarise_always();
  if (pooled.is_bound()) {
    summary = records.bound();
    add_sentence(summary.note, "each record counts as one trial");
  } else {
    summary.status = pooled.point.status;
    summary.note = pooled.point.note;
  }
  if (pooled.has_line()) summary.curve = to_curve(pooled.point.line, records.center());
  summary.curve.floor = pooled.floor;
  if (pooled.floor > 0) add_sentence(summary.note, note_on_floor);
  if (pooled.is_bound()) {  // with the log_std that the bound assumes
    const double p50_over_median = summary.curve.intensity_at(0.5) / summary.curve.median;
    summary.p50_interval = {p50_over_median * summary.median_interval.low,
                            p50_over_median * summary.median_interval.high};
  }
  if (!pooled.has_line()) return summary;
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
  const Interval log_p50 = resamples.log_p50();
  summary.p50_interval = {std::exp(records.center() + log_p50.low),
                          std::exp(records.center() + log_p50.high)};
  summary.floor_interval = resamples.floor();
  summary.interval_method = resamples.method();
  add_sentence(summary.note, resamples.note());
  if (band != nullptr) {
    for (std::size_t i = 0; i < band_intensities.size(); ++i) {
      (*band)[i] = resamples.probability_at(std::log(band_intensities[i]) - records.center());
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
