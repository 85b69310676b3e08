// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "lognormal/point_fit.hpp"

namespace glissade::fragility {

/// How many independent rows, and records, data with weights are worth (Kish 1965, Survey
/// Sampling): (sum w)^2 / sum w^2. A row is a history.
struct Worth {
  double rows = 0.0, records = 0.0;
  double scale = 1.0;    ///< of weights, so that they sum to `rows`: 1 where all are 1
  double freedom = 0.0;  ///< degrees of a variance of the records: (sum w^2)^2 / sum w^4 - 1

  double rows_per_record() const { return rows / records; }
};

/// Rows of a lognormal, by record. All weights have one scale: they sum to what the rows are worth.
class Records {
 public:
  using Scores = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  Records(const std::vector<Stripe>& rows, Independent independent);
  Records(const std::vector<Bracket>& rows, Independent independent);

  PointFit fit() const;
  PointFit fit_jeffreys() const;
  FitSummary bound() const;  ///< one trial per record

  const LogRows& pooled() const { return pooled_; }
  Scores scores(const ProbitLine& line) const;  ///< gradients of the log likelihood by record
  /// Variance of the summed gradient were all histories independent.
  Eigen::Matrix2d score_variance(const ProbitLine& line) const;
  double log_likelihood(const FragilityCurve& curve) const;  ///< with all constants
  std::string method() const;
  std::string note() const;  ///< on rows that say nothing

  const Worth& worth() const { return worth_; }
  Eigen::Index count() const { return std::ssize(records_); }
  Eigen::ArrayXd parts_of_weight() const;  ///< by record
  bool one_row_each() const { return worth_.rows_per_record() < 1 + 1e-9; }
  bool equal_weights() const { return equal_weights_; }
  /// Some records are at some of the levels only: multiple stripes.
  bool has_gaps() const;
  /// Every trial is independent, of trials that are many: chi-square in place of Student's t.
  bool independent_counts() const;
  /// How many records the histories are worth that exceed (or do not): (sum k)^2 / sum k^2.
  double contributing(bool exceed) const;

  /// Share of all histories that exceed without shaking.
  double floor() const;
  Interval floor_interval() const;  ///< NaN where it is the same in all records

 private:
  /// Weights of histories that slide freely and of the others; of these the sum of squared weights,
  /// and the weight of those that exceeded at any intensity and of those that did not at any.
  struct Record {
    LogRows rows = {};
    double free = 0.0, histories = 0.0, squares = 0.0, exceed = 0.0, held = 0.0;
  };
  void take_weights();
  Eigen::ArrayXd by_record(double Record::*value) const;
  LogRows one_each() const;

  bool counts_, rows_are_independent_, equal_weights_ = true;
  std::map<std::size_t, Record> records_;
  std::vector<Bracket> rows_;  ///< those that say something
  LogRows pooled_;
  Worth worth_;
  std::size_t without_limit_ = 0;
};

}  // namespace glissade::fragility
