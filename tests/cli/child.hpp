// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glissade::test {

/// A folder of its own for a test, gone when the test is over.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Writes a file, in a folder that is made, and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Every file and folder in it, sorted, relative.
  std::vector<std::string> contents() const;

 private:
  std::filesystem::path folder_;
};

/// What a finished child left: its exit status (128 + signal where one ended it) and what it
/// printed.
struct Finished {
  int status = -1;
  std::string out, err;
};

/// A process under way, of which the system keeps no trace once this is gone.
class Child {
 public:
  /// Starts `arguments` (the program first, found on the PATH).
  explicit Child(const std::vector<std::string>& arguments);
  ~Child();  ///< kills it
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  int pid() const { return pid_; }
  bool is_running();
  Finished wait();  ///< until it ends

 private:
  ScratchFolder folder_;
  int pid_, status_ = 0;
  bool waited_ = false;
};

/// Runs `arguments` and waits.
Finished run_child(const std::vector<std::string>& arguments);
/// Runs glissade.
Finished run_program(std::vector<std::string> arguments);
/// The same; fails the test unless its exit status is 0.
Finished succeeding(const std::vector<std::string>& arguments);
/// Runs a line of sh; "$0" in it is glissade.
Finished run_shell(const std::string& line);

/// Every command as its help names it: {}, {"run"}, {"suite"}, {"suite", "show"} ...
std::vector<std::vector<std::string>> all_commands();

std::string read_file(const std::filesystem::path& file);
std::vector<std::string> lines_of(const std::string& text);
/// Of a line of CSV, without their quotes.
std::vector<std::string> cells_of(const std::string& line);

/// Fails the test unless the program refused its input: status 2, nothing on standard output, and
/// one message on standard error that begins with the program's name and holds all of `parts`.
void expect_refused(const Finished& child, const std::vector<std::string>& parts);

}  // namespace glissade::test
