// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/friction_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/sampling/tolerance.hpp"

namespace glissade {
namespace {

constexpr double confidence = 0.95;
/// The share above mean - 2 std of a normal population, Phi(2).
const double coverage = normal_cdf(2.0);
constexpr double refused_at = 0.05;    // level of the normality test
constexpr std::size_t few_tests = 10;  // fewer hardly identify a distribution
constexpr double uneven_pull = 0.05;   // of sliding mu

std::vector<std::string> directions_in(const std::vector<TraceFriction>& tests) {
  std::vector<std::string> directions;
  for (const TraceFriction& test : tests) {
    if (std::find(directions.begin(), directions.end(), test.direction) == directions.end())
      directions.push_back(test.direction);
  }
  return directions;
}

std::vector<double> values_of(const std::vector<TraceFriction>& tests, const std::string& direction,
                              double TraceFriction::*mu) {
  std::vector<double> values;
  for (const TraceFriction& test : tests)
    if (test.direction == direction) values.push_back(test.*mu);
  return values;
}

std::string note_on_number(const DirectionFriction& d) {
  const MuStatistics& s = d.sliding;
  if (s.tests == 1) {
    return fmt::format("{}: one test has no standard deviation, so there is no mean - 2 std",
                       d.direction);
  }
  return fmt::format(
      "{}: mean - 2 std = {:.3f} rests on {} tests and is itself uncertain; with 95 % confidence "
      "97.7 % of pulls have more than {:.3f} (mean - {:.2f} std, if friction is normal)",
      d.direction, s.mean_minus_2_std, s.tests, s.lower_bound_95,
      one_sided_tolerance_factor({s.tests, coverage, confidence}));
}

std::string note_on_design(const DirectionFriction& d) {
  const MuStatistics& s = d.sliding;
  const double design = s.mean - 2.0 * s.std;
  if (!(design < 0.0)) return "";
  return fmt::format("{}: mean - 2 std = {:.3f} is below 0: 0 is taken", d.direction, design);
}

std::string note_on_normality(const DirectionFriction& d) {
  const MuStatistics& s = d.sliding;
  if (!s.normality) {
    return s.tests < 3
               ? fmt::format("{}: whether friction is normal is not judged from fewer than 3 tests",
                             d.direction)
               : fmt::format("{}: all tests give one friction; normality is not judged",
                             d.direction);
  }
  if (s.normality->p_value < refused_at) {
    return fmt::format(
        "{}: sliding friction does not look normal (Shapiro-Wilk W = {:.3f}, p = {:.3f}): look at "
        "the tests one by one before using mean - 2 std",
        d.direction, s.normality->w, s.normality->p_value);
  }
  if (s.tests < few_tests) {
    return fmt::format(
        "{}: nothing speaks against normal friction (Shapiro-Wilk p = {:.2f}), but {} tests could "
        "hardly show it",
        d.direction, s.normality->p_value, s.tests);
  }
  return "";
}

std::vector<std::string> notes_on_trace(const TraceFriction& t) {
  constexpr double most_travel_m = 3.0;
  std::vector<std::string> notes;
  const std::string name = fmt::format("test {} {}", t.test, t.direction);
  if (t.travel_m > most_travel_m)
    notes.push_back(
        fmt::format("{}: the array is pulled over {:.3g} m: check the unit of the displacements",
                    name, t.travel_m));
  if (t.breakaway_mu < t.sliding_mu) {
    notes.push_back(fmt::format(
        "{}: breakaway {:.3f} is below sliding {:.3f}: if the rig stretches before the array "
        "slips, raise slip_m; are displacements and forces in their units?",
        name, t.breakaway_mu, t.sliding_mu));
  }
  if (std::abs(t.mu_by_displacement - t.sliding_mu) > uneven_pull * t.sliding_mu) {
    notes.push_back(fmt::format(
        "{}: the pull was uneven (or so was the logging): sliding friction is {:.3f} as a mean "
        "over samples, {:.3f} as a mean over displacement",
        name, t.sliding_mu, t.mu_by_displacement));
  }
  return notes;
}

/// "A1, A2": the tests of a direction for which something holds; empty for none.
template <class Holds>
std::string tests_with(const PullTestSummary& summary, const std::string& direction, Holds holds) {
  std::string names;
  for (const TraceFriction& t : summary.tests) {
    if (t.direction == direction && holds(t)) names += (names.empty() ? "" : ", ") + t.test;
  }
  return names;
}

/// What pull tests are asked for and these do not have.
std::vector<std::string> notes_on_provision(const PullTestSummary& summary,
                                            const DirectionFriction& d) {
  std::vector<std::string> notes;
  if (d.sliding.tests < least_pull_tests)
    notes.push_back(fmt::format("{}: {} test{}, fewer than {}", d.direction, d.sliding.tests,
                                d.sliding.tests == 1 ? "" : "s", least_pull_tests));
  const auto add = [&](const std::string& tests, const std::string& what) {
    if (!tests.empty()) notes.push_back(fmt::format("{}: test {}: {}", d.direction, tests, what));
  };
  add(tests_with(summary, d.direction,
                 [&](const TraceFriction& t) { return is_too_short(t, summary.rule); }),
      "pulled over less than 3 in");
  add(tests_with(summary, d.direction, is_at_other_speed),
      fmt::format("not pulled at {:g} to {:g} mm/s", 1e3 * slowest_pull_mps,
                  1e3 * fastest_pull_mps));
  return notes;
}

std::vector<std::string> notes_on(const PullTestSummary& summary) {
  std::vector<std::string> notes;
  for (const DirectionFriction& d : summary.directions) {
    for (std::string& note : notes_on_provision(summary, d)) notes.push_back(std::move(note));
    for (std::string& note : outliers_in(d)) notes.push_back(std::move(note));
    if (d.sliding.mean < least_probable_friction || d.sliding.mean > most_probable_friction)
      notes.push_back(fmt::format(
          "{}: a mean friction of {:.3g} is outside of what roofs have shown, {:g} to {:g}: check "
          "the units of the forces",
          d.direction, d.sliding.mean, least_probable_friction, most_probable_friction));
    notes.push_back(note_on_number(d));
    if (std::string note = note_on_design(d); !note.empty()) notes.push_back(std::move(note));
    if (std::string note = note_on_normality(d); !note.empty()) notes.push_back(std::move(note));
  }
  for (const TraceFriction& test : summary.tests)
    for (std::string& note : notes_on_trace(test)) notes.push_back(std::move(note));
  const bool knows_speed = std::ranges::any_of(
      summary.tests, [](const TraceFriction& t) { return !std::isnan(t.speed_mps); });
  notes.push_back(pull_test_provision() +
                  (summary.tests.empty() ? "; travel and speed are not in the file"
                   : knows_speed         ? ""
                                         : "; the speed is not in the file") +
                  " (recalled: verify)");
  return notes;
}

}  // namespace

std::vector<std::string> outliers_in(const DirectionFriction& d) {
  constexpr double most_deviation = 0.4;  // of the median; pulls of one roof scatter by 0.1 or so
  std::vector<double> sorted = d.sliding_mu;
  std::ranges::sort(sorted);
  const double median = 0.5 * (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < d.sliding_mu.size(); ++i) {
    if (std::abs(d.sliding_mu[i] - median) > most_deviation * median)
      notes.push_back(fmt::format(
          "{}: test {} of {} has friction {:.3g}, {:.2g} times the median {:.3g}: check it",
          d.direction, i + 1, d.sliding_mu.size(), d.sliding_mu[i], d.sliding_mu[i] / median,
          median));
  }
  return notes;
}

double lower_bound_95(double mean, double std, std::size_t tests) {
  return std::max(0.0, mean - one_sided_tolerance_factor({tests, coverage, confidence}) * std);
}

MuStatistics statistics_of(const std::vector<double>& mu) {
  GLISSADE_EXPECTS(!mu.empty());
  const auto n = static_cast<double>(mu.size());
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  MuStatistics s{mu.size(), 0.0, none, none, none, {}};
  for (const double x : mu) s.mean += x / n;
  if (mu.size() == 1) return s;
  const auto [least, most] = std::minmax_element(mu.begin(), mu.end());
  if (*least == *most) s.mean = *least;  // no rounding, so no spread
  double squares = 0.0;
  for (const double x : mu) squares += (x - s.mean) * (x - s.mean);
  s.std = std::sqrt(squares / (n - 1.0));
  s.mean_minus_2_std = std::max(0.0, s.mean - 2.0 * s.std);
  s.lower_bound_95 = glissade::lower_bound_95(s.mean, s.std, s.tests);
  constexpr std::size_t most_judged = 5000;
  if (mu.size() >= 3 && mu.size() <= most_judged && *least < *most) s.normality = shapiro_wilk(mu);
  return s;
}

PullTestSummary summarise(const std::vector<PullTest>& tests, const SlidingRule& rule) {
  validate(rule);
  PullTestSummary summary;
  summary.rule = rule;
  ProblemList problems;
  for (const PullTest& test : tests) {
    try {
      summary.tests.push_back(friction_of(test, rule));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
  for (const std::string& direction : directions_in(summary.tests)) {
    const auto statistics = [&](double TraceFriction::*mu) {
      return statistics_of(values_of(summary.tests, direction, mu));
    };
    summary.directions.push_back({direction, statistics(&TraceFriction::sliding_mu),
                                  statistics(&TraceFriction::breakaway_mu),
                                  values_of(summary.tests, direction, &TraceFriction::sliding_mu),
                                  ""});
  }
  summary.notes = notes_on(summary);
  return summary;
}

PullTestSummary summarise(const std::vector<EvaluatedTests>& tests) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  PullTestSummary summary;
  for (const EvaluatedTests& t : tests)
    summary.directions.push_back(
        {t.direction, statistics_of(t.mu), {0, none, none, none, none, {}}, t.mu, ""});
  summary.notes = notes_on(summary);
  return summary;
}

}  // namespace glissade
