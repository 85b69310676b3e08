// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace glissade {

/// One pull of an array, or of a part of one, over a roof membrane, as it was logged.
struct PullTest {
  std::string test;                    ///< what its user calls it; unique within a direction
  std::string direction;               ///< of the array that is pulled: "along", "across" ...
  std::string place;                   ///< where its rows begin: "tests.csv:12"
  std::vector<double> displacement_m;  ///< positive along the pull, from any zero
  std::vector<double> force_n;         ///< as many: of the pull
  std::vector<double> normal_n;        ///< as many: between array and roof, > 0
};

/// Which part of a trace is what. Displacement counts from the test's first sample.
struct SlidingRule {
  /// Up to this displacement it is the rig and the membrane that stretch, not the array that slips.
  /// > 0
  double slip_m = 0.003;
  double sliding_from_m = 0.02;  ///< beyond this the breakaway is over; >= slip_m
};

/// Throws InputError with what is wrong, its place the options' names.
void validate(const SlidingRule& rule);

/// The effective coefficient of friction, pull over normal force, of one test.
struct TraceFriction {
  std::string test, direction;
  double breakaway_mu;  ///< largest up to and at the first sample beyond slip_m
  /// The sliding part: the samples [begin, end) from the first one beyond sliding_from_m to the
  /// first one within slip_m of the largest displacement, after which the pull stops or goes back.
  std::size_t sliding_begin, sliding_end;
  double sliding_mu;      ///< mean over the samples of the sliding part, so over time
  double sliding_std;     ///< of these samples (n - 1): along the trace, not between tests
  double min_mu, max_mu;  ///< of these samples
  double
      mu_by_displacement;  ///< mean over displacement (trapezoids): what dissipates the same work
  double travel_m;         ///< of the sliding part
};

/// Throws InputError at the test's place where the array does not slide, is pushed backwards, or
/// where the friction found cannot be one (not between 0 and 10).
TraceFriction friction_of(const PullTest& test, const SlidingRule& rule);

}  // namespace glissade
