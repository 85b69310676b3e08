// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "glissade/core/error.hpp"
#include "plot/script.hpp"

namespace glissade::gnuplot {
namespace {

[[noreturn]] void throw_failed(const std::filesystem::path& folder, const std::string& script,
                               const std::string& why) {
  throw InputError(
      {(folder / script).string(), "gnuplot could not draw this figure: " + why,
       "see whether `gnuplot " + script + "` works there, and whether the disk has room", ""});
}

/// The reading end of a pipe on the child's standard error.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    close_write_end();
  }
  int write_end() const { return ends_[1]; }
  void close_write_end() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  std::string read_all() {
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
};

}  // namespace

void run(const std::filesystem::path& folder, const std::string& script) {
  Pipe errors;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors.write_end(), STDERR_FILENO);

  std::string program = "gnuplot", option = "--default-settings", argument = script;
  std::array<char*, 4> arguments = {program.data(), option.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int spawn_error =
      ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (spawn_error == ENOENT) {
    throw InputError({"gnuplot", "the program is not found, and the figures are drawn with it",
                      "install it (Debian: apt install gnuplot-nox) or add its folder to PATH; "
                      "then make the report from the results file",
                      ""});
  }
  if (spawn_error != 0) throw_failed(folder, script, std::generic_category().message(spawn_error));

  errors.close_write_end();
  const std::string message = errors.read_all();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw_failed(folder, script, std::generic_category().message(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw_failed(folder, script, message.empty() ? "it stopped without saying why" : message);
  }
}

}  // namespace glissade::gnuplot
