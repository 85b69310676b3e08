// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "facts.hpp"
#include "made_up_results.hpp"
#include "page/symbols.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Not;

TEST(html_report, escapes_the_study_and_the_records) {
  Results results = made_up_results();
  results.study_name = "<script>alert(1)</script>";
  const std::string html = html_report(results, {});
  EXPECT_THAT(html, Not(testing::HasSubstr("<script")));
  EXPECT_THAT(
      html, states("&lt;script&gt;", "# a &lt;test&gt; &amp; nothing more", "Kobold &lt;1995&gt;"));
}

TEST(html_report, names_the_earthquakes_of_a_design_target) {
  Results results = made_up_results();
  EXPECT_THAT(html_report(results, {}), Not(states("DBE")));
  results.model.dbe_level = 1.0;
  EXPECT_THAT(html_report(results, {}), states("DBE", "S<sub>DS</sub> = 1.00 g", "MCE 1.50 g"));
  results.model.dbe_level = 1.035;  // 1.04 or 1.03 elsewhere would be another level
  EXPECT_THAT(html_report(results, {}), states("DBE", "S<sub>DS</sub> = 1.035 g"));
  results.levels = {1.0};
  EXPECT_THAT(html_report(results, {}), states("x 1 level"));
}

TEST(html_report, needs_nothing_from_outside) {
  const std::string html = html_report(made_up_results(), {});
  for (const char* reference : {"src=", "href=", "@import", "url("})
    EXPECT_THAT(html, Not(states(reference)));
}

TEST(html_report, states_what_is_assumed_and_what_must_be_verified) {
  const std::string html = html_report(made_up_results(), {});
  // What the model leaves out is promised to be said: here alone its words are compared.
  EXPECT_THAT(html, states("In plan", "Coulomb", "single-degree-of-freedom", "mass is neglected",
                           "Which component acts along the slope", "11 of 12 records",
                           "Verify against the standard"));
}

TEST(html_report, says_rigid_where_the_samples_have_no_period) {
  Results results = made_up_results();
  for (Case& c : results.cases.cases) c.period_s = 0.0;
  EXPECT_THAT(html_report(results, {}), states("Rigid"));
  EXPECT_THAT(html_report(results, {}), Not(states("mass is neglected")));
}

TEST(html_report, prints_a_table_of_many_columns_on_a_landscape_page) {
  const std::string html = html_report(made_up_results(), {});
  EXPECT_THAT(html, states("@page wide { size: landscape; }"));
  const std::size_t records = html.find("Ground motions of suite");
  EXPECT_GT(html.rfind("<div class=\"wide many\">", records), records - 100);
}

TEST(html_report, puts_the_drawing_in_the_page_without_its_xml_declaration) {
  const std::string html = html_report(
      made_up_results(),
      {{{"one", "Title", "", "Caption"}, "<?xml version=\"1.0\"?>\n<svg id=\"x\"></svg>"}});
  EXPECT_THAT(
      html,
      states("<div class=\"drawing\"><svg role=\"img\" aria-label=\"Title\" id=\"x\"></svg>"));
  EXPECT_THAT(html, Not(states("<?xml")));
}

TEST(html_report, has_the_description_of_a_drawing_and_not_its_title_which_covers_it) {
  const std::string html = html_report(
      made_up_results(), {{{"one", "Title", "", "Caption"},
                           "<svg id=\"x\"><title>Title</title><desc id=\"one_desc\">Up.</desc>"
                           "<g id=\"y\"></g></svg>"}});
  EXPECT_THAT(html, states("aria-describedby=\"one_desc\" id=\"x\"><desc id=\"one_desc\">Up."));
}

TEST(symbols, are_set_in_text_alone) {
  EXPECT_EQ(with_symbols("<p title=\"S_DS\">S_DS, a^2, my_file, t_1.csv</p>"),
            "<p title=\"S_DS\">S<sub>DS</sub>, a<sup>2</sup>, my_file, t_1.csv</p>");
  EXPECT_EQ(with_symbols("<pre>S_S</pre> S_S"), "<pre>S_S</pre> S<sub>S</sub>");
  for (const char* unclosed : {"S <pre>S_S", "S <svg S_S", "S <b S_S"})
    EXPECT_EQ(with_symbols(unclosed), unclosed);
}

// An id, a name and a description are shown as they are written, whatever they are like.
TEST(symbols, are_not_set_in_texts_of_the_user) {
  Results results = made_up_results();
  results.records.front().id = "R_1";
  results.study_name = "Roof T_a^2";
  results.study_description = "S_DS of x^2";
  const std::vector<DrawnFigure> none;
  {
    const UserTexts texts(user_texts(results));
    EXPECT_EQ(with_symbols("R_1, r_1: S_DS, T_L"),
              "R_1, r<sub>1</sub>: S<sub>DS</sub>, T<sub>L</sub>");
    const std::string html = html_report(results, none);
    EXPECT_THAT(html, states("Roof T_a^2</h1>", ">R_1<", "S_DS of x^2", "<sub>DS</sub>"));
  }
  EXPECT_EQ(with_symbols("R_1"), "R<sub>1</sub>");
}

}  // namespace
}  // namespace glissade
