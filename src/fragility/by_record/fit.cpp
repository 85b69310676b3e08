// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>

#include "by_record/allowance.hpp"
#include "by_record/records.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/line_region.hpp"

namespace glissade {
namespace {

using namespace fragility;

Interval exponentials(const Interval& logs) { return {std::exp(logs.low), std::exp(logs.high)}; }

/// Of a fit that has a line: the intervals, as ranges over the lines that the data allow.
class Intervals {
 public:
  Intervals(const Records& data, const LineRegion& region) : data_(data), region_(region) {
    const double floor = data.floor();
    floors_ = data.floor_interval();
    if (std::isnan(floors_.low)) floors_ = {floor, floor};
  }
  Interval median() const { return at(0); }
  Interval log_std() const { return region_.range(fragility::log_std); }
  /// Where half of all exceed. NaN where as many exceed without shaking in any case.
  Interval p50() const {
    if (floors_.low >= 0.5) return {};
    return {floors_.high >= 0.5 ? 0.0 : at(z_of_half(floors_.high)).low,
            at(z_of_half(floors_.low)).high};
  }
  Interval probability(double intensity) const {
    const double y = std::log(intensity) - data_.center();
    const Interval z = region_.range([y](const ProbitLine& l) { return l[0] + l[1] * y; });
    return {floors_.low + (1 - floors_.low) * normal_cdf(z.low),
            floors_.high + (1 - floors_.high) * normal_cdf(z.high)};
  }

 private:
  static double z_of_half(double floor) { return normal_quantile((0.5 - floor) / (1 - floor)); }
  Interval at(double z) const {
    const Interval y = region_.range([z](const ProbitLine& l) { return (z - l[0]) / l[1]; });
    return exponentials({data_.center() + y.low, data_.center() + y.high});
  }

