// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/one_package.hpp"
#include "cli/one_run.hpp"
#include "cli/shaking.hpp"
#include "cli/small_study.hpp"

// What the program does where a call of the system fails (inject.cpp), memory ends
// (faults_memory.cpp) or the clock is set (faults.cpp). GLISSADE_FAULTS=all: each call of each
// command in turn by each error, or so many of each function, for
// tests/verification/reliability.md.
namespace glissade::test {
namespace {

using testing::HasSubstr;

/// Every file of a folder and below it, by its name there: but run.json, which has times, and what
/// could not be removed of a journal or of a file that was not finished.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
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

  Finished run_with(const std::string& faults, const std::string& options = "") const {
    return run_shell(faults + " \"$0\" run '" + study_ + "' --out '" + again_.string() + "' " +
                     options);
  }
  const std::string library_ = " LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY;

  fs::path again_ = folder_->path("again");
};

/// Functions of the system (inject.cpp) and the errors by which a call of each can fail.
struct Function {
  const char* name;
  std::vector<int> errors;
};
const std::vector<Function> functions = {{"open", {EIO, ENOSPC, EMFILE, EACCES, EROFS}},
                                         {"read", {EIO}},
                                         {"pread", {EIO}},
                                         {"list", {EIO}},
                                         {"stat", {EIO, EACCES}},
                                         {"readlink", {EIO}},
                                         {"access", {EIO, EROFS}},
                                         {"space", {EIO}},
                                         {"write", {EIO, ENOSPC, EDQUOT, EFBIG}},
                                         {"pwrite", {ENOSPC, EIO, EDQUOT, EFBIG}},
                                         {"fsync", {EIO, ENOSPC, EDQUOT}},
                                         {"ftruncate", {EIO, EFBIG}},
                                         {"fallocate", {ENOSPC, EIO}},
                                         {"mmap", {ENOMEM}},
                                         {"close", {EIO, ENOSPC, EDQUOT}},
                                         {"mkdir", {ENOSPC, EACCES, EROFS, EIO}},
                                         {"rename", {EIO, ENOSPC, EROFS}},
                                         {"remove", {EROFS, EIO, EACCES}},
                                         {"memory_file", {EMFILE, ENOMEM}},
                                         {"pipe", {EMFILE}},
                                         {"start", {EAGAIN, ENOMEM}}};

/// A command that writes, of which the calls fail one by one.
struct Walked {
  std::string name;       ///< of the test
  std::string arguments;  ///< of glissade; OUT is its folder, IN that of what it reads
  std::function<void(const fs::path& in, const fs::path& out)> prepare;  ///< what is there before
  bool prints_result = false;  ///< its output has no times: what is printed is compared too
  std::string again = "";      ///< the command that then makes all, where none is stated;
                               ///< empty: the same
  bool keeps = false;          ///< what was there before is there after a failure
};

using Files = std::map<std::string, std::string>;

void PrintTo(const Walked& walked, std::ostream* out) { *out << walked.name; }

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

/// Its arguments with the paths.
std::string line_of(const std::string& arguments, const fs::path& in, const fs::path& out) {
  std::string line = "\"$0\" " + arguments;
  for (const auto& [word, path] : {std::pair{"OUT", out}, {"IN", in}})
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at))
      line.replace(at, std::string(word).size(), path.string());
  return line;
}

/// How often, of the calls of a function that were made to fail.
struct Tally {
  long calls = 0, failed = 0, reported = 0, whole = 0, silent = 0, lost = 0, signals = 0,
       internal = 0;
};

