// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/parallel/communicator.hpp"

namespace glissade::cli {

struct ConvergenceRun {
  std::filesystem::path study, out;
  bool dry_run = false;
};

/// Runs a convergence study: its histories, one record at a time on each rank, its results and its
/// report.
void run_convergence(const ConvergenceRun& run, const Communicator& world);

}  // namespace glissade::cli
