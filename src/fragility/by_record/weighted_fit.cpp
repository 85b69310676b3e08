// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/weighted_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "by_record/clusters.hpp"
#include "by_record/line_draws.hpp"
#include "by_record/sandwich.hpp"
#include "lognormal/bracket_likelihood.hpp"
#include "lognormal/newton_maximum.hpp"
#include "lognormal/point_fit.hpp"
#include "lognormal/profile.hpp"

namespace glissade {
namespace fragility {

Clusters::Clusters(const std::vector<std::size_t>& records, const std::vector<double>& weights) {
  check_weights(weights);
  std::map<std::size_t, Eigen::Index> known;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (weights[i] == 0) {
      of_row_.push_back(-1);
      continue;
    }
    const auto [at, is_new] = known.emplace(records[i], static_cast<Eigen::Index>(known.size()));
    of_row_.push_back(at->second);
  }
  weight_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(known.size()));
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (of_row_[i] >= 0) weight_[of_row_[i]] += weights[i];
  }
}

double Clusters::effective() const { return effective_number(weight_); }

void check_weights(const std::vector<double>& weights) {
  double sum = 0;
  for (const double weight : weights) {
    if (!(weight >= 0 && std::isfinite(weight)))
      throw InputError(
          {"weights", std::to_string(weight) + " is not a weight", "give 0 or more", ""});
    sum += weight;
  }
  if (!weights.empty() && sum == 0)
    throw InputError({"weights", "all of them are 0", "give at least one above 0", ""});
}

namespace {

/// Curve and sandwich intervals of a line that maximises a weighted likelihood.
void add_line(const ProbitLine& line, double center, const Eigen::MatrixXd& scores,
              const Eigen::MatrixXd& information, const Clusters& clusters, FitSummary& summary) {
  summary.curve = to_curve(line, center);
  summary.effective_records = clusters.effective();
  if (clusters.count() < 2) {
    add_sentence(summary.note, "one record has weight: no interval");
    return;
  }
  const Eigen::MatrixXd covariance = cluster_sandwich(scores, information);
  const Eigen::Vector2d of_median{-1 / line[1], line[0] / (line[1] * line[1])};
  const double median_error = std::sqrt(std::max(0.0, of_median.dot(covariance * of_median)));
  const Interval log_median =
      t_interval(std::log(summary.curve.median), median_error, clusters.effective());
  summary.median_interval =
      summary.p50_interval = {std::exp(log_median.low), std::exp(log_median.high)};
  const LineDraws lines = draw_lines({line, covariance.topLeftCorner<2, 2>(),
                                      information.topLeftCorner<2, 2>().inverse(),
                                      std::max(2.0, clusters.effective())});
  summary.log_std_interval = interval_over(
      lines.families(), [](const ProbitLine& drawn) { return 1.0 / drawn[1]; }, 0.025);
  summary.interval_method = "variance between records (sandwich; Student t, chi-square)";
  if (clusters.effective() < 5)
    add_sentence(summary.note,
                 "the weight is that of fewer than five records: the intervals are too short");
}

std::vector<LogBracket> in_logs(const std::vector<CapacityBracket>& rows, double& center) {
  double sum = 0, ends = 0;
  for (const CapacityBracket& row : rows) {
    for (const double end : {row.low, row.high}) {
      if (!(end > 0 && std::isfinite(end))) continue;
      sum += std::log(end);
      ++ends;
    }
  }
  center = ends > 0 ? sum / ends : 0;
  std::vector<LogBracket> brackets;
  for (const CapacityBracket& row : rows)
    brackets.push_back({std::log(row.low) - center, std::log(row.high) - center});
  return brackets;
}

/// The rows that have weight and limit the capacity, in logarithms.
struct WeighedBrackets {
  std::vector<CapacityBracket> rows;
  std::vector<LogBracket> brackets;
  double center = 0, highest_low = 0, lowest_high = std::numeric_limits<double>::infinity();
  std::size_t without_limit = 0;

