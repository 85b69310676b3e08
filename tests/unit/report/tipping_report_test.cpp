// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Contains;
using testing::Not;

/// The second record tips at the highest level, in a quarter of its histories.
Results made_up(double least_friction) {
  Results r = made_up_chart_results();
  TippingResults& tipping = r.tipping.emplace(TippingResults{{0.5, 0.4}, least_friction, {}});
  for (std::size_t i = 0; i < r.cases.combinations() * r.levels.size(); ++i) {
    const bool tips = i + 1 == r.levels.size();
    TippingShare row{0, "T 0.2 s", r.levels[i % r.levels.size()], 0.0, {}};
    row.by_record.assign(r.records.size(), 0.0);
    row.by_record[1] = tips ? 0.25 : 0.0;
    row.share = tips ? 0.025 : 0.0;
    tipping.shares.push_back(row);
  }
  return r;
}

TEST(tipping_report, names_the_records_that_tip_and_where) {
  const Results r = made_up(0.0);
  const Table table = table_named(r, "tipping");
  ASSERT_EQ(table.rows.size(), r.tipping->shares.size());
  const auto& row = table.rows.at(r.levels.size() - 1);
  EXPECT_EQ(std::get<std::string>(row.back()), r.records[1].id);
  EXPECT_EQ(std::get<double>(row.at(row.size() - 2)), 1.0);
  EXPECT_EQ(std::get<double>(row.at(row.size() - 3)), 0.025);
  EXPECT_EQ(std::get<std::string>(table.rows.front().back()), "");
  EXPECT_THAT(answer_sentences(r), Contains(states("1 of 10", "0.4 m", "1.50 g")));
  EXPECT_THAT(html_report(r, {}), states("tables/tipping.csv"));
}

TEST(tipping_report, of_a_body_that_slides_first_says_so) {
  EXPECT_THAT(answer_sentences(made_up(10.0)), Contains(states("cannot tip")));
}

TEST(tipping_report, is_absent_without_the_analysis) {
  const Results r = made_up_chart_results();
  EXPECT_THAT(summary_text(r), Not(testing::ContainsRegex("[Tt]ipping")));
  for (const Table& table : csv_tables(r)) EXPECT_NE(table.name, FileName("tipping"));
}

}  // namespace
}  // namespace glissade
