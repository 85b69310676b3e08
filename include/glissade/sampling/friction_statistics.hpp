// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/sampling/normality.hpp"
#include "glissade/sampling/pull_test.hpp"

namespace glissade {

/// A coefficient of friction over the tests of one direction, one value for each test.
struct MuStatistics {
  std::size_t tests;
  double mean;
  double std;               ///< between tests (n - 1); NaN with one test, as are the next two
  double mean_minus_2_std;  ///< the design value (Walters et al. 2012), not below 0
  /// With 95 % confidence at least 97.7 % of pulls have more friction than this: the probability
  /// Phi(2) of mean - 2 std, with the uncertainty of a small number of tests (mean - k std,
  /// sampling/tolerance.hpp). For normal friction; not below 0.
  double lower_bound_95;
  std::optional<ShapiroWilk> normality;  ///< none with fewer than three tests or without spread
};
MuStatistics statistics_of(const std::vector<double>& mu);

/// lower_bound_95 of `tests` (>= 2) tests with this mean and standard deviation.
double lower_bound_95(double mean, double std, std::size_t tests);

struct DirectionFriction {
  std::string direction;
  MuStatistics sliding, breakaway;  ///< breakaway.tests = 0: it is not known
  std::vector<double> sliding_mu;   ///< of each test, as given
  std::string note;                 ///< on its name; "" where nothing is to be said
};

/// Remarks on tests whose friction is far from that of the others of the direction.
std::vector<std::string> outliers_in(const DirectionFriction& direction);

/// Results of a set of pull tests.
struct PullTestSummary {
  SlidingRule rule;
  std::vector<TraceFriction> tests;           ///< as given; none of a sheet of values
  std::vector<DirectionFriction> directions;  ///< as they first appear
  std::vector<std::string> notes;             ///< remarks for the user
};

/// Throws InputError with the problems of all tests.
PullTestSummary summarise(const std::vector<PullTest>& tests, const SlidingRule& rule);
/// Friction of tests that others evaluated, one direction.
struct EvaluatedTests {
  std::string direction;
  std::vector<double> mu;  ///< sliding, by test
};
PullTestSummary summarise(const std::vector<EvaluatedTests>& tests);

}  // namespace glissade