  WeighedBrackets(const std::vector<CapacityBracket>& all, bool independent) {
    std::vector<double> weights;
    for (const CapacityBracket& row : all) weights.push_back(row.weight);
    check_weights(weights);
    for (const CapacityBracket& row : all) {
      if (row.weight == 0) continue;
      if (row.low == 0 && std::isinf(row.high)) {
        ++without_limit;
        continue;
      }
      rows.push_back(row);
      if (independent) rows.back().record = rows.size();
      highest_low = std::max(highest_low, row.low);
      lowest_high = std::min(lowest_high, row.high);
    }
    brackets = in_logs(rows, center);
  }
  std::string note() const {
    return without_limit == 0 ? ""
                              : std::to_string(without_limit) +
                                    " row(s) from 0 to infinity say nothing and are left out";
  }
  Clusters clusters() const {
    std::vector<std::size_t> records;
    std::vector<double> weights;
    for (const CapacityBracket& row : rows) {
      records.push_back(row.record);
      weights.push_back(row.weight);
    }
    return {records, weights};
  }
  Evaluation likelihood(const ProbitLine& line) const {
    Evaluation sum;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Evaluation one = bracket_likelihood(brackets[i], line);
      sum.value += rows[i].weight * one.value;
      sum.gradient += rows[i].weight * one.gradient;
      sum.information += rows[i].weight * one.information;
    }
    return sum;
  }
  Eigen::MatrixXd scores(const ProbitLine& line, const Clusters& clusters) const {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(clusters.count(), 2);
    for (std::size_t i = 0; i < rows.size(); ++i)
      sums.row(clusters.of(i)) +=
          rows[i].weight * bracket_likelihood(brackets[i], line).gradient.transpose();
    return sums;
  }
  /// From densities of ln x to those of x.
  double log_of_exact() const {
    double sum = 0;
    for (const CapacityBracket& row : rows) {
      if (row.low == row.high) sum += row.weight * std::log(row.low);
    }
    return sum;
  }
};

void check(const std::vector<CapacityBracket>& rows) {
  ProblemList problems;
  for (const CapacityBracket& row : rows) {
    if (row.low >= 0 && row.high > 0 && row.low <= row.high && std::isfinite(row.low)) continue;
    problems.add({"brackets",
                  std::to_string(row.low) + " to " + std::to_string(row.high) +
                      " is no range of intensities",
                  "give 0 <= low <= high, high above 0", ""});
  }
  problems.throw_if_any();
}

/// None or all of the histories reached it, each record one trial.
FitSummary bound_of(const std::vector<CapacityBracket>& rows, bool reached) {
  std::map<std::size_t, double> limit;  // by record, the one that says most
  for (const CapacityBracket& row : rows) {
    const double end = reached ? row.high : row.low;
    const auto [at, is_new] = limit.emplace(row.record, end);
    if (!is_new) at->second = reached ? std::min(at->second, end) : std::max(at->second, end);
  }
  std::vector<Stripe> stripes;
  for (const auto& [record, end] : limit) stripes.push_back({end, 1.0, reached ? 1.0 : 0.0});
  return summarise_bound(to_data(stripes));
}

/// Each record one trial at each level.
StripeData one_trial_by_record(const std::vector<WeightedStripe>& rows) {
  std::map<std::pair<double, std::size_t>, double> reached;
  for (const WeightedStripe& row : rows) {
    if (row.weight * row.stripe.trials == 0) continue;
    double& any = reached[{row.stripe.intensity, row.record}];
    any = std::max(any, row.stripe.exceedances > 0 ? 1.0 : 0.0);
  }
  std::vector<Stripe> stripes;
  for (const auto& [key, any] : reached) stripes.push_back({key.first, 1.0, any});
  return to_data(stripes);
}

ProbitLine guess(const std::vector<LogBracket>& brackets) {
  double n = 0, sum = 0, squares = 0;
  for (const LogBracket& b : brackets) {
    const double y = std::isinf(b.low)    ? b.high
                     : std::isinf(b.high) ? b.low
                                          : 0.5 * (b.low + b.high);
    ++n;
    sum += y;
    squares += y * y;
  }
  const double mean = sum / n;
  return ProbitLine(-mean, 1) / std::max(0.1, std::sqrt(std::max(0.0, squares / n - mean * mean)));
}

