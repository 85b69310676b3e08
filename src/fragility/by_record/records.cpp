// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/records.hpp"

#include <cmath>

#include "glissade/core/error.hpp"

namespace glissade::fragility {
namespace {

std::string record_name(std::size_t i) { return "record " + std::to_string(i + 1); }

std::vector<Stripe> stripes_of(const std::vector<double>& intensities,
                               const RecordStripes& record) {
  std::vector<Stripe> stripes;
  for (std::size_t j = 0; j < intensities.size(); ++j) {
    stripes.push_back({intensities[j], record.trials[j], record.exceedances[j]});
  }
  return stripes;
}

void check_records(const std::vector<double>& intensities,
                   const std::vector<RecordStripes>& records) {
  ProblemList problems;
  if (records.empty()) problems.add({"records", "there are none", "give at least one record", ""});
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].trials.size() != intensities.size() ||
        records[i].exceedances.size() != intensities.size()) {
      problems.add({record_name(i),
                    std::to_string(records[i].trials.size()) + " trials and " +
                        std::to_string(records[i].exceedances.size()) + " exceedances for " +
                        std::to_string(intensities.size()) + " intensities",
                    "give both per intensity", ""});
      continue;
    }
    if (!(records[i].free >= 0 && std::isfinite(records[i].free))) {
      problems.add({record_name(i), "free = " + std::to_string(records[i].free) + " is not a count",
                    "", ""});
    }
    try {
      check(stripes_of(intensities, records[i]), record_name(i));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
}

void check_records(const std::vector<RecordCapacities>& records, double censored_at) {
  ProblemList problems;
  if (records.empty()) problems.add({"records", "there are none", "give at least one record", ""});
  for (std::size_t i = 0; i < records.size(); ++i) {
    try {
      check(
          CapacitySample{records[i].capacities, records[i].censored, censored_at, records[i].free},
          record_name(i));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
}

}  // namespace

void Records::add_record(double free, double rest) {
  free_.push_back(free);
  histories_.push_back(free + rest);
}

double Records::floor(const Eigen::VectorXd& weights) const {
  const auto sum = [&](const std::vector<double>& values) {
    return weights.dot(Eigen::Map<const Eigen::VectorXd>(values.data(), weights.size()));
  };
  const double free = sum(free_);
  return free > 0 ? free / sum(histories_) : 0.0;
}

bool Records::floor_varies() const {
  for (std::size_t i = 1; i < free_.size(); ++i) {
    if (free_[i] * histories_[0] != free_[0] * histories_[i]) return true;
  }
  return false;
}

StripeRecords::StripeRecords(const std::vector<double>& intensities,
                             const std::vector<RecordStripes>& records) {
  check_records(intensities, records);
  const auto rows = static_cast<Eigen::Index>(records.size()),
             columns = static_cast<Eigen::Index>(intensities.size());
  exceedances_.resize(rows, columns);
  trials_.resize(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const RecordStripes& record = records[static_cast<std::size_t>(i)];
    exceedances_.row(i) = Eigen::Map<const Eigen::RowVectorXd>(record.exceedances.data(), columns);
    trials_.row(i) = Eigen::Map<const Eigen::RowVectorXd>(record.trials.data(), columns);
    add_record(record.free, columns > 0 ? trials_.row(i).maxCoeff() : 0.0);
  }
  levels_ = to_data(stripes_of(intensities, {std::vector<double>(intensities.size()),
                                             std::vector<double>(intensities.size())}));
  levels_ = pooled(Eigen::VectorXd::Ones(rows));
}

StripeData StripeRecords::pooled(const Eigen::VectorXd& weights) const {
  return {levels_.y, trials_.transpose() * weights, exceedances_.transpose() * weights,
          levels_.center};
}

PointFit StripeRecords::fit(const Eigen::VectorXd& weights, const ProbitLine& start) const {
  return fit_point(pooled(weights), start);
}

Records::Scores StripeRecords::scores(const ProbitLine& line) const {
  // d/dz of ln Phi(z) and ln Phi(-z), once per level: a score is the sum of k hazard_above - (n -
  // k) hazard_below.
  Eigen::VectorXd above(levels_.y.size()), below(levels_.y.size());
  for (Eigen::Index j = 0; j < levels_.y.size(); ++j) {
    const double z = line[0] + line[1] * levels_.y[j];
    above[j] = hazard(z);
    below[j] = hazard(-z);
  }
  Eigen::MatrixX2d design(levels_.y.size(), 2);
  design << Eigen::VectorXd::Ones(levels_.y.size()), levels_.y.matrix();
  return exceedances_ * above.asDiagonal() * design -
         (trials_ - exceedances_) * below.asDiagonal() * design;
}

Eigen::Matrix2d StripeRecords::information(const Eigen::VectorXd& weights,
                                           const ProbitLine& line) const {
  return stripe_likelihood(pooled(weights), line).information;
}

double StripeRecords::log_likelihood(const FragilityCurve& curve) const {
  std::vector<Stripe> stripes;
  for (Eigen::Index j = 0; j < levels_.y.size(); ++j) {
    stripes.push_back(
        {std::exp(levels_.y[j] + levels_.center), levels_.trials[j], levels_.exceedances[j]});
  }
  return stripe_log_likelihood(stripes, curve);
}

FitSummary StripeRecords::bound() const {
  StripeData one_trial_each = levels_;
  one_trial_each.trials = (trials_.array() > 0).cast<double>().colwise().sum().transpose();
  one_trial_each.exceedances =
      (exceedances_.array() > 0).cast<double>().colwise().sum().transpose();
  return summarise_bound(one_trial_each);
}

CapacityRecords::CapacityRecords(const std::vector<RecordCapacities>& records, double censored_at) {
  check_records(records, censored_at);
  sample_.censored_at = censored_at;
  for (const RecordCapacities& record : records) {
    sample_.capacities.insert(sample_.capacities.end(), record.capacities.begin(),
                              record.capacities.end());
    sample_.censored += record.censored;
  }
  const double center = mean_log(sample_.capacities);
  pooled_ = to_data(sample_, center);
  for (const RecordCapacities& record : records) {
    records_.push_back(to_data({record.capacities, record.censored, censored_at}, center));
    add_record(record.free, static_cast<double>(record.capacities.size()) + record.censored);
  }
}

CapacityData CapacityRecords::pooled(const Eigen::VectorXd& weights) const {
  CapacityData sum{.censored_at = pooled_.censored_at, .center = pooled_.center};
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const CapacityData& record = records_[static_cast<std::size_t>(i)];
    sum.count += weights[i] * record.count;
    sum.sum += weights[i] * record.sum;
    sum.sum_squares += weights[i] * record.sum_squares;
    sum.censored += weights[i] * record.censored;
  }
  return sum;
}

PointFit CapacityRecords::fit(const Eigen::VectorXd& weights, const ProbitLine& start) const {
  return fit_point(pooled(weights), start);
}

Records::Scores CapacityRecords::scores(const ProbitLine& line) const {
  Scores result(count(), 2);
  for (Eigen::Index i = 0; i < count(); ++i) {
    result.row(i) =
        capacity_likelihood(records_[static_cast<std::size_t>(i)], line).gradient.transpose();
  }
  return result;
}

Eigen::Matrix2d CapacityRecords::information(const Eigen::VectorXd& weights,
                                             const ProbitLine& line) const {
  return capacity_likelihood(pooled(weights), line).information;
}

double CapacityRecords::log_likelihood(const FragilityCurve& curve) const {
  return capacity_log_likelihood(sample_, curve);
}

FitSummary CapacityRecords::bound() const {
  double records = 0;
  for (const CapacityData& record : records_) records += record.censored > 0 ? 1 : 0;
  return summarise_bound(to_data({{sample_.censored_at, records, 0.0}}));
}

}  // namespace glissade::fragility
