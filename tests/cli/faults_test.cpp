// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/one_package.hpp"
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"

// What the program does where a call of the system fails (faults.cpp), memory ends
// (faults_memory.cpp) or the clock is set. GLISSADE_FAULTS=all: each call in turn, or so many of
// each function, for tests/verification/reliability.md.
namespace glissade::test {
namespace {

using testing::HasSubstr;

/// Every file of a folder and below it, by its name there: but run.json, which has times, and what
/// could not be removed of a journal or of a file that was not finished.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && entry.path().filename() != "run.json" &&
        !name.starts_with("journal/") && name.find(".partial.") == std::string::npos)
      files[name] = read_file(entry.path());
  }
  return files;
}

/// The first file in which two folders differ; empty: none.
std::string difference(const std::map<std::string, std::string>& a,
                       const std::map<std::string, std::string>& b) {
  for (const auto& [name, text] : a) {
    if (!b.contains(name) || b.at(name) != text) return name;
  }
  for (const auto& [name, text] : b) {
    if (!a.contains(name)) return name;
  }
  return "";
}

/// Calls of each function that are made to fail; 0: one in each of two outputs.
long wanted_calls() {
  const char* wanted = getenv("GLISSADE_FAULTS");
  if (wanted == nullptr) return 0;
  return std::string(wanted) == "all" ? std::numeric_limits<long>::max() : atol(wanted);
}

class Faults : public OneRun<short_study> {
 protected:
  ~Faults() override { fs::remove_all(again_); }

  Finished run_with(const std::string& variables, const std::string& options = "") const {
    return run_shell(variables + " LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" run '" + study_ +
                     "' --out '" + again_.string() + "' " + options);
  }

  fs::path again_ = folder_->path("again");
};

/// A command whose calls fail one by one.
struct Walked {
  std::string name, line;            ///< "$0" is glissade
  std::function<void()> prepare;     ///< what is there before
  std::string again;                 ///< where the command states no other: makes all anew
  std::vector<std::string> outputs;  ///< words in the paths of what it writes
};

/// How often, of the calls of a function that were made to fail.
struct Tally {
  long calls = 0, failed = 0, reported = 0, whole = 0, silent = 0, lost = 0, signals = 0,
       internal = 0;
};

class FaultWalk : public Faults {
 protected:
  struct Kind {
    std::string library, variables;  ///< which calls fail
    std::vector<int> errors;
  };
  static Kind kind_of(const std::string& function, const std::string& output = "") {
    const std::string in = output.empty() ? "" : " FAULT_IN=" + output;
    if (function == "malloc") return {GLISSADE_MEMORY_FAULTS_LIBRARY, "", {ENOMEM}};
    const bool removes = function == "remove" || function == "access";  // on a full disk too
    const std::string calls = function == "any" ? "" : " FAULT_CALLS=" + function;
    return {GLISSADE_FAULTS_LIBRARY, calls + in,
            removes ? std::vector{EROFS} : std::vector{EIO, ENOSPC, EDQUOT, EROFS}};
  }

