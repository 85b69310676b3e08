// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/standards.hpp"

// Prescribed displacements, judged by what was computed. Records are the independent unit of all
// intervals (95 %).
namespace glissade {

/// The probabilities of exceedance that prescribed displacements are judged by: the first is
/// accepted at DBE.
struct VerdictConfig {
  std::vector<double> exceedance = {0.1, 0.05, 0.01};  ///< falling, (0, 1)
};

/// That displacement exceeds the prescribed one, in the building whose period makes it largest.
struct VerdictProbability {
  double probability = 0.0;
  Interval interval;  ///< never narrower than that of a binomial, see widened()
  double period_s = 0.0;
};

/// One prescribed displacement on arrays of one kind, in the building whose period makes each
/// number largest. Histories of all records, samples and orientations count alike.
struct VerdictRow {
  Standard standard = Standard::seaoc_pv1_2012;
  double sds_g = 0.0;  ///< at the design earthquake (DBE); 1.5 times that at the MCE
  Prescription prescribed;
  std::uint64_t first_case = 0;      ///< of the first building period
  std::string condition;             ///< what the study lists of it but the building period
  double mu = 0.0, slope_deg = 0.0;  ///< as stated: of what is drawn the mean of its distribution
  bool within_conditions = false;    ///< of the standard: slope and friction
  VerdictProbability dbe, mce;
  /// At DBE, exceeded with each probability of VerdictResults::exceedance; infinite where so many
  /// histories slide freely.
  std::vector<double> displacement_m;
  std::vector<Interval> displacement_interval;
};

/// One of the separations that the standard requires of a prescribed displacement, on the same
/// arrays. Between arrays: that the gap to a neighbour closes by more, where they have one.
struct VerdictSeparation {
  std::uint64_t row = 0;  ///< of VerdictResults::rows
  std::string what;       ///< "between similar arrays, along the slope"
  double factor = 0.0;    ///< on the prescribed displacement
  double value_m = 0.0;
  VerdictProbability dbe, mce;  ///< that more is needed
};

enum class Judgement {
  exceeded,      ///< at DBE, with more than the largest probability of the list
  sufficient,    ///< not so
  conservative,  ///< more than twice the displacement that the least probability of the list has
};

struct VerdictResults {
  std::vector<double> exceedance;  ///< falling, (0, 1)
  std::vector<VerdictRow> rows;    ///< by (combination without the period, standard, level)
  std::vector<VerdictSeparation> separations;  ///< by (row, separation)
};

Judgement judgement(const VerdictResults& verdict, const VerdictRow& row);

/// The interval of the probability at DBE lies on one side of the accepted one.
bool is_certain(const VerdictResults& verdict, const VerdictRow& row);

/// Position of a level, found to 1e-9 of it; levels.size() where there is none.
std::size_t level_at(const std::vector<double>& levels, double level);

struct VerdictAnalysis {
  struct InStudy {
    std::optional<VerdictConfig> verdict;
  };
  struct InResults {
    std::optional<VerdictResults> verdict;
  };
  /// At every level of which 1.5 times is a level too, of the arrays that slide.
  static VerdictResults find(const StudyConfig& study, const Results& results);
  static std::vector<std::string> notes(const Results& results, const StudyConfig& study);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