class FaultWalk : public testing::TestWithParam<Walked> {
 protected:
  void TearDown() override {
    std::printf(
        "| %s | calls | made to fail | reported | whole | silent | lost | signal | internal |\n",
        GetParam().name.c_str());
    for (const auto& [function, t] : tallies_) {
      std::printf("| %s | %ld | %ld | %ld | %ld | %ld | %ld | %ld | %ld |\n", function.c_str(),
                  t.calls, t.failed, t.reported, t.whole, t.silent, t.lost, t.signals, t.internal);
    }
  }
  void begin() {
    prepare();
    before_ = files_of(out_);
    const Finished whole = run_shell(line());
    ASSERT_EQ(whole.status, 0) << whole.err;
    undisturbed_ = files_of(out_);
    printed_ = whole.out;
  }
  void prepare() const {
    for (const fs::path& path : {in_, out_}) fs::remove_all(path);
    fs::create_directories(in_);
    if (GetParam().prepare) GetParam().prepare(in_, out_);
  }
  std::string line(const std::string& variables = "", const std::string& program = "") const {
    const std::string line = line_of(GetParam().arguments, in_, out_);
    return variables + " " + program + " " + line;
  }
  /// How many calls there are of each function.
  std::map<std::string, long> count(const std::string& program) const {
    const std::string file = folder().path("count").string();
    fs::remove(file);
    prepare();
    const Finished child = run_shell(line("FAULT_COUNT='" + file + "'", program));
    EXPECT_EQ(child.status, 0) << child.err;
    std::map<std::string, long> calls;
    for (const std::string& line : lines_of(read_file(file))) {
      const std::size_t space = line.find(' ');
      calls[line.substr(0, space)] = std::stol(line.substr(space));
    }
    return calls;
  }
  /// One call fails, or all from it on.
  void fail(const std::string& function, const std::string& program, int error, bool only,
            long at) {
    prepare();
    const bool is_memory = function == "malloc";
    const std::string what = (is_memory ? "" : "FAULT_CALLS=" + function + " ") +
                             "FAULT_ERRNO=" + std::to_string(error) +
                             (only ? " FAULT_AT=" : " FAULT_FROM=") + std::to_string(at);
    const Finished child = run_shell(line(what, program));
    SCOPED_TRACE(GetParam().name + ", " + what + ": status " + std::to_string(child.status) + ", " +
                 child.err);
    Tally& tally = tallies_[function];
    ++tally.failed;
    const std::size_t message = child.err.find("glissade: ");
    // libxlsxwriter writes a line of its own, and HDF5 where memory ends.
    const bool is_of_library = child.err.starts_with("[ERROR] workbook");
    const bool is_reported = child.status == 2 && message != std::string::npos &&
                             (message == 0 || is_memory || is_of_library) &&
                             child.err.find("internal error") == std::string::npos;
    if (child.status == 0) {
      const std::string file = GetParam().prints_result && child.out != printed_
                                   ? "what is printed"
                                   : difference(undisturbed_, files_of(out_));
      ++(file.empty() ? tally.whole : tally.silent);
      EXPECT_EQ(file, "");
    } else if (is_reported) {
      ++tally.reported;
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
    if (GetParam().keeps) {
      for (const auto& [name, text] : before_)
        if (!fs::exists(out_ / name)) return name + ", which was there before";
      if (before_.empty() && !files_of(out_).empty() && files_of(out_) != undisturbed_)
        return "a draft";
    }
    const fs::path results = out_ / "results.h5";
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
      const auto json = nlohmann::json::parse(read_file(out_ / "run.json"), nullptr, false);
      if (json.is_object() && json.contains("what_to_do")) mend = json.at("what_to_do");
    }
    if (mend.empty() && fs::exists(out_ / "journal/run"))
      mend = "glissade run --resume " + in_quotes(out_);
    if (!mend.empty()) mend = "\"$0\"" + mend.substr(mend.find(' '));
    const std::string& again = GetParam().again;
    const Finished mended = run_shell(!mend.empty()   ? mend
                                      : again.empty() ? line()
                                                      : line_of(again, in_, out_));
    if (mended.status != 0) return mend + ": " + mended.err;
    // Of what a run skipped only its own report knows.
    Files wanted = undisturbed_, found = files_of(out_);
    for (auto* page : {&wanted["report.html"], &found["report.html"]})
      *page = page->substr(page->find("</html>") == std::string::npos ? 0 : page->size());
    return difference(wanted, found);
  }
  /// Where all are wanted, each call by each error, alone and with all that follow; else so many of
  /// each function; else one of each.
  void walk(const std::string& function, const std::vector<int>& errors, long calls,
            const std::string& program) {
    tallies_[function].calls = calls;
    const long most = std::min(std::max(1L, wanted_calls()), calls);
    const bool is_each = wanted_calls() >= calls;
    for (long i = 0; i < most; ++i) {
      const long at = (2 * i + 1) * calls / (2 * most) + 1;
      for (std::size_t e = 0; e < (is_each ? errors.size() : 1); ++e) {
        const int error = errors[(static_cast<std::size_t>(i) + e) % errors.size()];
        fail(function, program, error, true, at);
        if (wanted_calls() > 0) fail(function, program, error, false, at);
      }
    }
  }

