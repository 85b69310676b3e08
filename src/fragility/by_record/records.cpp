// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/records.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>

#include "by_record/clusters.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade::fragility {
namespace {

std::vector<Stripe> stripes_of(const std::vector<double>& intensities,
                               const RecordStripes& record) {
  std::vector<Stripe> stripes;
  for (std::size_t j = 0; j < intensities.size(); ++j) {
    stripes.push_back({intensities[j], record.trials[j], record.exceedances[j]});
  }
  return stripes;
}

/// Throws the problems of all records together. @param check_one of a record, by its number and
/// name
void check_each(std::size_t records,
                const std::function<void(std::size_t, const std::string&)>& check_one) {
  ProblemList problems;
  if (records == 0) problems.add({"records", "there are none", "give at least one record", ""});
  for (std::size_t i = 0; i < records; ++i) {
    try {
      check_one(i, "record " + std::to_string(i + 1));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
}

void check_stripes(const std::vector<double>& intensities, const RecordStripes& record,
                   const std::string& name) {
  if (record.trials.size() != intensities.size() || record.exceedances.size() != intensities.size())
    throw InputError({name,
                      std::to_string(record.trials.size()) + " trials and " +
                          std::to_string(record.exceedances.size()) + " exceedances for " +
                          std::to_string(intensities.size()) + " intensities",
                      "give both per intensity", ""});
  check(CapacitySample{.free = record.free}, name);
  check(stripes_of(intensities, record), name);
}

void check_rows(const std::vector<CapacityBracket>& rows) {
  ProblemList problems;
  std::vector<double> weights;
  for (const CapacityBracket& row : rows) {
    weights.push_back(row.weight);
    if (row.low >= 0 && row.low <= row.high && std::isfinite(row.low)) continue;
    problems.add({"brackets",
                  std::to_string(row.low) + " to " + std::to_string(row.high) +
                      " is no range of intensities",
                  "give 0 <= low <= high", ""});
  }
  problems.throw_if_any();
  check_weights(weights);
}

/// Counts are a table of records by intensities, however few of its places have any.
void check_table(std::size_t records, std::size_t intensities) {
  constexpr std::size_t most = 10'000'000;
  if (records <= most / std::max<std::size_t>(1, intensities)) return;
  throw InputError({"counts",
                    std::to_string(records) + " records at " + std::to_string(intensities) +
                        " intensities are more than ten million places",
                    "give the counts at the levels of the analysis, which the records share, or "
                    "each history as a row of --capacities or --cloud",
                    ""});
}

/// (sum k)^2 / sum k^2; 0 where all are 0.
double contributions(const std::vector<double>& of) {
  const Eigen::Map<const Eigen::VectorXd> k(of.data(), static_cast<Eigen::Index>(of.size()));
  return k.sum() > 0 ? k.sum() * k.sum() / k.squaredNorm() : 0;
}

}  // namespace

Worth worth_of(const std::vector<RecordWeight>& records) {
  double sum = 0, squares = 0, record_squares = 0, fourths = 0;
  for (const RecordWeight& record : records) {
    sum += record.sum;
    squares += record.squares;
    record_squares += record.sum * record.sum;
    fourths += std::pow(record.sum, 4);
  }
  if (sum == 0) return {};
  return {sum * (sum / squares), sum * (sum / record_squares), sum / squares,
          record_squares * (record_squares / fourths) - 1};
}

double Records::contributing(bool exceed) const { return contributions(exceed ? exceed_ : held_); }

Eigen::ArrayXd Records::parts_of_weight() const {
  const Eigen::Map<const Eigen::ArrayXd> weights(histories_.data(), count());
  return weights / weights.sum();
}

double Records::floor() const {
  const double free = std::accumulate(free_.begin(), free_.end(), 0.0);
  return free > 0 ? free / std::accumulate(histories_.begin(), histories_.end(), free) : 0;
}

Interval Records::floor_interval() const {
  const double free = std::accumulate(free_.begin(), free_.end(), 0.0);
  const double all = std::accumulate(histories_.begin(), histories_.end(), free);
  if (free > 0 && one_row_each())
    return {binomial_lower_end(all, free, 0.025), binomial_upper_end(all, free, 0.025)};
  std::vector<double> shares;
  for (std::size_t i = 0; i < free_.size(); ++i)
    shares.push_back(free_[i] > 0 ? free_[i] / (free_[i] + histories_[i]) : 0.0);
  const bool varies = std::ranges::any_of(
      shares, [&](double share) { return std::abs(share - shares.front()) > 1e-12; });
  return varies ? share_interval(shares) : Interval{};
}

StripeRecords::StripeRecords(const std::vector<Stripe>& stripes) {
  check(stripes, "stripes");
  std::vector<double> intensities;
  trials_.resize(1, static_cast<Eigen::Index>(stripes.size()));
  exceedances_ = trials_;
  for (const Stripe& stripe : stripes) {
    const auto j = static_cast<Eigen::Index>(intensities.size());
    intensities.push_back(stripe.intensity);
    trials_(0, j) = stripe.trials;
    exceedances_(0, j) = stripe.exceedances;
  }
  free_ = {0.0};
  finish(intensities, {});
}

StripeRecords::StripeRecords(const std::vector<WeightedStripe>& rows) {
  std::vector<Stripe> stripes;
  std::vector<double> weights;
  std::map<double, Eigen::Index> levels;
  std::map<std::size_t, Eigen::Index> records;
  for (const WeightedStripe& row : rows) {
    stripes.push_back(row.stripe);
    weights.push_back(row.weight * row.stripe.trials);
    if (weights.back() == 0) continue;
    levels.emplace(row.stripe.intensity, 0);
    records.emplace(row.record, static_cast<Eigen::Index>(records.size()));
  }
  check(stripes, "stripes");
  check_weights(weights);
  check_table(records.size(), levels.size());
  std::vector<double> intensities;
  for (auto& [intensity, j] : levels) {
    j = static_cast<Eigen::Index>(intensities.size());
    intensities.push_back(intensity);
  }
  trials_ = exceedances_ = Eigen::MatrixXd::Zero(std::ssize(records), std::ssize(levels));
  std::vector<RecordWeight> of(records.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (weights[i] == 0) continue;
    const WeightedStripe& row = rows[i];
    const Eigen::Index r = records.at(row.record), j = levels.at(row.stripe.intensity);
    trials_(r, j) += weights[i];
    exceedances_(r, j) += row.weight * row.stripe.exceedances;
    RecordWeight& record = of[static_cast<std::size_t>(r)];
    record.sum = std::max(record.sum, trials_(r, j));
    record.squares = std::max(record.squares, row.weight * trials_(r, j));
    equal_weights_ = equal_weights_ && row.weight == rows.front().weight;
  }
  free_.assign(records.size(), 0.0);
  finish(intensities, of);
}

StripeRecords::StripeRecords(const std::vector<double>& intensities,
                             const std::vector<RecordStripes>& records) {
  check_each(records.size(), [&](std::size_t i, const std::string& name) {
    check_stripes(intensities, records[i], name);
  });
  trials_.resize(std::ssize(records), std::ssize(intensities));
  exceedances_ = trials_;
  std::vector<RecordWeight> weights;
  for (const RecordStripes& record : records) {
    const Eigen::Index i = std::ssize(weights), columns = trials_.cols();
    exceedances_.row(i) = Eigen::Map<const Eigen::RowVectorXd>(record.exceedances.data(), columns);
    trials_.row(i) = Eigen::Map<const Eigen::RowVectorXd>(record.trials.data(), columns);
    const double histories = columns > 0 ? trials_.row(i).maxCoeff() : 0.0;
    weights.push_back({histories, histories});
    free_.push_back(record.free);
  }
  finish(intensities, weights);
}

/// @param weights none: all trials are independent
void StripeRecords::finish(const std::vector<double>& intensities,
                           const std::vector<RecordWeight>& weights) {
  worth_ = worth_of(weights);
  if (weights.empty()) worth_ = {trials_.sum(), trials_.sum(), 1.0, trials_.sum() - 1};
  trials_ *= worth_.scale;
  exceedances_ *= worth_.scale;
  row_weight_ = Eigen::VectorXd::Ones(trials_.rows());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double sum = worth_.scale * weights[i].sum;
    histories_.push_back(sum);
    if (sum > 0)
      row_weight_[std::ssize(histories_) - 1] =
          worth_.scale * worth_.scale * weights[i].squares / sum;
  }
  if (weights.empty()) histories_ = {trials_.sum()};
  independent_ = weights.empty() ||
                 (one_row_each() && equal_weights_ && trials_.sum() < (1 + 1e-9) * worth_.rows);
  std::vector<Stripe> stripes;
  double trials = 0, each = 0;
  for (Eigen::Index j = 0; j < trials_.cols(); ++j) {
    stripes.push_back({intensities[static_cast<std::size_t>(j)], trials_.col(j).sum(),
                       exceedances_.col(j).sum()});
    if (!(stripes.back().trials > 0)) continue;
    trials += stripes.back().trials;
    each += trials_.col(j).sum() * (trials_.col(j).sum() / trials_.col(j).squaredNorm());
  }
  pooled_ = one_each_ = to_data(stripes);
  center_ = pooled_.center;
  lowest_ = infinity, highest_ = -infinity;
  for (Eigen::Index j = 0; j < trials_.cols(); ++j) {
    if (!(pooled_.trials[j] > 0)) continue;
    lowest_ = std::min(lowest_, pooled_.y[j]);
    highest_ = std::max(highest_, pooled_.y[j]);
  }
  if (!independent_ && trials > 0) {
    one_each_.trials *= each / trials;
    one_each_.exceedances *= each / trials;
  }
  if (trials_.cols() == 0) return;
  const Eigen::VectorXd exceed = exceedances_.rowwise().maxCoeff(),
                        held = (trials_ - exceedances_).rowwise().maxCoeff();
  exceed_.assign(exceed.begin(), exceed.end());
  held_.assign(held.begin(), held.end());
}

PointFit StripeRecords::fit() const {
  return shape_of(pooled_) == StripeShape::overlapping ? fit_point(pooled_, first_guess())
                                                       : fit_jeffreys();
}

PointFit StripeRecords::fit_jeffreys() const {
  PointFit point = fit_point_jeffreys(one_each_, first_guess());
  if (shape_of(pooled_) == StripeShape::separated)
    point.note =
        "the stripes are separated by intensity: the likelihood alone has no finite maximum";
  return point;
}

Records::Scores StripeRecords::scores(const ProbitLine& line) const {
  // d/dz of ln Phi(z) and ln Phi(-z), once per level: a score is the sum of k hazard_above - (n -
  // k) hazard_below.
  Eigen::VectorXd above(pooled_.y.size()), below(pooled_.y.size());
  for (Eigen::Index j = 0; j < pooled_.y.size(); ++j) {
    const double z = line[0] + line[1] * pooled_.y[j];
    above[j] = hazard(z);
    below[j] = hazard(-z);
  }
  Eigen::MatrixX2d design(pooled_.y.size(), 2);
  design << Eigen::VectorXd::Ones(pooled_.y.size()), pooled_.y.matrix();
  return exceedances_ * above.asDiagonal() * design -
         (trials_ - exceedances_) * below.asDiagonal() * design;
}

/// A history has one capacity: whether it exceeds at two levels has the covariance Phi(z_low)
/// Phi(-z_high); independent counts have none. Of two levels of a record the smaller number of
/// histories is common: it is summed over the steps of their number, so that the time is linear in
/// the levels.
Eigen::Matrix2d StripeRecords::score_variance(const ProbitLine& line) const {
  struct Level {
    Eigen::Vector2d x, below;  // the latter phi/Phi(-z) x
    double above = 0;          // phi/Phi(z)
    Eigen::Index column = 0;
  };
  std::vector<Level> levels;
  for (Eigen::Index j = 0; j < pooled_.y.size(); ++j) {
    const Eigen::Vector2d x{1, pooled_.y[j]};
    levels.push_back({x, hazard(-line.dot(x)) * x, hazard(line.dot(x)), j});
  }
  std::ranges::sort(levels, {}, [](const Level& level) { return level.x[1]; });
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  if (independent_) {
    for (const Level& level : levels)
      sum += pooled_.trials[level.column] * level.above * level.below * level.x.transpose();
    return sum;
  }
  for (Eigen::Index r = 0; r < trials_.rows(); ++r) {
    const auto trials = trials_.row(r);
    double before = 0;
    for (const double number : std::set<double>(trials.begin(), trials.end())) {
      Eigen::Matrix2d common = Eigen::Matrix2d::Zero();
      Eigen::Vector2d lower = Eigen::Vector2d::Zero();
      for (const Level& level : levels) {
        if (!(trials[level.column] >= number)) continue;
        const Eigen::Matrix2d with_lower = level.above * lower * level.x.transpose();
        common +=
            level.above * level.below * level.x.transpose() + with_lower + with_lower.transpose();
        lower += level.below;
      }
      sum += row_weight_[r] * (number - before) * common;
      before = number;
    }
  }
  return sum;
}

double StripeRecords::log_likelihood(const FragilityCurve& curve) const {
  std::vector<Stripe> stripes;
  for (Eigen::Index j = 0; j < pooled_.y.size(); ++j) {
    stripes.push_back(
        {std::exp(pooled_.y[j] + pooled_.center), pooled_.trials[j], pooled_.exceedances[j]});
  }
  return stripe_log_likelihood(stripes, curve);
}

FitSummary StripeRecords::bound() const {
  StripeData one_trial_each = pooled_;
  if (independent_) return summarise_bound(one_trial_each);
  const double worth = worth_.records / static_cast<double>(count());
  one_trial_each.trials = worth * (trials_.array() > 0).cast<double>().colwise().sum().transpose();
  one_trial_each.exceedances =
      worth * (exceedances_.array() > 0).cast<double>().colwise().sum().transpose();
  return summarise_bound(one_trial_each);
}

BracketRecords::BracketRecords(const std::vector<CapacityBracket>& all, bool independent) {
  check_rows(all);
  std::vector<Row> rows;
  std::map<std::size_t, std::size_t> records;
  for (const CapacityBracket& row : all) {
    if (row.weight == 0) continue;
    if (row.low == 0 && std::isinf(row.high)) {
      ++without_limit_;
      continue;
    }
    const std::size_t record = independent ? rows.size() : row.record;
    const auto [at, is_new] = records.emplace(record, records.size());
    // So narrow a bracket is a capacity, its lower end: a probability within it is lost in
    // rounding.
    const bool is_exact = row.low > 0 && row.high < (1 + 1e-5) * row.low;
    rows.push_back(
        {row.low, is_exact ? row.low : row.high, row.weight, row.weight * row.weight, at->second});
    equal_weights_ = equal_weights_ && row.weight == rows.front().weight;
  }
  finish(std::move(rows), records.size());
}

BracketRecords::BracketRecords(const std::vector<RecordCapacities>& records, double censored_at) {
  check_each(records.size(), [&](std::size_t i, const std::string& name) {
    const RecordCapacities& record = records[i];
    check(CapacitySample{record.capacities, record.censored, censored_at, record.free}, name);
  });
  std::vector<Row> rows;
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (const double capacity : records[i].capacities)
      rows.push_back({capacity, capacity, 1.0, 1.0, i});
    if (records[i].censored > 0)
      rows.push_back({censored_at, infinity, records[i].censored, records[i].censored, i});
    if (records[i].free > 0) rows.push_back({0.0, 0.0, records[i].free, records[i].free, i});
  }
  finish(std::move(rows), records.size());
}