  void begin(const Walked& walked) {
    walked_ = &walked;
    fs::remove_all(again_);
    walked.prepare();
    const Finished whole = run_shell(walked.line);
    ASSERT_EQ(whole.status, 0) << whole.err;
    undisturbed_ = files_of(again_);
  }
  /// How many calls there are of each function, and of any, in paths with the words of an output.
  std::map<std::string, long> count(Kind kind) const {
    const std::string file = folder_->path("count").string();
    fs::remove_all(again_);
    fs::remove(file);
    walked_->prepare();
    // An error, of no call, so that removals count too.
    const Finished child =
        run_shell(command(kind, "FAULT_COUNT='" + file + "' FAULT_ERRNO=" + std::to_string(EROFS)));
    EXPECT_EQ(child.status, 0) << child.err;
    std::map<std::string, long> calls;
    for (const std::string& line : lines_of(read_file(file))) {
      const std::size_t space = line.find(' ');
      calls["any"] += calls[line.substr(0, space)] = std::stol(line.substr(space));
    }
    return calls;
  }
  /// One call fails, or all from it on.
  void fail(const std::string& function, const Kind& kind, int error, bool only, long at) {
    fs::remove_all(again_);
    walked_->prepare();
    const std::string what = "FAULT_ERRNO=" + std::to_string(error) +
                             (only ? " FAULT_AT=" : " FAULT_FROM=") + std::to_string(at);
    const Finished child = run_shell(command(kind, what));
    SCOPED_TRACE(walked_->name + ", " + function + kind.variables + " " + what + ": status " +
                 std::to_string(child.status) + ", " + child.err);
    Tally& tally = tallies_[function];
    ++tally.failed;
    // Without memory CLI11, nlohmann/json and HDF5 can end the process, after which as after kill
    // -9 nothing is lost; HDF5 can write lines of its own.
    const bool is_memory = function == "malloc", is_ended = is_memory && child.status > 2;
    const std::size_t message = child.err.find("glissade: ");
    const bool is_reported = child.status == 2 &&
                             (message == 0 || (is_memory && message != std::string::npos)) &&
                             child.err.find("internal error") == std::string::npos;
    if (child.status == 0) {
      const std::string file = difference(undisturbed_, files_of(again_));
      ++(file.empty() ? tally.whole : tally.silent);
      EXPECT_EQ(file, "");
    } else if (is_reported || is_ended) {
      ++(is_reported ? tally.reported : tally.signals);
      const std::string file = difference_when_mended(child);
      if (!file.empty()) ++tally.lost;
      EXPECT_EQ(file, "");
    } else {
      ++(child.status > 2 ? tally.signals : tally.internal);
      ADD_FAILURE() << "neither whole nor reported";
    }
  }
  /// After the command that the program stated, or the same again.
  std::string difference_when_mended(const Finished& child) const {
    const fs::path results = again_ / "results.h5";
    if (fs::exists(results) && read_file(results) != undisturbed_.at("results.h5"))
      return "results.h5, not whole";
    std::string mend;
    for (const char* command :
         {"glissade run --resume", "glissade report --overwrite", "glissade clearance --resume"}) {
      const std::size_t at = child.err.find(command);
      if (at != std::string::npos)
        mend = child.err.substr(at, child.err.find_first_of(";\n", at) - at);
    }
    if (mend.empty()) {
      const auto json = nlohmann::json::parse(read_file(again_ / "run.json"), nullptr, false);
      if (json.is_object() && json.contains("what_to_do")) mend = json.at("what_to_do");
    }
    if (mend.empty() && fs::exists(again_ / "journal/run"))
      mend = "glissade run --resume '" + again_.string() + "'";
    mend = mend.empty() ? walked_->again : "\"$0\"" + mend.substr(mend.find(' '));
    const Finished mended = run_shell(mend);
    if (mended.status != 0) return mend + ": " + mended.err;
    // Of what a run skipped only its own report knows.
    std::map<std::string, std::string> wanted = undisturbed_, found = files_of(again_);
    for (auto* page : {&wanted["report.html"], &found["report.html"]})
      *page = page->substr(page->find("</html>") == std::string::npos ? 0 : page->size());
    return difference(wanted, found);
  }
  /// Every call, where all are wanted, alone and with all that follow, by each error in turn; else
  /// of each function calls in the middle of two outputs.
  void walk(const Walked& walked, const std::vector<std::string>& functions) {
    ASSERT_NO_FATAL_FAILURE(begin(walked));
    const auto all = count(kind_of("any"));
    std::vector<std::map<std::string, long>> of_outputs;
    for (const std::string& output : walked.outputs)
      of_outputs.push_back(count(kind_of("any", output)));
    for (std::size_t f = 0; f < functions.size(); ++f) {
      const std::string& function = functions[f];
      const bool is_memory = function == "malloc";
      const Kind kind = kind_of(function);
      const auto calls_of = [&](const std::map<std::string, long>& calls) {
        return calls.contains(function) ? calls.at(function) : 0;
      };
      const long calls = tallies_[function].calls = calls_of(is_memory ? count(kind) : all);
      if (wanted_calls() > 0 || is_memory) {
        constexpr long few = 6, many = 1000;  // allocations are 100,000
        const long most = !is_memory           ? std::min(wanted_calls(), calls)
                          : wanted_calls() > 0 ? std::min(wanted_calls(), many)
                                               : few;
        const long step = std::max(1L, calls / std::max(1L, most));
        for (long at = step; at <= calls; at += step) {
          for (const bool only : {true, false})
            fail(function, kind, kind.errors[at % kind.errors.size()], only, at);
        }
        continue;
      }
      for (std::size_t i = f, outputs = 0; i < f + walked.outputs.size() && outputs < 2; ++i) {
        const std::size_t output = i % walked.outputs.size();
        const long of_it = calls_of(of_outputs[output]);
        if (of_it == 0) continue;
        ++outputs;
        fail(function, kind_of(function, walked.outputs[output]),
             kind.errors[i % kind.errors.size()], outputs == 1, (of_it + 1) / 2);
      }
    }
    print();
  }
  void print() const {
    std::printf(
        "| %s | calls | made to fail | reported | whole | silent | lost | signal | internal |\n",
        walked_->name.c_str());
    for (const auto& [function, t] : tallies_) {
      std::printf("| %s | %ld | %ld | %ld | %ld | %ld | %ld | %ld | %ld |\n", function.c_str(),
                  t.calls, t.failed, t.reported, t.whole, t.silent, t.lost, t.signals, t.internal);
    }
  }
  std::string command(const Kind& kind, const std::string& what) const {
    return what + kind.variables + " LD_PRELOAD=" + kind.library + " " + walked_->line;
  }

