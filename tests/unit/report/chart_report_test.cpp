// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
using testing::Contains;
using testing::Not;

// Levels that scale each record by itself: the factored mean is nothing to design with.
TEST(chart_summary, of_a_measure_that_is_no_design_spectrum_names_no_design_displacement) {
  Results results = made_up_chart_results();
  results.measure = IntensityMeasure::pga_g;
  EXPECT_EQ(table_named(results, "chart").columns[3].heading, "1.1 x mean slip, m (in)");
  const auto no_design = Not(testing::ContainsRegex("[Dd]esign displacement"));
  EXPECT_THAT(summary_text(results), no_design);
  for (const Figure& figure : make_figures(results))
    EXPECT_THAT(figure.title + figure.caption, no_design) << figure.title;
}

TEST(chart_summary, reports_the_clearance_beside_what_is_prescribed_in_ascii) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 0.0;
  const auto sentences = answer_sentences(results);
  // 1.1 x 0.125 m; 60 (1 - 0.4)^2 = 21.6 in = 0.549 m = 3.99 x 0.1375 m.
  EXPECT_THAT(sentences[0], states(format_length(0.1375), "0.5 s"));
  EXPECT_THAT(sentences, Contains(states("SEAOC PV1-2012", format_length(0.54864), "3.99 x")));
  EXPECT_THAT(sentences[1], states("Design displacement: 1.1 x the mean"));
  const std::string text = summary_text(results);
  for (const char c : text) EXPECT_LT(static_cast<unsigned char>(c), 128);
  EXPECT_THAT(text, states("0.138"));
}

TEST(chart_report, names_the_factor_of_the_study) {
  Results results = made_up_chart_results();
  EXPECT_THAT(table_named(results, "chart").columns[3].heading, states("1.1 x"));
  for (ChartPoint& p : results.chart->points) p.clearance_m *= 1.3 / 1.1;
  results.clearance = required_clearance(results, {.factor = 1.3});
  EXPECT_THAT(table_named(results, "chart").columns[3].heading, states("1.3 x"));
  EXPECT_THAT(answer_sentences(results), Contains(states("1.3 x")));
  std::string captions;
  for (const Figure& figure : make_figures(results))
    captions += figure.caption + (figure.panels.empty() ? "" : figure.panels[0].y.label) + "\n";
  EXPECT_THAT(captions, states("1.3 x"));
  EXPECT_THAT(captions + html_report(results, {}), Not(states("1.1 x")));
}

TEST(chart_summary, says_that_seaoc_is_not_for_the_shown_point) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 3.5;
  EXPECT_THAT(answer_sentences(results), Contains(states("3 degrees", "0.4")));
  results.chart->shown_slope_deg = 0.0;
  EXPECT_THAT(answer_sentences(results), Not(Contains(states("3 degrees"))));
}

TEST(chart_summary, answers_the_questions) {
  const auto sentences = answer_sentences(made_up_chart_results());
  EXPECT_THAT(sentences, Contains(states("friction 0.5", "0.275 m")));
  EXPECT_THAT(sentences, Contains(states("0.500 m", "0.450", "0.8")));
}

TEST(chart_summary, states_what_the_largest_of_the_records_is_worth) {
  // 1 - 0.84^10 = 0.825, 1 - 0.95^10 = 0.401; one record is worth no such sentence.
  EXPECT_THAT(answer_sentences(made_up_chart_results()),
              Contains(states("10 records", "83 %", "40 %")));
  EXPECT_THAT(answer_sentences(made_up_one_record_chart()), Not(Contains(states("confidence"))));
}

TEST(chart_summary, never_counts_samples_as_records) {
  Results results = made_up_chart_results();
  const auto head_of_chart = [&] {
    const Table table = table_named(results, "chart");
    std::string text = table.title;
    for (const std::string& note : table.notes) text += "\n" + note;
    return text;
  };
  EXPECT_THAT(head_of_chart(), Not(states("samples")));
  results.cases.samples = 8;
  EXPECT_THAT(head_of_chart(), states("10 records", "8 samples"));
  EXPECT_THAT(head_of_chart(), Not(states("80 records")));
  // Of what pooled samples are worth nothing is said.
  EXPECT_THAT(answer_sentences(results), Not(Contains(states("confidence"))));
}

TEST(chart_summary, counts_free_sliding_and_reports_uplift_only_where_it_is) {
  Results results = made_up_chart_results();
  // tan of 6, 6.5 and 7 degrees is above 0.1.
  EXPECT_THAT(answer_sentences(results), Contains(states("3", "225")));
  EXPECT_THAT(answer_sentences(results), Not(Contains(states("lifts"))));
  results.chart->points[0].uplift_share = 0.03;
  EXPECT_THAT(answer_sentences(results), Contains(states("lifts", "3.0 %", "S_DS = 0.500 g")));
  for (ChartPoint& p : results.chart->points)
    if (p.level == results.chart->shown_level) p.uplift_share = 0.02;
  EXPECT_THAT(answer_sentences(results), Contains(states("lifts", "2.0 %")));
}

TEST(chart_summary, of_a_shown_point_that_slides_freely_says_so) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 7.0;
  results.chart->shown_mu = 0.1;
  EXPECT_THAT(answer_sentences(results)[0], Not(testing::ContainsRegex("[0-9] m ")));
  EXPECT_THAT(summary_text(results), Not(states("inf")));
}

TEST(chart_page, has_tables_readings_and_standards_where_there_are_some) {
  const std::string html = html_report(made_up_chart_results(), {});
  EXPECT_THAT(html, states("<title>made_up_chart", "more than 0.8", "ASCE 7-16", "tables/chart.csv",
                           "<caption>"));
  EXPECT_THAT(html_report(made_up_one_record_chart(), {}), Not(states("ASCE 7-16")));
}

TEST(chart_report, is_written_whole) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_chart_whole";
  fs::remove_all(folder);
  write_report(made_up_chart_results(), folder);
  const std::string html = read_text_file(folder / "report.html");
  for (const char* figure : {"chart_contours", "chart_friction", "chart_slope", "chart_intensity",
                             "chart_slope_levels", "chart_period", "spectra"}) {
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(figure) + ".pdf"))) << figure;
    EXPECT_THAT(html, states("id=\"figure_" + std::string(figure) + "\""));
  }
  EXPECT_TRUE(fs::exists(folder / "tables" / "chart.csv"));
}

}  // namespace
}  // namespace glissade
