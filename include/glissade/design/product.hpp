// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/design_spectrum.hpp"
#include "glissade/study/analysis/hazard.hpp"
#include "glissade/study/results.hpp"

// The product sheet of a manufacturer: design displacement of an array by site, slope and friction.
namespace glissade {

enum class SheetUnit { inch, foot, metre };
/// "in", "ft", "m".
const char* to_string(SheetUnit unit);
double in_unit(SheetUnit unit, double length_m);

/// A site of the sheet, by its design values.
struct ProductTarget {
  DesignTarget target;                 ///< S_DS and S_D1
  std::optional<HazardConfig> hazard;  ///< in S_DS
};

struct Product {
  std::filesystem::path file;
  std::string source_text;                         ///< of the file, without its comments
  std::string name, manufacturer, revision, date;  ///< empty: not stated
  SheetUnit unit = SheetUnit::inch;
  double round_up_m = 0.0;
  std::vector<ProductTarget> targets;
  double event_years = 700.0;   ///< return period of the one large event, with a hazard curve
  std::filesystem::path suite;  ///< suite file
};

/// The levels of a target's study, increasing: S_DS; with a hazard curve also that of the event and
/// smaller ones, from a twentieth of it on.
std::vector<double> levels_of(const Product& product, const ProductTarget& target);

/// On one slope with one friction; infinite where the array slides freely.
struct ProductDisplacement {
  double slope_deg = 0.0, mu = 0.0;
  ChartSlip slip;                   ///< at S_DS, the largest over the building periods
  double period_s = 0.0;            ///< where its mean is largest
  double analysis_m = 0.0;          ///< factor x mean, or largest record
  double design_m = 0.0;            ///< within ASCE 7-16 its least value, I_e = 1, if more
  std::vector<double> by_period_m;  ///< as analysis_m, by building period
  // With a hazard curve.
  double event_m = 0.0;       ///< as analysis_m, at the event
  double smaller_m = 0.0;     ///< sum of the mean displacements of smaller events
  bool slides_below = false;  ///< at the lowest level already: the sum is a lower bound
};

struct TargetDisplacements {
  bool of_largest = false;  ///< fewer than 7 records: the largest counts in place of the mean
  double factor = 1.1, event_g = 0.0;
  std::vector<double> slope_deg, mu, period_s;
  std::vector<ProductDisplacement> points;  ///< by (slope, friction), friction fastest
};
/// From the results of the target's study.
TargetDisplacements displacements_of(const Product& product, const ProductTarget& target,
                                     const Results& results);

/// The expected sum of the displacements of all events up to `most` in so many years: the integral
/// of the mean displacement, linear between levels, over the rates of the hazard curve.
double accumulated_m(const HazardCurve& curve, const std::vector<double>& levels,
                     const std::vector<double>& mean_m, double most, double years);

}  // namespace glissade
