// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "by_record/check.hpp"
#include "by_record/intervals.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade::fragility {
namespace {

/// So narrow a bracket is a capacity, its lower end: a probability within it is lost in rounding.
bool is_exact(const Bracket& row) { return row.low > 0 && row.high < (1 + 1e-5) * row.low; }

bool says_nothing(const Bracket& row) { return row.low == 0 && std::isinf(row.high); }

/// The mean of ln x, of capacities that are known exactly if there are any.
double center_of(const std::vector<Bracket>& rows) {
  const double unit = largest_weight(rows);
  double weight = 0, sum = 0;
  std::vector<double> ends;
  for (const Bracket& row : rows) {
    if (is_exact(row)) {
      weight += row.weight / unit;
      sum += row.weight / unit * std::log(row.low);
    }
    for (const double end : {row.low, row.high})
      if (row.weight > 0 && end > 0 && std::isfinite(end)) ends.push_back(end);
  }
  return weight > 0 ? sum / weight : mean_log(ends);
}

double center_of(const std::vector<Stripe>& rows) {
  std::set<double> levels;
  for (const Stripe& row : rows)
    if (row.intensity > 0 && row.weight * row.trials > 0) levels.insert(row.intensity);
  return mean_log({levels.begin(), levels.end()});
}

/// A history has one capacity: whether it exceeds at two levels has the covariance Phi(z_low)
/// Phi(-z_high). Of two levels of a record the smaller number of histories is common: it is summed
/// over the steps of their number, so that the time is linear in the levels.
Eigen::Matrix2d score_variance_of(const std::map<double, CutWeight>& cuts, const ProbitLine& line) {
  struct Level {
    double trials, above;      // the latter phi/Phi(z)
    Eigen::Vector2d x, below;  // the latter phi/Phi(-z) x
  };
  std::vector<Level> levels;
  std::set<double> numbers;
  for (const auto& [y, cut] : cuts) {
    const Eigen::Vector2d x{1, y};
    const double z = line.dot(x);
    levels.push_back({cut.trials(), hazard(z), x, hazard(-z) * x});
    numbers.insert(cut.trials());
  }
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  double before = 0;
  for (const double number : numbers) {
    Eigen::Matrix2d common = Eigen::Matrix2d::Zero();
    Eigen::Vector2d lower = Eigen::Vector2d::Zero();
    for (const Level& level : levels) {
      if (level.trials < number) continue;
      const Eigen::Matrix2d with_lower = level.above * lower * level.x.transpose();
      common +=
          level.above * level.below * level.x.transpose() + with_lower + with_lower.transpose();
      lower += level.below;
    }
    sum += (number - before) * common;
    before = number;
  }
  return sum;
}

/// (sum k)^2 / sum k^2; 0 where all are 0.
double contributions(const Eigen::ArrayXd& k) {
  return k.sum() > 0 ? effective_number(k.matrix()) : 0;
}

}  // namespace

Records::Records(const std::vector<Stripe>& rows, Independent independent)
    : counts_(true), rows_are_independent_(independent == Independent::rows) {
  check(rows);
  pooled_.center = center_of(rows);
  const double unit = largest_weight(rows);
  double weight = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Stripe row = rows[i];
    row.weight /= unit;
    if (row.weight * row.trials == 0) continue;
    if (weight == 0) weight = row.weight;
    equal_weights_ = equal_weights_ && row.weight == weight;
    Record& record = records_[rows_are_independent_ ? i : row.record];
    if (row.intensity == 0) {
      record.free += row.weight * row.trials;
      continue;
    }
    const double y = std::log(row.intensity) - pooled_.center;
    for (LogRows* sums : {&record.rows, &pooled_})
      sums->add_counts(y, row.weight * row.exceedances,
                       row.weight * (row.trials - row.exceedances));
    // The same histories are at every level.
    const CutWeight& cut = record.rows.cuts[y];
    record.histories = std::max(record.histories, cut.trials());
    record.squares = std::max(record.squares, row.weight * cut.trials());
    record.exceed = std::max(record.exceed, cut.exceeding);
    record.held = std::max(record.held, cut.held);
  }
  take_weights();
}