BracketRecords::BracketRecords(const CapacitySample& sample) {
  check(sample, "capacities");
  std::vector<Row> rows;
  for (const double capacity : sample.capacities) rows.push_back({capacity, capacity, 1.0, 1.0, 0});
  if (sample.censored > 0)
    rows.push_back({sample.censored_at, infinity, sample.censored, sample.censored, 0});
  if (sample.free > 0) rows.push_back({0.0, 0.0, sample.free, sample.free, 0});
  finish(std::move(rows), 1);
  worth_.records = worth_.rows;
  worth_.freedom = worth_.rows - 1;
}

LogBracket BracketRecords::in_logs(const Row& row) const {
  return {std::log(row.low) - center_, std::log(row.high) - center_};
}

void BracketRecords::finish(std::vector<Row> rows, std::size_t records) {
  std::vector<RecordWeight> weights(records);
  for (const Row& row : rows) {
    if (row.high == 0) continue;
    weights[row.record].sum += row.weight;
    weights[row.record].squares += row.squares;
  }
  worth_ = worth_of(weights);
  for (auto* of : {&free_, &histories_, &exceed_, &held_}) of->assign(records, 0.0);
  double exact = 0, ends = 0, sum_exact = 0, sum_ends = 0;
  lowest_high_ = lowest_ = infinity;
  highest_ = -infinity;
  for (Row& row : rows) {
    row.weight *= worth_.scale;
    row.squares *= worth_.scale * worth_.scale;
    if (row.high == 0) {
      free_[row.record] += row.weight;
      continue;
    }
    histories_[row.record] += row.weight;
    if (std::isfinite(row.high)) exceed_[row.record] += row.weight;
    if (row.low > 0) held_[row.record] += row.weight;
    highest_low_ = std::max(highest_low_, row.low);
    lowest_high_ = std::min(lowest_high_, row.high);
    for (const double end : {row.low, row.high}) {
      if (!(end > 0 && std::isfinite(end))) continue;
      ends += 1;
      sum_ends += std::log(end);
      lowest_ = std::min(lowest_, std::log(end));
      highest_ = std::max(highest_, std::log(end));
    }
    if (row.low == row.high) {
      exact += row.weight;
      sum_exact += row.weight * std::log(row.low);
    }
    rows_.push_back(row);
  }
  center_ = exact > 0 ? sum_exact / exact : ends > 0 ? sum_ends / ends : 0;
  lowest_ -= center_;
  highest_ -= center_;
  records_.resize(records);
  for (const Row& row : rows_) {
    const LogBracket bracket = in_logs(row);
    for (Part* part : {&records_[row.record], &pooled_}) {
      if (row.low == row.high) {
        part->exact.count += row.weight;
        part->exact.sum += row.weight * bracket.low;
        part->exact.sum_squares += row.weight * bracket.low * bracket.low;
      } else {
        part->open[{bracket.low, bracket.high}] += row.weight;
      }
    }
  }
}

