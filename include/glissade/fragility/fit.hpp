// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// One intensity level: of `trials`, `exceedances` exceeded. Counts may be fractional (weights,
/// resampling).
struct Stripe {
  double intensity = 0.0;  ///< > 0
  double trials = 0.0;
  double exceedances = 0.0;
};

/// Capacities, the lowest intensity at which each history reached the threshold. Histories that
/// never reached it by `censored_at` are counted in `censored`, never filled in; histories that
/// reach it without shaking (capacity 0: an array that slides freely) are counted in `free`.
struct CapacitySample {
  std::vector<double> capacities;  ///< > 0
  double censored = 0.0;
  double censored_at = std::numeric_limits<double>::infinity();
  double free = 0.0;
};

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
  Interval floor_interval;  ///< NaN: floor 0, or the same in all records
  Interval p50_interval;    ///< of curve.intensity_at(0.5); median_interval where floor is 0
  double log_likelihood = std::numeric_limits<double>::quiet_NaN();  ///< without those of `floor`
  std::string method;           ///< "probit maximum likelihood on stripes", ...
  std::string interval_method;  ///< "profile likelihood", ...
  std::string note;             ///< what a reader must know; may be empty
  double effective_records = std::numeric_limits<double>::quiet_NaN();  ///< of a weighted fit
  /// Of the median, for an assumed log_std.
  bool is_bound() const {
    return status == FitStatus::lower_bound || status == FitStatus::upper_bound;
  }
  bool converged() const {
    return status == FitStatus::maximum_likelihood || status == FitStatus::extrapolated ||
           status == FitStatus::jeffreys_penalised;
  }
};

// All functions below throw InputError for counts or capacities out of range, and never for what
// the data show.

/// ln C(n,k) + k ln Phi(z) + (n-k) ln Phi(-z) summed over stripes (Baker 2015, Earthquake Spectra
/// 31(1), eq 11).
double stripe_log_likelihood(const std::vector<Stripe>& stripes, const FragilityCurve& curve);

/// Maximum likelihood on stripes with independent trials; 95 % intervals by profile likelihood.
/// Separated data: Jeffreys penalised fit. No exceedance, or all exceeded: one-sided bound, trials
/// taken as independent. Share that does not rise with intensity, or by so little that no finite
/// median has a share of one half: no_trend. A single level: one_level. Failed: no trials.
/// Accuracy of the maximum about 1e-12. What the data leave open is 0 or infinite.
FitSummary fit_stripes(const std::vector<Stripe>& stripes);

/// The Jeffreys (Firth 1993) penalised fit, separated or not: the log likelihood plus half the log
/// determinant of the expected information of the probit line, maximised in that line. Intervals by
/// penalised profile likelihood (Heinze & Schemper 2002, Statistics in Medicine 21(16):2409-2419).
FitSummary fit_stripes_jeffreys(const std::vector<Stripe>& stripes);

/// Sum of ln density at the capacities plus censored x ln Phi(-z) at censored_at.
double capacity_log_likelihood(const CapacitySample& sample, const FragilityCurve& curve);

/// Lognormal maximum likelihood on capacities, right-censored at `censored_at`. Without censoring
/// log_std has n - 1 below the line (statistics as in FEMA P-58 and Baker 2015). 95 % intervals:
/// Student t for ln median and chi-square for log_std without censoring, else profile likelihood
/// with Student's t (theory.md, 6.3). None reached: one-sided bound. Fewer than two different
/// capacities without censoring: one_capacity. `free` histories are the curve's floor, their share
/// of all, with its Clopper-Pearson interval.
FitSummary fit_capacities(const CapacitySample& sample);

}  // namespace glissade
