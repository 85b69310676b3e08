// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "glissade/block/two_axis.hpp"
#include "glissade/building/motion_table.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"
#include "unit/study/clearance_motions.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::listed;
using test::shaking;
using test::suite_of;
using Axis = ConditionAxis;

StudyConfig config() {
  StudyConfig c;
  c.name = "clearance";
  c.file = "study.toml";
  c.suite_files = {"suite.toml"};
  c.intensity.measure = IntensityMeasure::mce_fraction;
  c.intensity.levels = {1.0};
  c.model.axes = SlidingAxes::two;
  c.quantities.at("building", "period_s") = fixed(0.3);
  c.quantities.at("building", "mass_ratio") = fixed(0.05);
  c.quantities.at("roof", "slope_deg") = fixed(1.2);
  c.quantities.at("friction", "mu") = fixed(0.3);
  c.orientation = {OrientationChoice::all_permutations, {SlopeAxis::e_w, SlopeAxis::n_s}};
  c.clearance = ClearanceConfig{.without_target = true};
  c.base_shear = true;
  return c;
}

StudyConfig as_recorded_config() {
  StudyConfig c = config();
  c.orientation = {OrientationChoice::as_recorded, {SlopeAxis::e_w}};
  return c;
}

Plan plan_of(const StudyConfig& c, std::vector<Motion> motions) {
  return make_plan(c, {suite_of(std::move(motions))});
}

Results run(const Plan& plan) { return test::run(plan); }

Results run(const StudyConfig& c, std::vector<Motion> motions) {
  return run(plan_of(c, std::move(motions)));
}

/// History number `i` of a record in an orientation.
ConditionHistory history(const Results& results, std::size_t record, std::size_t orientation,
                         std::size_t i) {
  const ConditionGrid grid(results);
  return grid.history(record, orientation, grid.position(i));
}

TEST(clearance_grid, has_every_combination_of_places_the_period_varying_fastest) {
  StudyConfig c = config();
  c.support = {ArraySupport::isolated, ArraySupport::no_array};
  c.quantities.at("building", "mass_ratio") = listed({0.0, 0.05, 0.1});
  c.quantities.at("roof", "slope_deg") = listed({1.0, 2.0});
  c.quantities.at("building", "period_s") = listed({0.2, 0.4, 0.7});
  const Results results =
      test::results_by_rule(c, {{}}, [](const auto&) { return test::MadeUpHistory(); });
  const ConditionGrid grid(results);
  ASSERT_EQ(grid.count(), 36u);
  std::set<std::size_t> cases;
  for (const Condition& at : all_conditions(grid)) cases.insert(grid.first_case(at));
  EXPECT_EQ(cases.size(), 36u);
  EXPECT_EQ(grid.position(1)[Axis::period], 1u);
  EXPECT_EQ(along(grid, Axis::mass, grid.position(35)).size(), 3u);
  EXPECT_EQ(all_but(grid, Axis::period).size(), 12u);
  const Case& last = grid.case_at(grid.position(35));
  EXPECT_EQ(last.support, ArraySupport::no_array);
  EXPECT_EQ(last.mass_ratio, 0.1);
  EXPECT_EQ(last.slope_deg, 2.0);
  EXPECT_EQ(last.period_s, 0.7);
}

TEST(clearance, of_listed_friction_and_damping_is_that_of_a_study_for_each) {
  const std::vector<double> mu = {0.25, 0.35}, damping = {0.02, 0.05};
  StudyConfig c = as_recorded_config();
  c.quantities.at("friction", "mu") = listed(mu);
  c.quantities.at("building", "damping") = listed(damping);
  const Results together = run(c, {shaking("a", 6.0, 0.4)});
  const ConditionGrid grid(together);
  ASSERT_EQ(grid.size(Axis::listed), 4u);
  std::vector<double> seen;
  for (const Condition& at : along(grid, Axis::listed)) {
    const std::size_t place = at[Axis::listed];
    const std::size_t slow = place / 2, fast = place % 2;
    const bool mu_is_slow =
        grid.case_at({}).friction == grid.case_at(Condition().with(Axis::listed, 1)).friction;
    StudyConfig one = as_recorded_config();
    one.quantities.at("friction", "mu") = fixed(mu[mu_is_slow ? slow : fast]);
    one.quantities.at("building", "damping") = fixed(damping[mu_is_slow ? fast : slow]);
    const Results alone = run(one, {shaking("a", 6.0, 0.4)});
    EXPECT_EQ(grid.case_at(at).friction, ConditionGrid(alone).case_at({}).friction);
    EXPECT_EQ(suite_mean(together, {}, 0, at), suite_mean(alone, {}, 0, {}))
        << grid.listed_text(place);
    seen.push_back(suite_mean(alone, {}, 0, {}));
  }
  std::ranges::sort(seen);
  EXPECT_EQ(std::ranges::unique(seen).size(), 0u);  // the four differ
}

