// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "glissade/fragility/curve.hpp"

namespace glissade {

struct Interval {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

/// A number with its 95 % interval.
struct Estimate {
  double value = 0.0;
  Interval interval;
};

/// Of `trials` histories at an intensity, `exceedances` reach the threshold. At intensity 0 all of
/// them do: those that slide freely. Counts may be fractional.
struct Stripe {
  double intensity = 0.0, trials = 0.0, exceedances = 0.0;
  double weight = 1.0;
  std::size_t record = 0;
};

/// A capacity, the lowest intensity at which a history reaches the threshold: above `low` and not
/// above `high`; exact where they are equal. low = 0: reached by the first level; high infinite:
/// not reached by `low`, the highest level. Both 0: the history slides freely.
struct Bracket {
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  double weight = 1.0;
  std::size_t record = 0;
};

/// What is independent: each trial of a stripe and each bracket; or the records alone, whose rows
/// depend on each other.
enum class Independent { rows, records };

/// How many records rows belong to, which are numbered from 0.
template <class Row>
std::size_t record_count(const std::vector<Row>& rows) {
  std::size_t count = 0;
  for (const Row& row : rows) count = std::max(count, row.record + 1);
  return count;
}

enum class FitStatus {
  failed,              ///< no fit; see note
  maximum_likelihood,  ///< finite maximum of the likelihood
  jeffreys_penalised,  ///< separated data: penalised by half the log determinant of the information
                       ///< (Firth 1993)
  lower_bound,         ///< no exceedance at all: median is a lower bound at 95 % for an assumed
                       ///< log_std of 0.4, and median_interval reaches to infinity
  upper_bound,         ///< every trial exceeded: an upper bound, median_interval begins at 0
  no_trend,            ///< the share of exceedances does not rise with intensity: no curve
  always_exceeds,      ///< every history exceeds without shaking: floor 1, no median, no log_std
  one_level,           ///< all data are at one intensity: no curve
  one_capacity,        ///< all histories have one capacity: it is the median; log_std is NaN
  no_information,      ///< no row limits the capacity: no curve
  extrapolated,        ///< a maximum of the likelihood whose median is beyond the data
};
std::string to_string(FitStatus status);

/// Starts as failure; says what came out and how.
struct FitSummary {
  FitStatus status = FitStatus::failed;
  FragilityCurve curve;
  Interval median_interval;  ///< 95 %, method in interval_method; an open side is 0 or infinite
  Interval log_std_interval;
  Interval floor_interval;     ///< NaN: floor 0, or the same in all records
  Interval p50_interval;       ///< of curve.intensity_at(0.5); median_interval where floor is 0
  std::vector<Interval> band;  ///< of the probability, at each intensity that was asked for
  double log_likelihood = std::numeric_limits<double>::quiet_NaN();  ///< without those of `floor`
  std::string method;           ///< "probit maximum likelihood on stripes", ...
  std::string interval_method;  ///< "profile likelihood", ...
  std::string note;             ///< what a reader must know; may be empty
  double effective_records = std::numeric_limits<double>::quiet_NaN();  ///< where weights differ
  /// Of the median, for an assumed log_std.
  bool is_bound() const {
    return status == FitStatus::lower_bound || status == FitStatus::upper_bound;
  }
  bool converged() const {
    return status == FitStatus::maximum_likelihood || status == FitStatus::extrapolated ||
           status == FitStatus::jeffreys_penalised;
  }
};

// Maximum likelihood of a lognormal, sum of w l over rows with weights w (importance sampling).
// Weights are scaled to sum to the effective number of rows, (sum w)^2 / sum w^2 (Kish 1965, Survey
// Sampling): their unit has no effect, and a row of weight 0 plays no part. The share of histories
// that slide freely is the curve's floor; the lognormal is that of the others.
//
// Intervals at 95 % are ranges over the lines that the data allow, by the likelihood (theory.md,
// 6.3): scaled by the variance between records where rows of one depend on each other, and of as
// many records as their weights are worth. There is none (NaN) with one record, with records that
// are identical, and where records are separated: they do not show how much they differ. What the
// data leave open is 0 or infinite. Both ends of `band` rise with intensity, and cross 1/2 where
// p50_interval ends. The interval of the floor is that of a share (share.hpp); p50 and band are
// wider than 95 % by it. Where none exceeds, or all do, each record is one trial of a bound.
//
// All functions throw InputError for rows out of range and weights that are negative or all 0, and
// never for what the data show.

/// l = ln C(n,k) + k ln Phi(z) + (n-k) ln Phi(-z) (Baker 2015, Earthquake Spectra 31(1), eq 11).
/// Separated stripes: Jeffreys penalised fit. Share that does not rise with intensity, or by so
/// little that no finite median has a share of one half: no_trend. Accuracy of the maximum about
/// 1e-12.
FitSummary fit_stripes(const std::vector<Stripe>& rows, Independent independent,
                       const std::vector<double>& band_intensities = {});

/// The Jeffreys (Firth 1993) penalised fit, separated or not: the log likelihood plus half the log
/// determinant of the expected information of the probit line, maximised in that line. Intervals of
/// independent trials by penalised profile likelihood (Heinze & Schemper 2002, Statistics in
/// Medicine 21(16):2409-2419).
FitSummary fit_stripes_jeffreys(const std::vector<Stripe>& rows, Independent independent);

/// l = ln[Phi(z_high) - Phi(z_low)], or the density of an exact capacity. Where all are exact,
/// log_std has n - 1 below the line (as in FEMA P-58 and Baker 2015), and independent ones have
/// Student's t for ln median and chi-square for log_std. All exact and equal: one_capacity, the
/// median. Else one_level, where one intensity is in every bracket, so that log_std would be 0.
/// Rows from 0 to infinity say nothing: they are left out, and the note counts them; no_information
/// if no others are left.
FitSummary fit_brackets(const std::vector<Bracket>& rows, Independent independent,
                        const std::vector<double>& band_intensities = {});

/// The log likelihood of a curve, with all constants.
double log_likelihood(const std::vector<Stripe>& rows, const FragilityCurve& curve);
double log_likelihood(const std::vector<Bracket>& rows, const FragilityCurve& curve);

}  // namespace glissade