  static const ScratchFolder& folder() {
    static const ScratchFolder one;  // paths are in what is kept
    return one;
  }
  WithoutWeasyprint path_;
  fs::path in_ = folder().path("in"), out_ = folder().path("out");
  Files before_, undisturbed_;
  std::string printed_;
  std::map<std::string, Tally> tallies_;
};

/// What a command leaves that is made once for all tests of this program.
class Kept {
 public:
  explicit Kept(std::string arguments, std::function<void(const fs::path&)> inputs)
      : arguments_(std::move(arguments)), inputs_(std::move(inputs)) {}
  void copy(const fs::path& in, const fs::path& out) {
    inputs_(in);
    if (folder_ == nullptr) {
      folder_ = std::make_unique<ScratchFolder>();
      const Finished made = run_shell(line_of(arguments_, in, out));
      EXPECT_EQ(made.status, 0) << made.err;
      fs::copy(out, folder_->path("out"), fs::copy_options::recursive);
      fs::remove_all(out);
    }
    fs::copy(folder_->path("out"), out, fs::copy_options::recursive);
  }

 private:
  std::string arguments_;
  std::function<void(const fs::path&)> inputs_;
  std::unique_ptr<ScratchFolder> folder_;
};

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// Writes one file of the folder of what a command reads.
std::function<void(const fs::path&, const fs::path&)> with(const std::string& name,
                                                           std::string (*text)()) {
  return [=](const fs::path& in, const fs::path&) { write(in / name, text()); };
}

/// Its studies are finished, and what is made of them is not.
void unfinished(const fs::path& folder) {
  write(folder / "run.json", replaced(read_file(folder / "run.json"), "finished", "started"));
  for (const char* name : {"package.html", "sites.html", "product.html"}) fs::remove(folder / name);
}

std::function<void(const fs::path&, const fs::path&)> finished_calculation(std::string (*text)()) {
  const auto kept =
      std::make_shared<Kept>("clearance IN/project.toml --out OUT",
                             [text](const fs::path& in) { write(in / "project.toml", text()); });
  return [kept](const fs::path& in, const fs::path& out) {
    kept->copy(in, out);
    unfinished(out);
    if (fs::exists(out / "site_1")) unfinished(out / "site_1");
  };
}

std::function<void(const fs::path&, const fs::path&)> finished_run() {
  const auto kept = std::make_shared<Kept>("run IN/study.toml --out OUT", [](const fs::path& in) {
    write(in / "study.toml", short_study());
  });
  return [kept](const fs::path& in, const fs::path& out) { kept->copy(in, out); };
}

/// Two components of one record, and a table of two.
void write_records(const fs::path& in, const fs::path&) {
  for (const int azimuth : {0, 90})
    write(in / ("PLC-" + std::string(azimuth == 0 ? "000" : "090") + ".txt"),
          two_columns(shaking_g(0.1 + azimuth)));
  write(in / "ROOF.csv", two_columns(shaking_g(0.4)));
}

void write_pull_tests(const fs::path& in, const fs::path&) {
  write(in / "pulls.csv", "direction,mu\nx,0.31\nx,0.28\nx,0.33\n");
}

const std::string suite_2 = GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml";

const std::string a_site = " --edition asce7_16 --ss-g 1.5 --s1-g 0.6 --site-class C";
/// Written over where it was put in place and the folder could not be flushed to the disk.
Walked one_file(const std::string& name, const std::string& arguments, auto prepare) {
  return {name, arguments, prepare, true, arguments + " --overwrite", true};
}

