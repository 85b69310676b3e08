// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/convergence_error.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace {

double no_clock() { return 0.0; }

Motion motion(const std::string& id, std::vector<double> first) {
  Motion m;
  m.id = id;
  m.dt_s = 0.01;
  m.horizontal_mps2[0] = std::move(first);
  return m;
}

Suite suite_of(std::vector<Motion> motions) {
  Suite suite;
  suite.name = "made up";
  suite.motions = std::move(motions);
  return suite;
}

ConvergenceConfig config() {
  ConvergenceConfig c;
  c.name = "convergence";
  c.file = "study.toml";
  c.suite_file = "suite.toml";
  c.slope_deg = {-7.0, 0.0, 7.0};
  c.mu = {0.0, 0.1, 0.5};
  c.ppa_g = {0.0, 0.5};
  c.substeps = {1, 2, 64, 128};
  return c;
}

ConvergenceResults run(const ConvergencePlan& plan) {
  std::vector<ConvergenceUnit> units;
  for (std::size_t i = plan.suite.motions.size(); i > 0; --i)  // any order will do
    units.push_back(execute(plan, i - 1, no_clock));
  return reduce(plan, units);
}

/// The scene's place.
std::size_t scene_at(const ConvergenceResults& results, const ConvergenceScene& wanted) {
  for (std::size_t j = 0; j < results.scenes.size(); ++j) {
    const ConvergenceScene& s = results.scenes[j];
    if (s.slope_deg == wanted.slope_deg && s.mu == wanted.mu && s.ppa_g == wanted.ppa_g) return j;
  }
  ADD_FAILURE() << "no such scene";
  return 0;
}

TEST(convergence, the_papers_grid_has_sixty_scenes_and_540_histories) {
  ConvergenceConfig c = config();  // Rodriguez-Nikl et al. (2019), "Convergence"
  c.slope_deg = {-7, -4, 0, 4, 7};
  c.mu = {0.0, 0.1, 0.5};
  c.ppa_g = {0.0, 0.18, 1.0, 1.44};
  c.substeps = {1, 2, 4, 8, 16, 32, 64, 128, 256};
  const ConvergencePlan plan = make_plan(c, suite_of({motion("a", {1.0})}));
  EXPECT_EQ(plan.scenes.size(), 60u);
  EXPECT_EQ(plan.histories(), 540u);
}

TEST(convergence, a_free_slider_on_a_still_roof_goes_half_a_t_squared) {
  // Physical check 2 of the paper: slope 7 deg, mu 0.1; told in plan, at the last sample.
  const ConvergenceResults results =
      run(make_plan(config(), suite_of({motion("a", test::made_up_record(300, 1, 1.0))})));
  const double theta = 7.0 * rad_per_deg, t = 299 * 0.01;
  const double expected = 0.5 * standard_gravity_mps2 * (std::sin(theta) - 0.1 * std::cos(theta)) *
                          std::cos(theta) * t * t;
  const double residual = results.exact_at(0, scene_at(results, {7.0, 0.1, 0.0})).residual_m;
  EXPECT_NEAR(residual, expected, 1e-12 * expected);
}

TEST(convergence, a_flat_roof_without_friction_moves_away_below_the_block) {
  // A step of A over one interval, then linearly to zero: U = A dt^2 (1/2 + 1 + 1/3). Zeros that
  // pad the record are not its own.
  for (const std::size_t zeros : {0u, 50u}) {
    std::vector<double> a(2 + zeros, 0.0);
    a[0] = a[1] = 2.0;
    const ConvergenceResults results = run(make_plan(config(), suite_of({motion("a", a)})));
    const std::size_t j = scene_at(results, {0.0, 0.0, 0.5});
    const double expected = -0.5 * standard_gravity_mps2 * 1e-4 * 11.0 / 6.0;
    EXPECT_NEAR(results.exact_at(0, j).residual_m, expected, 1e-15);
    EXPECT_NEAR(results.residual_m(0, j, 3), expected, 0.01 * std::abs(expected));
    EXPECT_EQ(results.records[0].samples, 2u);
  }
}

