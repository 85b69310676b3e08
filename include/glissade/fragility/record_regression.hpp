// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/core/independent_units.hpp"
#include "glissade/fragility/bootstrap.hpp"

namespace glissade {

/// A value of each record, as ln capacity, and what it may depend on.
struct RecordRegression {
  std::vector<double> value;
  std::vector<bool> censored;                   ///< known only to be above `value`
  std::vector<std::vector<double>> covariates;  ///< by (covariate, record)
  std::vector<std::size_t> unit_of = {};        ///< by record, from 0; empty: each is independent

  std::size_t records() const { return value.size(); }
  std::size_t unit(std::size_t record) const { return unit_at(unit_of, record); }
  std::size_t units() const { return unit_count(unit_of, records()); }
  std::size_t unknowns() const { return 1 + covariates.size(); }
};

/// value = intercept + slopes x covariates + normal residual: maximum likelihood with censored
/// values (Tobin 1958) by expectation and maximisation (Schmee & Hahn 1979, Technometrics
/// 21(4):417-432). Without censored values least squares.
struct RecordFit {
  std::vector<double> coefficients;  ///< intercept, then slopes
  double std = 0.0;                  ///< of the residual, with n - unknowns below the line
  double log_std_error = 0.0;        ///< standard error of ln std, by the fourth moment over units
  double log_likelihood = 0.0;
};
/// `weights`: how often each record counts; empty: once. Expects more records than unknowns.
RecordFit fit_records(const RecordRegression& data, const std::vector<double>& weights = {});

/// The slope of one more covariate, with the p-value of the likelihood ratio (without censored
/// values: Student's t test of the slope). NaN where the records are too few or have one value of
/// it.
struct SlopeTest {
  double slope, p_value;
};
SlopeTest test_slope(const RecordRegression& data, const std::vector<double>& covariate);

/// The interval of each regression's std (bootstrap over units as for log_std of a fit), all from
/// the same resamples, and the share of these in which it is the smallest.
struct RecordDispersion {
  double std;
  Interval interval;
  double smallest_share;
};
std::vector<RecordDispersion> record_dispersions(const std::vector<RecordRegression>& regressions,
                                                 const BootstrapOptions& options);

}  // namespace glissade
