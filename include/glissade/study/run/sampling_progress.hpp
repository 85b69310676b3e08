// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {

/// After which of its blocks of samples a run is precise enough (sampling.target_error): a free
/// function of the complete blocks, whichever ranks and sessions ran them.
class SamplingProgress {
 public:
  explicit SamplingProgress(const Plan& plan);
  void add(const UnitResult& unit);
  /// The units of the next block are all added.
  void end_block();
  bool is_enough() const;

 private:
  HistoryValues<double>::iterator place(std::size_t record, std::size_t c);
  const Plan& plan_;
  HistoryTable capacities_;  ///< of the units that were added; nothing else
  BlockMedians medians_;
};

}  // namespace glissade
