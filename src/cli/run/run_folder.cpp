// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "clearance/calculation_record.hpp"
#include "glissade/core/bytes.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/report/results_folder.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/run/exchange.hpp"
#include "run/stop_request.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {

namespace fs = std::filesystem;

void share(std::vector<Suite>& suites, const Communicator& world) {
  if (world.size() == 1) return;
  PackedSuites packed = pack(std::exchange(suites, {}));
  world.broadcast(packed.headers);
  suites = unpack_suites(packed.headers, world.on_each_machine(std::move(packed.samples_mps2)));
}

void share(Plan& plan, const Communicator& world) {
  if (world.size() == 1) return;
  std::vector<char> bytes = ByteWriter()
                                .put(plan.hash)
                                .put(plan.unit_ends)
                                .put(plan.roofs_are_kept)
                                .put(plan.frictions_repeat)
                                .take();
  world.broadcast(bytes);
  ByteReader(bytes)
      .get(plan.hash)
      .get(plan.unit_ends)
      .get(plan.roofs_are_kept)
      .get(plan.frictions_repeat);
  const auto share_list = [&](auto& list) {
    using List = std::remove_reference_t<decltype(list)>;
    list = List::elsewhere(world.on_each_machine(list.copy()));
  };
  share_list(plan.order);
  share_list(plan.building);
  share_list(plan.by_building);
  share_list(plan.first_on);
  share_list(plan.units);
}

void check_same_plan(const Plan& plan, const Communicator& world) {
  const std::string hash = fingerprint(plan);
  const auto hashes = world.gather({hash.begin(), hash.end()});
  on_root(world, [&] {
    for (const std::vector<char>& other : hashes) {
      if (hash == std::string(other.begin(), other.end())) continue;
      throw InputError({"", "the ranks make different plans of one study",
                        "run them on one kind of machine", ""});
    }
  });
}

void check_room(const fs::path& folder, const Plan& plan) {
  // The journals and the pages of the first rank hold what the results hold; and figures, tables,
  // report.
  const double needed = 3.0 * bytes_of(plan.config, plan.records.size(), plan.cases.size()) + 20e6;
  std::error_code error;
  const fs::space_info space = fs::space(existing_part(folder), error);
  if (!error && static_cast<double>(space.available) < needed) {
    throw InputError(
        {folder.string(),
         fmt::format("the disk has {:.0f} MB free and the results need about {:.0f} MB",
                     static_cast<double>(space.available) / 1e6, needed / 1e6),
         "make room, or give a folder on another disk with --out", ""});
  }
}

namespace {

/// A run, or a merge that copied journals, was killed before it stated what it is: nothing that it
/// computed is lost with its folder.
bool was_killed_at_its_begin(const fs::path& folder) {
  const fs::path journal = folder / "journal";
  return fs::is_directory(status_of(folder)) && files_in(folder) == std::vector{journal} &&
         !has_identity(folder) && std::ranges::all_of(files_in(journal), [](const fs::path& file) {
           return file.filename() == "lock" || file.extension() == ".units" ||
                  whole_name(file.filename()) == "run";
         });
}

/// Why the results of a run that states them cannot be relied on; nothing: they can.
std::optional<InputError> fault_of_results(const fs::path& folder) {
  const fs::path file = folder / "results.h5", run_json = folder / "run.json";
  try {
    if (read_origin(file).plan_hash == plan_hash_in(run_json)) return {};
    return InputError({file.string(), "is of another run than " + run_json.string(), "", ""});
  } catch (const IoError&) {
    throw;
  } catch (const InputError& error) {
    return error;
  }
}

}  // namespace

std::string resume_command(const fs::path& folder) {
  const fs::path above = folder.parent_path();  // of a calculation, with its package
  return is_calculation(above) && !is_finished_calculation(above)
             ? resume_calculation_command(above)
             : "glissade run --resume " + quoted_for_shell(folder.string());
}

void check_run_folder(const fs::path& folder, bool overwrite) {
  check_own(folder);
  if (is_running(folder)) {
    throw InputError({"--out", folder.string() + ": a run is going on in it",
                      "wait until it ends, or give another --out", ""});
  }
  if (!overwrite && has_identity(folder)) {
    throw InputError(
        {"--out", folder.string() + " holds a run that was stopped or killed, or a part of one",
         "go on with: " + resume_command(folder) + ", or give another --out, or --overwrite", ""});
  }
  check_output_folder(folder, overwrite || was_killed_at_its_begin(folder));
}

