// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fault_walk.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/small_study.hpp"

namespace glissade::test {
namespace {

/// Every file of a folder and below it, by its name there: but run.json, which has times, and what
/// could not be removed of a journal or of a file that was not finished.
Files files_of(const fs::path& folder) {
  Files files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && entry.path().filename() != "run.json" &&
        !name.starts_with("journal/") && name.find(".partial.") == std::string::npos &&
        !name.starts_with("tmp."))
      files[name] = read_file(entry.path());
  }
  return files;
}

/// The first file in which two folders differ; empty: none.
std::string difference(const Files& a, const Files& b) {
  for (const auto& [name, text] : a) {
    if (!b.contains(name) || b.at(name) != text) return name;
  }
  for (const auto& [name, text] : b) {
    if (!a.contains(name)) return name;
  }
  return "";
}

void print(const std::string& what, const Tally& t) {
  std::printf("| %s | %ld | %ld | %ld | %ld | %ld | %ld | %ld | %ld |\n", what.c_str(), t.calls,
              t.failed, t.reported, t.whole, t.silent, t.lost, t.signals, t.internal);
}

}  // namespace

long wanted_calls() {
  const char* wanted = getenv("GLISSADE_FAULTS");
  if (wanted == nullptr) return 0;
  return std::string(wanted) == "all" ? std::numeric_limits<long>::max() : atol(wanted);
}

const std::vector<Function> system_functions = {{"open", {EIO, ENOSPC, EMFILE, EACCES, EROFS}},
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

std::string line_of(const std::string& arguments, const fs::path& in, const fs::path& out) {
  std::string line = "\"$0\" " + arguments;
  for (const auto& [word, path] : {std::pair{"OUT", out}, {"IN", in}})
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at))
      line.replace(at, std::string(word).size(), path.string());
  return line;
}

void FaultWalk::TearDown() {
  std::printf(
      "| %s | calls | made to fail | reported | whole | silent | lost | signal | internal |\n",
      GetParam().name.c_str());
  Tally all;
  for (const auto& [function, t] : tallies_) {
    print(function, t);
    for (long Tally::*count : {&Tally::calls, &Tally::failed, &Tally::reported, &Tally::whole,
                               &Tally::silent, &Tally::lost, &Tally::signals, &Tally::internal})
      all.*count += t.*count;
  }
  print(GetParam().name + ", all", all);
}

void FaultWalk::begin() {
  prepare();
  before_ = files_of(out_);
  const Finished whole = run_shell(line());
  ASSERT_EQ(whole.status, 0) << whole.err;
  undisturbed_ = files_of(out_);
  printed_ = whole.out;
}

void FaultWalk::prepare() const {
  for (const fs::path& path : {in_, out_}) fs::remove_all(path);
  fs::create_directories(in_);
  if (GetParam().prepare) GetParam().prepare(in_, out_);
}

std::string FaultWalk::line(const std::string& variables, const std::string& program) const {
  const std::string line = line_of(GetParam().arguments, in_, out_);
  return variables + " " + program + " " + line;
}

std::map<std::string, long> FaultWalk::count(const std::string& program) const {
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

void FaultWalk::fail(const std::string& function, const std::string& program, int error, bool only,
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
  const bool is_of_library = child.err.starts_with("[ERROR]");
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
std::string FaultWalk::difference_when_mended(const Finished& child) const {
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

void FaultWalk::walk(const std::string& function, const std::vector<int>& errors, long calls,
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

namespace {

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

/// Its studies are finished, and what is made of them is not.
void unfinished(const fs::path& folder) {
  write_input(folder / "run.json", replaced(read_file(folder / "run.json"), "finished", "started"));
  for (const char* name : {"package.html", "sites.html", "product.html"}) fs::remove(folder / name);
}

}  // namespace

void write_input(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

Prepare with(const std::string& name, std::string (*text)()) {
  return [=](const fs::path& in, const fs::path&) { write_input(in / name, text()); };
}

Prepare finished_calculation(std::string (*text)()) {
  const auto kept = std::make_shared<Kept>(
      "clearance IN/project.toml --out OUT",
      [text](const fs::path& in) { write_input(in / "project.toml", text()); });
  return [kept](const fs::path& in, const fs::path& out) {
    kept->copy(in, out);
    unfinished(out);
    if (fs::exists(out / "site_1")) unfinished(out / "site_1");
  };
}

Prepare finished_run() {
  const auto kept = std::make_shared<Kept>("run IN/study.toml --out OUT", [](const fs::path& in) {
    write_input(in / "study.toml", short_study());
  });
  return [kept](const fs::path& in, const fs::path& out) { kept->copy(in, out); };
}

}  // namespace glissade::test
