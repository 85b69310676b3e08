// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

struct Case;
struct CaseGrid;
struct SampleBlocks;
struct HistoryTable;

/// Standard errors of ln median of the fit on capacities: of the number of records, which samples
/// do not reduce, and of the samples.
struct SamplingErrorRow {
  std::string label;  ///< of the run
  double threshold_m = 0.0;
  double median = 0.0;          ///< NaN: not fitted, also where there is a bound of it
  double record_error = 0.0;    ///< the interval of ln median (95 %) over 3.92
  double sampling_error = 0.0;  ///< from the scrambles; NaN where a part has no fit
};

/// Where a run with sampling.target_error ended.
struct ReachedTarget {
  double target_error = 0.0;
  double error = 0.0;  ///< largest half_width() of the medians; infinite: one has no fit
  std::uint64_t scrambles = 0, most_scrambles = 0;

  bool is_reached() const { return error <= target_error; }
};

/// @param study with the scrambles that were run
ReachedTarget reached_target(const StudyConfig& study, const std::vector<SamplingErrorRow>& rows);

/// ln medians of the fits on the capacities of the blocks of samples so far, by (combination in
/// which the array slides, threshold).
class BlockMedians {
 public:
  /// Adds the next of the blocks. Where it has no fit its median is NaN.
  void add(const CaseGrid& cases, const std::function<Case(std::size_t)>& case_of,
           const HistoryTable& histories, double highest_level, SampleBlocks blocks);
  std::uint64_t blocks() const { return blocks_; }  ///< added
  std::size_t rows() const { return by_row_.size(); }
  /// Of the mean of the blocks.
  double standard_error(std::size_t row) const;

 private:
  std::uint64_t blocks_ = 0;
  std::vector<std::vector<double>> by_row_;
};

/// Half of the 95 % interval of a mean over blocks (Student's t). NaN is infinite.
double half_width(double standard_error, std::uint64_t blocks);

struct SamplingErrorAnalysis {
  struct InStudy {};
  struct InResults {
    std::vector<SamplingErrorRow> sampling_errors;  ///< of two scrambles or more
  };
  /// By (run, threshold). None with one scramble, or without [fragility].
  static std::vector<SamplingErrorRow> find(const StudyConfig& study, const Results& results);
  static std::vector<std::string> warnings(const Results& results, const StudyConfig& study);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
