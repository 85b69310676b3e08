// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/shape.hpp"
#include "glissade/study/analysis/analysis.hpp"

// The shape of the fragilities: is a lognormal right, what else could be, do curves cross.
namespace glissade {

/// One threshold. Scores are by ShapeModel, and empty unless they were compared.
struct ThresholdShape {
  double threshold_m = 0.0;
  ComparisonStatus status = ComparisonStatus::few_records;
  std::vector<double> score, difference, standard_error;  ///< as in ModelScore
  std::vector<double> probability;                        ///< by (model, level)
  std::vector<double> recrossed;  ///< by level: share of all histories that reached the threshold
                                  ///< at a lower level and do not here

  /// At a level, by a model; NaN where it was not fitted.
  double probability_at(ShapeModel model, std::size_t level) const {
    return probability.empty()
               ? std::numeric_limits<double>::quiet_NaN()
               : probability[static_cast<std::size_t>(model) * recrossed.size() + level];
  }
};

/// Two lognormals of neighbouring thresholds. On one side of it the larger displacement would be
/// the more probable one.
struct ShapeCrossing {
  double threshold_m = 0.0, next_threshold_m = 0.0;
  double intensity = 0.0, probability = 0.0;
  bool within_levels = false;
};

/// Of the one surface that never crosses.
struct SurfaceMedian {
  double threshold_m = 0.0;
  Estimate median;
};

struct ShapeRun {
  std::string label;  ///< that of its fragility
  std::vector<ThresholdShape> thresholds;
  std::vector<ShapeCrossing> crossings;
  std::vector<SurfaceMedian> surface;  ///< thresholds that a history reached; empty: no surface
  Estimate surface_log_std = {std::numeric_limits<double>::quiet_NaN(), {}};
};

struct ShapeResults {
  std::vector<ShapeRun> runs;  ///< as Results::runs
};

struct ShapeAnalysis {
  struct InStudy {
    bool shape = false;
  };
  struct InResults {
    std::optional<ShapeResults> shape;
  };
  /// From the fragility runs and the histories.
  static ShapeResults find(const StudyConfig& study, const Results& results);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
