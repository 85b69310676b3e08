// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/study/run/execute.hpp"

namespace glissade {

// Messages between the ranks of one run; one of a unit is also a record of the run's journal.

/// Suites as the ranks exchange them: their samples one after another, apart from all else, so that
/// the ranks of one machine can share them.
struct PackedSuites {
  std::vector<char> headers;
  std::vector<double> samples_mps2;
};
PackedSuites pack(const std::vector<Suite>& suites);
/// @param samples_mps2 must outlive the suites, which refer to them
std::vector<Suite> unpack_suites(std::span<const char> headers,
                                 std::span<const double> samples_mps2);

std::vector<char> pack(const UnitResult& result);
UnitResult unpack_unit_result(std::span<const char> bytes);

/// Whether a result is one of this plan, with all that is kept of each history: `reduce` relies on
/// it.
bool fits(const Plan& plan, const UnitResult& result);

/// Names what a message of a unit contains and how the plan's work is cut: results of two programs
/// can be mixed only where it is the same.
std::string unit_layout(const Plan& plan);

}  // namespace glissade
