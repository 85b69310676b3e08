// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "glissade/report/friction_report.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

void add_row(Table& table, const std::string& direction, const char* which, const MuStatistics& s) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  table.add({direction, std::string(which), static_cast<double>(s.tests), s.mean, s.std,
             s.mean_minus_2_std, s.lower_bound_95, s.normality ? s.normality->w : none,
             s.normality ? s.normality->p_value : none});
}

}  // namespace

Table pull_tests_table(const PullTestSummary& summary) {
  Table table{
      "pull_tests",
      "Each pull: force over normal force, largest before it slips and over its sliding part",
      {text_column("test", "Test"),
       text_column("direction", "Direction"),
       {"breakaway_mu", "", "Breakaway"},
       {"sliding_mu", "", "Sliding, mean"},
       {"sliding_std", "", "Std"},
       {"min_mu", "", "Least"},
       {"max_mu", "", "Largest"},
       {"mu_by_displacement", "", "Mean over displacement"},
       {"travel", "m", "Travel, m (in)", ColumnKind::length},
       {"speed", "m/s", "Speed, m/s"}},
      {}};
  for (const TraceFriction& t : summary.tests) {
    table.add({t.test, t.direction, t.breakaway_mu, t.sliding_mu, t.sliding_std, t.min_mu, t.max_mu,
               t.mu_by_displacement, t.travel_m, t.speed_mps});
  }
  return table;
}

Table friction_table(const PullTestSummary& summary) {
  Table table{"friction",
              "Friction over the tests of a direction, each test one value",
              {text_column("direction", "Direction"),
               text_column("friction", "Friction"),
               {"tests", "", "Tests", ColumnKind::count},
               {"mean", "", "Mean"},
               {"std", "", "Std"},
               {"mean_minus_2_std", "", "Mean - 2 std"},
               {"lower_bound_95", "", "95 % lower bound"},
               {"shapiro_wilk_w", "", "Shapiro-Wilk W"},
               {"shapiro_wilk_p", "", "p"}},
              {}};
  for (const DirectionFriction& d : summary.directions) {
    add_row(table, d.direction, "sliding", d.sliding);
    if (d.breakaway.tests > 0) add_row(table, d.direction, "breakaway", d.breakaway);
  }
  return table;
}

void write_friction_report(const std::vector<PullTest>& tests, const PullTestSummary& summary,
                           const std::filesystem::path& out_dir, bool overwrite) {
  ReportParts parts{.tables = {friction_table(summary)}};
  if (!tests.empty()) {
    parts.tables.push_back(pull_tests_table(summary));
    parts.figures.push_back(friction_figure(tests, summary));
  }
  write_parts(std::move(parts), out_dir, overwrite);
}

}  // namespace glissade
