// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "cli/killed_run.hpp"

namespace glissade::test {

/// Who gets SIGKILL. `program`: it runs without mpirun.
enum class Victim { program, root, last_rank, all_ranks, mpirun };

struct Kill {
  Victim victim = Victim::program;
  int ranks = 1;
  std::function<bool(const std::filesystem::path& out)> moment;
};

/// What came of it.
struct Killed {
  bool under_way = false;  ///< the run had not ended before
  std::uintmax_t journal_bytes = 0;
};

/// The processes of the ranks of a running mpirun, by rank.
std::vector<int> ranks_of(const Child& mpirun);

/// Runs a study until the moment, kills, and waits until no process of the run is left.
Killed kill_run(const std::string& study, const std::filesystem::path& out, const Kill& kill);

}  // namespace glissade::test
