// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "commands.hpp"
#include "glissade/core/bytes.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/io/product_file.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/parallel/threads.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/plan/history_cost.hpp"
#include "glissade/study/run/reduce.hpp"
#include "run/run_folder.hpp"
#include "run/run_record.hpp"
#include "run/run_study.hpp"
#include "run/run_units.hpp"
#include "run/stop_request.hpp"
#include "shared/build.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// Every suite's problems, reported together.
std::vector<Suite> load_suites(const std::vector<fs::path>& files) {
  ProblemList problems;
  std::vector<Suite> suites;
  for (const fs::path& file : files) {
    try {
      suites.push_back(load_suite(file));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
  return suites;
}

/// On root, by threads on the processors of all ranks of its machine.
void on_root_threads(const Communicator& world, const std::function<void()>& work) {
  const LentProcessors lent(world);
  on_root(world, [&] { tbb::task_arena(startable_threads(lent.threads())).execute(work); });
}

/// What root does with the histories of all ranks.
void write_all(const Plan& whole, RunHistories& all, std::uint64_t resumed,
               const RunOptions& options, StopRequest& stop, const RunLock& lock, PhaseClock& clock,
               int ranks) {
  const fs::path out = options.folder();
  std::optional<Plan> ended;
  if (all.units < whole.units.size()) ended = first_blocks(whole, all.units);
  const Plan& plan = ended ? *ended : whole;
  const WorkCount count = all.histories.count();
  const std::vector<Skip> skips = skipped(plan, count);
  const Results results = reduce(plan, all.histories.take(plan), all.motion_parts);
  clock.end_phase("analyses");
  if (stop.requested()) end_stopped(out, stop.reason(), all.units, all.units);
  keeping_units(out, [&] { write_results(out / "results.h5", results, data_tables(results)); });
  clock.end_phase("results file");
  const auto record = [&](const std::string& what_to_do) {
    write_text_file(out / "run.json", run_json(results, skips, clock, ranks, count, resumed,
                                               all.other_ranks_mb, what_to_do));
  };
  write_beside(out / "results.h5", "is complete", resume_command(out), [&] {
    record(resume_command(out));
    write_report(results, out, skips);
    clock.end_phase("report");
    lock.check();
    record("");
  });
  if (options.quiet) return;
  put("{}\n", summary_text(results, skips));
  print_seconds(clock, ranks);
  put_lines(fmt::format("Histories integrated: {} at the levels, {} in search of capacities, on {} "
                        "roof motions",
                        count.integrated, count.searched, count.roofs),
            2);
  print_where(out);
}

/// Else --overwrite would remove what is to be merged.
void check_is_none_of(const std::vector<FinishedPart>& parts, const fs::path& out) {
  for (const FinishedPart& part : parts)
    if (fs::equivalent(part.folder, out))
      throw InputError({"--out", out.string() + " is one of the parts", "give another --out", ""});
}

/// A part cannot know what the others have found.
void check_has_parts(const Plan& plan, const PlanPart& part) {
  if (part.count > plan.units.size()) {
    throw InputError({"--part",
                      fmt::format("the study has {} of work, fewer than {} parts",
                                  counted(plan.units.size(), "unit"), part.count),
                      "take fewer parts", ""});
  }
  if (part.is_all() || !plan.config.sampling.target) return;
  throw InputError({"--part", "sampling.target_error ends a run by the results of all its units",
                    "run the study without --part, or state samples and scrambles instead", ""});
}

/// Reads and simulates once, on root; the study's files and the part to everybody.
std::vector<Suite> prepare_motions(RunOptions& options, TextFiles& files, StoppedRun& stopped,
                                   std::vector<FinishedPart>& parts, const Communicator& world) {
  std::vector<Suite> suites;
  on_root_threads(world, [&] {
    if (!options.resume.empty()) {
      stopped = take_stopped_run(options.resume, options.study);
      if (options.study.empty()) options.study = stopped.begun.study_file.string();
      options.part = stopped.begun.part;
    } else if (!options.dry_run) {
      if (!options.merge.empty()) {
        parts = read_parts(options.merge);
        check_is_none_of(parts, options.folder());
        if (options.study.empty()) options.study = parts.front().begun.study_file.string();
      }
      check_run_folder(options.folder(), options.overwrite);
    }
    suites = load_suites(read_study(options.study, files).suite_files);
  });
  std::vector<char> run = ByteWriter().put(options.study).put(options.part).take();
  world.broadcast(run);
  ByteReader(run).get(options.study).get(options.part);
  std::vector<char> texts = files.packed();
  world.broadcast(texts);
  files = TextFiles(texts);
  share(suites, world);
  return suites;
}

/// Root makes the lists of the plan, and the ranks share its spectra.
/// @param made_of as of RunOptions
Plan make_shared_plan(const std::string& study, const fs::path& made_of, TextFiles files,
                      std::vector<Suite> suites, const Communicator& world) {
  Plan plan;
  together(world, [&] { plan = begin_plan(read_study(study, files), std::move(suites)); });
  std::vector<std::vector<double>> spectra_g =
      share_parts(world, spectra_to_scale(plan),
                  [&](std::size_t record) { return spectrum_to_scale(plan, record); });
  together(world, [&] { scale_plan(plan, std::move(spectra_g)); });
  check_same_plan(plan, world);
  on_root(world, [&] { with_place_of(study, made_of, [&] { finish_plan(plan); }); });
  share(plan, world);
  return plan;
}

/// Adds the units of earlier sessions, or of the parts, on root.
void read_earlier_units(const char* how, const fs::path& out, const RunIdentity& run,
                        const Plan& plan, RunHistories& done) {
  const std::uint64_t bytes_not_read =
      read_journals(out, run, plan, [&](const UnitResult& unit) { done.add(unit); });
  write_text_file(out / "run.json", started_json(plan.config.name, plan.hash));
  put("{}: {} of {} units are in the journals", how, done.units, units_of(plan, run.part).size());
  if (bytes_not_read > 0) put(", beside {} bytes that are not whole records", bytes_not_read);
  put("\n");
}

/// What would run, what it would cost, and whether its folder is free; if not, that is an error.
void check_study(const Plan& plan, const fs::path& out, bool overwrite) {
  put("{}", to_string(plan));
  put("time        roughly {:.0f} s on one core, and {:.0f} s of fits\n",
      std::ceil(plan.predicted_seconds()), std::ceil(predicted_fit_seconds(plan)));
  put("results     about {:.1f} MB of histories before compression in results.h5; as much in\n"
      "            the journals until then, and in the first rank's memory, or on the disk\n"
      "            where memory is short\n",
      bytes_of(plan.config, plan.records.size(), plan.cases.size()) / 1e6);
  check_run_folder(out, overwrite);
  check_room(out, plan);
  put("folder      {}: free\n", out.string());
}

/// "2/8".
PlanPart part_of(const std::string& text) {
  PlanPart part;
  const char* end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  const bool is_fraction = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = is_fraction ? std::from_chars(number.ptr + 1, end, part.count) : number;
  if (!is_fraction || count.ec != std::errc() || count.ptr != end || part.number < 1 ||
      part.number > part.count)
    throw CLI::ValidationError("--part", text + " is not K/N with K from 1 to N, for example 2/8");
  return part;
}

void add_merge(CLI::App& program, const Communicator& world) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand(
      "merge",
      "Put the parts of a run together that `run --part` made on several machines or jobs");
  command->add_option("parts", options->merge, "the results folder of every part")->required();
  command->add_option("--out", options->out, "results folder, new or empty")->required();
  command->add_option("--study", options->study,
                      "study file, where it has moved since [as of the first part]");
  add_overwrite(*command, options->overwrite);
  command->callback([options, world] { run_study(*options, world); });
}

}  // namespace