TEST(convergence, twice_the_substeps_halve_the_error_of_a_first_order_scheme) {
  const ConvergenceResults results =
      run(make_plan(config(), suite_of({motion("a", {2.0, 2.0, -1.0, 3.0})})));
  const std::size_t j = scene_at(results, {0.0, 0.0, 0.5});
  const auto error = [&](std::size_t step) {
    return scheme_error(results, {0, j, step}, ErrorMeasure::exact_peak);
  };
  EXPECT_GT(error(3), 0.0);
  EXPECT_NEAR(error(1) / error(0), 0.5, 0.05);
  EXPECT_NEAR(error(3) / error(2), 0.5, 0.001);
}

TEST(convergence, every_record_is_scaled_to_the_scenes_peak) {
  std::vector<double> a = test::made_up_record(300, 2, 1.0), b = a;
  for (double& x : b) x *= 16.0;  // a power of two: to the last bit
  const ConvergenceResults results =
      run(make_plan(config(), suite_of({motion("a", a), motion("b", b)})));
  for (std::size_t j = 0; j < results.scenes.size(); ++j)
    EXPECT_EQ(results.exact_at(0, j).residual_m, results.exact_at(1, j).residual_m);
}

TEST(convergence, the_clock_changes_times_and_nothing_else) {
  const ConvergencePlan plan =
      make_plan(config(), suite_of({motion("a", test::made_up_record(100, 3, 1.0))}));
  double seconds = 0.0;
  const Stopwatch ticking = [&] { return seconds += 1.0; };  // every history takes a second
  const ConvergenceUnit timed = execute(plan, 0, ticking), still = execute(plan, 0, no_clock);
  EXPECT_EQ(timed.residual_m, still.residual_m);
  EXPECT_EQ(timed.times.published_s, std::vector<double>(timed.residual_m.size(), 1.0));
  EXPECT_EQ(timed.times.exact_s, std::vector<double>(plan.scenes.size(), 1.0));
  const ConvergenceTimes times = time_summary({timed}, 4);
  ASSERT_EQ(times.published.size(), 4u);
  EXPECT_EQ(times.published[2].longest_s, 1.0);
  EXPECT_EQ(times.kernel.median_s, 1.0);
}

TEST(convergence, units_come_through_a_message_whole) {
  const ConvergencePlan plan =
      make_plan(config(), suite_of({motion("a", {1.0, -2.0}), motion("b", {3.0})}));
  const std::vector<ConvergenceUnit> sent{execute(plan, 1, no_clock), execute(plan, 0, no_clock)};
  const std::vector<ConvergenceUnit> received = unpack_convergence_units(pack(sent));
  ASSERT_EQ(received.size(), 2u);
  EXPECT_EQ(received[0].record, 1u);
  EXPECT_EQ(reduce(plan, received).residual_m.data, reduce(plan, sent).residual_m.data);
  EXPECT_EQ(received[1].times.kernel_s, sent[1].times.kernel_s);
}

TEST(convergence, records_are_chosen_by_id_in_the_suites_order) {
  ConvergenceConfig c = config();
  c.records = {"c", "a"};
  const ConvergencePlan plan =
      make_plan(c, suite_of({motion("a", {1.0}), motion("b", {1.0}), motion("c", {1.0})}));
  ASSERT_EQ(plan.suite.motions.size(), 2u);
  EXPECT_EQ(plan.suite.motions[0].id, "a");
  EXPECT_EQ(plan.suite.motions[1].id, "c");
}

