// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

/// Intensity measures are ranked by what they say about the capacities of [fragility].
struct IntensityMeasuresConfig {
  std::vector<double> sa_periods_s = {0.2, 0.5, 1.0, 2.0};  ///< rising, 0.02 to 4
};

/// How well an intensity measure predicts when an array slides a threshold (theory.md, 6.11): the
/// dispersion of the records' ln capacity in it (efficiency), and how that depends on magnitude and
/// distance (sufficiency). Of measures that go with a power of the motion the capacity is that of
/// their root, so that all can be compared.
struct RankedMeasure {
  std::uint64_t run = 0;  ///< position in Results::runs
  double threshold_m = 0.0;
  std::string name;           ///< "PGV", "Sa(0.5 s)", "PGA and PGV"
  std::uint64_t pair = 0;     ///< 1: of two measures
  Estimate dispersion;        ///< of ln capacity between records; bootstrap over records
  double smallest_share = 0;  ///< of the resamples of the records in which it ranks first
  /// Of ln capacity per unit of magnitude and of ln distance, NaN where records do not have them.
  double magnitude_slope = std::numeric_limits<double>::quiet_NaN(), magnitude_p = magnitude_slope;
  double distance_slope = magnitude_slope, distance_p = magnitude_slope;
  std::uint64_t censored_records = 0;  ///< half their histories do not reach the threshold
};

struct IntensityMeasuresAnalysis {
  struct InStudy {
    std::optional<IntensityMeasuresConfig> intensity_measures;
  };
  struct InResults {
    std::optional<std::vector<RankedMeasure>> intensity_measures;
  };
  /// By run and threshold, the smallest dispersion first. Nothing where half of the records or more
  /// do not reach a threshold, or slide freely.
  static std::vector<RankedMeasure> find(const StudyConfig& study, const Results& results);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
