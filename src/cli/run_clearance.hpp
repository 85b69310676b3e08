// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/parallel/communicator.hpp"

namespace glissade::cli {

struct ClearanceRun {
  std::filesystem::path study, out;
  bool dry_run = false, overwrite = false;
};

/// Runs a clearance study: its histories, one record in one orientation at a time on each rank, its
/// results and its report.
void run_clearance(const ClearanceRun& run, const Communicator& world);

}  // namespace glissade::cli