fs::path RunOptions::folder() const {
  if (!resume.empty()) return resume;
  return out.empty() ? fs::path("results") / fs::path(study).stem() : fs::path(out);
}

void run_study(RunOptions options, const Communicator& world) {
  const auto start = std::chrono::steady_clock::now();
  PhaseClock clock;
  std::optional<StopRequest> stop;  // signals are taken from here on
  if (!options.dry_run) {
    std::vector<fs::path> stop_files;
    if (world.is_root()) stop_files = {options.folder() / "stop"};
    if (world.is_root() && !options.stop_file.empty()) stop_files.push_back(options.stop_file);
    stop.emplace(std::move(stop_files), options.walltime_s, start);
  }
  StoppedRun stopped;               // on root, where it is resumed
  std::vector<FinishedPart> parts;  // on root, where they are merged
  TextFiles files;
  std::vector<Suite> suites = prepare_motions(options, files, stopped, parts, world);
  const fs::path out = options.folder();
  clock.end_phase("motions");

  const Plan plan =
      make_shared_plan(options.study, options.made_of, std::move(files), std::move(suites), world);
  RunIdentity identity;
  together(world, [&] { identity = identity_of(plan, GLISSADE_VERSION ", " + build_text()); });
  identity.part = options.part;
  std::optional<RunHistories> done;  // on root
  on_root(world, [&] {
    if (options.dry_run) return check_study(plan, out, options.overwrite);
    check_has_parts(plan, options.part);
    if (stopped.lock) {
      check_same_run(stopped.begun, identity, out);
      if (stopped.begun.study_file != identity.study_file) write_identity(out, identity);  // moved
    } else {
      check_parts(parts, identity);
      stopped.lock = take_run_folder(out, plan, identity, options.overwrite, parts);
    }
  });
  const RunFolderGuard guard(options.dry_run || !world.is_root() ? fs::path() : out);
  on_root(world, [&] {
    if (options.dry_run) return;
    done.emplace(plan, out);
    if (!options.resume.empty() || !parts.empty())
      read_earlier_units(parts.empty() ? "Resumed" : "Merged", out, identity, plan, *done);
  });
  clock.end_phase("plan");
  if (options.dry_run) return;

  const std::uint64_t resumed = done ? done->units : 0;
  UnitRun{.plan = plan,
          .part = options.part,
          .skipping = options.no_skip ? Skipping::none : Skipping::all,
          .at_root = done,
          .journal = JournalWriter(out, world.rank(), identity),
          .stop = *stop,
          .folder = out,
          .world = world}
      .run();
  clock.end_phase("histories");
  on_root_threads(world, [&] {
    if (!options.part.is_all()) return end_part(out, options.part, done->units);
    write_all(plan, *done, resumed, options, *stop, *stopped.lock, clock, world.size());
    stopped.lock->remove_journals();
  });
}

