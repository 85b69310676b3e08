// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/child_program.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "glissade/core/file.hpp"

namespace glissade {
namespace {

std::string text_of(int error_number) { return std::generic_category().message(error_number); }

/// The reading end of a pipe on the child's standard error.
class Pipe {
 public:
  Pipe() : error_(::pipe2(ends_.data(), O_CLOEXEC) == 0 ? 0 : errno) {}
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }
  int error() const { return error_; }
  int write_end() const { return ends_[1]; }
  std::string read_all() {
    ::close(ends_[1]);
    ends_[1] = -1;
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
      const ssize_t n = ::read(ends_[0], buffer.data(), buffer.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return text;
      text.append(buffer.data(), static_cast<std::size_t>(n));
    }
  }

 private:
  std::array<int, 2> ends_{-1, -1};
  int error_;
};

/// What posix_spawn does in the child; its memory is given back.
class Actions {
 public:
  Actions() : error_(posix_spawn_file_actions_init(&actions_)) {}
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  ~Actions() { posix_spawn_file_actions_destroy(&actions_); }
  void add(int error) {
    if (error_ == 0) error_ = error;
  }
  void open(int fd, const std::string& path, int how) {
    add(posix_spawn_file_actions_addopen(&actions_, fd, path.c_str(), how, 0));
  }
  void copy(int from, int to) { add(posix_spawn_file_actions_adddup2(&actions_, from, to)); }
  void enter(const std::filesystem::path& folder) {
    add(posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str()));
  }
  int error() const { return error_; }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
  int error_;
};

}  // namespace

MemoryFile::MemoryFile(const std::filesystem::path& shown)
    : file_(::memfd_create("glissade", MFD_CLOEXEC), shown) {}

std::string MemoryFile::read() const { return read_text_file(name()); }

std::optional<std::string> ChildProgram::failure() const {
  Pipe errors;
  Actions actions;
  actions.add(errors.error());
  for (const MemoryFile* file : files) actions.copy(file->descriptor(), file->descriptor());
  actions.open(STDIN_FILENO, input, O_RDONLY);
  actions.open(STDOUT_FILENO, output, O_WRONLY);
  actions.copy(errors.write_end(), STDERR_FILENO);
  if (!folder.empty()) actions.enter(folder);

  std::vector<std::string> copies = words;
  copies.push_back(variable);
  std::vector<char*> arguments, variables;
  for (std::size_t i = 0; i < words.size(); ++i) arguments.push_back(copies[i].data());
  if (!variable.empty()) variables.push_back(copies.back().data());
  for (char** of_this = environ; *of_this != nullptr; ++of_this) variables.push_back(*of_this);
  arguments.push_back(nullptr);
  variables.push_back(nullptr);
  pid_t child = 0;
  if (actions.error() != 0) return text_of(actions.error());
  const int error = ::posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(),
                                   variables.data());
  if (error == ENOENT) return {};
  if (error != 0) return text_of(error);

  const std::string message = errors.read_all();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return text_of(errno);
  if (WIFSIGNALED(status))
    return std::string("it was ended by a signal: ") + ::strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return "";
  return message.empty() ? "it stopped without saying why" : message;
}

}  // namespace glissade
