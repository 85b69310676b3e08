// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/file.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

TEST(chart_summary, reports_the_clearance_beside_what_is_prescribed_in_ascii) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 0.0;
  const auto sentences = answer_sentences(results);
  // 1.1 x 0.125 m; 60 (1 - 0.4)^2 = 21.6 in = 0.549 m = 3.99 x 0.1375 m.
  EXPECT_THAT(sentences[0], HasSubstr("the recommended clearance is 0.138 m"));
  EXPECT_THAT(sentences[0], HasSubstr("A building period of 0.5 s governs"));
  EXPECT_THAT(sentences[1], HasSubstr("SEAOC PV1-2012 prescribes 0.549 m (21.6 in) there, 3.99 x"));
  const std::string text = summary_text(results);
  for (const char c : text) EXPECT_LT(static_cast<unsigned char>(c), 128);
  EXPECT_THAT(text, HasSubstr("slides"));
  EXPECT_THAT(text, HasSubstr("0.138"));
}

TEST(chart_summary, says_that_seaoc_is_not_for_the_shown_point) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 3.0;
  EXPECT_THAT(answer_sentences(results)[1],
              HasSubstr("it is for slopes under 3 degrees and friction above 0.4"));
}

TEST(chart_summary, answers_the_questions) {
  const auto sentences = answer_sentences(made_up_chart_results());
  EXPECT_THAT(sentences, Contains(HasSubstr("Displacement at S_DS = 1.00 g, slope 2 degrees, "
                                            "friction 0.5: clearance 0.275 m (10.8 in), mean")));
  EXPECT_THAT(sentences,
              Contains(HasSubstr("Friction needed for 0.500 m (19.7 in) at S_DS = 1.00 g, slope 2 "
                                 "degrees: clearance 0.450, mean 0.1 or less")));
  EXPECT_THAT(sentences, Contains(HasSubstr("largest record more than 0.8")));
}

TEST(chart_summary, states_what_the_largest_of_the_records_is_worth) {
  // 1 - 0.84^10 = 0.825, 1 - 0.95^10 = 0.401; one record is worth no such sentence.
  EXPECT_THAT(answer_sentences(made_up_chart_results()),
              Contains(testing::AllOf(HasSubstr("largest of 10 records"), HasSubstr("83 %"),
                                      HasSubstr("40 %"))));
  EXPECT_THAT(answer_sentences(made_up_one_record_chart()),
              testing::Not(Contains(HasSubstr("whatever their distribution"))));
}

TEST(chart_summary, counts_free_sliding_and_reports_uplift_and_rocking_only_where_they_are) {
  Results results = made_up_chart_results();
  // tan of 6, 6.5 and 7 degrees is above 0.1.
  EXPECT_THAT(answer_sentences(results), Contains(HasSubstr("At 3 of the chart's 225")));
  EXPECT_THAT(answer_sentences(results), Each(Not(HasSubstr("lifts off"))));
  results.chart->points[0].uplift_share = 0.03;
  results.chart->points[1].tip_share = 0.2;
  EXPECT_THAT(
      answer_sentences(results),
      Contains(HasSubstr("At S_DS = 1.00 g the array lifts off (outside the model) in no "
                         "history; in up to 3.0 % of those at a point at S_DS = 0.500 g.")));
  for (ChartPoint& p : results.chart->points)
    if (p.level == results.chart->shown_level) p.uplift_share = 0.02;
  EXPECT_THAT(answer_sentences(results),
              Contains(HasSubstr("in up to 2.0 % of the histories at a point of the chart")));
  EXPECT_THAT(answer_sentences(results), Contains(HasSubstr("begin to rock")));
}

TEST(chart_summary, of_a_shown_point_that_slides_freely_says_so) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 7.0;
  results.chart->shown_mu = 0.1;
  EXPECT_THAT(answer_sentences(results)[0], HasSubstr("no clearance is enough"));
  EXPECT_THAT(summary_text(results), Not(HasSubstr("inf ")));
}

TEST(chart_page, reports_chart_readings_standards_and_assumptions) {
  const std::string html = html_report(made_up_chart_results(), {});
  for (const char* part :
       {"<title>made_up_chart", "15 slopes x 15 coefficients of friction", "more than 0.8",
        "Verify against the standard", "Standards beside the results", "tables/chart.csv",
        "a recommendation, not a bound", "Linear in slope and friction"}) {
    EXPECT_THAT(html, HasSubstr(part));
  }
  for (const char* part : {"Fits in full", "first reaches the clearance", "drawn for each sample"})
    EXPECT_THAT(html, Not(HasSubstr(part)));
}

TEST(chart_page, of_one_record_without_standards_speaks_of_its_peak) {
  const std::string html = html_report(made_up_one_record_chart(), {});
  EXPECT_THAT(html, HasSubstr("Peak slip of the record"));
  EXPECT_THAT(html, Not(HasSubstr("Standards beside the results")));
}

TEST(chart_report, is_written_whole) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_chart_whole";
  fs::remove_all(folder);
  write_report(made_up_chart_results(), folder);
  const std::string html = read_text_file(folder / "report.html");
  for (const char* figure : {"chart_contours", "chart_friction", "chart_slope", "chart_intensity",
                             "chart_slope_levels", "chart_period", "spectra"}) {
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(figure) + ".pdf"))) << figure;
    EXPECT_THAT(html, HasSubstr("id=\"figure_" + std::string(figure) + "\""));
  }
  EXPECT_TRUE(fs::exists(folder / "tables" / "chart.csv"));
}

}  // namespace
}  // namespace glissade