/// Every command that writes: a new one joins by a line.
const std::vector<Walked> commands = {
    {"run", "run IN/study.toml --out OUT", with("study.toml", short_study), false,
     "run IN/study.toml --out OUT --overwrite"},
    {"resume", "run --resume OUT",
     [](const fs::path& in, const fs::path& out) {
       write(in / "study.toml", short_study());
       run_shell(line_of("run IN/study.toml --out OUT --walltime-s 0.01", in, out));
     }},
    {"report", "report --overwrite OUT/results.h5", finished_run(), false, "", true},
    {"clearance", "clearance --resume OUT", finished_calculation(moved_project)},
    {"sites", "clearance --resume OUT", finished_calculation(two_roofs)},
    {"product", "clearance --resume OUT", finished_calculation(small_product)},
    {"friction", "friction IN/pulls.csv --out OUT", write_pull_tests, true,
     "friction IN/pulls.csv --out OUT --overwrite"},
    one_file("import", "suite import IN --directions-from-names --out OUT/suite.toml",
             write_records),
    one_file("select",
             "suite select " + suite_2 + a_site + " --count 3 --max-scale 50 --out OUT/suite.toml",
             nullptr),
    one_file("spectra", "suite spectra " + suite_2 + " --out OUT/spectra.csv", nullptr),
    one_file("init", "init OUT/study.toml --suite " + suite_2 + " --mu 0.5 --mu-std 0.04", nullptr),
    one_file(
        "init_project",
        "init OUT/project.toml --kind project --suite " + suite_2 + " --pull-tests IN/pulls.csv",
        write_pull_tests),
    one_file("slide",
             "slide IN/PLC-000.txt --mu 0.3 --slope-deg 1 --json --history OUT/history.csv",
             write_records)};

INSTANTIATE_TEST_SUITE_P(, FaultWalk, testing::ValuesIn(commands),
                         [](const auto& of) { return of.param.name; });

TEST_P(FaultWalk, is_whole_or_reports_it_where_any_call_fails) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::map<std::string, long> calls = count(GLISSADE_INJECT);
  std::size_t sample = GetParam().name.size();  // without a number every fourth function
  for (const Function& function : functions)
    if (calls.contains(function.name) && (wanted_calls() > 0 || ++sample % 4 == 0))
      walk(function.name, function.errors, calls.at(function.name), GLISSADE_INJECT);
}
TEST_P(FaultWalk, is_whole_or_reports_it_where_memory_ends_at_any_allocation) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "LD_PRELOAD=" GLISSADE_MEMORY_FAULTS_LIBRARY;
  walk("malloc", {ENOMEM}, count(program).at("malloc"), program);
}

/// Commands and what they read, below IN: a new one joins by a line.
const std::vector<Walked> readers = {
    one_file("import", "suite import IN --directions-from-names --out OUT/suite.toml",
             write_records),
    {"show", "suite show IN", write_records, true},
    one_file(
        "init", "init OUT/study.toml --suite IN/suite.toml --mu 0.5 --mu-std 0.04",
        [](const fs::path& in, const fs::path&) { write(in / "suite.toml", read_file(suite_2)); }),
    {"check", "check IN/study.toml", with("study.toml", short_study), true}};

class FaultyInput : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, FaultyInput, testing::ValuesIn(readers),
                         [](const auto& of) { return of.param.name; });

// Not that it is not there, or a file of another kind: each call of each function.
TEST_P(FaultyInput, is_reported_where_the_system_does_not_read_it) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "FAULT_IN=" + in_quotes(in_) + " " GLISSADE_INJECT;
  const std::map<std::string, long> calls = count(program);
  for (const Function& function : functions)
    for (const char* reads : {"open", "read", "list", "stat", "readlink"})
      if (function.name == std::string(reads) && calls.contains(reads))
        for (long at = 1; at <= calls.at(reads); ++at)
          fail(reads, program, function.errors[at % function.errors.size()], true, at);
}