  const Walked* walked_ = nullptr;
  std::map<std::string, std::string> undisturbed_;
  std::map<std::string, Tally> tallies_;
};

const std::vector<std::string> disk_functions = {"any",    "open",      "write", "pwrite",
                                                 "fsync",  "ftruncate", "close", "mkdir",
                                                 "rename", "remove",    "access"};

Walked a_run(const std::string& study, const std::string& out) {
  const std::string line = "\"$0\" run '" + study + "' --out '" + out + "'";
  return {"run",
          line,
          [] {},
          line + " --overwrite",
          {"journal", "results.h5", "tables", "figures", "report.html", "run.json"}};
}

TEST_F(FaultWalk, a_run_to_which_any_call_fails_is_whole_or_reports_it_and_states_a_way_on) {
  walk(a_run(study_, again_.string()), disk_functions);
}
/// The studies are finished, and what is made of them is not.
TEST_F(FaultWalk, a_calculation_package_to_which_any_call_fails_is_whole_or_reports_it) {
  const WithoutWeasyprint path;
  succeeding(
      {"clearance", folder_->write("project.toml", moved_project()), "--out", again_.string()});
  const fs::path kept = folder_->path("kept");
  fs::rename(again_, kept);
  folder_->write("kept/run.json",
                 replaced(read_file(kept / "run.json"), "\"finished\"", "\"started\""));
  const std::string line = "\"$0\" clearance --resume '" + again_.string() + "'";
  const auto prepare = [&] {
    fs::copy(kept, again_, fs::copy_options::recursive);
    for (const char* name : {"package.html", "package.json", "tables", "figures"})
      fs::remove_all(again_ / name);
  };
  walk({"package", line, prepare, line, {"tables", "figures", "package.html", "run.json"}},
       disk_functions);
}
TEST_F(FaultWalk, results_of_which_the_disk_loses_a_part_without_a_word_are_found_out) {
  const Walked run = a_run(study_, again_.string());
  ASSERT_NO_FATAL_FAILURE(begin(run));
  const Kind kind = kind_of("pwrite");
  const long calls = tallies_["pwrite"].calls = count(kind).at("pwrite"),
             step = std::max(1L, calls / (wanted_calls() > 0 ? wanted_calls() : 4));
  for (long at = step; at <= calls; at += step) fail("pwrite", kind, 0, true, at);
  fail("pwrite", kind, 0, true, calls);  // the checksum
  print();
  EXPECT_GT(tallies_["pwrite"].reported, 0);
}
/// Two million histories at rest, which are in pages of a file.
TEST_F(FaultWalk, a_run_whose_histories_get_no_pages_reports_it_and_can_be_begun_again) {
  std::string levels = "levels = [0.01";
  for (int i = 2; i <= 80; ++i) levels += ", " + std::to_string(0.01 * i);
  std::string study = replaced(short_study(), "levels = [0.5, 1.0, 2.0", levels);
  study = replaced(study, "mean = 0.3", "mean = 1.9");
  study = replaced(study, "\"sampled\", \"design\"", "\"sampled\"");
  study = replaced(study, "samples = 2", "samples = 4096");
  Walked run = a_run(folder_->write("pages.toml", study), again_.string());
  run.outputs = {"again/#"};  // the file has no name
  walk(run, {"fallocate", "mmap"});
}
TEST_F(FaultWalk, a_run_in_which_memory_ends_at_any_allocation_reports_it_and_states_a_way_on) {
  walk(a_run(study_, again_.string()), {"malloc"});
}
TEST_F(FaultWalk, a_report_to_which_any_call_fails_is_whole_or_reports_it) {
  const std::string line = "\"$0\" report --overwrite '" + (again_ / "results.h5").string() + "'";
  walk({"report",
        line,
        [&] { fs::copy(out(), again_, fs::copy_options::recursive); },
        line,
        {"tables", "figures", "report.html"}},
       disk_functions);
}
TEST_F(Faults, a_file_that_the_disk_does_not_give_back_is_refused) {
  for (const char* file : {"results.h5", "run.json"}) {
    for (const char* at : {"FAULT_AT=1", "FAULT_AT=2", "FAULT_FROM=1"}) {
      expect_refused(
          run_shell("FAULT_CALLS=read FAULT_ERRNO=5 " + std::string(at) + " FAULT_IN=" + file +
                    " LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" report '" +
                    (out() / "results.h5").string() + "' --out '" + again_.string() + "'"),
          {file, "cannot be read: Input/output error"});
    }
  }
}

