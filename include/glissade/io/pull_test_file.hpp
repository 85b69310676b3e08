// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/io/text_files.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "glissade/sampling/pull_test.hpp"

namespace glissade {

/// Pull tests from a CSV file (columns: studies/README.md): a header, then a row for each
/// logged sample, those of one test together and in order of time. Lines that begin with # are
/// comments. Throws InputError with a message for each kind of wrong row, at the first such row:
/// numbers that are none, time that goes back, normal force not above 0 ...
std::vector<PullTest> read_pull_tests(const TextFile& file);

/// Pull tests with what came out. The file may also be a sheet with a test in each row: a column
/// mu, and test and direction if wanted; then there are no logs. Directions that differ in case or
/// in blanks around them are one, which a note of it says.
struct PullTestResults {
  std::vector<PullTest> tests;
  PullTestSummary summary;
};
PullTestResults read_pull_test_results(const TextFile& file, const SlidingRule& rule);

/// The direction of that name, in any case; null where there is none.
const DirectionFriction* find_direction(const PullTestSummary& summary, const std::string& name);

}  // namespace glissade
