// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace glissade {

/// A numerical scheme did not get to the end of a history. A result of that history, not an error
/// of the program: a run counts it and goes on.
class NotConverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace glissade