// Four calls make run.json when the run begins.
TEST_F(Faults,
       a_disk_that_is_full_after_the_results_leaves_a_run_that_is_started_and_can_be_resumed) {
  const Finished failed =
      run_with("FAULT_IN=run.json FAULT_FROM=5 FAULT_ERRNO=" + std::to_string(ENOSPC));
  EXPECT_EQ(failed.status, 2) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("is complete"));
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"started\""));
  EXPECT_EQ(run_program({"report", "--overwrite", (again_ / "results.h5").string()}).status, 0);
  succeeding({"run", "--resume", again_.string()});
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"finished\""));
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_FALSE(fs::exists(again_ / "journal"));
}

// The journals are flushed to the disk before the results are made of them. How far the run comes
// without more memory depends on what it has free by then; HDF5 can end it by a signal.
TEST_F(Faults, memory_that_ends_after_the_histories_leaves_a_run_that_can_be_resumed) {
  const std::string study =
      folder_->write("large.toml", replaced(short_study(), "samples = 2", "samples = 256"));
  const fs::path whole = folder_->path("whole");
  ASSERT_EQ(run_program({"run", study, "--out", whole.string()}).status, 0);
  const Finished failed = run_shell(
      "FAULT_MEMORY=1 FAULT_IN=.units LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" run '" + study +
      "' --out '" + again_.string() + "'");
  ASSERT_GE(failed.status, 2) << failed.err;
  const auto json = nlohmann::json::parse(read_file(again_ / "run.json"));
  if (json.at("status") == "stopped") {
    EXPECT_FALSE(fs::exists(again_ / "results.h5"));
    EXPECT_EQ(json.at("what_to_do"), "glissade run --resume " + again_.string());
  } else if (failed.status == 2) {
    EXPECT_EQ(json.at("status"), "results written, report missing");
  } else {
    EXPECT_NE(json.at("status"), "finished");
  }
  succeeding({"run", "--resume", again_.string()});
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(whole / "results.h5"));
}

TEST_F(Faults, a_disk_with_less_room_than_the_results_need_is_refused_before_the_run) {
  // 20 MB for report and figures, and twice the histories, which are small here.
  expect_refused(run_with("FAULT_FREE_MB=20"), {"again", "20 MB free", "make room", "--out"});
  EXPECT_FALSE(fs::exists(again_));
  EXPECT_EQ(run_with("FAULT_FREE_MB=21").status, 0);
}

TEST_F(Faults, a_dry_run_sees_that_the_disk_is_read_only) {
  const Finished child =
      run_with("FAULT_ERRNO=" + std::to_string(EROFS) + " FAULT_FROM=1", "--dry-run");
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.out, HasSubstr("units"));  // the plan all the same
  EXPECT_THAT(child.err, testing::AllOf(HasSubstr("again"), HasSubstr("Read-only file system"),
                                        HasSubstr("--out")));
}

// A limit of processes or of address space.
TEST_F(Faults, a_system_that_starts_no_thread_gives_the_same_results) {
  const Finished child = run_with("FAULT_THREADS=1");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.err, "");
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  const Finished report = run_shell("FAULT_THREADS=1 LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY
                                    " \"$0\" report --overwrite '" +
                                    (again_ / "results.h5").string() + "'");
  EXPECT_EQ(report.status, 0) << report.err;
}

TEST_F(Faults, a_clock_that_is_set_during_the_run_neither_stops_it_nor_changes_its_results) {
  const Finished child = run_with("FAULT_CLOCK=1", "--walltime-s 3600");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_EQ(child.out.find("-86"), std::string::npos) << child.out;  // no seconds of a day
}

}  // namespace
}  // namespace glissade::test