std::unique_ptr<RunLock> take_run_folder(const fs::path& folder, const Plan& plan,
                                         const RunIdentity& run, bool overwrite,
                                         const std::vector<FinishedPart>& parts) {
  check_run_folder(folder, overwrite);
  check_room(folder, plan);
  auto lock = take_folder(folder);
  std::error_code ignored;
  try {
    lock->empty();
    for (const char* name : {"run.json", "results.h5", "stop"}) remove_file(folder / name);
    remove_listed(folder);
    for (const FinishedPart& part : parts) copy_journals(part.folder, folder);
    write_identity(folder, run);
    create_text_file(folder / "run.json", started_json(plan.config.name, plan.hash));
  } catch (...) {
    lock->remove_journals();
    fs::remove(folder, ignored);  // if empty
    throw;
  }
  return lock;
}

namespace {

/// A finished run removes its journal, but not that of another.
void check_journal_is_of(const fs::path& results_file, const fs::path& folder) {
  if (!has_identity(folder) ||
      read_identity(folder).plan_hash == read_origin(results_file).plan_hash)
    return;
  throw InputError({(folder / "journal").string(),
                    "is of another run than " + results_file.string(),
                    "move the journal, or results.h5 and run.json, to another folder", ""});
}

/// The report that is missing is made.
[[noreturn]] void end_finished(const fs::path& folder, const fs::path& study) {
  const fs::path results_file = folder / "results.h5", run_json = folder / "run.json";
  check_journal_is_of(results_file, folder);
  if (!study.empty()) {
    check_same_study(read_origin(results_file).study_text, study, read_study(study).source_text,
                     folder);
  }
  const bool lacks_report =
      state_in(run_json) == RunState::unreported || !is_there(folder / "report.html");
  if (lacks_report || is_there(folder / "journal")) {
    const std::unique_ptr<RunLock> lock = take_folder(folder);
    if (lacks_report) {
      write_report(read_results(results_file), folder, skips_in(run_json));
      put_reported(run_json);
    }
    lock->remove_journals();
  }
  put("{} is finished{}\n", folder.string(), lacks_report ? ": its report was made" : "");
  throw ExitStatus{0};
}

[[noreturn]] void refuse_resume(const fs::path& folder, const std::optional<InputError>& fault) {
  const std::string anew = "glissade run STUDY.toml --out " + quoted_for_shell(folder.string());
  std::vector<Problem> problems;
  if (fault) {
    problems = fault->problems();
    problems.push_back({folder.string(), "holds no journal to make the results again from",
                        "run the study again: " + anew + " --overwrite", ""});
  } else if (was_killed_at_its_begin(folder)) {
    problems.push_back({folder.string(), "holds a run that was killed before its first unit",
                        "begin it again: " + anew, ""});
  } else {
    problems.push_back({folder.string(), "holds no run that can be resumed",
                        "give the folder of a run that was stopped, or run the study anew", ""});
  }
  throw InputError(std::move(problems));
}

}  // namespace

bool has_results(const fs::path& folder) {
  return has_results(state_in(folder / "run.json")) && !fault_of_results(folder);
}

StoppedRun take_stopped_run(const fs::path& folder, const fs::path& study) {
  check_own(folder);
  std::optional<InputError> fault;
  if (has_results(state_in(folder / "run.json"))) {
    fault = fault_of_results(folder);
    if (!fault) end_finished(folder, study);
  }
  if (!has_identity(folder)) refuse_resume(folder, fault);
  StoppedRun run{take_folder(folder), read_identity(folder)};
  if (fault) {
    const Problem& problem = fault->problems().front();
    put("{}: {}: made again from the journal\n", problem.where, problem.what);
  }
  remove_file(folder / "stop");
  return run;
}

namespace {

void leave(const fs::path& folder) noexcept {
  try {
    const fs::path run_json = folder / "run.json";
    if (state_in(run_json) != RunState::started) return;
    if (has_units(folder)) {
      put_state(run_json, RunState::stopped,
                {{"stopped_by", "an error"},
                 {"stopped_utc", now_utc()},
                 {"what_to_do", resume_command(folder)}});
    } else {
      std::error_code ignored;
      fs::remove(run_json, ignored);
      remove_journals(folder);
      fs::remove(folder, ignored);  // if empty
    }
  } catch (const std::exception&) {  // run.json stays "started"
  }
}

}  // namespace

RunFolderGuard::~RunFolderGuard() {
  if (!folder_.empty() && std::uncaught_exceptions() > exceptions_) leave(folder_);
}

namespace {
constexpr int stopped_status = 75;  // EX_TEMPFAIL of sysexits.h: try again
}  // namespace

