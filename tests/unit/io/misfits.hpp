// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problems.hpp"
#include "run_results.hpp"

namespace glissade {

/// The part, of the message "cannot fit <part> to ...", for which such a file is refused: "" where
/// it is read, the whole message where it is refused for another reason.
inline std::string misfit_in(const Results& results) {
  const TemporaryFolder folder;
  write_results(folder.path() / "a.h5", results);
  const std::string message = message_of([&] { read_results(folder.path() / "a.h5"); });
  const std::size_t begin = message.find("cannot fit ");
  if (begin == std::string::npos) return message;
  return message.substr(begin + 11, message.find(" to ", begin + 11) - begin - 11);
}

}  // namespace glissade
