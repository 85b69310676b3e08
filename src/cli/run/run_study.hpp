// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "glissade/parallel/communicator.hpp"
#include "glissade/study/plan/plan.hpp"

namespace glissade::cli {

struct RunOptions {
  std::string study, out;
  std::string resume;              ///< the folder of a run to go on with; then `out` is empty
  std::vector<std::string> merge;  ///< the folders of finished parts of the run
  PlanPart part;                   ///< to run; the folder then holds its journals only
  double walltime_s = std::numeric_limits<double>::infinity();
  bool dry_run = false;
  bool no_skip = false;
  bool overwrite = false;
  bool quiet = false;                    ///< no summary on the screen
  std::filesystem::path made_of = {};    ///< the project file of the study; empty: the user's own
  std::filesystem::path stop_file = {};  ///< beside `stop` in the folder; empty: none

  std::filesystem::path folder() const;  ///< of the results
};

/// What `glissade run` does. Throws ExitStatus where a rank cannot go on, or the run is stopped.
void run_study(RunOptions options, const Communicator& world);

}  // namespace glissade::cli
