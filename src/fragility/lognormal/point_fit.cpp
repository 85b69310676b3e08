// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/point_fit.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/finite.hpp"
#include "lognormal/line_region.hpp"
#include "lognormal/newton_maximum.hpp"

namespace glissade::fragility {
namespace {

/// Of one-sided bounds: a usual dispersion of sliding capacities.
constexpr double assumed_log_std = 0.4;

PointFit no_line(FitStatus status, const std::string& note) {
  return {status, ProbitLine::Zero(), note};
}

PointFit of_line(FitStatus status, const std::optional<ProbitLine>& line, double center) {
  if (!line) return no_line(FitStatus::failed, "no greatest likelihood was found");
  if (!((*line)[1] > 0))
    return no_line(FitStatus::no_trend, "the share of exceedances does not rise with intensity");
  if (!std::isnormal(to_curve(*line, center).median))
    return no_line(FitStatus::no_trend,
                   "the share of exceedances rises so little with intensity that it has no median");
  return {status, *line, ""};
}

/// Mean and standard deviation, with n - 1, of y.
PointFit of_sample(const ExactRows& sample) {
  const double mean = sample.sum / sample.count;
  const double variance = (sample.sum_squares - mean * sample.sum) / (sample.count - 1);
  if (sample.count < 2 || !(variance > 1e-24))
    return {FitStatus::one_capacity, ProbitLine(-mean, 1),
            "the capacities are equal: log_std and intervals cannot be determined"};
  return {FitStatus::maximum_likelihood, ProbitLine(-mean, 1) / std::sqrt(variance), ""};
}

}  // namespace

PointFit fit_point(const LogRows& rows, const ProbitLine& start) {
  switch (shape_of(rows)) {
    case RowsShape::empty:
      return no_line(FitStatus::failed, "there are no histories");
    case RowsShape::none_exceeded:
      return no_line(FitStatus::lower_bound, "");
    case RowsShape::all_exceeded:
      return no_line(FitStatus::upper_bound, "");
    case RowsShape::single_level:
      return no_line(FitStatus::one_level,
                     "only one intensity level has trials: log_std cannot be determined");
    case RowsShape::separated:
      return no_line(FitStatus::one_level,
                     "one intensity is in every bracket: log_std cannot be determined");
    case RowsShape::not_rising:
      return of_line(FitStatus::no_trend, ProbitLine(0, 0), 0);
    case RowsShape::exact:
      return of_sample(rows.exact);
    case RowsShape::overlapping:
      break;
  }
  const auto objective = [&](const ProbitLine& line) { return likelihood(rows, line); };
  return of_line(FitStatus::maximum_likelihood, newton_maximum(objective, start), rows.center);
}

namespace {

auto objective_of(const LogRows& counts) {
  return [&counts](const ProbitLine& line) { return jeffreys_likelihood(counts, line); };
}

/// Counts with the origin of y moved to `origin`.
LogRows moved(const LogRows& counts, double origin) {
  LogRows rows;
  rows.center = counts.center + origin;
  for (const auto& [y, cut] : counts.cuts) rows.add_counts(y - origin, cut.exceeding, cut.held);
  return rows;
}

/// Of counts that are separated at y = 0, where the penalised likelihood may have several maxima:
/// the best of slopes that double from that of all levels to that of the nearest.
ProbitLine guess_at_gap(const LogRows& counts) {
  const Interval range = counts.range();
  const double nearest = std::max(1e-12, std::min(-counts.highest_low(), counts.lowest_high()));
  ProbitLine best{0.0, 1.0 / std::max(-range.low, range.high)};
  double greatest = objective_of(counts)(best).value;
  for (double slope = 2.0 * best[1]; slope < 1.0 / nearest; slope *= 2) {
    const double value = objective_of(counts)({0.0, slope}).value;
    if (value > greatest) greatest = value, best = {0.0, slope};
  }
  return best;
}

}  // namespace

PointFit fit_jeffreys(const LogRows& counts) {
  const RowsShape shape = shape_of(counts);
  if (shape != RowsShape::overlapping && shape != RowsShape::separated)
    return fit_point(counts, first_guess(counts));
  if (shape == RowsShape::overlapping)
    return of_line(FitStatus::jeffreys_penalised,
                   newton_maximum(objective_of(counts), first_guess(counts)), counts.center);
  const double gap = 0.5 * (counts.highest_low() + counts.lowest_high());
  const LogRows about = moved(counts, gap);
  std::optional<ProbitLine> line = newton_maximum(objective_of(about), guess_at_gap(about));
  if (line) (*line)[0] -= (*line)[1] * gap;
  PointFit fit = of_line(FitStatus::jeffreys_penalised, line, counts.center);
  fit.note = "the stripes are separated by intensity: the likelihood alone has no finite maximum";
  return fit;
}

PointFit fit_counts(const LogRows& counts) {
  return shape_of(counts) == RowsShape::separated ? fit_jeffreys(counts)
                                                  : fit_point(counts, first_guess(counts));
}

ProbitLine first_guess(const LogRows& rows) {
  const Interval range = rows.range();
  if (rows.cuts.empty() && rows.exact.count == 0 && rows.between.empty()) return {0.0, 1.0};
  if (rows.has_only_cuts()) return {0.0, 2.0 / std::max(0.1, range.high - range.low)};
  ExactRows about = rows.exact;
  const auto add = [&](double y, double weight) {
    about.count += weight;
    about.sum += weight * y;
    about.sum_squares += weight * y * y;
  };
  for (const auto& [y, cut] : rows.cuts) add(y, cut.trials());
  for (const auto& [ends, weight] : rows.between) add(0.5 * (ends.first + ends.second), weight);
  const double count = std::max(1.0, about.count), mean = about.sum / count;
  const double log_std =
      std::max(0.1, std::sqrt(std::max(0.0, about.sum_squares / count - mean * mean)));
  return ProbitLine(-mean, 1) / log_std;
}

FitSummary summarise_bound(const LogRows& trials) {
  const bool none = std::isinf(trials.lowest_high());
  const auto log_probability = [&](const ProbitLine& line) {
    return likelihood(trials, line).value;
  };
  const double bound = median_bound(log_probability, assumed_log_std, trials.center);
  FitSummary summary;
  summary.status = none ? FitStatus::lower_bound : FitStatus::upper_bound;
  summary.curve = {bound, assumed_log_std};
  summary.median_interval = none ? Interval{bound, infinity} : Interval{0.0, bound};
  summary.p50_interval = summary.median_interval;
  summary.log_likelihood = log_probability(to_line(summary.curve, trials.center));
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
