// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glissade/block/tipping.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {

/// In how many histories of one combination of what the study lists the body begins to tip.
struct TippingShare {
  std::uint64_t first_case = 0;  ///< of the combination's cases, which are in a row
  std::string condition;         ///< what the study lists of it; empty where it lists nothing
  double level = 0.0;
  double share = 0.0;             ///< of all its histories at the level
  std::vector<double> by_record;  ///< the same of each record
};

/// The onset of tipping. The motion after it is outside the model.
struct TippingResults {
  RigidBase body;
  double least_friction = 0.0;       ///< b / (2 h): with no more the body slides first
  std::vector<TippingShare> shares;  ///< by (combination, level)
};

struct TippingAnalysis {
  struct InStudy {
    std::optional<RigidBase> tipping;  ///< of the array
  };
  struct InResults {
    std::optional<TippingResults> tipping;
  };
  static TippingResults find(const StudyConfig& study, const Results& results);
  static constexpr auto keeps = &KeptFields::tips;
  static void check(const StudyConfig& study, std::size_t records, ProblemList& problems);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