Evaluation BracketRecords::evaluate(const Part& part, const ProbitLine& line) const {
  Evaluation sum;
  if (part.exact.count > 0) sum = capacity_likelihood(part.exact, line);
  for (const auto& [ends, weight] : part.open) {
    const Evaluation one = bracket_likelihood({ends.first, ends.second}, line);
    sum.value += weight * one.value;
    sum.gradient += weight * one.gradient;
    sum.information += weight * one.information;
  }
  return sum;
}

ProbitLine BracketRecords::first_guess() const {
  CapacityData about = pooled_.exact;
  for (const auto& [ends, weight] : pooled_.open) {
    const double y = std::isinf(ends.first)    ? ends.second
                     : std::isinf(ends.second) ? ends.first
                                               : 0.5 * (ends.first + ends.second);
    about.count += weight;
    about.sum += weight * y;
    about.sum_squares += weight * y * y;
  }
  return fragility::first_guess(about);
}

PointFit BracketRecords::fit() const {
  const ProbitLine none = ProbitLine::Zero();
  if (rows_.empty())
    return without_limit_ > 0
               ? PointFit{FitStatus::no_information, none, "no row limits the capacity"}
               : PointFit{FitStatus::failed, none, "there are no capacities"};
  if (std::isinf(lowest_high_)) return {FitStatus::lower_bound, none, ""};
  if (highest_low_ == 0) return {FitStatus::upper_bound, none, ""};
  if (complete()) return fit_point(pooled_.exact, first_guess());
  if (highest_low_ <= lowest_high_)
    return {FitStatus::one_level, none,
            "one intensity is in every bracket: log_std cannot be determined"};
  const auto line = maximise([&](const ProbitLine& at) { return evaluate(at); }, first_guess());
  if (!line) return {FitStatus::failed, none, "no greatest likelihood was found"};
  return (*line)[1] > 0
             ? PointFit{FitStatus::maximum_likelihood, *line, ""}
             : PointFit{FitStatus::no_trend, none, "the brackets do not rise with intensity"};
}

