// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed displacements judged by histories that can be followed by hand.
#include "glissade/study/analysis/verdict.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "analysis/pooled_level.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// Ten records, four samples, friction 0.5 and 0.3 on buildings of 0.2 and 1 s, at 1 g, 1.2 g and
/// 1.5 g. SEAOC prescribes 60 x 0.36 in at 1 g.
struct TwoFrictions {
  static constexpr std::size_t records = 10, samples = 4;
  StudyConfig config;
  Results results;

  TwoFrictions() {
    config.verdict.emplace();
    config.standards.compare = {Standard::seaoc_pv1_2012};
    config.sampling.bootstrap_replicates = 200;
    results.levels = {1.0, 1.2, 1.5};
    results.records.resize(records);
    CaseSet& set = results.cases;
    set.axes = {{"building.period_s", "s", {0.2, 1.0}, {}}, {"friction.mu", "-", {0.5, 0.3}, {}}};
    set.samples = samples;
    for (const double period_s : {0.2, 1.0}) {
      for (const double mu : {0.5, 0.3}) {
        for (std::size_t i = 0; i < samples; ++i) {
          Case c;
          c.period_s = period_s;
          c.friction = mu;
          c.slope_deg = 1.0;
          set.cases.push_back(c);
        }
      }
    }
    results.histories = {records, set.size(), results.levels.size(), 0, {}};
    results.histories.fields.peak_displacement_m.assign(
        records * set.size() * results.levels.size(), 0.1);
  }
  /// All histories of a record on a combination.
  void slide(std::size_t record, std::size_t combination, std::size_t level, double peak_m) {
    for (std::size_t i = 0; i < samples; ++i) {
      const std::size_t at = results.histories.at(record, combination * samples + i, level);
      results.histories.fields.peak_displacement_m[at] = peak_m;
    }
  }
};

constexpr double prescribed_m = 60.0 * 0.36 * 0.0254;  // 60 (S_DS - 0.4)^2 in

TEST(verdict, is_on_levels_of_which_the_MCE_is_a_level_too) {
  const TwoFrictions made;
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  ASSERT_EQ(verdict.rows.size(), 2u);  // 1 g for either friction; 1.2 and 1.5 g have no MCE
  EXPECT_EQ(verdict.rows[0].mu, 0.5);
  EXPECT_EQ(verdict.rows[1].mu, 0.3);
  EXPECT_NEAR(verdict.rows[0].prescribed.value_m, prescribed_m, 1e-12);
  EXPECT_TRUE(verdict.rows[0].within_conditions);
  EXPECT_FALSE(verdict.rows[1].within_conditions);  // friction above 0.4
}

// R = 4 of a design target of 1.2 g is not the building of a design earthquake of 1 g.
TEST(verdict, of_buildings_with_R_is_at_the_S_DS_that_gives_their_strength) {
  TwoFrictions made;
  made.results.levels = {1.0, 1.2, 1.5, 1.8};
  made.results.histories.levels = 4;
  made.results.histories.fields.peak_displacement_m.resize(
      TwoFrictions::records * made.results.cases.size() * 4, 0.1);
  ASSERT_EQ(VerdictAnalysis::find(made.config, made.results).rows.size(), 4u);
  made.results.model.dbe_level = 1.2;
  for (Case& c : made.results.cases.cases) c.response_modification = 4.0;
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  ASSERT_EQ(verdict.rows.size(), 2u);
  EXPECT_EQ(verdict.rows[0].sds_g, 1.2);
}

