// SPDX-License-Identifier: GPL-3.0-or-later
#include "mpi/kill.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "mpi/mpirun.hpp"

namespace glissade::test {

namespace fs = std::filesystem;

std::vector<int> ranks_of(const Child& mpirun) {
  const std::string process = "/proc/" + std::to_string(mpirun.pid());
  std::vector<int> ranks;
  std::error_code ignored;
  for (const auto& thread : fs::directory_iterator(process + "/task", ignored)) {
    std::istringstream children(read_file(thread.path() / "children"));
    for (int child = 0; children >> child;) ranks.push_back(child);
  }
  std::ranges::sort(ranks);  // mpirun starts them by rank
  return ranks;
}

namespace {

std::vector<int> victims(const Child& child, Victim victim, const std::vector<int>& ranks) {
  if (victim == Victim::program || victim == Victim::mpirun || ranks.empty()) return {child.pid()};
  if (victim == Victim::root) return {ranks.front()};
  if (victim == Victim::last_rank) return {ranks.back()};
  return ranks;
}

/// A killed mpirun is not there to end its ranks; they notice it by themselves.
void wait_for_end_of(const std::vector<int>& processes) {
  for (const int process : processes) {
    while (::kill(process, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

Killed kill_run(const std::string& study, const fs::path& out, const Kill& kill) {
  const std::vector<std::string> run{"run", study, "--out", out.string()};
  std::vector<std::string> alone = run;
  alone.insert(alone.begin(), GLISSADE_PROGRAM);
  const bool by_itself = kill.victim == Victim::program;
  Child child(by_itself ? alone : mpirun_command(kill.ranks, run));
  Killed killed;
  killed.under_way = reaches(child, [&] { return kill.moment(out); });
  if (!killed.under_way) return killed;
  const std::vector<int> ranks = by_itself ? std::vector<int>() : ranks_of(child);
  for (const int victim : victims(child, kill.victim, ranks)) ::kill(victim, SIGKILL);
  child.wait();
  wait_for_end_of(ranks);
  killed.journal_bytes = journal_bytes(out);
  return killed;
}

}  // namespace glissade::test
