// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "analysis/shape/shape.hpp"
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

/// The first threshold is not lognormal and best predicted by two parts, the second has no
/// comparison.
Results made_up() {
  Results r = made_up_results();
  ShapeResults& shape = r.shape.emplace();
  for (RunResults& of : r.runs) {
    ShapeRun& run = shape.runs.emplace_back();
    run.label = of.label;
    for (ThresholdFragility& fragility : of.fragilities) {
      ThresholdShape& t = run.thresholds.emplace_back();
      t.threshold_m = fragility.threshold_m;
      t.status = ComparisonStatus::no_overlap;
      t.recrossed.assign(r.levels.size(), 0.0);
    }
    of.fragilities[0].lognormal = {0.01, 0.005, 0.3, -0.125, 0.5 * r.levels.back()};
    ThresholdShape& first = run.thresholds[0];
    first.status = ComparisonStatus::compared;
    first.score = {-0.3, -0.31, -0.35, -0.25, -0.29, std::nan("")};
    first.difference = {0.0, -0.01, -0.05, 0.05, 0.01, std::nan("")};
    first.standard_error = {0.0, 0.01, 0.01, 0.02, 0.02, std::nan("")};
    first.probability.assign(shape_model_count * r.levels.size(), 0.5);
    first.recrossed.back() = 0.25;
    run.crossings = {{first.threshold_m, run.thresholds[1].threshold_m, 0.75, 0.125, true}};
    run.surface = {{first.threshold_m, {0.5, {0.4, 0.6}}}};
    run.surface_log_std.value = 0.4;
  }
  return r;
}

TEST(shape_report, has_a_row_for_each_threshold_model_and_level) {
  const Results r = made_up();
  const std::size_t runs = r.runs.size(), thresholds = r.thresholds_m.size();
  EXPECT_EQ(table_named(r, "shape").rows.size(), runs * thresholds);
  EXPECT_EQ(table_named(r, "shape_models").rows.size(), runs * shape_model_count);
  EXPECT_EQ(table_named(r, "shape_levels").rows.size(), runs * thresholds * r.levels.size());
  EXPECT_EQ(table_named(r, "shape_crossings").rows.size(), runs);
  EXPECT_EQ(table_named(r, "shape_surface").rows.size(), runs);
  const auto models = table_named(r, "shape_models").rows;
  EXPECT_EQ(std::get<std::string>(models[2].back()), "worse");
  EXPECT_EQ(std::get<std::string>(models[3].back()), "better");
  EXPECT_EQ(std::get<std::string>(models[4].back()), "no clear difference");
}

TEST(shape_report, names_the_best_model_and_what_is_not_lognormal) {
  const Results r = made_up();
  const ThresholdShape& first = r.shape->runs[0].thresholds[0];
  EXPECT_EQ(best_model(first), ShapeModel::two_part);
  EXPECT_TRUE(differs_clearly(first, ShapeModel::two_part));
  EXPECT_FALSE(differs_clearly(first, ShapeModel::logit));
  EXPECT_FALSE(best_model(r.shape->runs[0].thresholds[1]));
  EXPECT_THAT(answer_sentences(r), Contains(states("p <= 0.005")));
  EXPECT_THAT(summary_text(r), states("lognormal"));
}

TEST(shape_report,
     figure_marks_the_gap_of_what_was_tested_and_draws_the_same_models_in_all_panels) {
  const Figure figure = shape_figure(made_up());
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_THAT(figure.panels[0].title, states("gap"));
  EXPECT_THAT(figure.panels[1].title, testing::Not(states("gap")));
  ASSERT_EQ(figure.panels[0].rules.size(), 1u);
  EXPECT_THAT(figure.panels[0].rules[0].label, states("largest gap"));
  EXPECT_TRUE(figure.panels[1].rules.empty());
  const auto models = [&](std::size_t panel) {
    std::vector<std::string> names;
    for (const DataSeries& series : figure.panels[panel].series) names.push_back(series.label);
    return names;
  };
  EXPECT_EQ(models(0), models(1));
  EXPECT_THAT(models(0), testing::Contains("two-part"));
}

}  // namespace
}  // namespace glissade
