// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/fragility/weighted_fit.hpp"
#include "lognormal/bracket_likelihood.hpp"
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

/// Of a record that has weight: the weights of its histories, and their squares.
struct RecordWeight {
  double sum = 0.0, squares = 0.0;
};
Worth worth_of(const std::vector<RecordWeight>& records);

/// Data of a lognormal, by record. All weights have one scale: they sum to what the rows are worth.
class Records {
 public:
  using Scores = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  virtual ~Records() = default;
  virtual ProbitLine first_guess() const = 0;
  virtual PointFit fit() const = 0;
  /// Log likelihood, up to a constant of the data, with its derivatives.
  virtual Evaluation evaluate(const ProbitLine& line) const = 0;
  virtual double value(const ProbitLine& line) const { return evaluate(line).value; }
  virtual Evaluation evaluate_penalised(const ProbitLine& line) const { return evaluate(line); }
  virtual Scores scores(const ProbitLine& line) const = 0;  ///< gradients by record
  /// Variance of the summed gradient were all histories independent.
  virtual Eigen::Matrix2d score_variance(const ProbitLine& line) const = 0;
  virtual double log_likelihood(const FragilityCurve& curve) const = 0;  ///< with all constants
  virtual FitSummary bound() const = 0;                                  ///< one trial per record
  virtual std::string method() const = 0;
  virtual bool complete() const { return false; }  ///< every capacity is known exactly
  /// Some records are at some of the levels only: multiple stripes.
  virtual bool has_gaps() const { return false; }
  /// Every trial is independent, of trials that are many: chi-square in place of Student's t.
  virtual bool independent_counts() const { return false; }

  double center() const { return center_; }
  const Worth& worth() const { return worth_; }
  Eigen::Index count() const { return static_cast<Eigen::Index>(histories_.size()); }
  Eigen::ArrayXd parts_of_weight() const;  ///< by record
  bool one_row_each() const { return worth_.rows_per_record() < 1 + 1e-9; }
  bool equal_weights() const { return equal_weights_; }
  bool below_data(double y) const { return y < lowest_ - 1e-9; }
  bool above_data(double y) const { return y > highest_ + 1e-9; }
  /// How many records the histories are worth that exceed (or do not): (sum k)^2 / sum k^2.
  double contributing(bool exceed) const;

  /// Share of all histories that exceed without shaking.
  double floor() const;
  Interval floor_interval() const;  ///< NaN where it is the same in all records

 protected:
  // By record: weights of histories that slide freely, of the others, and of these that reached it
  // at any intensity or were below it at any.
  std::vector<double> free_, histories_, exceed_, held_;
  Worth worth_;
  double center_ = 0.0, lowest_ = 0.0, highest_ = 0.0;  // range of the data as y
  bool equal_weights_ = true;
};

class StripeRecords final : public Records {
 public:
  /// Of all trials independent of each other.
  explicit StripeRecords(const std::vector<Stripe>& stripes);
  explicit StripeRecords(const std::vector<WeightedStripe>& rows);
  StripeRecords(const std::vector<double>& intensities, const std::vector<RecordStripes>& records);

  ProbitLine first_guess() const override { return fragility::first_guess(pooled_); }
  PointFit fit() const override;
  PointFit fit_jeffreys() const;
  Evaluation evaluate(const ProbitLine& line) const override {
    return stripe_likelihood(pooled_, line);
  }
  double value(const ProbitLine& line) const override {
    return stripe_log_likelihood(pooled_, line);
  }
  /// Of the penalised likelihood, with as many trials as records.
  Evaluation evaluate_penalised(const ProbitLine& line) const override {
    return stripe_jeffreys(one_each_, line);
  }
  Scores scores(const ProbitLine& line) const override;
  Eigen::Matrix2d score_variance(const ProbitLine& line) const override;
  double log_likelihood(const FragilityCurve& curve) const override;
  FitSummary bound() const override;
  std::string method() const override { return "probit maximum likelihood on stripes"; }
  bool has_gaps() const override { return (trials_.array() == 0).any(); }
  bool independent_counts() const override { return independent_; }

 private:
  void finish(const std::vector<double>& intensities, const std::vector<RecordWeight>& weights);

  Eigen::MatrixXd exceedances_, trials_;  // record x level
  Eigen::VectorXd row_weight_;            // by record
  StripeData pooled_, one_each_;          // the latter: as many trials as records are worth
  bool independent_ = false;
};

class BracketRecords final : public Records {
 public:
  /// @param independent each row is a record of its own
  BracketRecords(const std::vector<CapacityBracket>& rows, bool independent);
  BracketRecords(const std::vector<RecordCapacities>& records, double censored_at);
  explicit BracketRecords(const CapacitySample& sample);  ///< each capacity independent

  ProbitLine first_guess() const override;
  PointFit fit() const override;
  Evaluation evaluate(const ProbitLine& line) const override { return evaluate(pooled_, line); }
  Scores scores(const ProbitLine& line) const override;
  Eigen::Matrix2d score_variance(const ProbitLine& line) const override;
  double log_likelihood(const FragilityCurve& curve) const override;
  FitSummary bound() const override;
  std::string method() const override;
  bool complete() const override { return pooled_.open.empty(); }
  std::string note() const;  ///< on rows that say nothing

 private:
  /// Exact capacities by their sums, the others as brackets with the weights of each.
  struct Part {
    CapacityData exact;
    std::map<std::pair<double, double>, double> open;
  };
  struct Row {
    double low, high, weight, squares;  // intensities; sums of its rows' weights and their squares
    std::size_t record;
  };
  void finish(std::vector<Row> rows, std::size_t records);
  LogBracket in_logs(const Row& row) const;
  Evaluation evaluate(const Part& part, const ProbitLine& line) const;

  std::vector<Row> rows_;
  std::vector<Part> records_;
  Part pooled_;
  double highest_low_ = 0.0, lowest_high_ = 0.0;
  std::size_t without_limit_ = 0;
};

/// The one writer of summaries. `band` (if not null) receives the interval of the probability at
/// each given intensity.
FitSummary summarise(const Records& data, const PointFit& point,
                     const std::vector<double>& band_intensities = {},
                     std::vector<Interval>* band = nullptr);

}  // namespace glissade::fragility
