// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/output_file.hpp"
#include "plot/script.hpp"

namespace glissade::gnuplot {
namespace {

[[noreturn]] void throw_failed(const std::filesystem::path& script, const std::string& why) {
  throw InputError({script.string(), "gnuplot could not draw this figure: " + why,
                    "see whether `gnuplot " + script.filename().string() +
                        "` works there, and whether there is "
                        "memory",
                    ""});
}

std::string text_of(int error_number) { return std::generic_category().message(error_number); }

/// A file in memory that the child has open too, by the same number.
class MemoryFile {
 public:
  explicit MemoryFile(const std::filesystem::path& shown)
      : file_(::memfd_create("figure", MFD_CLOEXEC), shown) {}
  int descriptor() const { return file_.descriptor(); }
  std::string name() const { return "/dev/fd/" + std::to_string(descriptor()); }
  void write(const std::string& text) { file_.write(text); }
  void share(posix_spawn_file_actions_t& actions) const {
    posix_spawn_file_actions_adddup2(&actions, descriptor(), descriptor());
  }
  /// What was drawn, to its last word.
  std::string read(const std::filesystem::path& script, const std::string& last_word) const {
    std::string text = read_text_file(name());
    const std::size_t at = text.rfind(last_word);
    if (at == std::string::npos || text.size() - at > last_word.size() + 2)
      throw_failed(script, "what it drew is incomplete");
    return text;
  }

 private:
  OutputFile file_;
};

/// The reading end of a pipe on the child's standard error.
class Pipe {
 public:
  explicit Pipe(const std::filesystem::path& script) {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw_failed(script, text_of(errno));
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

// gnuplot does not notice what it could not write, so it writes to no disk.
Drawn draw(const Figure& figure, const std::filesystem::path& folder) {
  const std::filesystem::path shown = folder / (figure.name + ".gp");
  const MemoryFile svg(shown), pdf(shown);
  MemoryFile script(shown);
  script.write(script_of(figure, {svg.descriptor(), pdf.descriptor()}));
  Pipe errors(shown);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors.write_end(), STDERR_FILENO);
  for (const MemoryFile* file : {&svg, &pdf, static_cast<const MemoryFile*>(&script)})
    file->share(actions);

  std::string program = "gnuplot", option = "--default-settings", argument = script.name();
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
  if (spawn_error != 0) throw_failed(shown, text_of(spawn_error));

  errors.close_write_end();
  const std::string message = errors.read_all();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw_failed(shown, text_of(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw_failed(shown, message.empty() ? "it stopped without saying why" : message);
  return {svg.read(shown, "</svg>"), pdf.read(shown, "%%EOF")};
}

}  // namespace glissade::gnuplot
