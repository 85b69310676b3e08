// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "lognormal/point_fit.hpp"

namespace glissade::fragility {

/// Data by record, reduced to sufficient statistics once, so that a resample (a weight per record)
/// costs little.
class Records {
 public:
  using Scores = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  virtual ~Records() = default;
  virtual Eigen::Index count() const = 0;
  virtual double center() const = 0;
  virtual ProbitLine first_guess() const = 0;
  virtual PointFit fit(const Eigen::VectorXd& weights, const ProbitLine& start) const = 0;
  /// Gradient of each record's log likelihood, and the observed information of all of them.
  virtual Scores scores(const ProbitLine& line) const = 0;
  virtual Eigen::Matrix2d information(const Eigen::VectorXd& weights,
                                      const ProbitLine& line) const = 0;
  virtual double log_likelihood(const FragilityCurve& curve) const = 0;  ///< with all constants
  virtual FitSummary bound() const = 0;  ///< with one trial per record
  virtual std::string method() const = 0;

  /// Share of all histories that exceed without shaking.
  double floor(const Eigen::VectorXd& weights) const;
  bool floor_varies() const;  ///< from record to record

 protected:
  void add_record(double free, double rest);

 private:
  std::vector<double> free_, histories_;  // per record
};

class StripeRecords final : public Records {
 public:
  StripeRecords(const std::vector<double>& intensities, const std::vector<RecordStripes>& records);
  Eigen::Index count() const override { return exceedances_.rows(); }
  double center() const override { return levels_.center; }
  ProbitLine first_guess() const override { return fragility::first_guess(levels_); }
  PointFit fit(const Eigen::VectorXd& weights, const ProbitLine& start) const override;
  Scores scores(const ProbitLine& line) const override;
  Eigen::Matrix2d information(const Eigen::VectorXd& weights,
                              const ProbitLine& line) const override;
  double log_likelihood(const FragilityCurve& curve) const override;
  FitSummary bound() const override;
  std::string method() const override { return "probit maximum likelihood on stripes"; }

 private:
  StripeData pooled(const Eigen::VectorXd& weights) const;

  Eigen::MatrixXd exceedances_, trials_;  // record x level
  StripeData levels_;                     // of all records
};

class CapacityRecords final : public Records {
 public:
  CapacityRecords(const std::vector<RecordCapacities>& records, double censored_at);
  Eigen::Index count() const override { return static_cast<Eigen::Index>(records_.size()); }
  double center() const override { return pooled_.center; }
  ProbitLine first_guess() const override { return fragility::first_guess(pooled_); }
  PointFit fit(const Eigen::VectorXd& weights, const ProbitLine& start) const override;
  Scores scores(const ProbitLine& line) const override;
  Eigen::Matrix2d information(const Eigen::VectorXd& weights,
                              const ProbitLine& line) const override;
  double log_likelihood(const FragilityCurve& curve) const override;
  FitSummary bound() const override;
  std::string method() const override {
    return sample_.censored > 0 ? "lognormal maximum likelihood on right-censored capacities"
                                : "lognormal sample of capacities (n - 1)";
  }

 private:
  CapacityData pooled(const Eigen::VectorXd& weights) const;

  CapacitySample sample_;  // of all records
  CapacityData pooled_;
  std::vector<CapacityData> records_;
};

}  // namespace glissade::fragility
