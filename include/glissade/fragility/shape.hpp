// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/two_part.hpp"

// Is a lognormal the right shape, and what else could be. Records are the independent unit.
namespace glissade {

/// What a study knows of several thresholds. Histories that slide freely are no part of it.
struct ShapeData {
  std::vector<double> intensities, thresholds_m;  ///< both rise
  std::vector<std::vector<Stripe>> stripes;       ///< by threshold
  std::vector<std::vector<Bracket>> capacities;   ///< by threshold: exact, or above a highest level
  std::vector<std::vector<SlipSums>> slips;       ///< [unit][level]; empty: not all are known
};

/// The probability of exceedance as a function of the intensity x.
enum class ShapeModel {
  lognormal,              ///< Phi(b0 + b1 ln x), fitted on stripes: the probit model
  logit,                  ///< 1 / (1 + exp(-b0 - b1 ln x))
  complementary_log_log,  ///< 1 - exp(-exp(b0 + b1 ln x))
  two_part,               ///< TwoPartFit, one for all thresholds
  monotone,               ///< non-decreasing shares (pooled adjacent violators, Ayer et al. 1955)
  one_surface,            ///< FragilitySurface, one for all thresholds
};
inline constexpr std::size_t shape_model_count = 6;

/// How well a model fitted on the other records predicts a record that is left out: ln of the
/// probability that it gives to what was observed, mean over the histories and levels of a record,
/// then over records. Higher is better. NaN: not fitted.
struct ModelScore {
  ShapeModel model = ShapeModel::lognormal;
  double score = std::numeric_limits<double>::quiet_NaN();
  double difference = std::numeric_limits<double>::quiet_NaN();      ///< to the lognormal's score
  double standard_error = std::numeric_limits<double>::quiet_NaN();  ///< of that, over records
  std::vector<double> probability;  ///< fitted on all records, by level
};

enum class ComparisonStatus {
  compared,
  few_records,     ///< fewer than three
  no_overlap,      ///< with a record left out the others are separated, or none or all exceed
  no_rise,         ///< ... or their share does not rise with intensity
  always_exceeds,  ///< every history slides freely
};
std::string to_string(ComparisonStatus status);

struct ShapeComparison {
  ComparisonStatus status = ComparisonStatus::few_records;
  std::vector<ModelScore> models;  ///< by ShapeModel; empty unless compared
};

/// By threshold. The monotone model's share p of n records is taken as (n p + 1/2)/(n + 1) where it
/// predicts, so that nothing is impossible.
std::vector<ShapeComparison> compare_shapes(const ShapeData& data);

/// Lognormal fragilities of several displacements with one log_std, which never cross. (Two
/// lognormals of different log_std always cross somewhere.) ln median is linear in ln displacement
/// between the thresholds.
struct FragilitySurface {
  std::vector<double> thresholds_m = {}, medians = {};  ///< both rise; thresholds that no history
                                                        ///< reached are left out
  std::vector<Interval> median_intervals = {};          ///< 95 %, cluster sandwich, Student t
  double log_std = std::numeric_limits<double>::quiet_NaN();
  Interval log_std_interval = {};

  double median_at(double displacement_m) const;  ///< within the thresholds
  double probability(double intensity, double displacement_m) const;
};

/// Maximum likelihood on the capacities of all thresholds, each right-censored at the highest
/// level, as if they were independent; intervals from the cluster sandwich over records. Empty
/// where fewer than two thresholds are reached or there is no maximum.
std::optional<FragilitySurface> fit_surface(const ShapeData& data);

/// Where two lognormals have the same probability: the intensity and that probability. Beyond it
/// the larger displacement has the higher probability on one side. Empty where log_std is the same.
struct CurveCrossing {
  double intensity = 0.0, probability = 0.0;
};
std::optional<CurveCrossing> crossing_of(const FragilityCurve& a, const FragilityCurve& b);

}  // namespace glissade
