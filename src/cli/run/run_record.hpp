// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "glissade/study/plan/skip.hpp"
#include "glissade/study/results.hpp"
#include "glissade/study/run/work_count.hpp"

namespace glissade::cli {

/// Seconds by phase of a run.
class PhaseClock {
 public:
  /// Ends the phase that began at the last call (or at construction).
  void end_phase(const std::string& name);
  const std::vector<std::pair<std::string, double>>& phases() const { return phases_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, double>> phases_;
};

/// "2026-01-31T12:00:00Z".
std::string now_utc();

/// A run.json, an object; null where it is not there, is no regular file, or not JSON as a run
/// writes it (larger, or nested deeper).
nlohmann::ordered_json read_run_json(const std::filesystem::path& run_json_file);

/// How far a run or a calculation is.
enum class RunState { none, started, stopped, part_finished, unreported, finished };
/// As it stands in run.json: "started".
const char* name_of(RunState state);
/// What a run.json states; none where it is not there or not as a run writes it.
RunState state_in(const std::filesystem::path& run_json_file);
/// The results are written, and to be checked; the report may be missing.
bool has_results(RunState state);
/// Puts a run that began, as run.json has it, in another state, with what is to be said of that.
void put_state(const std::filesystem::path& run_json_file, RunState state,
               const nlohmann::ordered_json& more);

/// run.json while a run is under way, or was killed: its folder is taken.
std::string started_json(const std::string& study_name, const std::string& plan_hash);

/// The report that was missing is there.
void put_reported(const std::filesystem::path& run_json_file);

/// Empty where it states none.
std::string plan_hash_in(const std::filesystem::path& run_json_file);

/// run.json: when, where, on how many ranks, how long, and what was skipped: all that results.h5
/// must not contain.
/// @param what_to_do to make the report, which is missing; empty: the run is finished
/// @param resumed units that earlier sessions of the run had finished
/// @param other_ranks_mb the largest peak_memory_mb() of ranks other than this; 0: there are none
std::string run_json(const Results& results, const std::vector<Skip>& skips,
                     const PhaseClock& clock, int ranks, const WorkCount& count,
                     std::uint64_t resumed, double other_ranks_mb, const std::string& what_to_do);

/// The largest memory that this process has had so far.
double peak_memory_mb();

/// The skips in a run.json; none where there is no such file. Throws InputError where the file
/// is not one that a run wrote.
std::vector<Skip> skips_in(const std::filesystem::path& run_json_file);

}  // namespace glissade::cli
