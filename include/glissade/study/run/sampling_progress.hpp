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
  explicit SamplingProgress(const Plan& plan)
      : plan_(plan),
        capacities_{plan.records.size(),
                    plan.cases.size(),
                    plan.config.intensity.levels.size(),
                    plan.config.thresholds_m().size(),
                    {}} {}
  /// Takes the units of the next block, which must all be there; others are left.
  void add_block(const std::vector<UnitResult>& units);
  bool is_enough() const;

 private:
  const Plan& plan_;
  HistoryTable capacities_;  ///< of the blocks that were taken; nothing else
  BlockMedians medians_;
};

}  // namespace glissade