/// Its PDF is printed by a script in the place of WeasyPrint.
class Printing : public FaultWalk {
 protected:
  Finished print(const std::string& script) {
    prepare();  // the first time without WeasyPrint: no PDF is listed
    path_.put(script);
    return run_shell(line());
  }
  static inline const std::string a_pdf_ = R"(printf '%%PDF-1.7\nxref\nstartxref\n9\n%%%%EOF\n')";
  const fs::path pdf_ = out_ / "product.pdf";
};
INSTANTIATE_TEST_SUITE_P(, Printing,
                         testing::Values(Walked{"product", "clearance --resume OUT",
                                                finished_calculation(small_product)}),
                         [](const auto& of) { return of.param.name; });

TEST_P(Printing, that_fails_is_reported_and_done_by_the_stated_command) {
  for (const auto& [script, why] :
       {std::pair{"echo no fonts >&2; exit 1", "no fonts"},
        {"exit 3", "without saying why"},
        {"kill -TERM $$", "by a signal"},
        {"echo %PDF-1.7", "is incomplete"},
        {"printf '%%PDF-1.7\\nstartxref\\n900\\n%%%%EOF\\n'", "is incomplete"}}) {
    const Finished child = print(script);
    EXPECT_EQ(child.status, 2) << child.err;
    EXPECT_THAT(child.err, testing::AllOf(HasSubstr("WeasyPrint could not print product.html"),
                                          HasSubstr(why), HasSubstr("clearance --resume")));
    EXPECT_THAT(read_file(out_ / "run.json"), HasSubstr("\"stopped\""));
    EXPECT_FALSE(fs::exists(pdf_));
    path_.put(a_pdf_);
    succeeding({"clearance", "--resume", out_.string()});
    EXPECT_THAT(read_file(pdf_), testing::EndsWith("%%EOF\n"));
  }
  fs::remove(pdf_);  // and again where it is gone
  succeeding({"clearance", "--resume", out_.string()});
  EXPECT_TRUE(fs::exists(pdf_));
}

// As of a terminal or mpirun, to all processes of the group.
TEST_P(Printing, that_a_signal_ends_stops_the_calculation) {
  for (const char* signal : {"INT", "TERM", "HUP", "USR1"}) {
    const Finished child =
        print("kill -" + std::string(signal) + " $PPID; kill -" + std::string(signal) + " $$");
    EXPECT_EQ(child.status, 75) << child.err;
    EXPECT_THAT(child.err, testing::AllOf(HasSubstr("stopped by SIG" + std::string(signal)),
                                          HasSubstr("clearance --resume")));
    path_.put(a_pdf_);
    succeeding({"clearance", "--resume", out_.string()});
    EXPECT_TRUE(fs::exists(pdf_));
  }
}

TEST_P(Printing, into_a_folder_that_is_not_utf8_is_like_others) {
  prepare();
  path_.put(a_pdf_);
  const fs::path other = out_.string() + "\377";
  fs::remove_all(other);
  fs::rename(out_, other);
  EXPECT_EQ(run_program({"clearance", "--resume", other.string()}).status, 0);
  EXPECT_TRUE(fs::exists(other / "product.pdf"));
}

TEST_P(Printing, into_a_folder_that_is_removed_meanwhile_is_reported) {
  const Finished child = print("/bin/rm -r " + in_quotes(out_) + "; " + a_pdf_);
  EXPECT_EQ(child.status, 2) << child.err;
  EXPECT_THAT(child.err, HasSubstr("was removed or moved"));
}

// That of a browser, say.
TEST_P(Printing, does_not_write_over_a_pdf_of_the_user) {
  prepare();
  path_.put(a_pdf_);
  write(pdf_, "mine");
  expect_refused(run_shell(line()), {"product.pdf", "does not list it", "move it away"});
  EXPECT_EQ(read_file(pdf_), "mine");
}

class LostWrites : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, LostWrites, testing::Values(commands.front()),
                         [](const auto& of) { return of.param.name; });