/// Every problem make_plan tells, in one text.
std::string problems_of(const ConvergenceConfig& c, Suite suite) {
  try {
    make_plan(c, std::move(suite));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(convergence, records_that_do_not_fit_are_refused_by_name) {
  ConvergenceConfig c = config();
  c.records = {"far_1", "near_1"};
  const std::string unknown = problems_of(c, suite_of({motion("far_2", {1.0})}));
  EXPECT_NE(unknown.find("names far_1, which is not in suite.toml"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("did you mean far_2?"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("near_1"), std::string::npos) << unknown;
  EXPECT_NE(problems_of(config(), suite_of({motion("quiet", {0.0, 0.0})})).find("quiet is zero"),
            std::string::npos);
  c = config();
  c.component = HorizontalComponent::second;
  EXPECT_NE(problems_of(c, suite_of({motion("one", {1.0})})).find("no second horizontal"),
            std::string::npos);
}

/// One record, three scenes, P = 1, 64, 256.
ConvergenceResults by_hand() {
  ConvergenceResults r;
  r.substeps = {1, 64, 256};
  r.scenes = {{0.0, 0.5, 0.1}, {0.0, 0.5, 1.0}, {7.0, 0.5, 1.0}};
  r.records = {{"a", "", "", 0.01, 10, 0.3}};
  r.residual_m = Array3<double>(1, 3, 3);
  r.residual_m.data = {0.0, 0.0, 0.0, 1.5, 1.1, 1.0, -0.03, -0.019, -0.02};
  r.exact = {{0.0, 0.0, 0}, {0.8, 2.0, 0}, {-0.016, 0.5, 0}};
  return r;
}

TEST(convergence, an_error_is_relative_to_what_its_measure_says) {
  const ConvergenceResults r = by_hand();
  EXPECT_DOUBLE_EQ(scheme_error(r, {0, 1, 0}, ErrorMeasure::finest), 0.5);
  EXPECT_DOUBLE_EQ(scheme_error(r, {0, 1, 0}, ErrorMeasure::exact_residual), 0.7 / 0.8);
  EXPECT_DOUBLE_EQ(scheme_error(r, {0, 1, 0}, ErrorMeasure::exact_peak), 0.35);
  EXPECT_EQ(scheme_error(r, {0, 2, 2}, ErrorMeasure::finest), 0.0);
}

TEST(convergence, scenes_at_rest_are_left_out_and_counted) {
  const ConvergenceResults r = by_hand();
  EXPECT_EQ(count_at_rest(r), 1u);
  for (const ErrorMeasure m :
       {ErrorMeasure::finest, ErrorMeasure::exact_residual, ErrorMeasure::exact_peak}) {
    EXPECT_TRUE(std::isnan(scheme_error(r, {0, 0, 0}, m)));
    EXPECT_EQ(error_summary(r, 0, m).counted, 2u);
  }
}

TEST(convergence, a_summary_tells_the_largest_the_median_and_the_worst) {
  const ConvergenceResults r = by_hand();
  const ErrorSummary first = error_summary(r, 0, ErrorMeasure::finest);  // 0.5 and 0.5
  EXPECT_DOUBLE_EQ(first.largest, 0.5);
  const ErrorSummary second = error_summary(r, 1, ErrorMeasure::finest);  // 0.1 and 0.05
  EXPECT_NEAR(second.largest, 0.1, 1e-15);
  EXPECT_NEAR(second.median, 0.075, 1e-15);
  EXPECT_EQ(second.worst.scene, 1u);
  EXPECT_NEAR(share_within(r, 1, ErrorMeasure::finest, 0.06), 0.5, 1e-15);
  // The last scene's residual is 3 % of its peak.
  EXPECT_EQ(error_summary(r, 0, ErrorMeasure::finest, {.least_residual_of_peak = 0.1}).counted, 1u);
  EXPECT_TRUE(std::isnan(error_summary(r, 0, ErrorMeasure::finest, {.first_record = 1}).largest));
}

TEST(convergence, the_chosen_step_is_the_papers_64_or_the_nearest_that_is_not_the_truth) {
  EXPECT_EQ(chosen_step({1, 2, 4, 8, 16, 32, 64, 128, 256}), 6u);
  EXPECT_EQ(chosen_step({1, 50, 100, 200}), 1u);
  EXPECT_EQ(chosen_step({1, 2, 4}), 1u);
  EXPECT_EQ(chosen_step({8, 64}), 0u);
}

}  // namespace
}  // namespace glissade
