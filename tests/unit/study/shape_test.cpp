// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of fragilities of histories that can be followed by hand.
#include "glissade/study/analysis/shape.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "glissade/study/results.hpp"

namespace glissade {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Four records of two cases at three levels; nothing slides. Two thresholds.
Results by_hand() {
  Results r;
  r.levels = {0.5, 1.0, 2.0};
  r.thresholds_m = {0.1, 0.4};
  r.cases.samples = 2;
  r.cases.cases.resize(2);
  for (Case& c : r.cases.cases) c.friction = c.friction_across = 0.5;
  r.histories = {4, 2, 3, 2, {}};
  r.histories.fields.peak_displacement_m.assign(4 * 2 * 3, 0.0);
  r.histories.fields.capacity.assign(4 * 2 * 2, infinity);
  RunResults run;
  run.label = "sampled";
  run.cases = 2;
  for (const double threshold_m : r.thresholds_m) {
    run.fragilities.emplace_back().threshold_m = threshold_m;
    run.fragilities.back().capacities.status = FitStatus::maximum_likelihood;
  }
  run.fragilities[0].capacities.curve = {1.0, 0.3};
  run.fragilities[1].capacities.curve = {1.2, 0.6};
  r.runs = {run};
  return r;
}

/// Displacements of one history at the three levels, and the capacities that they have.
void slide(Results& r, std::size_t record, std::size_t c, std::vector<double> displacement_m) {
  for (std::size_t level = 0; level < 3; ++level)
    r.histories.fields.peak_displacement_m[r.histories.at(record, c, level)] =
        displacement_m[level];
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t level = 3; level-- > 0;) {
      if (displacement_m[level] >= r.thresholds_m[t])
        r.histories.fields.capacity[(record * 2 + c) * 2 + t] = 0.9 * r.levels[level];
    }
  }
}

TEST(shape, recrossings_are_counted_at_the_level_where_they_are) {
  Results r = by_hand();
  slide(r, 0, 0, {0.2, 0.05, 0.3});
  slide(r, 1, 1, {0.5, 0.3, 0.2});
  const ShapeRun run = ShapeAnalysis::find({}, r).runs.at(0);
  EXPECT_THAT(run.thresholds[0].recrossed, ElementsAre(0.0, 0.125, 0.0));
  EXPECT_THAT(run.thresholds[1].recrossed, ElementsAre(0.0, 0.125, 0.125));
}

TEST(shape, crossings_of_the_fits_are_found) {
  Results r = by_hand();
  const ShapeRun run = ShapeAnalysis::find({}, r).runs.at(0);
  ASSERT_EQ(run.crossings.size(), 1u);
  EXPECT_NEAR(run.crossings[0].intensity, 1 / 1.2, 1e-12);
  EXPECT_TRUE(run.crossings[0].within_levels);
  r.levels = {1.0, 1.5, 2.0};
  EXPECT_FALSE(ShapeAnalysis::find({}, r).runs.at(0).crossings.at(0).within_levels);
  r.runs[0].fragilities[1].capacities.status = FitStatus::lower_bound;
  EXPECT_TRUE(ShapeAnalysis::find({}, r).runs.at(0).crossings.empty());
}

/// Every record slides a little earlier or later, with an overlap that no record alone makes.
Results rising() {
  Results r = by_hand();
  for (std::size_t record = 0; record < 4; ++record) {
    slide(r, record, 0, record < 2 ? std::vector{0.15, 0.2, 0.5} : std::vector{0.0, 0.05, 0.2});
    slide(r, record, 1, {0.0, record % 2 == 0 ? 0.2 : 0.05, 0.5});
  }
  return r;
}

TEST(shape, models_are_compared_and_one_surface_is_fitted) {
  const Results r = rising();
  const ShapeRun run = ShapeAnalysis::find({}, r).runs.at(0);
  const ThresholdShape& shape = run.thresholds[0];
  ASSERT_EQ(shape.status, ComparisonStatus::compared);
  ASSERT_EQ(shape.score.size(), shape_model_count);
  EXPECT_EQ(shape.difference[0], 0.0);
  // Observed shares: 2, 4 and 8 of 8.
  EXPECT_THAT((std::vector{shape.probability_at(ShapeModel::monotone, 0),
                           shape.probability_at(ShapeModel::monotone, 1),
                           shape.probability_at(ShapeModel::monotone, 2)}),
              Pointwise(DoubleNear(1e-12), {0.25, 0.5, 1.0}));
  ASSERT_EQ(run.surface.size(), 2u);
  EXPECT_LT(run.surface[0].median.value, run.surface[1].median.value);
  EXPECT_GT(run.surface_log_std.value, 0.0);
}

// A displacement that is not known: above all thresholds, as where it was not computed.
TEST(shape, two_parts_are_not_fitted_where_a_displacement_is_not_known) {
  Results r = rising();
  r.histories.fields.peak_displacement_m[r.histories.at(0, 0, 2)] = infinity;
  const ShapeResults results = ShapeAnalysis::find({}, r);
  const ThresholdShape& shape = results.runs.at(0).thresholds[0];
  EXPECT_TRUE(std::isnan(shape.score[static_cast<std::size_t>(ShapeModel::two_part)]));
  EXPECT_FALSE(std::isnan(shape.score[static_cast<std::size_t>(ShapeModel::logit)]));
}

}  // namespace
}  // namespace glissade