Records::Scores BracketRecords::scores(const ProbitLine& line) const {
  Scores result(count(), 2);
  for (Eigen::Index i = 0; i < count(); ++i)
    result.row(i) = evaluate(records_[static_cast<std::size_t>(i)], line).gradient.transpose();
  return result;
}

/// The information, but for weights that differ: these may belong to large scores.
Eigen::Matrix2d BracketRecords::score_variance(const ProbitLine& line) const {
  Eigen::Matrix2d information = evaluate(line).information;
  if (equal_weights_) return information;
  Eigen::Matrix2d plain = Eigen::Matrix2d::Zero(), weighted = plain;
  for (const Row& row : rows_) {
    const Eigen::Vector2d score = bracket_likelihood(in_logs(row), line).gradient;
    plain += row.weight * score * score.transpose();
    const double rest = 1 - row.weight / worth_.rows;
    weighted += row.squares / (rest * rest) * score * score.transpose();
  }
  const Eigen::Matrix2d root = information.llt().matrixL(), root_plain = plain.llt().matrixL(),
                        to = root * root_plain.inverse();
  return to * weighted * to.transpose();
}

double BracketRecords::log_likelihood(const FragilityCurve& curve) const {
  double constants = 0;
  for (const Row& row : rows_) {
    if (row.low == row.high)
      constants += row.weight * (std::log(row.low) + 0.5 * std::log(2 * std::numbers::pi));
  }
  return evaluate(to_line(curve, center_)).value - constants;
}

