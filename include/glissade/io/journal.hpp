// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/execute.hpp"

// The journals of a run: what its ranks have finished, on the disk while the run goes on, in the
// folder `journal` of its results folder. A file for each writer, to which it only appends; a run
// that is resumed begins new ones. Every record has its length and a checksum, so that what a
// killed writer left is read up to its last whole record.
namespace glissade {

/// What a run rests on: written when it begins, compared when it is resumed.
struct RunIdentity {
  std::string program_version, plan_hash;
  std::string mathematics;  ///< core/mathematics.hpp
  std::string layout;       ///< unit_layout() of the plan
  std::filesystem::path study_file;
  std::string study_text;
  std::string motions_text;  ///< of the plan; rank 0 only
  PlanPart part = {};
};

RunIdentity identity_of(const Plan& plan, const std::string& program_version);

void write_identity(const std::filesystem::path& run_folder, const RunIdentity& run);
/// Throws InputError where no run began in the folder, or its journal is not whole.
RunIdentity read_identity(const std::filesystem::path& run_folder);
/// Whether a run began in the folder and its journal is still there. Throws InputError where that
/// cannot be seen.
bool has_identity(const std::filesystem::path& run_folder);

/// Throws InputError that names each difference, if another run began than the one that is to be
/// resumed.
void check_same_run(const RunIdentity& begun, const RunIdentity& now,
                    const std::filesystem::path& run_folder);

/// The same of the text of its study alone, where that is all that is left of a run.
void check_same_study(const std::string& begun, const std::filesystem::path& file,
                      const std::string& now, const std::filesystem::path& run_folder);

/// Copies the journals of one run folder beside those of another.
void copy_journals(const std::filesystem::path& from, const std::filesystem::path& to);

/// Whether any unit is in the journals.
bool has_units(const std::filesystem::path& run_folder);

/// Held while a command writes into a results folder, of a run by rank 0: two processes cannot hold
/// that of one folder, and the system takes it back when the process ends in any way. It is a file
/// in the folder of the journals, which goes with it where there are none.
class RunLock {
 public:
  /// Makes the folder. Throws InputError where another process holds it.
  explicit RunLock(const std::filesystem::path& run_folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  /// Throws InputError where the folder was removed or moved since it was taken.
  void check() const;
  /// As the destructor does; throws InputError where check() does, or the file cannot be removed.
  void give_back();
  /// Removes the journals of an earlier run.
  void empty();
  /// The same, and gives the lock back: the run has its results, or none are wanted.
  void remove_journals();

 private:
  std::filesystem::path folder_;
  int fd_;
};

/// Whether a process holds the lock of a folder. It is not taken for that: a run that begins
/// meanwhile is not refused.
bool is_running(const std::filesystem::path& run_folder);

/// Removes the journals of a run that ends without units, by whichever rank.
void remove_journals(const std::filesystem::path& run_folder);

/// Appends the units of one rank. A unit is given to the system at once, so that it outlives the
/// process, and is on the disk within `seconds_to_disk`. Failures are InputErrors.
class JournalWriter {
 public:
  static constexpr int seconds_to_disk = 5;
  /// The file is made with the first unit, by a name that no writer had before.
  JournalWriter(const std::filesystem::path& run_folder, int rank, const RunIdentity& run);
  JournalWriter(JournalWriter&&) noexcept;
  ~JournalWriter();
  void append(const UnitResult& unit);
  void sync();  ///< all units are on the disk on return
  /// The message of the next unit that was appended, from the first on: a rank does not hold what
  /// its journal holds. Precondition: there is one.
  std::vector<char> read_next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads every journal of the folder and gives each of its units once. Throws InputError for those
/// of another run. Files may hold anything: nothing larger than a unit of the plan is allocated for
/// a record. @return the bytes that are not whole records
std::uint64_t read_journals(const std::filesystem::path& run_folder, const RunIdentity& run,
                            const Plan& plan, const std::function<void(const UnitResult&)>& take);

}  // namespace glissade