  const Records& data_;
  const LineRegion& region_;
  Interval floors_;
};

/// Student t for ln median, chi-square for log_std: exact for a lognormal sample of n.
void take_sample_intervals(double n, FitSummary& summary) {
  const double t = student_quantile(n - 1, 0.975), log_std = summary.curve.log_std;
  const double factor = std::exp(t * log_std / std::sqrt(n));
  summary.median_interval = {summary.curve.median / factor, summary.curve.median * factor};
  summary.log_std_interval = {log_std * std::sqrt((n - 1) / chi_squared_quantile(n - 1, 0.975)),
                              log_std * std::sqrt((n - 1) / chi_squared_quantile(n - 1, 0.025))};
  summary.interval_method = "Student t and chi-square";
}

/// The lines that the data allow; none where they do not show it.
std::optional<LineRegion> region_of(const Records& data, const PointFit& point,
                                    FitSummary& summary) {
  if (data.count() < 2 && !data.one_row_each()) {
    add_sentence(summary.note, "one record: no interval");
    return std::nullopt;
  }
  const bool penalised = point.status == FitStatus::jeffreys_penalised;
  if (penalised && !data.independent_counts()) {
    add_sentence(summary.note, "the records do not show how much they differ: no interval");
    return std::nullopt;
  }
  // Of complete capacities the median and log_std are those of n - 1, the greatest likelihood not.
  const double n = data.worth().rows;
  const ProbitLine line = data.complete() ? point.line * std::sqrt(n / (n - 1)) : point.line;
  const bool above = data.above_data(log_median(line));
  const Allowance allowance(data, line, above || data.below_data(log_median(line)), above);
  if (allowance.identical()) {
    add_sentence(summary.note, "the records are identical: no interval");
    return std::nullopt;
  }
  summary.interval_method = penalised ? "penalised profile likelihood"
                            : data.one_row_each() && data.equal_weights()
                                ? "profile likelihood"
                                : "profile likelihood, scaled by the variance between records";
  return LineRegion(
      [&data, penalised](const ProbitLine& l) {
        return penalised ? data.evaluate_penalised(l).value : data.value(l);
      },
      line, allowance.half_axes(), allowance);
}

void note_extrapolation(const Records& data, const ProbitLine& line, FitSummary& summary) {
  const double y = log_median(line);
  if (summary.status != FitStatus::maximum_likelihood ||
      !(data.above_data(y) || data.below_data(y)))
    return;
  summary.status = FitStatus::extrapolated;
  add_sentence(summary.note, std::string("the data ") +
                                 (data.above_data(y) ? "end below 50 %" : "begin above 50 %") +
                                 ": the median is an extrapolation by the lognormal");
}

/// A bound has a median interval with one open end, and the log_std that it assumes.
void take_bound(const FitSummary& bound, FitSummary& summary) {
  const double floor = summary.curve.floor;
  summary = bound;
  summary.curve.floor = floor;
  const double p50 = summary.curve.intensity_at(0.5);
  summary.p50_interval = p50 == 0                                   ? Interval{}
                         : summary.status == FitStatus::lower_bound ? Interval{p50, infinity}
                                                                    : Interval{0.0, p50};
}

}  // namespace

namespace fragility {

FitSummary summarise(const Records& data, const PointFit& point,
                     const std::vector<double>& band_intensities, std::vector<Interval>* band) {
  if (band != nullptr) band->assign(band_intensities.size(), Interval{});
  FitSummary summary;
  summary.curve.floor = data.floor();
  if (summary.curve.floor == 1) return summarise_always();
  summary.status = point.status;
  summary.note = point.note;
  if (point.is_bound()) {
    take_bound(data.bound(), summary);
    if (!data.one_row_each()) add_sentence(summary.note, "each record counts as one trial");
  }
  if (!data.equal_weights()) summary.effective_records = data.worth().records;
  if (summary.curve.floor > 0) add_sentence(summary.note, note_on_floor);
  summary.floor_interval = data.floor_interval();
  if (point.status == FitStatus::one_capacity)
    summary.curve.median = to_curve(point.line, data.center()).median;
  if (!summary.converged()) return summary;
  const double floor = summary.curve.floor;
  summary.curve = to_curve(point.line, data.center());
  summary.curve.floor = floor;
  summary.log_likelihood = data.log_likelihood(summary.curve);
  summary.method = (point.status == FitStatus::jeffreys_penalised ? "Jeffreys penalised " : "") +
                   data.method() + (data.one_row_each() ? "" : ", records pooled");
  note_extrapolation(data, point.line, summary);
  const std::optional<LineRegion> region = region_of(data, point, summary);
  if (!region) return summary;
  const Intervals intervals(data, *region);
  summary.median_interval = intervals.median();
  summary.log_std_interval = intervals.log_std();
  summary.p50_interval = intervals.p50();
  if (data.complete() && data.one_row_each() && data.equal_weights()) {
    take_sample_intervals(data.worth().rows, summary);
    if (floor == 0) summary.p50_interval = summary.median_interval;
  }
  for (std::size_t i = 0; band != nullptr && i < band_intensities.size(); ++i)
    (*band)[i] = intervals.probability(band_intensities[i]);
  return summary;
}

}  // namespace fragility

FitSummary fit_stripes(const std::vector<Stripe>& stripes) {
  const StripeRecords data(stripes);
  return summarise(data, data.fit());
}

FitSummary fit_stripes_jeffreys(const std::vector<Stripe>& stripes) {
  const StripeRecords data(stripes);
  return summarise(data, data.fit_jeffreys());
}

FitSummary fit_capacities(const CapacitySample& sample) {
  const BracketRecords data(sample);
  return summarise(data, data.fit());
}

FitSummary fit_stripes_by_record(const std::vector<double>& intensities,
                                 const std::vector<RecordStripes>& records,
                                 const std::vector<double>& band_intensities,
                                 std::vector<Interval>* band) {
  const StripeRecords data(intensities, records);
  return summarise(data, data.fit(), band_intensities, band);
}

FitSummary fit_capacities_by_record(const std::vector<RecordCapacities>& records,
                                    double censored_at, const std::vector<double>& band_intensities,
                                    std::vector<Interval>* band) {
  const BracketRecords data(records, censored_at);
  return summarise(data, data.fit(), band_intensities, band);
}

FitSummary fit_weighted_stripes(const std::vector<WeightedStripe>& rows) {
  const StripeRecords data(rows);
  return summarise(data, data.fit());
}

FitSummary fit_brackets(const std::vector<CapacityBracket>& rows, bool independent) {
  const BracketRecords data(rows, independent);
  FitSummary summary = summarise(data, data.fit());
  add_sentence(summary.note, data.note());
  return summary;
}

}  // namespace glissade