TEST_P(LostWrites, are_found_out_where_the_disk_reports_none) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const long calls = count(GLISSADE_INJECT).at("pwrite"),
             step = std::max(1L, calls / (wanted_calls() > 0 ? wanted_calls() : 4));
  tallies_["pwrite"].calls = calls;
  for (long at = step; at <= calls; at += step) fail("pwrite", GLISSADE_INJECT, 0, true, at);
  fail("pwrite", GLISSADE_INJECT, 0, true, calls);  // the checksum
  EXPECT_GT(tallies_["pwrite"].reported, 0);
}

/// Two million histories at rest, which are in pages of a file.
std::string study_of_pages() {
  std::string levels = "levels = [0.01";
  for (int i = 2; i <= 80; ++i) levels += ", " + std::to_string(0.01 * i);
  std::string study = replaced(short_study(), "levels = [0.5, 1.0, 2.0", levels);
  study = replaced(study, "mean = 0.3", "mean = 1.9");
  study = replaced(study, "\"sampled\", \"design\"", "\"sampled\"");
  return replaced(study, "samples = 2", "samples = 4096");
}

class PagesOfARun : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, PagesOfARun,
                         testing::Values(Walked{"run", "run IN/study.toml --out OUT",
                                                with("study.toml", study_of_pages)}),
                         [](const auto& of) { return of.param.name; });

TEST_P(PagesOfARun, that_are_refused_are_reported) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "FAULT_IN=out/# " GLISSADE_INJECT;  // the file has no name
  const std::map<std::string, long> calls = count(program);
  for (const auto& [function, error] : {std::pair{"fallocate", ENOSPC}, {"mmap", ENOMEM}})
    fail(function, program, error, true, calls.at(function));
}

TEST_F(Faults, a_file_that_the_disk_does_not_give_back_is_refused) {
  for (const char* file : {"results.h5", "run.json"}) {
    for (const char* at : {"FAULT_AT=1", "FAULT_AT=2", "FAULT_FROM=1"}) {
      expect_refused(
          run_shell("FAULT_CALLS=read FAULT_ERRNO=5 " + std::string(at) + " FAULT_IN=" + file +
                    " " GLISSADE_INJECT " \"$0\" report '" + (out() / "results.h5").string() +
                    "' --out '" + again_.string() + "'"),
          {file, "cannot be read: Input/output error"});
    }
  }
}

TEST_F(Faults,
       a_disk_that_is_full_after_the_results_leaves_a_run_that_is_started_and_can_be_resumed) {
  const Finished failed =
      run_with("FAULT_IN=run.json FAULT_CALLS=rename FAULT_FROM=1 FAULT_ERRNO=28 " GLISSADE_INJECT);
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
  expect_refused(run_with("FAULT_FREE_MB=20" + library_),
                 {"again", "20 MB free", "make room", "--out"});
  EXPECT_FALSE(fs::exists(again_));
  EXPECT_EQ(run_with("FAULT_FREE_MB=21" + library_).status, 0);
}

TEST_F(Faults, a_dry_run_sees_that_the_disk_is_read_only) {
  const Finished child =
      run_with("FAULT_CALLS=access FAULT_ERRNO=30 FAULT_FROM=1 " GLISSADE_INJECT, "--dry-run");
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.out, HasSubstr("units"));  // the plan all the same
  EXPECT_THAT(child.err, testing::AllOf(HasSubstr("again"), HasSubstr("Read-only file system"),
                                        HasSubstr("--out")));
}

// A limit of processes or of address space.
TEST_F(Faults, a_system_that_starts_no_thread_gives_the_same_results) {
  const Finished child = run_with("FAULT_THREADS=1" + library_);
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.err, "");
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  const Finished report = run_shell("FAULT_THREADS=1 LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY
                                    " \"$0\" report --overwrite '" +
                                    (again_ / "results.h5").string() + "'");
  EXPECT_EQ(report.status, 0) << report.err;
}

TEST_F(Faults, a_clock_that_is_set_during_the_run_neither_stops_it_nor_changes_its_results) {
  const Finished child = run_with("FAULT_CLOCK=1" + library_, "--walltime-s 3600");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_EQ(child.out.find("-86"), std::string::npos) << child.out;  // no seconds of a day
}

}  // namespace
}  // namespace glissade::test
