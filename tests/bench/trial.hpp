// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "work_precision.hpp"

namespace glissade::bench {

/// Histories under one ground motion that slide more than 1 mm and stay on the roof.
struct TrialBatch {
  std::span<const double> samples;  ///< of the motion's first component
  std::vector<double> truth_m;      ///< peak displacement, by history
  std::vector<std::string> scenes;  ///< what each history is
};

/// Below 1 mm a peak has no relative error that anyone needs; a block that lifts off is outside the
/// model.
inline bool is_for_trial(double peak_m, bool uplift) { return peak_m > 1e-3 && !uplift; }

/// A way to get the peaks of a batch, in plan, m: all at once or one after another.
struct BatchScheme {
  std::string family;  ///< a curve of the figure
  std::string label;   ///< its point: "P = 64"
  std::function<std::vector<double>(std::size_t batch)> peaks_m;
  Problem problem = Problem::samples;
};

/// One pass over the samples of the first component for each history: the floor.
BatchScheme one_pass(std::span<const TrialBatch> batches);

/// Schemes taking turns on each batch. The time of a history is that on the core, for 8,000
/// samples of the record: the least of `rounds`, by the batch's number of histories.
std::vector<SchemeResult> run_trial(std::span<const TrialBatch> batches,
                                    const std::vector<BatchScheme>& schemes, std::size_t rounds);

/// 0 ... count - 1, each once, neighbours far apart. Always the same.
std::vector<std::size_t> scattered(std::size_t count, std::size_t start);

}  // namespace glissade::bench
