// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/parallel/communicator.hpp"
#include "run/run_record.hpp"

// What a run does around its histories.
namespace glissade::cli {

/// Root prepares what may fail on the user's input, and sends the outcome to the other ranks.
template <class Prepare>
void on_root(const Communicator& world, Prepare prepare) {
  std::vector<char> ok(1, 1);
  if (world.is_root()) {
    try {
      prepare();
    } catch (const InputError& error) {
      fmt::print(stderr, "glissade: {}\n", error.what());
      ok[0] = 0;
    }
  }
  world.broadcast(ok);
  if (ok[0] == 0) throw ExitStatus{2};
}

/// Root's motions to everybody.
void share(std::vector<Suite>& suites, const Communicator& world);

/// Every rank makes the plan itself; other processors or mathematical libraries could make another.
void check_same_plan(const std::string& hash, const Communicator& world);

/// Before hours of work: the folder is there, has room for the results, and no other run can take
/// it. With `overwrite` an earlier run in it is removed.
void take_results_folder(const std::filesystem::path& folder, double bytes_of_results,
                         const std::string& run_json, bool overwrite);

/// Made on every rank once the results folder is taken. Where an exception of any kind ends the
/// run, on any rank, it gives the folder back: without results.h5 the run.json of
/// take_results_folder goes, and the folder if it is then empty, so that it can be taken again;
/// with results.h5 run.json states that the results are complete and how to make the report.
class ResultsFolderGuard {
 public:
  /// @param folder empty: none was taken
  ResultsFolderGuard(std::filesystem::path folder, const Communicator& world);
  ~ResultsFolderGuard();
  ResultsFolderGuard(const ResultsFolderGuard&) = delete;
  ResultsFolderGuard& operator=(const ResultsFolderGuard&) = delete;

 private:
  std::filesystem::path folder_;
  Communicator world_;
  int exceptions_ = std::uncaught_exceptions();
};

/// What is made from the results can be made again: the error states how.
template <class Write>
void write_beside_results(const std::filesystem::path& folder, Write write) {
  try {
    write();
  } catch (const InputError& error) {
    const std::string results = (folder / "results.h5").string();
    ProblemList problems;
    problems.add(error);
    problems.add({results, "is complete",
                  "make the rest again with: glissade report --overwrite " + results, ""});
    problems.throw_if_any();
  }
}

/// "Seconds on 2 ranks: 6.03 (motions 1.20, ...)".
void print_seconds(const PhaseClock& clock, int ranks);
/// Where everything is.
void print_where(const std::filesystem::path& folder);

}  // namespace glissade::cli