void add_run(CLI::App& program, const Communicator& world) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand(
      "run", "Run a study: histories, its analyses, tables, figures and report");
  CLI::Option* study =
      command->add_option("study", options->study, "study file (TOML); see studies/");
  CLI::Option* out = command->add_option(
      "--out", options->out, "results folder, new or empty [results/NAME OF THE STUDY FILE]");
  CLI::Option* resume = command->add_option(
      "--resume", options->resume,
      "continue the stopped or killed run in this results folder, on any number of ranks; the "
      "results are the same to the last bit");
  CLI::Option* part =
      command
          ->add_option_function<std::string>(
              "--part", [options](const std::string& text) { options->part = part_of(text); },
              "run part K of N of the work only, in a folder of its own; glissade merge puts the "
              "parts together")
          ->type_name("K/N");
  command
      ->add_option("--walltime-s", options->walltime_s,
                   "stop before this wall time, s; the run can be resumed")
      ->check(CLI::Range(0.0, 1e9));
  add_overwrite(*command, options->overwrite);
  CLI::Option* dry_run =
      command->add_flag("--dry-run", options->dry_run, "the same as `glissade check`");
  command->add_flag(
      "--no-skip", options->no_skip,
      "also compute what the study does not need: much slower, the same results to the last bit");
  for (CLI::Option* other : {out, dry_run, command->get_option("--overwrite"), part})
    resume->excludes(other);
  part->excludes(dry_run);
  command->footer(
      "SIGINT (Ctrl-C), SIGTERM, SIGHUP, SIGUSR1 or a file named stop in the results\n"
      "folder stop a run with exit status 75; --resume continues it.");
  command->callback([options, study, world] {
    if (options->study.empty() && options->resume.empty())
      throw CLI::RequiredError(study->get_name());
    run_study(*options, world);
  });

  add_merge(program, world);

  CLI::App* check = program.add_subcommand("check",
                                           "What a study, project or product would run, its cost "
                                           "and warnings; nothing is run or written");
  check->add_option("study", options->study, "study, project or product file (TOML); see studies/")
      ->required();
  check->add_option("--out", options->out, "results folder to check [as of run]");
  check->callback([options, world] {
    const bool is_study = root_says(world, [&] {
      const bool of_product = is_product(options->study);
      if (!of_product && !is_project(options->study)) return true;
      (of_product ? check_product : check_project)(options->study, options->folder());
      return false;
    });
    if (!is_study) return;
    options->dry_run = true;
    run_study(*options, world);
  });
}

}  // namespace glissade::cli
