// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_folder.hpp"

#include "glissade/core/file.hpp"
#include "glissade/study/run/exchange.hpp"
#include "output_rule.hpp"

namespace glissade::cli {

namespace fs = std::filesystem;

void share(std::vector<Suite>& suites, const Communicator& world) {
  std::vector<char> message = world.is_root() ? pack(suites) : std::vector<char>();
  world.broadcast(message);
  if (!world.is_root()) suites = unpack_suites(message);
}

void check_same_plan(const std::string& hash, const Communicator& world) {
  const auto hashes = world.gather({hash.begin(), hash.end()});
  on_root(world, [&] {
    for (const std::vector<char>& other : hashes) {
      if (hash == std::string(other.begin(), other.end())) continue;
      throw InputError({"", "the ranks make different plans of one study",
                        "run them on one kind of machine, and do not change the study file while "
                        "they start",
                        ""});
    }
  });
}

namespace {

void check_room(const fs::path& folder, double bytes_of_results) {
  const double needed = bytes_of_results + 20e6;  // figures, tables, report
  std::error_code error;
  fs::path existing = fs::absolute(folder);
  while (!fs::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  const fs::space_info space = fs::space(existing, error);
  if (!error && static_cast<double>(space.available) < needed) {
    throw InputError(
        {folder.string(),
         fmt::format("the disk has {:.0f} MB free and the results need about {:.0f} MB",
                     static_cast<double>(space.available) / 1e6, needed / 1e6),
         "make room, or give a folder on another disk with --out", ""});
  }
}

}  // namespace

void take_results_folder(const fs::path& folder, double bytes_of_results,
                         const std::string& run_json, bool overwrite) {
  check_room(folder, bytes_of_results);
  if (overwrite) remove_run(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw InputError({folder.string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
  }
  create_text_file(folder / "run.json", run_json);
}

namespace {

void give_back(const fs::path& folder) noexcept {
  try {
    const fs::path run_json = folder / "run.json", results = folder / "results.h5";
    if (!is_started(run_json)) return;
    std::error_code ignored;
    if (fs::exists(results, ignored)) {
      write_text_file(run_json, unreported_json(run_json, results));
    } else {
      fs::remove(run_json, ignored);
      fs::remove(folder, ignored);  // if empty
    }
  } catch (const std::exception&) {  // run.json stays "started"
  }
}

}  // namespace

ResultsFolderGuard::ResultsFolderGuard(fs::path folder, const Communicator& world)
    : folder_(std::move(folder)), world_(world) {
  if (!folder_.empty()) world_.before_abort([this] { give_back(folder_); });
}

ResultsFolderGuard::~ResultsFolderGuard() {
  world_.before_abort({});
  if (!folder_.empty() && std::uncaught_exceptions() > exceptions_) give_back(folder_);
}

void print_seconds(const PhaseClock& clock, int ranks) {
  std::string phases;
  double total = 0.0;
  for (const auto& [phase, seconds] : clock.phases()) {
    phases += fmt::format("{}{} {:.2f}", phases.empty() ? "" : ", ", phase, seconds);
    total += seconds;
  }
  fmt::print("Seconds on {} rank{}: {:.2f} ({})\n", ranks, ranks == 1 ? "" : "s", total, phases);
}

void print_where(const fs::path& folder) {
  fmt::print("Report   {}\nResults  {}\nTables   {}\nFigures  {}\nRun      {}\n",
             (folder / "report.html").string(), (folder / "results.h5").string(),
             (folder / "tables").string(), (folder / "figures").string(),
             (folder / "run.json").string());
}

}  // namespace glissade::cli