TEST(verdict, takes_the_building_that_makes_each_number_largest) {
  TwoFrictions made;
  made.slide(0, 0, 0, 2.0 * prescribed_m);  // 0.2 s, DBE
  made.slide(1, 2, 0, 3.0 * prescribed_m);  // 1 s, DBE: two records
  made.slide(2, 2, 0, 3.0 * prescribed_m);
  for (std::size_t record = 0; record < 4; ++record) made.slide(record, 0, 2, 9.0);  // 0.2 s, MCE
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  const VerdictRow& row = verdict.rows[0];
  EXPECT_DOUBLE_EQ(row.dbe.probability, 0.2);
  EXPECT_EQ(row.dbe.period_s, 1.0);
  EXPECT_DOUBLE_EQ(row.mce.probability, 0.4);
  EXPECT_EQ(row.mce.period_s, 0.2);
  EXPECT_LT(row.dbe.interval.low, 0.1);
  EXPECT_GT(row.dbe.interval.high, 0.2);
  EXPECT_EQ(judgement(verdict, row), Judgement::exceeded);
  EXPECT_FALSE(is_certain(verdict, row));  // two records of ten
  EXPECT_DOUBLE_EQ(row.displacement_m.at(2), 3.0 * prescribed_m);
}

TEST(verdict, of_nothing_exceeded_is_no_more_certain_than_the_records_are_many) {
  const TwoFrictions made;
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  const VerdictRow& row = verdict.rows[0];
  EXPECT_EQ(row.dbe.probability, 0.0);
  EXPECT_NEAR(row.dbe.interval.high, 1.0 - std::pow(0.025, 0.1), 1e-12);  // 31 % of ten records
  EXPECT_EQ(judgement(verdict, row), Judgement::conservative);            // 0.55 m against 0.1 m
  EXPECT_FALSE(is_certain(verdict, row));
}

TEST(verdict, has_no_upper_end_of_what_few_records_do_not_bound) {
  const TwoFrictions made;  // ten records
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  for (const Interval& interval : verdict.rows[0].displacement_interval) {
    EXPECT_TRUE(std::isfinite(interval.low));
    EXPECT_TRUE(std::isinf(interval.high));
  }
}

// A slip of 1 to 72 m on each of as many records. None above is 1 - 0.025^(1/72) = 5.0 % at most.
TEST(pooled_level, bounds_the_slip_that_a_part_exceeds_by_the_interval_of_that_part) {
  std::vector<std::vector<double>> slips;
  for (int record = 1; record <= 72; ++record) slips.push_back({1.0 * record});
  const PooledLevel pooled(slips);
  const Interval of_10 = pooled.exceeded_interval(0.10);
  EXPECT_LT(of_10.high, 72.0);
  EXPECT_LE(pooled.wide_share_interval(of_10.high).high, 0.10);
  EXPECT_GT(pooled.wide_share_interval(of_10.high - 1.0).high, 0.10);
  EXPECT_LE(pooled.wide_share_interval(of_10.low).low, 0.10);
  EXPECT_GT(pooled.wide_share_interval(of_10.low - 1.0).low, 0.10);
  EXPECT_EQ(pooled.exceeded_interval(0.05).high, 72.0);
  EXPECT_TRUE(std::isinf(pooled.exceeded_interval(0.01).high));
}

TEST(verdict, of_an_array_that_slides_freely_is_exceeded) {
  TwoFrictions made;
  for (std::size_t record = 0; record < TwoFrictions::records; ++record)
    made.slide(record, 1, 0, std::numeric_limits<double>::infinity());
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  EXPECT_EQ(verdict.rows[1].dbe.probability, 1.0);
  EXPECT_TRUE(std::isinf(verdict.rows[1].displacement_m.front()));
  EXPECT_EQ(judgement(verdict, verdict.rows[1]), Judgement::exceeded);
  EXPECT_TRUE(is_certain(verdict, verdict.rows[1]));
  EXPECT_EQ(verdict.rows[0].dbe.probability, 0.0);
}

TEST(verdict, has_the_exact_friction_of_cases_that_share_it) {
  TwoFrictions made;  // six times 0.4 is not 2.4
  made.config.standards.compare = {Standard::asce7_16};
  for (Case& c : made.results.cases.cases) c.friction = 0.4;
  const VerdictResults verdict = VerdictAnalysis::find(made.config, made.results);
  EXPECT_EQ(verdict.rows[0].mu, 0.4);
  EXPECT_TRUE(verdict.rows[0].within_conditions);  // of ASCE 7-16: 0.4 or more
}