FitSummary fit_of(const WeighedBrackets& data, bool independent) {
  FitSummary summary;
  if (data.rows.empty()) {
    if (data.without_limit > 0) summary.status = FitStatus::no_information;
    summary.note =
        data.without_limit > 0 ? "no row limits the capacity" : "there are no capacities";
    return summary;
  }
  if (std::isinf(data.lowest_high)) return bound_of(data.rows, false);
  if (data.highest_low == 0) return bound_of(data.rows, true);
  if (data.highest_low <= data.lowest_high) {
    const bool exact = std::ranges::all_of(
        data.rows, [](const CapacityBracket& row) { return row.low == row.high; });
    summary.status = exact ? FitStatus::one_capacity : FitStatus::one_level;
    if (exact) summary.curve.median = data.rows.front().low;
    summary.note = exact ? "one capacity: log_std cannot be determined"
                         : "one intensity is in every bracket: log_std cannot be determined";
    return summary;
  }
  const auto objective = [&](const ProbitLine& line) { return data.likelihood(line); };
  const auto line = newton_maximum(objective, guess(data.brackets));
  if (!line || !((*line)[1] > 0)) {
    summary.status = line ? FitStatus::no_trend : FitStatus::failed;
    summary.note =
        line ? "the brackets do not rise with intensity" : "no greatest likelihood was found";
    return summary;
  }
  summary.status = FitStatus::maximum_likelihood;
  summary.method = "lognormal maximum likelihood on brackets of the capacity";
  const Evaluation at = objective(*line);
  summary.log_likelihood = at.value - data.log_of_exact();
  if (!independent) {
    const Clusters clusters = data.clusters();
    add_line(*line, data.center, data.scores(*line, clusters), at.information, clusters, summary);
    return summary;
  }
  summary.curve = to_curve(*line, data.center);
  const ProfileIntervals intervals = profile_intervals(
      [&](const ProbitLine& other) { return objective(other).value; }, *line, data.center);
  summary.median_interval = summary.p50_interval = intervals.median;
  summary.log_std_interval = intervals.log_std;
  summary.interval_method = "profile likelihood";
  return summary;
}

}  // namespace
}  // namespace fragility

using namespace fragility;

FitSummary fit_weighted_stripes(const std::vector<WeightedStripe>& rows) {
  std::vector<Stripe> stripes;
  std::vector<std::size_t> records;
  std::vector<double> weights;
  for (const WeightedStripe& row : rows) {
    stripes.push_back(row.stripe);
    records.push_back(row.record);
    weights.push_back(row.weight * row.stripe.trials);
  }
  check(stripes, "stripes");
  const Clusters clusters(records, weights);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    stripes[i].trials *= rows[i].weight;
    stripes[i].exceedances *= rows[i].weight;
  }
  const StripeData data = to_data(stripes);
  const PointFit point = fit_point(data, first_guess(data));
  if (point.is_bound()) return summarise_bound(one_trial_by_record(rows));
  FitSummary summary;
  summary.status = point.status;
  summary.note = point.note;
  if (!summary.converged()) return summary;
  summary.method = to_string(point.status) + " of weighted stripes";
  if (point.status == FitStatus::jeffreys_penalised) {
    summary.curve = to_curve(point.line, data.center);
    summary.note = note_on_separation;
    return summary;
  }
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(clusters.count(), 2);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    StripeData one = to_data({stripes[i]});
    one.y += one.center - data.center;
    if (clusters.has(i))
      scores.row(clusters.of(i)) += stripe_likelihood(one, point.line).gradient.transpose();
  }
  const Evaluation at = stripe_likelihood(data, point.line);
  add_line(point.line, data.center, scores, at.information, clusters, summary);
  summary.log_likelihood = at.value;
  return summary;
}

FitSummary fit_brackets(const std::vector<CapacityBracket>& all, bool independent) {
  check(all);
  const WeighedBrackets data(all, independent);
  FitSummary summary = fit_of(data, independent);
  add_sentence(summary.note, data.note());
  return summary;
}

}  // namespace glissade
