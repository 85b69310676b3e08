// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/io/journal.hpp"
#include "glissade/parallel/communicator.hpp"
#include "glissade/study/run/roof_store.hpp"
#include "run/stop_request.hpp"

namespace glissade::cli {

/// What the ranks have computed, on root.
struct RunParts {
  std::vector<UnitResult>
      units;  ///< of the part of the plan, or of its first blocks where these are enough
  std::vector<std::vector<double>> motion_parts;  ///< for reduce()
  double other_ranks_mb = 0.0;                    ///< the largest memory of a rank other than root
};

/// The units are those of earlier sessions, and the others, which the ranks share and journal.
/// Collective. Throws ExitStatus on every rank where the run is stopped before all are done.
/// @param earlier on root
RunParts run_units(const Plan& plan, const PlanPart& part, Skipping skipping, Journal earlier,
                   JournalWriter writer, StopRequest& stop, const std::filesystem::path& folder,
                   const Communicator& world);

}  // namespace glissade::cli
