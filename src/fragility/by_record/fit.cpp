// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <optional>

#include "by_record/allowance.hpp"
#include "by_record/intervals.hpp"
#include "by_record/records.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/line_region.hpp"

namespace glissade {
namespace {

using namespace fragility;

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
    const double y = std::log(intensity) - data_.pooled().center;
    const Interval z = region_.range([y](const ProbitLine& l) { return l[0] + l[1] * y; });
    return {floors_.low + (1 - floors_.low) * normal_cdf(z.low),
            floors_.high + (1 - floors_.high) * normal_cdf(z.high)};
  }

 private:
  static double z_of_half(double floor) { return normal_quantile((0.5 - floor) / (1 - floor)); }
  Interval at(double z) const {
    const Interval y = region_.range([z](const ProbitLine& l) { return (z - l[0]) / l[1]; });
    return exponentials({data_.pooled().center + y.low, data_.pooled().center + y.high});
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
  summary.log_std_interval = chi_square_interval(log_std, n - 1);
  summary.interval_method = "Student t and chi-square";
}

/// Whether the median is beyond the data: 1 above, -1 below.
int beyond_data(const Records& data, const ProbitLine& line) {
  const Interval range = data.pooled().range();
  const double y = log_median(line);
  return y > range.high + 1e-9 ? 1 : y < range.low - 1e-9 ? -1 : 0;
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
  const ProbitLine line =
      data.pooled().is_exact() ? point.line * std::sqrt(n / (n - 1)) : point.line;
  const int beyond = beyond_data(data, line);
  const Allowance allowance(data, line, beyond != 0, beyond > 0);
  if (allowance.identical()) {
    add_sentence(summary.note, "the records are identical: no interval");
    return std::nullopt;
  }
  summary.interval_method = penalised ? "penalised profile likelihood"
                            : data.one_row_each() && data.equal_weights()
                                ? "profile likelihood"
                                : "profile likelihood, scaled by the variance between records";
  if (!data.one_row_each() && data.count() < 30)
    summary.interval_method += "; with fewer than 30 records that of log_std covers 90 % or more";
  return LineRegion(
      [rows = summed(data.pooled(), line), penalised](const ProbitLine& l) {
        return (penalised ? jeffreys_likelihood(rows, l) : likelihood(rows, l)).value;
      },
      line, allowance.half_axes(), allowance);
}

void note_extrapolation(const Records& data, const ProbitLine& line, FitSummary& summary) {
  const int beyond = beyond_data(data, line);
  if (summary.status != FitStatus::maximum_likelihood || beyond == 0) return;
  summary.status = FitStatus::extrapolated;
  add_sentence(summary.note, std::string("the data ") +
                                 (beyond > 0 ? "end below 50 %" : "begin above 50 %") +
                                 ": the median is an extrapolation by the lognormal");
}

/// Where simulations show that the intervals cover less than they state (verification manual, 5.2).
void note_small_sample(const Records& data, FitSummary& summary) {
  if (data.independent_counts()) return;
  const Worth& worth = data.worth();
  const auto count = static_cast<double>(data.count());
  if (worth.freedom < 1.99)
    add_sentence(summary.note,
                 std::string("the records") + (data.equal_weights() ? "" : ", by their weights,") +
                     " leave less than two degrees of freedom: the intervals say little");
  else if (count < 20 && worth.records < 0.9 * count)
    add_sentence(summary.note,
                 "few records with uneven weights or numbers of rows: the 95 % intervals cover as "
                 "little as 90 %");
  else if (count >= 7 && std::min(data.contributing(true), data.contributing(false)) < 6)
    add_sentence(summary.note, std::string("fewer than six records ") +
                                   (data.contributing(true) < 6 ? "exceed" : "do not exceed") +
                                   ": the 95 % intervals cover as little as 92 %");
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

FitSummary summary_of(const Records& data, const PointFit& point,
                      const std::vector<double>& band_intensities) {
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
    summary.curve.median = to_curve(point.line, data.pooled().center).median;
  if (!summary.converged()) return summary;
  const double floor = summary.curve.floor;
  summary.curve = to_curve(point.line, data.pooled().center);
  summary.curve.floor = floor;
  summary.log_likelihood = data.log_likelihood(summary.curve);
  summary.method = (point.status == FitStatus::jeffreys_penalised ? "Jeffreys penalised " : "") +
                   data.method() + (data.one_row_each() ? "" : ", records pooled");
  note_extrapolation(data, point.line, summary);
  note_small_sample(data, summary);
  const std::optional<LineRegion> region = region_of(data, point, summary);
  if (!region) return summary;
  const Intervals intervals(data, *region);
  summary.median_interval = intervals.median();
  summary.log_std_interval = intervals.log_std();
  summary.p50_interval = intervals.p50();
  if (data.pooled().is_exact() && data.one_row_each() && data.equal_weights()) {
    take_sample_intervals(data.worth().rows, summary);
    if (floor == 0) summary.p50_interval = summary.median_interval;
  }
  for (const double intensity : band_intensities)
    summary.band.push_back(intervals.probability(intensity));
  return summary;
}

/// The one writer of summaries.
FitSummary summarise(const Records& data, PointFit (Records::*fit)() const,
                     const std::vector<double>& band_intensities = {}) {
  FitSummary summary = summary_of(data, (data.*fit)(), band_intensities);
  add_sentence(summary.note, data.note());
  summary.band.resize(band_intensities.size());
  return summary;
}

}  // namespace

FitSummary fit_stripes(const std::vector<Stripe>& rows, Independent independent,
                       const std::vector<double>& band_intensities) {
  return summarise(Records(rows, independent), &Records::fit, band_intensities);
}

FitSummary fit_stripes_jeffreys(const std::vector<Stripe>& rows, Independent independent) {
  return summarise(Records(rows, independent), &Records::fit_jeffreys);
}

FitSummary fit_brackets(const std::vector<Bracket>& rows, Independent independent,
                        const std::vector<double>& band_intensities) {
  return summarise(Records(rows, independent), &Records::fit, band_intensities);
}

double log_likelihood(const std::vector<Stripe>& rows, const FragilityCurve& curve) {
  return Records(rows, Independent::rows).log_likelihood(curve);
}

double log_likelihood(const std::vector<Bracket>& rows, const FragilityCurve& curve) {
  return Records(rows, Independent::rows).log_likelihood(curve);
}

std::string to_string(FitStatus status) {
  switch (status) {
    case FitStatus::failed:
      break;
    case FitStatus::maximum_likelihood:
      return "maximum likelihood";
    case FitStatus::extrapolated:
      return "extrapolated beyond the data";
    case FitStatus::jeffreys_penalised:
      return "Jeffreys penalised";
    case FitStatus::lower_bound:
      return "lower bound";
    case FitStatus::upper_bound:
      return "upper bound";
    case FitStatus::no_trend:
      return "no rise with intensity";
    case FitStatus::always_exceeds:
      return "exceeds at any intensity";
    case FitStatus::one_level:
      return "one level";
    case FitStatus::one_capacity:
      return "one capacity";
    case FitStatus::no_information:
      return "no information";
  }
  return "failed";
}

}  // namespace glissade