TEST(clearance, of_an_array_that_slides_freely_is_none_that_is_enough) {
  StudyConfig c = as_recorded_config();
  c.quantities.at("roof", "slope_deg") = listed({1.0, 20.0});
  c.support = {ArraySupport::isolated, ArraySupport::anchored};
  const Results results = run(c, {shaking("a", 6.0, 0.4)});
  Condition steep;
  steep[Axis::slope] = 1;
  EXPECT_TRUE(std::isfinite(suite_mean(results, {}, 0, {})));
  EXPECT_TRUE(std::isinf(suite_mean(results, {}, 0, steep)));
  steep[Axis::support] = 1;  // does not slide
  EXPECT_TRUE(std::isfinite(suite_mean(results, {}, 0, steep)));
}

TEST(clearance, a_rigid_building_is_the_block_on_the_ground_in_every_orientation) {
  StudyConfig c = config();
  c.quantities.at("building", "period_s") = fixed(0.0);
  c.quantities.at("building", "mass_ratio") = fixed(0.0);
  c.friction.across_is_given = true;
  c.friction.values = {FrictionValue::design};  // mean - 2 std: 0.36 along N-S
  c.quantities.at("friction", "across_mu") = test::drawn(Normal{0.4, 0.02});
  const Motion motion = shaking("a", 6.0, 0.4);
  const Results results = run(c, {motion});
  const double mu[] = {0.3, 0.36};
  ASSERT_EQ(results.cases.orientations, 16u);
  for (std::size_t o = 0; o < results.cases.orientations; ++o) {
    // The components by the orientation's own words.
    const std::string words = to_string(orientation_at(results, o));
    const std::size_t first = words.find("it +first") != words.npos   ? 0
                              : words.find("it -first") != words.npos ? 0
                                                                      : 1;
    const double along = words.find("along it +") != words.npos ? 1.0 : -1.0;
    const double across = words.find("across +") != words.npos ? 1.0 : -1.0;
    std::array<std::vector<double>, 2> a{motion.horizontal_mps2[first].copy(),
                                         motion.horizontal_mps2[1 - first].copy()};
    for (double& x : a[0]) x *= along;
    for (double& x : a[1]) x *= across;
    const auto axis = static_cast<std::size_t>(orientation_at(results, o).slope_axis);
    const SlipResult direct = slide_two_axis(
        {.dt_s = motion.dt_s,
         .horizontal_mps2 = {a[0], a[1]},
         .vertical_mps2 = motion.vertical_mps2},
        {.friction = {mu[axis], mu[1 - axis]}, .slope_rad = 1.2 * rad_per_deg}, 1e-8);
    const ConditionHistory h = history(results, 0, o, 0);
    ASSERT_GT(direct.peak_displacement_m, 0.01);
    // The kernel's tolerance is 1e-6 a step; noise of many phases may take thirty of it.
    const double within = 3e-5 * direct.peak_displacement_m;
    EXPECT_NEAR(h.peak_m(), direct.peak_displacement_m, within) << words;
    EXPECT_NEAR(h.displacement_m(), srss_of_maxima_m(direct), within) << words;
    EXPECT_NEAR(h.mean(&HistoryFields::residual_along_m), direct.residual.along_m, within) << words;
    EXPECT_NEAR(h.mean(&HistoryFields::residual_across_m), direct.residual.across_m, within)
        << words;
  }
}

