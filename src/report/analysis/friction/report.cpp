// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/finite.hpp"
#include "glissade/report/friction_report.hpp"
#include "page/page.hpp"
#include "page/symbols.hpp"

namespace glissade {
Table pull_tests_table(const PullTestSummary& summary) {
  using T = TraceFriction;
  TableOf<T> t(
      "pull_tests",
      "Each pull: force over normal force, largest before it slips and over its sliding part");
  t.text("test", "Test", "name of the test", &T::test);
  t.text("direction", "Direction", "direction of the pull", &T::direction);
  t.number("breakaway_mu", "Breakaway", "largest friction before it slips", &T::breakaway_mu);
  t.number("sliding_mu", "Sliding, mean", "mean over the samples of the sliding part",
           &T::sliding_mu);
  t.number("sliding_std", "Std", "standard deviation of these samples", &T::sliding_std);
  t.number("min_mu", "Least", "least of these samples", &T::min_mu);
  t.number("max_mu", "Largest", "largest of these samples", &T::max_mu);
  t.number("mu_by_displacement", "Mean over displacement",
           "mean over the displacement of the sliding part", &T::mu_by_displacement);
  t.length("travel", "Travel", "length of the sliding part", &T::travel_m);
  t.number("speed", "Speed", "mean speed of the sliding part; empty without time_s", &T::speed_mps,
           "mps");
  t.add_each(summary.tests);
  return t;
}

Table friction_table(const PullTestSummary& summary) {
  using M = MuStatistics;
  TableOf<DirectionFriction, M> t("friction",
                                  "Friction over the tests of a direction, each test one value");
  t.text("direction", "Direction", "direction of the pulls", &DirectionFriction::direction);
  t.text("friction", "Friction", "sliding or breakaway",
         [](const DirectionFriction& of, const M& s) {
           return &s == &of.sliding ? "sliding" : "breakaway";
         });
  t.count("tests", "Tests", "number of tests", &M::tests);
  t.number("mean", "Mean", "mean over the tests", &M::mean);
  t.number("std", "Std", "standard deviation between tests (n - 1)", &M::std);
  t.number("mean_minus_2_std", "Mean - 2 std", "design value", &M::mean_minus_2_std);
  t.number("lower_bound_95", "95 % lower bound",
           "with 95 % confidence below 97.7 % of pulls (noncentral t)", &M::lower_bound_95);
  t.number("shapiro_wilk_w", "Shapiro-Wilk W", "statistic of the test for normality",
           [](const M& s) { return s.normality ? s.normality->w : nan; });
  t.number("shapiro_wilk_p", "p", "its p-value",
           [](const M& s) { return s.normality ? s.normality->p_value : nan; });
  for (const DirectionFriction& d : summary.directions) {
    t.add(d, d.sliding);
    if (d.breakaway.tests > 0) t.add(d, d.breakaway);
  }
  return t;
}

void write_friction_report(const std::vector<PullTest>& tests, const PullTestSummary& summary,
                           const std::filesystem::path& out_dir) {
  std::vector<std::string> names;
  for (const PullTest& test : tests) names.insert(names.end(), {test.test, test.direction});
  const UserTexts texts(names);
  ReportParts parts{.tables = {friction_table(summary)}};
  if (!tests.empty()) {
    parts.tables.push_back(pull_tests_table(summary));
    parts.figures.push_back(friction_figure(tests, summary));
  }
  write_parts(std::move(parts), out_dir, [](const std::vector<DrawnFigure>&) {});
}

}  // namespace glissade
