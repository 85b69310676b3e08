// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/pull_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

[[noreturn]] void refuse(const PullTest& test, const std::string& what,
                         const std::string& suggestion) {
  throw InputError(
      {test.place, fmt::format("test {} {}: {}", test.test, test.direction, what), suggestion, ""});
}

std::vector<double> friction_ratio(const PullTest& test) {
  std::vector<double> mu(test.force_n.size());
  std::transform(test.force_n.begin(), test.force_n.end(), test.normal_n.begin(), mu.begin(),
                 std::divides<>());
  return mu;
}

/// Displacement from the test's first sample.
std::vector<double> slip_of(const PullTest& test) {
  std::vector<double> slip_m = test.displacement_m;
  for (double& x : slip_m) x -= test.displacement_m.front();
  return slip_m;
}

std::size_t first_beyond(const std::vector<double>& slip_m, double limit_m) {
  const auto at = std::find_if(slip_m.begin(), slip_m.end(), [&](double x) { return x > limit_m; });
  return static_cast<std::size_t>(at - slip_m.begin());
}

void check_slip(const PullTest& test, const std::vector<double>& slip_m, const SlidingRule& rule) {
  const auto [least, most] = std::minmax_element(slip_m.begin(), slip_m.end());
  if (!(*least >= -rule.slip_m)) {
    refuse(test, fmt::format("its displacement goes back to {:.4g} m behind its start", -*least),
           "give one pull as one test, with displacement positive along it");
  }
  if (!std::isfinite(*most) || *most <= rule.sliding_from_m) {
    refuse(
        test,
        fmt::format("no sliding: it moves {:.4g} m and sliding counts from {:g} m on", *most,
                    rule.sliding_from_m),
        "pull it farther, see whether the displacement's unit is right, or lower sliding_from_m");
  }
}

struct Part {
  std::size_t begin, end;
};

Part sliding_part(const PullTest& test, const std::vector<double>& slip_m,
                  const SlidingRule& rule) {
  const double most = *std::max_element(slip_m.begin(), slip_m.end());
  const std::size_t begin = first_beyond(slip_m, rule.sliding_from_m);
  const auto at_end =
      std::find_if(slip_m.begin(), slip_m.end(), [&](double x) { return x >= most - rule.slip_m; });
  const auto end = static_cast<std::size_t>(at_end - slip_m.begin()) + 1;
  if (end < begin + 2 || !(slip_m[end - 1] > slip_m[begin])) {
    refuse(test,
           fmt::format("no sliding: there are not two samples between {:g} m and its largest "
                       "displacement, {:.4g} m, less {:g} m",
                       rule.sliding_from_m, most, rule.slip_m),
           "pull it farther, log it more often, or lower sliding_from_m");
  }
  return {begin, end};
}

double mean_over_displacement(const std::vector<double>& mu, const std::vector<double>& slip_m,
                              Part part) {
  double area = 0.0;
  for (std::size_t i = part.begin + 1; i < part.end; ++i)
    area += 0.5 * (mu[i - 1] + mu[i]) * (slip_m[i] - slip_m[i - 1]);
  return area / (slip_m[part.end - 1] - slip_m[part.begin]);
}

void check_mu(const PullTest& test, const char* which, double mu) {
  if (mu > 0.0 && mu <= largest_friction) return;
  refuse(test,
         fmt::format("force over normal force, {}, is {:.4g}, which is no coefficient of friction "
                     "(0 to {:g})",
                     which, mu, largest_friction),
         "see whether the units in the columns' names are right, and whether the pull is positive");
}

/// NaN where times are not logged, or do not advance.
double mean_speed_mps(const PullTest& test, const std::vector<double>& slip_m, Part part) {
  const double duration_s =
      test.time_s.empty() ? 0.0 : test.time_s[part.end - 1] - test.time_s[part.begin];
  return duration_s > 0.0 ? (slip_m[part.end - 1] - slip_m[part.begin]) / duration_s : std::nan("");
}

}  // namespace

std::string improbable_friction(const std::string& what, double mu) {
  if (mu <= most_probable_friction) return "";
  return fmt::format("{} of {:.3g} is above {:g}: no roof is known for it", what, mu,
                     most_probable_friction);
}

std::string pull_test_provision() {
  return fmt::format(
      "laboratories are asked for tests by ASTM G115, and SEAOC PV1-2012 for {} tests or more, "
      "each "
      "over 3 in ({:.3g} m) or more at {:g} to {:g} mm/s",
      least_pull_tests, least_pull_m, 1e3 * slowest_pull_mps, 1e3 * fastest_pull_mps);
}

bool is_too_short(const TraceFriction& test, const SlidingRule& rule) {
  return rule.sliding_from_m + test.travel_m < least_pull_m;
}

bool is_at_other_speed(const TraceFriction& test) {
  constexpr double rounding = 1e-9;
  return test.speed_mps < slowest_pull_mps * (1.0 - rounding) ||
         test.speed_mps > fastest_pull_mps * (1.0 + rounding);
}

bool meets_provision(const TraceFriction& test) {
  return !is_too_short(test, SlidingRule{}) && !is_at_other_speed(test);
}

void validate(const SlidingRule& rule) {
  ProblemList problems;
  if (!(rule.slip_m > 0.0) || !std::isfinite(rule.slip_m))
    problems.add({"slip_m", fmt::format("{:g} is not above 0", rule.slip_m), "", ""});
  if (!(rule.sliding_from_m >= rule.slip_m) || !std::isfinite(rule.sliding_from_m)) {
    problems.add({"sliding_from_m",
                  fmt::format("{:g} is below slip_m = {:g}", rule.sliding_from_m, rule.slip_m),
                  "sliding begins after the first slip", ""});
  }
  problems.throw_if_any();
}

TraceFriction friction_of(const PullTest& test, const SlidingRule& rule) {
  GLISSADE_EXPECTS(!test.force_n.empty() && test.displacement_m.size() == test.force_n.size() &&
                   test.normal_n.size() == test.force_n.size());
  const std::vector<double> mu = friction_ratio(test), slip_m = slip_of(test);
  check_slip(test, slip_m, rule);
  const Part part = sliding_part(test, slip_m, rule);
  const auto at = [&](std::size_t i) { return mu.begin() + static_cast<std::ptrdiff_t>(i); };

  TraceFriction f;
  f.test = test.test;
  f.direction = test.direction;
  f.breakaway_mu = *std::max_element(mu.begin(), at(first_beyond(slip_m, rule.slip_m) + 1));
  f.sliding_begin = part.begin;
  f.sliding_end = part.end;
  const auto [least, most] = std::minmax_element(at(part.begin), at(part.end));
  f.min_mu = *least;
  f.max_mu = *most;
  const auto samples = static_cast<double>(part.end - part.begin);
  f.sliding_mu = std::accumulate(at(part.begin), at(part.end), 0.0) / samples;
  double squares = 0.0;
  for (std::size_t i = part.begin; i < part.end; ++i)
    squares += (mu[i] - f.sliding_mu) * (mu[i] - f.sliding_mu);
  f.sliding_std = std::sqrt(squares / (samples - 1.0));
  f.mu_by_displacement = mean_over_displacement(mu, slip_m, part);
  f.travel_m = slip_m[part.end - 1] - slip_m[part.begin];
  f.speed_mps = mean_speed_mps(test, slip_m, part);
  check_mu(test, "largest before it slips", f.breakaway_mu);
  check_mu(test, "mean while it slides", f.sliding_mu);
  return f;
}

}  // namespace glissade
