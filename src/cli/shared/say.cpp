// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/say.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "glissade/core/error.hpp"

namespace glissade::cli {

void take_standard_files() {
  ::signal(SIGPIPE, SIG_IGN);  // a reader that is gone is an error like others
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);  // takes the lowest free number
}

namespace {

int error_of_results = 0;  ///< the first

void note_error_unless(bool is_written) {
  if (!is_written && error_of_results == 0) error_of_results = errno;
}

void flush_results() { note_error_unless(std::fflush(stdout) == 0); }

}  // namespace

void write_result(std::string_view text) {
  note_error_unless(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void end_of_results(int status) {
  flush_results();
  const int error = error_of_results;
  if (error == 0) return;
  if (error == EPIPE && status == 0) {
    ::signal(SIGPIPE, SIG_DFL);
    ::raise(SIGPIPE);
  }
  throw InputError({"standard output",
                    "cannot be written: " + std::generic_category().message(error),
                    "make room on the disk or write elsewhere", ""});
}

void say_text(std::string_view text) {
  flush_results();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace glissade::cli
