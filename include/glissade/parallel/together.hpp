// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "glissade/parallel/communicator.hpp"

namespace glissade {

/// How the program ends before its end: its exit status, and what root then says (empty: nothing).
struct ExitStatus {
  int status = 0;
  std::string message = {};
};

/// That of the exception that is being handled: 2 where input or machine is the cause, 1 of a fault
/// of the program.
ExitStatus exit_status_of_exception();

/// Runs a step on every rank. Where it throws on any of them, every rank throws the ExitStatus of
/// the first of these. All that can fail on one rank is such a step: others would wait for it for
/// ever. The step itself makes no collective call. Collective.
void together(const Communicator& world, const std::function<void()>& step);

/// The same of a step of root alone, for which the others wait.
void on_root(const Communicator& world, const std::function<void()>& step);

/// Root's answer, on every rank. Collective, and as on_root().
bool root_says(const Communicator& world, const std::function<bool()>& question);

}  // namespace glissade
