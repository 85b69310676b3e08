// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "facts.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;

TEST(summary, reports_fragilities_standards_skips_and_notes_in_ascii) {
  const std::string text = summary_text(
      made_up_results(),
      {{"histories whose roof peak stays in the stick range", "they cannot slip", 1234},
       {"a", "b", 0}});
  EXPECT_THAT(text, states("0.300 (11.8)", "SEAOC PV1-2012", "ASCE 7-16",
                           "stick range (1234): they", "\n  a: b\n"));
  for (const char c : text) EXPECT_LT(static_cast<unsigned char>(c), 128);
}

TEST(summary, begins_with_the_answer_then_warnings_then_evidence) {
  Results results = made_up_results();
  results.warnings.emplace_back("look out");
  const std::string text = summary_text(results),
                    answer = answer_sentences(results).front().substr(0, 20);
  EXPECT_LT(text.find(answer), text.find("WARNING: look out"));
  EXPECT_LT(text.find("WARNING: look out"), text.find("Model: "));
}

TEST(answer, reports_a_median_beyond_the_levels_studied) {
  Results results = made_up_results();
  results.runs[0].fragilities[0].capacities.curve.median = 3.0;  // levels end at 2 g
  EXPECT_THAT(answer_sentences(results)[0], states("extrapolates"));
}

TEST(answer, of_a_clearance_never_exceeded_is_a_lower_bound) {
  Results results = made_up_results();
  ThresholdFragility& fragility = results.runs[0].fragilities[3];
  fragility.stripes = fragility.capacities = FitSummary{};
  fragility.capacities.status = FitStatus::lower_bound;
  fragility.capacities.curve = {2.5, 0.4};
  EXPECT_THAT(answer_sentences(results)[3], states("S_DS = 2.50 g"));
}

TEST(summary, marks_an_assumed_log_std_and_names_medians_that_cross) {
  Results results = made_up_results();
  EXPECT_EQ(summary_text(results).find("cross"), std::string::npos);
  std::vector<ThresholdFragility>& f = results.runs[0].fragilities;
  f[1].capacities.curve.median = 0.95 * f[0].capacities.curve.median;
  f[3].stripes = f[3].capacities = FitSummary{};
  f[3].capacities.status = FitStatus::lower_bound;
  f[3].capacities.curve = {2.5, 0.4};
  EXPECT_THAT(summary_text(results),
              states("Fitted medians that cross", format_length(f[0].threshold_m) + " at",
                     format_length(f[1].threshold_m) + " at", "assumed 0.400"));
}

// 60 % slide freely: more than one half exceed at any intensity.
TEST(answer, contains_the_share_that_slides_freely) {
  Results results = made_up_results();
  std::vector<ThresholdFragility>& f = results.runs[0].fragilities;
  f[0].capacities.curve.floor = 0.2;
  f[1].capacities.curve.floor = 0.6;
  f[2].capacities = FitSummary{};
  f[2].capacities.status = FitStatus::always_exceeds;
  f[2].capacities.curve.floor = 1.0;
  f[2].stripes = f[2].capacities;
  const auto sentences = answer_sentences(results);
  const std::string half =
      "S_DS = " + format_number(f[0].capacities.curve.intensity_at(0.5)) + " g";
  EXPECT_THAT(sentences[0], states(half, "20 %"));
  EXPECT_THAT(sentences[1], states("60 %"));
  EXPECT_THAT(sentences[2], states("freely"));
  EXPECT_THAT(summary_text(results), states("20 %"));
}

TEST(answer, quotes_seaoc_at_1_g) {
  // 60 (1.0 - 0.4)^2 = 21.6 in, SEAOC PV1-2012.
  const auto sentences = answer_sentences(made_up_results());
  EXPECT_THAT(sentences, testing::Contains(states("SEAOC PV1-2012", format_length(0.54864))));
}

TEST(summary, names_recalled_provisions_only_where_there_are_some) {
  Results results = made_up_results();
  const auto names = [&](Provenance provenance) {
    for (StandardComparison& c : results.runs.front().standards)
      c.prescribed.provenance = provenance;
    return summary_text(results).find("Recalled") != std::string::npos;
  };
  EXPECT_TRUE(names(Provenance::recalled));
  EXPECT_FALSE(names(Provenance::checked));
}

TEST(summary, gives_the_probabilities_at_the_design_earthquakes) {
  Results results = made_up_results();
  EXPECT_TRUE(earthquakes_table(results).rows.empty());  // it has no design target
  results.model.dbe_level = results.levels[9];           // 1 g; 1.5 g is a level too
  const Table table = earthquakes_table(results);
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(table.columns[2].stem, "dbe_probability");
  EXPECT_EQ(table.columns[3].stem, "mce_probability");
  ASSERT_EQ(table.rows.size(), results.runs.size() * results.thresholds_m.size());
  EXPECT_EQ(std::get<NumberCell>(table.rows[1][2]).value,
            results.runs[0].fragilities[1].probability[9]);
  EXPECT_THAT(summary_text(results), states("DBE"));
}

// Which combination exceeds a prescribed displacement most often may differ from row to row.
TEST(answer, takes_for_each_prescribed_displacement_the_combination_that_exceeds_it_most) {
  Results results = made_up_results();
  results.cases.axes = {{"roof.slope_deg", "deg", {1.0, 2.0}, {}}};
  for (Case& c : results.cases.cases) c.friction_value = FrictionValue::as_drawn;
  for (std::size_t run : {0, 1}) {
    for (StandardComparison& c : results.runs[run].standards)
      c.exceedance_probability = (c.standard == Standard::asce7_16) == (run == 1) ? 0.4375 : 0.125;
  }
  const auto wanted = [](const char* standard, const char* slope) {
    return testing::Contains(states(standard, "44 %", slope));
  };
  EXPECT_THAT(answer_sentences(results), wanted("SEAOC PV1-2012", "slope 1 deg"));
  EXPECT_THAT(answer_sentences(results), wanted("ASCE 7-16", "slope 2 deg"));
}

TEST(answer, names_equal_intensity_measures_together_and_says_what_a_tie_is) {
  Results r = made_up_results();
  const auto row = [&](const char* name, double dispersion) {
    return RankedMeasure{.threshold_m = r.thresholds_m[0],
                         .name = name,
                         .dispersion = {dispersion, {0.8 * dispersion, 1.4 * dispersion}},
                         .smallest_share = dispersion < 0.2 ? 0.75 : 0.0};
  };
  r.intensity_measures = {row("Sa(0.5 s)", 0.09), row("roof acceleration", 0.09), row("PGA", 0.5)};
  EXPECT_THAT(answer_sentences(r),
              testing::Contains(states("Sa(0.5 s) = roof acceleration (0.09", "PGA (0.5")));
  const std::vector<Table> tables = csv_tables(r);
  const auto table = std::ranges::find(tables, FileName("intensity_measures"), &Table::name);
  ASSERT_NE(table, tables.end());
  EXPECT_THAT(table->notes, testing::Contains(states("Ties", "intervals overlap")));
  EXPECT_THAT(table->notes, testing::Contains(states("A and B")));
}

TEST(summary, of_nothing_is_still_text) {
  EXPECT_TRUE(answer_sentences(Results{}).empty());
  EXPECT_FALSE(summary_text(Results{}).empty());
}

}  // namespace
}  // namespace glissade