/// The limit of each record that says most.
FitSummary BracketRecords::bound() const {
  const bool reached = highest_low_ == 0;
  const double worth = worth_.records / static_cast<double>(count());
  std::map<std::size_t, Stripe> limits;  // by record, or row
  for (const Row& row : rows_) {
    const std::size_t trial = one_row_each() ? limits.size() : row.record;
    const double n = one_row_each() ? row.weight : worth;
    Stripe& limit = limits.emplace(trial, Stripe{reached ? row.high : row.low, n, reached ? n : 0})
                        .first->second;
    limit.intensity =
        reached ? std::min(limit.intensity, row.high) : std::max(limit.intensity, row.low);
  }
  std::vector<Stripe> stripes;
  for (const auto& [trial, limit] : limits) stripes.push_back(limit);
  return summarise_bound(to_data(stripes));
}

std::string BracketRecords::method() const {
  if (complete()) return "lognormal sample of capacities (n - 1)";
  const bool censored = std::ranges::all_of(
      rows_, [](const Row& row) { return row.low == row.high || std::isinf(row.high); });
  return censored ? "lognormal maximum likelihood on right-censored capacities"
                  : "lognormal maximum likelihood on brackets of the capacity";
}

std::string BracketRecords::note() const {
  return without_limit_ == 0 ? ""
                             : std::to_string(without_limit_) +
                                   " row(s) from 0 to infinity say nothing and are left out";
}

}  // namespace glissade::fragility