Records::Records(const std::vector<Bracket>& rows, Independent independent)
    : counts_(false), rows_are_independent_(independent == Independent::rows) {
  check(rows);
  pooled_.center = center_of(rows);
  const auto in_logs = [&](double x) { return std::log(x) - pooled_.center; };
  const double unit = largest_weight(rows);
  double weight = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Bracket row = rows[i];
    row.weight /= unit;
    if (row.weight == 0) continue;
    if (says_nothing(row)) {
      ++without_limit_;
      continue;
    }
    if (weight == 0) weight = row.weight;
    equal_weights_ = equal_weights_ && row.weight == weight;
    Record& record = records_[rows_are_independent_ ? i : row.record];
    if (row.high == 0) {
      record.free += row.weight;
      continue;
    }
    rows_.push_back({in_logs(row.low), in_logs(is_exact(row) ? row.low : row.high), row.weight});
    for (LogRows* sums : {&record.rows, &pooled_})
      sums->add_bracket(rows_.back().low, rows_.back().high, row.weight);
    record.histories += row.weight;
    record.squares += row.weight * row.weight;
    if (std::isfinite(row.high)) record.exceed += row.weight;
    if (row.low > 0) record.held += row.weight;
  }
  take_weights();
}

void Records::take_weights() {
  double sum = 0, squares = 0, record_squares = 0, fourths = 0;
  for (const auto& [name, record] : records_) {
    sum += record.histories;
    squares += record.squares;
    record_squares += record.histories * record.histories;
    fourths += std::pow(record.histories, 4);
  }
  if (sum > 0)
    worth_ = {sum * (sum / squares), sum * (sum / record_squares), sum / squares,
              record_squares * (record_squares / fourths) - 1};
  if (counts_ && rows_are_independent_)
    worth_.records = worth_.rows, worth_.freedom = worth_.rows - 1;
  const double scale = worth_.scale;
  pooled_.scale(scale);
  for (auto& [name, record] : records_) {
    record.rows.scale(scale);
    for (double* of : {&record.free, &record.histories, &record.exceed, &record.held}) *of *= scale;
    record.squares *= scale * scale;
  }
  for (Bracket& row : rows_) row.weight *= scale;
}

Eigen::ArrayXd Records::by_record(double Record::*value) const {
  Eigen::ArrayXd values(count());
  Eigen::Index i = 0;
  for (const auto& [name, record] : records_) values[i++] = record.*value;
  return values;
}

bool Records::has_gaps() const {
  return counts_ && std::ranges::any_of(records_, [&](const auto& at) {
           return at.second.rows.cuts.size() < pooled_.cuts.size();
         });
}

bool Records::independent_counts() const {
  if (!counts_ || rows_are_independent_) return counts_;
  double trials = 0;
  for (const auto& [y, cut] : pooled_.cuts) trials += cut.trials();
  return one_row_each() && equal_weights_ && trials < (1 + 1e-9) * worth_.rows;
}

double Records::contributing(bool exceed) const {
  return contributions(by_record(exceed ? &Record::exceed : &Record::held));
}

Eigen::ArrayXd Records::parts_of_weight() const {
  const Eigen::ArrayXd weights = by_record(&Record::histories);
  return weights / weights.sum();
}

double Records::floor() const {
  const double free = by_record(&Record::free).sum();
  return free > 0 ? free / (free + by_record(&Record::histories).sum()) : 0;
}

Interval Records::floor_interval() const {
  const Eigen::ArrayXd free = by_record(&Record::free), all = free + by_record(&Record::histories);
  if (free.sum() > 0 && one_row_each())
    return {binomial_lower_end(all.sum(), free.sum(), 0.025),
            binomial_upper_end(all.sum(), free.sum(), 0.025)};
  std::vector<double> shares;
  for (Eigen::Index i = 0; i < count(); ++i) shares.push_back(free[i] > 0 ? free[i] / all[i] : 0.0);
  const bool varies = std::ranges::any_of(
      shares, [&](double share) { return std::abs(share - shares.front()) > 1e-12; });
  return varies ? share_interval(shares) : Interval{};
}

PointFit Records::fit() const {
  if (records_.empty() && without_limit_ > 0)
    return {FitStatus::no_information, ProbitLine::Zero(), "no row limits the capacity"};
  return counts_ && shape_of(pooled_) == RowsShape::separated
             ? fit_jeffreys()
             : fit_point(pooled_, first_guess(pooled_));
}

