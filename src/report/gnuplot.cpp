// SPDX-License-Identifier: GPL-3.0-or-later
#include "gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/report/format.hpp"

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

std::string enhanced(std::string_view plain) {
  std::string text;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const char c = plain[i];
    if (plain.substr(i).starts_with("S_DS")) {
      text += "S_{DS}";
      i += 3;
      if (plain.substr(i + 1).starts_with(
              ' ')) {  // SVG readers drop a plain space at the end of a subscript
        text += "\u00a0";
        ++i;
      }
    } else if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) {
      text += std::string("\\") + c;
    } else {
      text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return text;
}

std::string quoted_markup(std::string_view markup) {
  // gnuplot does not take every doubled quote as one: an apostrophe is set instead.
  std::string text = "'";
  for (const char c : markup) text += c == '\'' ? std::string("\u2019") : std::string(1, c);
  return text + "'";
}

std::string quoted(std::string_view plain) { return quoted_markup(enhanced(plain)); }

std::string ramp_colour(std::size_t index, std::size_t count) {
  static constexpr std::array<std::array<double, 3>, 5> stops = {{{0x44, 0x01, 0x54},
                                                                  {0x3b, 0x52, 0x8b},
                                                                  {0x21, 0x91, 0x8c},
                                                                  {0x3f, 0xb0, 0x6e},
                                                                  {0x8f, 0xc3, 0x2f}}};
  const double position =
      count < 2 ? 1.0
                : static_cast<double>(index) / static_cast<double>(count - 1) * (stops.size() - 1);
  const auto lower = std::min<std::size_t>(static_cast<std::size_t>(position), stops.size() - 2);
  const double share = position - static_cast<double>(lower);
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double mixed = (1.0 - share) * stops[lower][channel] + share * stops[lower + 1][channel];
    colour += fmt::format("{:02x}", static_cast<int>(std::lround(mixed)));
  }
  return colour;
}

void DataBlocks::begin(const std::string& name, const std::string& columns) {
  if (!text_.empty()) text_ += "\n\n";
  text_ += "# " + name + "\n# columns: " + columns + "\n";
}

void DataBlocks::row(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    text_ += (i == 0 ? "" : " ") + (std::isfinite(values[i]) ? format_exact(values[i]) : "nan");
  }
  text_ += "\n";
}

void DataBlocks::break_line() { text_ += "\n"; }

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
    throw InputError(
        {"gnuplot", "the program is not found, and the figures are drawn with it",
         "install it (Debian: apt install gnuplot-nox) or add its folder to PATH; then make "
         "the report from the results file",
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
