// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/parallel/together.hpp"
#include "run/run_record.hpp"

// What a run does around its histories.
namespace glissade::cli {

/// Root's motions to everybody; their samples are stored once on each machine.
void share(std::vector<Suite>& suites, const Communicator& world);

/// Root's lists and hash to everybody; the lists are stored once on each machine.
void share(Plan& plan, const Communicator& world);

/// Every rank makes its cases by their numbers; another mathematical library could make others.
void check_same_plan(const Plan& plan, const Communicator& world);

/// Throws InputError where the disk of the folder has too little room for what the plan leaves.
void check_room(const std::filesystem::path& folder, const Plan& plan);

/// Throws InputError where a run cannot begin in the folder: a run is going on in it, one was
/// stopped or killed and can be resumed, or it holds other files.
void check_run_folder(const std::filesystem::path& folder, bool overwrite);

/// A folder that `run --part` left.
struct FinishedPart {
  std::filesystem::path folder;
  RunIdentity begun;
};

/// For `merge`: throws InputError unless the folders are all parts of one run, and finished.
std::vector<FinishedPart> read_parts(const std::vector<std::string>& folders);

/// Throws InputError that names each difference of a part from the run that they are merged to.
void check_parts(const std::vector<FinishedPart>& parts, const RunIdentity& run);

/// Ends a part of a run, on root: run.json and a line state what is done with it.
void end_part(const std::filesystem::path& folder, const PlanPart& part, std::uint64_t units);

/// Before hours of work: the folder is there, has room for the results, and no other run can take
/// it. With `overwrite` an earlier run in it is removed. The run begins with the units of `parts`.
std::unique_ptr<RunLock> take_run_folder(const std::filesystem::path& folder, const Plan& plan,
                                         const RunIdentity& run, bool overwrite,
                                         const std::vector<FinishedPart>& parts);

/// Whether the run in the folder has its results, and they are whole.
bool has_results(const std::filesystem::path& folder);

/// The folder of a run that was stopped or killed, for its resumption.
struct StoppedRun {
  std::unique_ptr<RunLock> lock;
  RunIdentity begun;
};
/// Throws InputError where there is none. Where the run has its results, which are checked, the
/// report is made if it is missing; then ExitStatus 0, or InputError if it was of another study.
/// @param study the study file to resume with; empty: as the run began
StoppedRun take_stopped_run(const std::filesystem::path& folder,
                            const std::filesystem::path& study);

/// Made on root once the results folder is taken. Where an exception of any kind ends the
/// run before its results are written, on any rank, it leaves the folder as it can be used: with
/// units in a journal the run can be resumed; without the folder is given back as it was before.
class RunFolderGuard {
 public:
  /// @param folder empty: none was taken
  explicit RunFolderGuard(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~RunFolderGuard();
  RunFolderGuard(const RunFolderGuard&) = delete;
  RunFolderGuard& operator=(const RunFolderGuard&) = delete;

 private:
  std::filesystem::path folder_;
  int exceptions_ = std::uncaught_exceptions();
};

/// "glissade run --resume DIR".
std::string resume_command(const std::filesystem::path& folder);

/// Where this fails, the histories in the journals are kept: the error states how to go on.
template <class Work>
void keeping_units(const std::filesystem::path& folder, Work work) {
  try {
    work();
  } catch (const InputError& error) {
    ProblemList problems;
    problems.add(error);
    if (has_units(folder)) {
      problems.add({folder.string(), "keeps the histories that were finished",
                    "then go on with: " + resume_command(folder), ""});
    }
    problems.throw_if_any();
  }
}

/// Ends a run that was stopped, on root: run.json and the message state how it goes on.
[[noreturn]] void end_stopped(const std::filesystem::path& folder, const std::string& reason,
                              std::uint64_t done_units, std::uint64_t units);

/// Writes what is made of results, and can be made again of them: an error states how, and so does
/// the end by a signal, which gnuplot and WeasyPrint receive too (ExitStatus 75).
/// @param kept what is there whole, and in which words; @param way_on the command
void write_beside(const std::filesystem::path& kept, const char* words, const std::string& way_on,
                  const std::function<void()>& write);

/// "Seconds on 2 ranks: 6.03 (motions 1.20, ...)".
void print_seconds(const PhaseClock& clock, int ranks);
/// Where everything is.
void print_where(const std::filesystem::path& folder);

}  // namespace glissade::cli