PointFit Records::fit_jeffreys() const { return fragility::fit_jeffreys(one_each()); }

/// Counts of as many trials as records are worth at the levels.
LogRows Records::one_each() const {
  LogRows one_each = pooled_;
  if (independent_counts() || pooled_.cuts.empty()) return one_each;
  std::map<double, double> squares;
  for (const auto& [name, record] : records_)
    for (const auto& [y, cut] : record.rows.cuts) squares[y] += cut.trials() * cut.trials();
  double trials = 0, each = 0;
  for (const auto& [y, cut] : pooled_.cuts) {
    trials += cut.trials();
    each += cut.trials() * (cut.trials() / squares[y]);
  }
  one_each.scale(each / trials);
  return one_each;
}

Records::Scores Records::scores(const ProbitLine& line) const {
  Scores result(count(), 2);
  Eigen::Index i = 0;
  for (const auto& [name, record] : records_)
    result.row(i++) = likelihood(record.rows, line).gradient.transpose();
  return result;
}

Eigen::Matrix2d Records::score_variance(const ProbitLine& line) const {
  if (counts_) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const auto& [name, record] : records_)
      if (record.histories > 0)
        sum += record.squares / record.histories * score_variance_of(record.rows.cuts, line);
    return sum;
  }
  // The information, but for weights that differ: these may belong to large scores.
  const Eigen::Matrix2d information = likelihood(pooled_, line).information;
  if (equal_weights_) return information;
  Eigen::Matrix2d plain = Eigen::Matrix2d::Zero(), weighted = plain;
  for (const Bracket& row : rows_) {
    LogRows one;
    one.add_bracket(row.low, row.high, 1.0);
    const Eigen::Vector2d score = likelihood(one, line).gradient;
    const double rest = 1 - row.weight / worth_.rows, part = row.weight / rest;
    plain += row.weight * score * score.transpose();
    weighted += part * part * score * score.transpose();
  }
  const Eigen::Matrix2d root = information.llt().matrixL(), root_plain = plain.llt().matrixL(),
                        to = root * root_plain.inverse();
  return to * weighted * to.transpose();
}

double Records::log_likelihood(const FragilityCurve& curve) const {
  double value = likelihood(pooled_, to_line(curve, pooled_.center)).value;
  if (!counts_)
    return value - pooled_.exact.sum -
           pooled_.exact.count * (pooled_.center + 0.5 * std::log(2 * std::numbers::pi));
  for (const auto& [y, cut] : pooled_.cuts)
    value += log_gamma(cut.trials() + 1) - log_gamma(cut.exceeding + 1) - log_gamma(cut.held + 1);
  return value;
}

/// Of counts a trial at each level, of brackets the limit of each record that says most.
FitSummary Records::bound() const {
  const bool reached = std::isinf(pooled_.highest_low());
  const bool as_counted = counts_ ? independent_counts() : one_row_each();
  const double each = worth_.records / static_cast<double>(count());
  LogRows limits;
  limits.center = pooled_.center;
  const auto add = [&](const auto& at) {
    const double n = as_counted ? at.second.trials() : each;
    limits.add_counts(at.first, reached ? n : 0.0, reached ? 0.0 : n);
  };
  for (const auto& [name, record] : records_) {
    const std::map<double, CutWeight>& cuts = record.rows.cuts;
    if (cuts.empty()) continue;
    if (counts_) std::ranges::for_each(cuts, add);
    if (!counts_) add(reached ? *cuts.begin() : *cuts.rbegin());
  }
  return summarise_bound(limits);
}

std::string Records::method() const {
  if (counts_) return "probit maximum likelihood on stripes";
  if (pooled_.is_exact()) return "lognormal sample of capacities (n - 1)";
  const bool censored =
      pooled_.between.empty() &&
      std::ranges::all_of(pooled_.cuts, [](const auto& at) { return at.second.exceeding == 0; });
  return censored ? "lognormal maximum likelihood on right-censored capacities"
                  : "lognormal maximum likelihood on brackets of the capacity";
}

std::string Records::note() const {
  return without_limit_ == 0 ? ""
                             : std::to_string(without_limit_) +
                                   " row(s) from 0 to infinity say nothing and are left out";
}

}  // namespace glissade::fragility
