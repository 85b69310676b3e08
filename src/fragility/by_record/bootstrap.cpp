// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "by_record/line_draws.hpp"
#include "by_record/records.hpp"
#include "by_record/resampling.hpp"
#include "by_record/sandwich.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// One curve of many that the data allow.
struct CandidateFit {
  ProbitLine line;
  double floor;

  /// ln x - center where the line is z: of the median where z = 0.
  double log_intensity_at(double z) const { return (z - line[0]) / line[1]; }
  /// ... where half of all exceed.
  double log_p50() const {
    if (floor >= 0.5) return -infinity;
    return log_intensity_at(normal_quantile((0.5 - floor) / (1 - floor)));
  }
  double log_log_std() const { return -std::log(line[1]); }
  double probability_at(double y) const {
    return floor + (1 - floor) * normal_cdf(line[0] + line[1] * y);
  }
};

/// Of all records. A bound has no line.
struct PooledFit {
  PointFit point;
  double floor;

  explicit PooledFit(const Records& records) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(records.count());
    floor = records.floor(ones);
    point =
        floor == 1 ? PointFit{FitStatus::always_exceeds} : records.fit(ones, records.first_guess());
  }
  bool has_line() const {
    return point.status == FitStatus::maximum_likelihood ||
           point.status == FitStatus::jeffreys_penalised;
  }
};

/// Curves that the data allow, in families: an interval of any quantity goes from the lowest end of
/// its families to the highest. As the curves rise, so do the ends of the interval of P over
/// intensity; and that of P = 1/2 is crossed where the interval of the intensity of P = 1/2 ends.
class CandidateFits {
 public:
  CandidateFits(const Records& records, const PooledFit& pooled, const BootstrapOptions& options)
      : floor_varies_(records.floor_varies()),
        floor_(pooled.floor),
        tail_(0.5 - 0.5 * options.level) {
    const auto count = static_cast<std::size_t>(records.count());
    std::vector<double> floors;  // of resamples of the records
    for (int r = 0; r < options.replicates && floor_varies_; ++r) {
      const std::vector<double> times = draw_records(count, options, r);
      floors.push_back(
          records.floor(Eigen::Map<const Eigen::VectorXd>(times.data(), records.count())));
    }
    const double widening =
        normal_quantile(expanded_tail(count, options.level)) / normal_quantile(tail_);
    const LineDraws lines = draw_lines(with_errors(records, pooled.point.line));
    for (const auto& family : lines.families()) {
      families_.emplace_back();
      for (const ProbitLine& line : family) families_.back().push_back({line, floor_});
      for (std::size_t i = 0; i < family.size() && !floors.empty(); ++i) {
        const double departure = floors[i % floors.size()] - floor_;
        families_.back()[i].floor = std::clamp(floor_ + widening * departure, 0.0, 1.0);
      }
    }
  }

  Interval log_median() const {
    return interval_of([](const CandidateFit& c) { return c.log_intensity_at(0); });
  }
  /// NaN where the floor is one half or more in all.
  Interval log_p50() const {
    return !floor_varies_ && floor_ >= 0.5 ? Interval{} : interval_of(&CandidateFit::log_p50);
  }
  Interval floor() const {
    return floor_varies_ ? interval_of([](const CandidateFit& c) { return c.floor; }) : Interval{};
  }
  Interval log_log_std() const { return interval_of(&CandidateFit::log_log_std); }
  Interval probability_at(double y) const {
    return interval_of([y](const CandidateFit& c) { return c.probability_at(y); });
  }

 private:
  static LineWithErrors with_errors(const Records& records, const ProbitLine& line) {
    const Records::Scores scores = records.scores(line);
    const Eigen::Matrix2d information =
        records.information(Eigen::VectorXd::Ones(records.count()), line);
    return {line, cluster_sandwich(scores, information), information.inverse(),
            static_cast<double>(records.count())};
  }
  Interval interval_of(const auto& quantity) const {
    return interval_over(families_, quantity, tail_);
  }

  bool floor_varies_;
  double floor_, tail_;
  std::vector<std::vector<CandidateFit>> families_;
};

FitSummary fit_by_record(const Records& records, const BootstrapOptions& options,
                         const std::vector<double>& band_intensities, std::vector<Interval>* band) {
  GLISSADE_EXPECTS(options.replicates >= 100);
  GLISSADE_EXPECTS(options.level > 0 && options.level < 1);
  if (band != nullptr) band->assign(band_intensities.size(), Interval{});
  const PooledFit pooled(records);
  FitSummary summary;
  if (pooled.floor == 1) return summarise_always();
  if (pooled.point.is_bound()) {
    summary = records.bound();
    add_sentence(summary.note, "each record counts as one trial");
  } else {
    summary.status = pooled.point.status;
    summary.note = pooled.point.note;
  }
  if (pooled.point.status == FitStatus::one_capacity)
    summary.curve.median = to_curve(pooled.point.line, records.center()).median;
  if (pooled.has_line()) summary.curve = to_curve(pooled.point.line, records.center());
  summary.curve.floor = pooled.floor;
  if (pooled.floor > 0) add_sentence(summary.note, note_on_floor);
  if (pooled.point.is_bound()) {  // with the log_std that the bound assumes
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
  if (summary.status == FitStatus::jeffreys_penalised) {  // nothing varies between the records
    add_sentence(summary.note, note_on_separation);
    return summary;
  }
  const CandidateFits candidates(records, pooled, options);
  const Interval log_median = candidates.log_median(), log_log_std = candidates.log_log_std();
  summary.median_interval = {std::exp(records.center() + log_median.low),
                             std::exp(records.center() + log_median.high)};
  summary.log_std_interval = {std::exp(log_log_std.low), std::exp(log_log_std.high)};
  const Interval log_p50 = candidates.log_p50();
  summary.p50_interval = {std::exp(records.center() + log_p50.low),
                          std::exp(records.center() + log_p50.high)};
  summary.floor_interval = candidates.floor();
  summary.interval_method = "variance between records (sandwich, chi-square)";
  if (band != nullptr) {
    for (std::size_t i = 0; i < band_intensities.size(); ++i) {
      (*band)[i] = candidates.probability_at(std::log(band_intensities[i]) - records.center());
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