TEST(clearance, orientations_that_are_not_run_would_have_given_the_same) {
  Plan plan = plan_of(config(), {shaking("a", 6.0, 0.4)});
  EXPECT_EQ(plan.order.size(), 4u);
  const Results skipped = run(plan);
  ASSERT_EQ(skipped.cases.orientations, 16u);
  std::vector<CaseNumber> all_cases(plan.same_as.size());
  std::iota(all_cases.begin(), all_cases.end(), 0u);
  plan.same_as = all_cases;
  std::ranges::stable_sort(all_cases, {}, [&](std::size_t i) { return plan.building[i]; });
  plan.order = all_cases;
  list_by_building(plan, std::ranges::max(plan.building) + 1);
  plan.units = {{0, 0, plan.order.size()}};
  const Results all = run(plan);
  for (std::size_t o = 0; o < all.cases.orientations; ++o) {
    const ConditionHistory a = history(skipped, 0, o, 0), b = history(all, 0, o, 0);
    EXPECT_NEAR(a.mean(&HistoryFields::peak_along_m), b.mean(&HistoryFields::peak_along_m),
                1e-5 * b.peak_m());
    EXPECT_NEAR(a.mean(&HistoryFields::peak_across_m), b.mean(&HistoryFields::peak_across_m),
                1e-5 * b.peak_m());
    EXPECT_NEAR(a.mean(&HistoryFields::residual_across_m),
                b.mean(&HistoryFields::residual_across_m), 1e-5 * b.peak_m());
    EXPECT_NEAR(a.mean(&HistoryFields::shear_along), b.mean(&HistoryFields::shear_along), 1e-9);
  }
}

TEST(clearance, friction_that_is_drawn_counts_at_its_design_value) {
  StudyConfig c = as_recorded_config();
  const double fixed_m = history(run(c, {shaking("a", 6.0, 0.4)}), 0, 0, 0).displacement_m();
  c.quantities.at("friction", "mu") = test::drawn(Normal{0.375, 0.0375});  // design: 0.3
  c.sampling.samples = 3;
  const Plan plan = plan_of(c, {shaking("a", 6.0, 0.4)});
  EXPECT_EQ(plan.cases.size(), 6u);  // three samples, as drawn and at the design value
  const Results results = run(plan);
  EXPECT_DOUBLE_EQ(ConditionGrid(results).case_at({}).friction, 0.3);
  EXPECT_EQ(ConditionGrid(results).count(), 1u);
  EXPECT_NEAR(history(results, 0, 0, 0).displacement_m(), fixed_m, 1e-6 * fixed_m);
}

/// max |a| of an oscillator's roof, by its own exact steps.
double roof_peak_mps2(const Motion& motion, std::size_t component, const Oscillator& oscillator) {
  auto ground = std::make_shared<GroundTable>(motion.dt_s, motion.horizontal_mps2[component]);
  return peak_acceleration_mps2(
      tabulate_response(ground, oscillator, {.quiet_horizontal_mps2 = 1e-3}));
}

TEST(clearance, an_anchored_array_adds_its_mass_and_nothing_else) {
  StudyConfig c = as_recorded_config();
  c.support = {ArraySupport::isolated, ArraySupport::anchored, ArraySupport::no_array};
  c.quantities.at("building", "mass_ratio") = fixed(0.1);
  const Motion motion = shaking("a", 6.0, 0.4);
  const Results results = run(c, {motion});
  const double longer = std::sqrt(1.1);  // period and 1 / damping ratio of the heavier mass
  for (const std::size_t axis : {0u, 1u}) {
    const double anchored =
        1.1 * roof_peak_mps2(motion, axis, {0.3 * longer, 0.05 / longer}) / standard_gravity_mps2;
    const double bare = roof_peak_mps2(motion, axis, {0.3, 0.05}) / standard_gravity_mps2;
    const ConditionHistory h1 = history(results, 0, 0, 1), h2 = history(results, 0, 0, 2);
    EXPECT_NEAR(
        axis == 0 ? h1.mean(&HistoryFields::shear_along) : h1.mean(&HistoryFields::shear_across),
        anchored, 1e-7 * anchored);
    EXPECT_NEAR(
        axis == 0 ? h2.mean(&HistoryFields::shear_along) : h2.mean(&HistoryFields::shear_across),
        bare, 1e-7 * bare);
    EXPECT_EQ(h1.peak_m(), 0.0);
  }
  EXPECT_GT(history(results, 0, 0, 0).peak_m(), 0.01);
}

