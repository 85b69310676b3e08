// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "unit/block/solvers.hpp"

namespace glissade::test {

/// Runs a check of one solver on all of them; what fails names the solver.
template <class Check>
void for_each_solver(const Check& check) {
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    check(solver);
  }
}

}  // namespace glissade::test
