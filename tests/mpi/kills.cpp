// SPDX-License-Identifier: GPL-3.0-or-later
// Kills runs of a small study at random moments by SIGKILL, resumes each on another number of ranks
// and compares results.h5 with that of a run that nothing disturbed:
//   kills [NUMBER]      prints a table for the verification of the journal (tests/README.md)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "glissade/io/journal.hpp"
#include "mpi/kill.hpp"
#include "mpi/mpirun.hpp"

namespace {

using namespace glissade::test;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A tenth of a second of units on records that are read, so that no time goes by before them.
std::string write_study(const ScratchFolder& folder) {
  std::string suite = "[suite]\nname = \"kills\"\n";
  for (int record = 0; record < 4; ++record) {
    const std::string id(1, static_cast<char>('a' + record));
    suite += "[[record]]\nid = \"" + id + "\"\n";
    for (const char* component : {"first", "second"}) {
      std::string text;
      for (int i = 0; i < 1500; ++i)
        text += std::to_string(0.4 * std::sin((0.06 + 0.01 * record) * i) *
                               std::sin(0.02 * i + component[0])) +
                "\n";
      const std::string name = id + component + ".txt";
      folder.write(name, text);
      suite +=
          std::string(component) + " = { file = \"" + name + "\", dt_s = 0.02, units = \"g\" }\n";
    }
  }
  folder.write("suite.toml", suite);
  return folder.write("study.toml",
                      "[study]\nname = \"kills\"\n[suite]\nfile = \"suite.toml\"\n[intensity]\n"
                      "measure = \"pga_g\"\nlevels = [0.5, 1.0, 2.0]\n[building]\nperiod_s = 0.4\n"
                      "mass_ratio = 0.1\n[friction]\nmu = { mean = 0.3, std = 0.03 }\n"
                      "[sampling]\nsamples = 64\nbootstrap_replicates = 100\n[fragility]\n"
                      "thresholds_m = [0.05]\n");
}

bool is_written_now(const fs::path& out) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(out, ignored)) {
    if (entry.path().filename().string().starts_with("results.h5")) return true;
  }
  return false;
}

/// One process, undisturbed: its results, and how many bytes its journal had.
struct Reference {
  std::string results;
  double journal_bytes = 0.0, seconds_to_first_unit = 0.0;
};

Reference reference(const std::string& study, const fs::path& out) {
  Reference reference;
  const auto start = Clock::now();
  Child child({GLISSADE_PROGRAM, "run", study, "--out", out.string()});
  reaches(child, [&] {
    const auto bytes = static_cast<double>(journal_bytes(out));
    if (reference.journal_bytes == 0.0 && bytes > 0.0)
      reference.seconds_to_first_unit = std::chrono::duration<double>(Clock::now() - start).count();
    reference.journal_bytes = std::max(reference.journal_bytes, bytes);
    return false;
  });
  if (child.wait().status == 0) reference.results = read_file(out / "results.h5");
  return reference;
}

struct Row {
  int kills = 0, ended_before = 0, with_units = 0, anew = 0, same = 0;
};

constexpr const char* victims[] = {"the program, alone", "rank 0", "the last rank", "all ranks",
                                   "mpirun"};
constexpr const char* moments[] = {"before the first unit", "while units run",
                                   "while results.h5 is written"};

bool has_partial_files(const fs::path& folder) {
  return std::ranges::any_of(fs::recursive_directory_iterator(folder), [](const auto& entry) {
    return entry.path().filename().string().find(".partial.") != std::string::npos;
  });
}

/// Goes on with what a kill left, or begins anew where it left nothing, as cluster/slurm does.
bool resumed_to(const std::string& results, const std::string& study, const fs::path& out,
                int ranks, Row& row) {
  std::vector<std::string> run{"run", "--resume", out.string()};
  row.with_units += glissade::has_units(out);
  if (!glissade::has_identity(out)) {
    ++row.anew;
    if (!fs::exists(out / "run.json")) run = {"run", study, "--out", out.string()};
  }
  const Finished child = ranks == 0 ? run_program(run) : run_on(ranks, run);
  if (child.status == 0 && read_file(out / "results.h5") == results && !has_partial_files(out))
    return true;
  std::fprintf(stderr, "status %d\n%s\n", child.status, child.err.c_str());
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const int number = argc > 1 ? std::atoi(argv[1]) : 200;
  if (!mpirun_is_there() || number < 1) return 2;
  const ScratchFolder folder;
  const std::string study = write_study(folder);
  const Reference whole = reference(study, folder.path("whole"));
  if (whole.results.empty()) return 2;
  const fs::path out = folder.path("out");
  std::mt19937_64 random(1);
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };

  std::map<std::pair<int, int>, Row> rows;
  int wrong = 0;
  for (int i = 0; i < number; ++i) {
    const int victim = i % 5, moment = i / 5 % 5;  // of five: one, three and one
    const int kind = moment == 0 ? 0 : moment == 4 ? 2 : 1;
    const double at = share();
    const auto start = Clock::now();
    const auto reached = [&](const fs::path& where) {
      if (kind == 2) return is_written_now(where);
      if (kind == 1) return static_cast<double>(journal_bytes(where)) > at * whole.journal_bytes;
      return std::chrono::duration<double>(Clock::now() - start).count() >
             at * whole.seconds_to_first_unit;
    };
    Row& row = rows[{victim, kind}];
    ++row.kills;
    if (!kill_run(study, out, {static_cast<Victim>(victim), 2 + below(3), reached}).under_way)
      ++row.ended_before;
    const bool same = resumed_to(whole.results, study, out, below(4), row);
    row.same += same;
    wrong += !same;
    fs::remove_all(out);
  }

  std::printf(
      "| killed | moment | kills | ended before | units resumed | nothing to resume | results.h5 "
      "the "
      "same |\n|---|---|---|---|---|---|---|\n");
  for (const auto& [key, row] : rows)
    std::printf("| %s | %s | %d | %d | %d | %d | %d |\n", victims[key.first], moments[key.second],
                row.kills, row.ended_before, row.with_units, row.anew, row.same);
  std::printf("\n%d kills, %d resumed runs with other bits or an error\n", number, wrong);
  return wrong == 0 ? 0 : 1;
}