TEST(clearance, a_building_yields_at_its_elastic_demand_over_r) {
  StudyConfig c = as_recorded_config();
  c.quantities.at("building", "damping") = fixed(0.0);  // then base shear is the spring's alone
  c.support = {ArraySupport::isolated, ArraySupport::no_array};
  c.quantities.at("building", "response_modification") = listed({0.0, 3.0, 6.0});
  const Results results = run(c, {shaking("a", 8.0, 0.4)});
  // Class D, S_s 1.95 g: S_DS = 2/3 x 1.0 x 1.95 g on the plateau, at 0.3 s.
  const double demand = 1.3;
  const ConditionGrid grid(results);
  for (const std::size_t r : {1u, 2u}) {
    for (const std::size_t support : {0u, 1u}) {
      Condition at;
      at[Axis::support] = support;
      at[Axis::response_modification] = r;
      const ConditionHistory h = grid.history(0, 0, at);
      // The kernel integrates a sliding array to 1e-6 of its speed, and the spring with it.
      EXPECT_NEAR(h.mean(&HistoryFields::shear_along),
                  demand / grid.case_at(at).response_modification, support == 0 ? 1e-7 : 1e-12);
    }
  }
  EXPECT_GT(history(results, 0, 0, 0).mean(&HistoryFields::shear_along), demand / 3.0);
}

TEST(clearance, the_level_is_a_factor_on_the_suites_own_scale) {
  StudyConfig c = as_recorded_config();
  c.intensity.levels = {0.5, 1.0};
  Motion once = shaking("a", 6.0, 0.4), scaled = shaking("a", 6.0, 0.4);
  scaled.scale = 2.0;
  const Results a = run(c, {once}), b = run(c, {scaled});
  for (std::size_t o = 0; o < a.cases.orientations; ++o) {
    EXPECT_EQ(history(a, 0, o, 1).mean(&HistoryFields::peak_along_m),
              history(b, 0, o, 0).mean(&HistoryFields::peak_along_m));
    EXPECT_EQ(history(a, 0, o, 1).mean(&HistoryFields::shear_along),
              history(b, 0, o, 0).mean(&HistoryFields::shear_along));
  }
}

TEST(clearance, a_record_without_a_vertical_is_run_without) {
  StudyConfig c = as_recorded_config();
  c.vertical = {VerticalChoice::none, VerticalChoice::if_available};
  c.quantities.at("vertical", "period_s") = listed({0.0, 0.2});
  Motion without = shaking("b", 6.0, 1.4);
  without.vertical_mps2 = {};
  const Results results = run(c, {shaking("a", 6.0, 0.4), without});
  ASSERT_EQ(ConditionGrid(results).count(), 3u);  // with no vertical its period has no part
  EXPECT_TRUE(results.records[0].has_vertical);
  EXPECT_FALSE(results.records[1].has_vertical);
  EXPECT_NE(history(results, 0, 0, 0).peak_m(), history(results, 0, 0, 1).peak_m());
  EXPECT_NE(history(results, 0, 0, 1).peak_m(), history(results, 0, 0, 2).peak_m());
  for (const std::size_t i : {1u, 2u}) {  // on a finer step where the vertical requires it
    EXPECT_NEAR(history(results, 1, 0, i).peak_m(), history(results, 1, 0, 0).peak_m(),
                1e-5 * history(results, 1, 0, 0).peak_m());
  }
}

TEST(clearance, suites_that_do_not_fit_are_refused_with_all_that_is_wrong) {
  StudyConfig c = config();
  c.quantities.at("building", "response_modification") = listed({0.0, 2.0});
  c.vertical = {VerticalChoice::required};
  Motion lame = shaking("lame", 6.0, 0.4), quiet = shaking("quiet", 0.0, 0.4);
  lame.horizontal_mps2[1] = {};
  lame.vertical_mps2 = {};
  Suite suite = suite_of({lame, quiet});
  suite.target.reset();
  try {
    make_plan(c, {suite});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    // No target, no second horizontal, no vertical, and zero throughout.
    ASSERT_EQ(error.problems().size(), 4u) << error.what();
    for (const auto& problem : error.problems()) EXPECT_EQ(problem.where, "suite.toml");
  }
}

}  // namespace
}  // namespace glissade
