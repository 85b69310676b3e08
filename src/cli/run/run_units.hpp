// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "glissade/io/journal.hpp"
#include "glissade/parallel/communicator.hpp"
#include "glissade/study/run/history_assembly.hpp"
#include "glissade/study/run/roof_store.hpp"
#include "glissade/study/run/sampling_progress.hpp"
#include "run/stop_request.hpp"

namespace glissade::cli {

/// What the ranks have computed, on root. It is put together as units come, and a rank does not
/// hold those that it has journalled.
struct RunHistories {
  /// @param folder of the results: what does not fit into memory is in pages there
  RunHistories(const Plan& plan, const std::filesystem::path& folder)
      : histories(plan, folder), sampling(plan) {}
  void add(const UnitResult& unit) {
    histories.add(unit);
    sampling.add(unit);
    ++units;
  }

  HistoryAssembly histories;
  SamplingProgress sampling;
  std::size_t units = 0;  ///< of the part of the plan, or of its first blocks
                          ///< where these are enough
  std::vector<std::vector<double>> motion_parts;  ///< for reduce()
  double other_ranks_mb = 0.0;                    ///< the largest memory of a rank other than root
};

/// The units of a part of the plan that are missing, which the ranks share and journal.
struct UnitRun {
  const Plan& plan;
  const PlanPart& part;
  Skipping skipping;
  std::optional<RunHistories>& at_root;  ///< with the units of earlier sessions; none on the others
  JournalWriter journal;
  StopRequest& stop;
  const std::filesystem::path& folder;
  const Communicator& world;

  /// Collective. Throws ExitStatus on every rank where the run is stopped before all are done.
  void run();
};

}  // namespace glissade::cli
