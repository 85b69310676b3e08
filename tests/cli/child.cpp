// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace glissade::test {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "glissade_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  folder_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::string& text) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name).string();
}

std::vector<std::string> ScratchFolder::contents() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    names.push_back(fs::relative(entry.path(), folder_).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments, const std::string& out,
                         const std::string& err) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  constexpr int how = O_WRONLY | O_CREAT | O_TRUNC;
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(open(out.c_str(), how, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), how, 0600), STDERR_FILENO);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments) : pid_(fork()) {
  if (pid_ < 0) throw std::runtime_error("no child");
  if (pid_ == 0) become(arguments, folder_.path("out").string(), folder_.path("err").string());
}

Child::~Child() {
  if (waited_) return;
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool Child::is_running() {
  if (!waited_) waited_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return !waited_;
}

Finished Child::wait() {
  if (!waited_) waitpid(pid_, &status_, 0);
  waited_ = true;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_),
          read_file(folder_.path("out")), read_file(folder_.path("err"))};
}

Finished run_child(const std::vector<std::string>& arguments) { return Child(arguments).wait(); }

Finished run_program(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), GLISSADE_PROGRAM);
  return run_child(arguments);
}

Finished succeeding(const std::vector<std::string>& arguments) {
  const Finished child = run_program(arguments);
  EXPECT_EQ(child.status, 0) << child.err;
  return child;
}

Finished run_shell(const std::string& line) {
  return run_child({"/bin/sh", "-c", line, GLISSADE_PROGRAM});
}

std::vector<std::vector<std::string>> all_commands() {
  std::vector<std::vector<std::string>> commands{{}};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    std::vector<std::string> arguments = commands[i];
    arguments.emplace_back("--help");
    bool listed = false;
    for (const std::string& line : lines_of(run_program(arguments).out)) {
      if (listed && line.starts_with("  ") && line[2] != ' ') {
        std::vector<std::string> command = commands[i];
        command.push_back(line.substr(2, line.find(' ', 2) - 2));
        commands.push_back(command);
      }
      listed = listed || line == "Subcommands:";
    }
  }
  return commands;
}

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

void expect_refused(const Finished& child, const std::vector<std::string>& parts) {
  EXPECT_EQ(child.status, 2) << child.err;
  EXPECT_EQ(child.out, "");
  EXPECT_THAT(child.err, testing::StartsWith("glissade: "));
  EXPECT_EQ(child.err.find("glissade: ", 1), std::string::npos) << "reported more than once:\n"
                                                                << child.err;
  for (const std::string& part : parts) EXPECT_THAT(child.err, testing::HasSubstr(part));
}

}  // namespace glissade::test
