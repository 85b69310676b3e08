// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/io/journal.hpp"
#include "glissade/parallel/communicator.hpp"
#include "glissade/study/run/roof_store.hpp"
#include "run/stop_request.hpp"

namespace glissade::cli {

/// Every unit of the plan, or of its first blocks of samples where these are enough, on root: those
/// of earlier sessions, and the others, which the ranks share and journal. Collective. Throws
/// ExitStatus on every rank where the run is stopped before all are done.
/// @param earlier on root
std::vector<UnitResult> run_units(const Plan& plan, Skipping skipping, Journal earlier,
                                  JournalWriter writer, StopRequest& stop,
                                  const std::filesystem::path& folder, const Communicator& world);

}  // namespace glissade::cli
