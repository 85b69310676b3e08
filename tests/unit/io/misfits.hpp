// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "problems.hpp"
#include "whole_results.hpp"

namespace glissade {

/// The part, of the message "cannot fit <part> to ...", for which such a file is refused: "" where
/// it is read, the whole message where it is refused for another reason.
template <class Action>
std::string misfit_of(const Action& action) {
  const std::string message = message_of(action);
  const std::size_t begin = message.find("cannot fit ");
  if (begin == std::string::npos) return message;
  return message.substr(begin + 11, message.find(" to ", begin + 11) - begin - 11);
}

/// The same, of a file of these results.
inline std::string misfit_in(const Results& results) {
  const TemporaryFolder folder;
  write_results(folder.path() / "a.h5", results);
  return misfit_of([&] { read_results(folder.path() / "a.h5"); });
}

}  // namespace glissade
