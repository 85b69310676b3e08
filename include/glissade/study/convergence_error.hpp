// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "glissade/study/convergence.hpp"

namespace glissade {

/// What an error of the residual r_P is relative to.
enum class ErrorMeasure {
  finest,  ///< |r_P / r_finest - 1|: the paper's convention, the finest P taken as the truth
  exact_residual,  ///< |r_P / r_exact - 1|
  exact_peak,  ///< |r_P - r_exact| / peak_exact: the only one that a residual near zero does not
               ///< inflate
};

/// One history of the published scheme; `step` is the position in ConvergenceResults::substeps.
struct HistoryIndex {
  std::size_t record = 0, scene = 0, step = 0;
};

/// The error of one history; NaN where the reference is zero (the scene does not slide, or comes
/// back exactly), which the paper leaves out too.
double scheme_error(const ConvergenceResults& results, const HistoryIndex& history,
                    ErrorMeasure measure);

/// Which histories to look at: records first_record <= i < last_record, and of these the ones whose
/// exact residual is at least a share of the exact peak.
struct Selection {
  std::size_t first_record = 0, last_record = std::numeric_limits<std::size_t>::max();
  double least_residual_of_peak = 0.0;
};

/// The errors at one P over records and scenes.
struct ErrorSummary {
  double largest = std::numeric_limits<double>::quiet_NaN();  ///< NaN where none counts
  double median = std::numeric_limits<double>::quiet_NaN();
  HistoryIndex worst;       ///< of `largest`
  std::size_t counted = 0;  ///< histories with a reference
};
ErrorSummary error_summary(const ConvergenceResults& results, std::size_t step,
                           ErrorMeasure measure, const Selection& selection = {});

/// The share of the histories counted whose error is `limit` or less.
double share_within(const ConvergenceResults& results, std::size_t step, ErrorMeasure measure,
                    double limit);

/// (record, scene) that never slide.
std::size_t count_at_rest(const ConvergenceResults& results);

/// The step of the P nearest to the 64 that the paper chose, the finest (the paper's truth) aside.
std::size_t chosen_step(const std::vector<int>& substeps);

struct TimeSummary {
  double longest_s = 0.0, median_s = 0.0;
};

/// Wall time of histories: known to a run, never in its results.
struct ConvergenceTimes {
  std::vector<TimeSummary> published;  ///< by substeps
  TimeSummary exact, kernel;           ///< slide(), peak_slip()
  TimeSummary table;                   ///< making a record's tables for peak_slip()
};
ConvergenceTimes time_summary(const std::vector<ConvergenceUnit>& units, std::size_t steps);

}  // namespace glissade
