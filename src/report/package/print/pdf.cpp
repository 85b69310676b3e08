// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/pdf.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include "glissade/core/file.hpp"
#include "page/page.hpp"
#include "page/symbols.hpp"

namespace glissade {
namespace {

/// Waits for a program without output; true if it succeeds.
bool succeeds(std::array<std::string, 8> words) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
  std::array<char*, 9> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  pid_t child = 0;
  const int spawn_error =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (spawn_error != 0) return false;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool write_and_print(const Html& page, const std::filesystem::path& html) {
  namespace fs = std::filesystem;
  write_text_file(html, with_symbols((page + page_foot()).str()));
  const fs::path whole = fs::absolute(html);
  fs::path pdf = whole, partial = whole;
  pdf.replace_extension(".pdf");
  partial.replace_extension(".pdf.partial");
  std::error_code error;
  // Without a date in the fonts the same page gives the same bytes.
  if (succeeds({"env", "SOURCE_DATE_EPOCH=0", "weasyprint", "--quiet", "--pdf-variant", "pdf/ua-1",
                whole.string(), partial.string()}))
    fs::rename(partial, pdf, error);
  else
    error = std::make_error_code(std::errc::io_error);
  if (error) fs::remove(partial, error);
  return fs::exists(pdf, error);
}

}  // namespace glissade
