// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/parallel/communicator.hpp"

namespace glissade::cli {

struct RunOptions {
  std::string study;
  std::string out;
  bool dry_run = false;
  bool no_skip = false;
  bool overwrite = false;
  bool quiet = false;  ///< no summary on the screen
};

/// What `glissade run` does. Throws ExitStatus where a rank cannot go on.
void run_study(const RunOptions& options, const Communicator& world);

}  // namespace glissade::cli
