// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "glissade/report/write_report.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::states;
using testing::Not;

TEST(impact_report, is_absent_where_the_study_does_not_ask_for_it) {
  const Results results = made_up_results();
  EXPECT_TRUE(impact_table(results).rows.empty());
  for (const Table& table : csv_tables(results)) EXPECT_NE(table.name.text(), "impact");
  for (const Figure& figure : make_figures(results)) EXPECT_NE(figure.name.text(), "impact");
  EXPECT_THAT(html_report(results, {}), Not(states("tables/impact.csv")));
}

TEST(impact_report, writes_table_figure_and_section) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_report_impact";
  fs::remove_all(folder);
  write_report(made_up_impact_results(), folder);
  EXPECT_TRUE(fs::exists(folder / "figures" / "impact.pdf"));
  const std::string html = read_text_file(folder / "report.html");
  EXPECT_THAT(html, states("id=\"figure_impact\"", "tables/impact.csv"));
  EXPECT_THAT(read_text_file(folder / "tables" / "impact.csv"),
              states("run,threshold_m,level_g,reached_share,reached_share_low95,"
                     "reached_share_high95,p16_speed_mps,median_speed_mps,median_speed_low95_mps,"
                     "median_speed_high95_mps,p84_speed_mps,",
                     "median_energy_Jpkg,p84_energy_Jpkg,p16_time_s,median_time_s,p84_time_s\n"));
}

TEST(impact_report, has_a_row_for_each_run_threshold_and_level_with_energy_v2_over_2) {
  Results results = made_up_impact_results();
  results.runs[0].impact[5].speed_median_mps.value = 3.0;
  results.runs[0].impact[5].speed_p84_mps.value = 4.0;
  const Table table = impact_table(results);
  ASSERT_EQ(table.rows.size(), 2u * 4u * 20u);
  EXPECT_EQ(std::get<double>(table.rows[5][9]), 4.5);  // J/kg
  EXPECT_EQ(std::get<double>(table.rows[5][10]), 8.0);
}

TEST(impact_report, answers_at_the_level_nearest_1_g_with_the_share_that_gets_there) {
  Results results = made_up_impact_results();
  for (ImpactStatistics& s : results.runs[0].impact) s.reached_share.value = 0.0;
  ImpactStatistics& s = results.runs[0].impact[20 + 9];  // 0.3 m, 1.0 g
  s.reached_share.value = 0.25;
  s.speed_median_mps.value = 0.5;
  s.speed_p84_mps.value = 0.75;
  EXPECT_THAT(answer_sentences(results),
              testing::Contains(
                  states("S_DS = 1.00 g", "0.500 and 0.750 m/s", format_length(0.3), "25 %")));
  s.reached_share.value = 0.0;
  EXPECT_THAT(answer_sentences(results), Not(testing::Contains(states("m/s"))));
}

// 1.2 m is reached by few: where fewer than three records reach it the figure shows no point.
TEST(impact_report, draws_only_what_enough_records_reach) {
  Results results = made_up_impact_results();
  RunResults& run = results.runs[0];
  auto& speed_mps = results.histories.fields.crossing_speed_mps;
  auto& time_s = results.histories.fields.crossing_time_s;
  const std::size_t of_record = speed_mps.size() / results.records.size();
  const auto forget_all_but = [&](std::size_t records) {
    for (std::size_t i = records * of_record; i < speed_mps.size(); ++i)
      speed_mps[i] = time_s[i] = std::nan("");
    run.impact =
        impact_statistics(results.histories, slice_of(run), results.levels, results.thresholds_m);
  };
  EXPECT_THAT(key_of(impact_figure(results, run)), testing::Contains(states("= 2.00 g")));
  forget_all_but(3);
  const std::vector<DataSeries> curves = curves_of(impact_figure(results, run));
  ASSERT_FALSE(curves.empty());
  EXPECT_GT(numbers_in(curves[0]), 0u);
  forget_all_but(2);
  EXPECT_TRUE(impact_figure(results, run).panels.empty());
  for (const Figure& figure : make_figures(results)) EXPECT_NE(figure.name.text(), "impact");
}

}  // namespace
}  // namespace glissade