// Issue 34: by the mean of 16 samples one seed was within and three outside.
TEST(verdict, judges_conditions_by_the_stated_mean_and_not_by_what_was_drawn) {
  TwoFrictions made;
  made.config.standards.compare = {Standard::asce7_16, Standard::seaoc_pv1_2012};
  made.config.quantities.at("friction", "mu") = {{}, Distribution(Normal{0.4, 0.04})};
  for (const double drawn : {0.39, 0.41}) {
    for (Case& c : made.results.cases.cases) c.friction = drawn;
    for (const VerdictRow& row : VerdictAnalysis::find(made.config, made.results).rows) {
      EXPECT_EQ(row.mu, 0.4);
      EXPECT_TRUE(row.within_conditions);
    }
  }
  made.config.quantities.at("friction", "mu").drawn = Normal{0.39, 0.04};
  for (const VerdictRow& row : VerdictAnalysis::find(made.config, made.results).rows)
    EXPECT_FALSE(row.within_conditions);
}

TEST(verdict, has_the_four_separations_and_between_arrays_those_of_neighbours) {
  TwoFrictions made;
  made.slide(0, 0, 0, 3.0 * prescribed_m);  // one record of ten beyond twice the value
  made.slide(1, 0, 0, 1.5 * prescribed_m);
  const auto found = VerdictAnalysis::find(made.config, made.results).separations;
  ASSERT_EQ(found.size(), 6u);  // two rows, no neighbours
  EXPECT_EQ(found[0].factor, 1.0);
  EXPECT_DOUBLE_EQ(found[0].dbe.probability, 0.2);
  EXPECT_EQ(found[2].factor, 2.0);
  EXPECT_NEAR(found[2].value_m, 2.0 * prescribed_m, 1e-12);
  EXPECT_DOUBLE_EQ(found[2].dbe.probability, 0.1);
  EXPECT_EQ(found[5].row, 1u);

  HistoryFields& fields = made.results.histories.fields;
  fields.closing_along_m.assign(fields.peak_displacement_m.size(), 0.0);
  fields.closing_across_m = fields.closing_along_m;
  for (Case& c : made.results.cases.cases) c.neighbour_friction = 0.4;
  for (std::size_t i = 0; i < TwoFrictions::samples; ++i)  // 1 s, MCE
    fields.closing_across_m[made.results.histories.at(4, 2 * TwoFrictions::samples + i, 2)] =
        0.51 * prescribed_m;
  const VerdictResults both = VerdictAnalysis::find(made.config, made.results);
  ASSERT_EQ(both.separations.size(), 10u);
  EXPECT_THAT(both.separations[0].what, testing::HasSubstr("along the slope"));
  EXPECT_EQ(both.separations[0].mce.probability, 0.0);
  EXPECT_THAT(both.separations[1].what, testing::HasSubstr("across the slope"));
  EXPECT_EQ(both.separations[1].factor, 0.5);
  EXPECT_EQ(both.separations[1].dbe.probability, 0.0);
  EXPECT_DOUBLE_EQ(both.separations[1].mce.probability, 0.1);
  EXPECT_EQ(both.separations[1].mce.period_s, 1.0);

  for (Case& c : made.results.cases.cases) c.neighbour_slope = NeighbourSlope::facing;
  const VerdictResults valley = VerdictAnalysis::find(made.config, made.results);
  EXPECT_THAT(valley.separations[0].what, testing::HasSubstr("facing slopes"));
  EXPECT_DOUBLE_EQ(valley.separations[1].mce.probability, 0.1);
}

TEST(verdict, finds_levels_to_rounding) {
  EXPECT_EQ(level_at({0.4, 0.6, 1.875}, 1.5 * 0.4), 1u);
  EXPECT_EQ(level_at({0.4, 0.6, 1.875}, 1.5 * 1.25), 2u);
  EXPECT_EQ(level_at({0.4, 0.6}, 0.5), 2u);
}

}  // namespace
}  // namespace glissade
