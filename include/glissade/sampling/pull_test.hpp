// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace glissade {

/// Pulls over roof membranes have shown 0.3 to 1 (recalled).
inline constexpr double least_probable_friction = 0.2, most_probable_friction = 1.2;
/// No pull of an array over a roof has shown more: a larger coefficient is an error of units or of
/// a decimal point.
inline constexpr double largest_friction = 2.0;
/// "" of one that a roof may have. @param what "a mean friction"
std::string improbable_friction(const std::string& what, double mu);

/// What pull tests are asked for, all recalled: verify against ASTM G115 and SEAOC PV1-2012.
inline constexpr std::size_t least_pull_tests = 3;
inline constexpr double least_pull_m = 0.0762;  ///< 3 in
inline constexpr double slowest_pull_mps = 1e-4, fastest_pull_mps = 1e-2;
/// The same in a sentence.
std::string pull_test_provision();

/// One pull of an array, or of a part of one, over a roof membrane, as logged.
struct PullTest {
  std::string test;                    ///< name given by the user; unique within a direction
  std::string direction;               ///< of the array that is pulled: "along", "across" ...
  std::string place;                   ///< first row: "tests.csv:12"
  std::vector<double> displacement_m;  ///< positive along the pull, from any zero
  std::vector<double> force_n;         ///< as many: of the pull
  std::vector<double> normal_n;        ///< as many: between array and roof, > 0
  std::vector<double> time_s;          ///< as many, or none: not logged
};

/// Division of a trace into parts. Displacement counts from the first sample of the test.
struct SlidingRule {
  /// Up to this displacement the rig and the membrane stretch, and the array does not slip. > 0
  double slip_m = 0.003;
  double sliding_from_m = 0.02;  ///< displacement at the end of the breakaway; >= slip_m
};

/// Throws InputError with the faults; `where` is the name of the option.
void validate(const SlidingRule& rule);

/// The effective coefficient of friction, pull over normal force, of one test.
struct TraceFriction {
  std::string test, direction;
  double breakaway_mu;  ///< largest up to and at the first sample beyond slip_m
  /// The sliding part: the samples [begin, end) from the first one beyond sliding_from_m to the
  /// first one within slip_m of the largest displacement, after which the pull stops or reverses.
  std::size_t sliding_begin, sliding_end;
  double sliding_mu;          ///< mean over the samples of the sliding part, so over time
  double sliding_std;         ///< of these samples (n - 1): along the trace, not between tests
  double min_mu, max_mu;      ///< of these samples
  double mu_by_displacement;  ///< mean over displacement (trapezoids): dissipates the same work
  double travel_m;            ///< of the sliding part
  double speed_mps;           ///< its mean; NaN where times are not logged
};

/// Whether the pull is shorter than, or at another speed than, the provision asks. A speed that is
/// not known is not another one.
bool is_too_short(const TraceFriction& test, const SlidingRule& rule);
bool is_at_other_speed(const TraceFriction& test);
/// Neither, by the usual rule.
bool meets_provision(const TraceFriction& test);

/// Throws InputError at the place of the test if the array does not slide or is pushed backwards,
/// or if the friction is not between 0 and largest_friction.
TraceFriction friction_of(const PullTest& test, const SlidingRule& rule);

}  // namespace glissade
