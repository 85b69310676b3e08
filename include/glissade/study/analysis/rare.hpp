// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

/// Probabilities of small exceedance, with samples from wider distributions.
struct RareConfig {
  std::vector<double> thresholds_m;  ///< > 0, strictly increasing
  double widening = 3.0;  ///< >= 1: on the standard normal numbers of unbounded quantities
};

/// The probability, over records and samples, that displacement reaches a threshold at a level.
struct RareRow {
  std::uint64_t first_case = 0;  ///< of the histories' cases
  std::string condition;         ///< which combination of what the study lists
  double threshold_m = 0.0, level = 0.0;
  double probability = 0.0;
  Interval sampling_interval;  ///< 95 %, of the samples, on these records; NaN where fewer than
                               ///< least_effective_samples carry the probability
  Interval record_interval;    ///< 95 %, over records
  /// (sum p_r)^2 / sum p_r^2 of the records' probabilities p_r: the number that carries it. NaN at
  /// 0.
  double effective_records = 0.0;
  double plain_samples = 0.0;      ///< samples of plain Monte Carlo with the same sampling error
  double effective_samples = 0.0;  ///< the number of samples that carries it
};

struct RareResults {
  double widening = 1.0;
  std::string friction;         ///< of the first combination, as RunResults::friction
  std::vector<double> weights;  ///< by sample: probability over that of the widened distributions
  std::vector<RareRow> rows;    ///< by (combination, threshold, level)
};

struct RareAnalysis {
  struct InStudy {
    std::optional<RareConfig> rare;
  };
  struct InResults {
    std::optional<RareResults> rare;
  };
  /// Precondition: config.rare.
  static RareResults find(const StudyConfig& study, const Results& results);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
