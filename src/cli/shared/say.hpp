// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace glissade::cli {

/// At the start of the program: what it opens later is never standard input, output or error, where
/// a message would be written into it. Of those that are closed nothing can be read, and nothing
/// written.
void take_standard_files();

/// Results, on standard output. What cannot be written ends no run: `end_of_results` reports it.
void write_result(std::string_view text);
/// Gives the results to the system. Throws InputError where any of them could not be written. Where
/// the reader of a pipe has what it wanted (`| head`), the process ends by SIGPIPE.
void end_of_results(int status);

void say_text(std::string_view text);
/// Messages and progress, on standard error, behind the results so far. What cannot be written
/// there (a full disk, a terminal that is closed) is left out.
template <class... T>
void say(fmt::format_string<T...> format, T&&... values) {
  say_text(fmt::format(format, std::forward<T>(values)...));
}

}  // namespace glissade::cli