void write_beside(const fs::path& kept, const char* words, const std::string& way_on,
                  const std::function<void()>& write) {
  try {
    write();
  } catch (const InputError& error) {
    if (const std::string signal = received_signal(); !signal.empty())
      throw ExitStatus{stopped_status, fmt::format("stopped by {}; {} {}. Go on with: {}", signal,
                                                   kept.string(), words, way_on)};
    ProblemList problems;
    problems.add(error);
    problems.add({kept.string(), words, "make the rest again with: " + way_on, ""});
    problems.throw_if_any();
  }
}

void end_stopped(const fs::path& folder, const std::string& reason, std::uint64_t done_units,
                 std::uint64_t units) {
  std::error_code ignored;
  fs::remove(folder / "stop", ignored);
  put_state(folder / "run.json", RunState::stopped,
            {{"stopped_by", reason},
             {"stopped_utc", now_utc()},
             {"units_done", done_units},
             {"units", units},
             {"what_to_do", resume_command(folder)}});
  throw ExitStatus{stopped_status,
                   fmt::format("stopped by {}; {} of {} units are done and kept. Go on with: {}",
                               reason, done_units, units, resume_command(folder))};
}

namespace {

/// What is wrong with a folder as a part; empty: nothing.
Problem part_problem(const fs::path& folder, const RunIdentity& begun) {
  if (is_running(folder))
    return {folder.string(), "a run is going on in it", "wait until it ends", ""};
  if (begun.part.is_all())
    return {folder.string(), "holds a whole run, not a part of one",
            "give folders of glissade run --part", ""};
  if (state_in(folder / "run.json") != RunState::part_finished)
    return {folder.string(), "its part of the run is not finished",
            "go on with: " + resume_command(folder), ""};
  return {};
}

}  // namespace

std::vector<FinishedPart> read_parts(const std::vector<std::string>& folders) {
  ProblemList problems;
  std::vector<FinishedPart> parts;
  std::map<std::uint64_t, std::string> folder_of;  // by number of the part
  for (const std::string& folder : folders) {
    try {
      check_own(folder);
      parts.push_back({folder, read_identity(folder)});
    } catch (const InputError& error) {
      problems.add(error);
      continue;
    }
    const RunIdentity& begun = parts.back().begun;
    const Problem problem = part_problem(folder, begun);
    if (!problem.what.empty()) {
      problems.add(problem);
      continue;
    }
    if (begun.part.count != parts.front().begun.part.count) {
      problems.add({folder,
                    fmt::format("is a part of {}, {} a part of {}", begun.part.count,
                                folders.front(), parts.front().begun.part.count),
                    "merge the parts of one run", ""});
    }
    const auto [first, is_new] = folder_of.emplace(begun.part.number, folder);
    if (!is_new) {
      problems.add({folder,
                    fmt::format("is part {} of {}, as {} is", begun.part.number, begun.part.count,
                                first->second),
                    "give each part once", ""});
    }
  }
  problems.throw_if_any();
  const std::uint64_t count = parts.front().begun.part.count;
  for (std::uint64_t number = 1; number <= count; ++number) {
    if (folder_of.contains(number)) continue;
    problems.add({"merge", fmt::format("part {} of {} is missing", number, count),
                  fmt::format("give its folder, or run it with --part {}/{}", number, count), ""});
  }
  problems.throw_if_any();
  return parts;
}

void check_parts(const std::vector<FinishedPart>& parts, const RunIdentity& run) {
  ProblemList problems;
  for (const FinishedPart& part : parts) {
    try {
      check_same_run(part.begun, run, part.folder);
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
}

void end_part(const fs::path& folder, const PlanPart& part, std::uint64_t units) {
  put_state(folder / "run.json", RunState::part_finished,
            {{"units_done", units}, {"finished_utc", now_utc()}});
  put("Part {} of {} is finished: {} units are kept in {}. When all parts are, merge them with: "
      "glissade merge FOLDERS OF THE PARTS --out DIR\n",
      part.number, part.count, units, folder.string());
}

void print_seconds(const PhaseClock& clock, int ranks) {
  std::string phases;
  double total = 0.0;
  for (const auto& [phase, seconds] : clock.phases()) {
    phases += fmt::format("{}{} {:.2f}", phases.empty() ? "" : ", ", phase, seconds);
    total += seconds;
  }
  put_lines(fmt::format("Seconds on {}: {:.2f} ({})",
                        counted(static_cast<std::size_t>(ranks), "rank"), total, phases),
            2);
}

void print_where(const fs::path& folder) {
  put("Report   {}\nResults  {}\nTables   {}\nFigures  {}\nRun      {}\n",
      (folder / "report.html").string(), (folder / "results.h5").string(),
      (folder / "tables").string(), (folder / "figures").string(), (folder / "run.json").string());
}

}  // namespace glissade::cli
