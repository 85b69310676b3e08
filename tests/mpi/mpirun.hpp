// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "cli/child.hpp"

namespace glissade::test {

/// Also prepares the environment: more ranks than cores, as root in a container, without the
/// kernel's single-copy path.
inline bool mpirun_is_there() {
  for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                           "OMPI_MCA_rmaps_base_oversubscribe", "OMPI_MCA_mpi_yield_when_idle"}) {
    setenv(name, "1", 1);
  }
  setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
  return run_shell("command -v mpirun").status == 0;
}

inline std::vector<std::string> mpirun_command(int ranks, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"mpirun", "-n", std::to_string(ranks), GLISSADE_PROGRAM});
  return arguments;
}

inline Finished run_on(int ranks, std::vector<std::string> arguments) {
  return run_child(mpirun_command(ranks, std::move(arguments)));
}

}  // namespace glissade::test
