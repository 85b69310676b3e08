// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/cases/probable.hpp"
#include "glissade/study/plan/history_cost.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::listed;
using test::small_config;
using test::small_plan;
using test::small_suite;
using test::states;
constexpr double g = standard_gravity_mps2;

std::vector<double> resized(const Samples& samples, std::size_t size, double padding = 0.0) {
  std::vector<double> all = samples.copy();
  all.resize(size, padding);
  return all;
}

TEST(plan, units_cover_every_record_and_case_that_differs_once) {
  StudyConfig config = small_config();
  config.quantities.at("building", "period_s") = listed({0.0, 0.3});
  config.orientation.choice = OrientationChoice::all_permutations;
  const Plan plan = small_plan(config);
  ASSERT_EQ(plan.cases.size(), 2u * 2u * 40u * 4u);  // frictions, periods, samples, orientations
  std::vector<std::vector<int>> seen(3, std::vector<int>(plan.cases.size(), 0));
  for (const WorkUnit& unit : plan.units) {
    for (std::size_t i = 0; i < unit.count; ++i) ++seen[unit.record][plan.order[unit.first + i]];
  }
  std::size_t repeated = 0;
  for (const auto& record : seen) {
    for (std::size_t c = 0; c < record.size(); ++c) {
      EXPECT_EQ(record[c], plan.same_as[c] == c ? 1 : 0);
      repeated += plan.same_as[c] != c;
    }
  }
  EXPECT_GT(repeated, 0u);  // a third of the roofs are flat: either sign is the same
  EXPECT_EQ(plan.histories(), (3 * plan.cases.size() - repeated) * 8);
}

// As studies/14: 384 cases on two axes, of which 96 differ, on 14 records.
TEST(plan, units_are_many_and_even_in_predicted_cost) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.intensity.measure = IntensityMeasure::mce_fraction;
  config.intensity.levels = {2.0 / 3.0};
  config.fragility.reset();
  config.standards.compare.clear();
  config.quantities = Quantities();
  config.quantities.at("building", "period_s") = listed({0.2, 0.4, 0.7, 1.0, 1.5, 2.0});
  config.quantities.at("building", "mass_ratio") = listed({0.05, 0.10});
  config.vertical = {VerticalChoice::if_available, VerticalChoice::none};
  config.orientation.choice = OrientationChoice::all_permutations;
  config.orientation.slope_axis = {SlopeAxis::e_w, SlopeAxis::n_s};
  Suite suite = small_suite();
  suite.motions.clear();
  for (unsigned i = 0; i < 14; ++i) {
    Motion m = small_suite().motions[i % 3];
    m.id += std::to_string(i);
    for (Samples& component : m.horizontal_mps2) component = resized(component, 600 + 400 * i, 0.1);
    m.vertical_mps2 = resized(m.vertical_mps2, 600 + 400 * i, 0.1);
    suite.motions.push_back(m);
  }
  const Plan plan = make_plan(config, {suite});
  EXPECT_EQ(plan.cases.size(), 6u * 2u * 2u * 16u);
  EXPECT_EQ(plan.order.size(), 6u * 2u * 2u * 4u);  // one friction: slopes along either axis agree
  EXPECT_GT(plan.units.size(), 100u);
  EXPECT_LT(plan.units.size(), 1000u);
  const auto cost = [&](const WorkUnit& unit) {
    return static_cast<double>(unit.count * plan.motion(unit.record).horizontal_mps2[0].size());
  };
  double sum = 0.0, largest = 0.0;
  for (const WorkUnit& unit : plan.units) {
    sum += cost(unit);
    largest = std::max(largest, cost(unit));
  }
  EXPECT_LT(largest, 2.0 * sum / static_cast<double>(plan.units.size()));
}

// What a run that is stopped or killed loses at most.
TEST(plan, units_of_a_long_study_are_predicted_to_take_seconds) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.sampling.samples = 4096;
  config.intensity.levels.resize(8000);
  for (std::size_t i = 0; i < config.intensity.levels.size(); ++i)
    config.intensity.levels[i] = 1.0 + 0.001 * static_cast<double>(i);
  const Plan plan = make_plan(config, {small_suite()});
  ASSERT_GT(plan.predicted_seconds(), 10.0 * 128.0);
  EXPECT_LE(plan.predicted_seconds() / static_cast<double>(plan.units.size()), 6.0);
}

TEST(plan, gives_out_the_longest_units_first) {
  Suite suite = small_suite();
  // The last record is three times as long as it was.
  for (Samples& component : suite.motions.back().horizontal_mps2)
    component = resized(component, 3 * component.size());
  const Plan plan = make_plan(small_config(), {suite});
  const std::vector<std::size_t> order = longest_first(plan, 0);
  ASSERT_EQ(std::set(order.begin(), order.end()).size(), plan.units.size());
  EXPECT_EQ(order.size(), plan.units.size());
  const auto cost = [&](std::size_t unit) {
    const WorkUnit& u = plan.units[unit];
    return u.count * plan.motion(u.record).horizontal_mps2[0].size();
  };
  EXPECT_TRUE(std::ranges::is_sorted(order, std::greater{}, cost));
}

TEST(plan, has_parts_of_even_cost_that_are_all_of_it) {
  Suite suite = small_suite();
  for (Samples& component : suite.motions.back().horizontal_mps2)
    component = resized(component, 3 * component.size());
  const Plan plan = make_plan(small_config(), {suite});
  const auto cost = [&](const std::vector<std::size_t>& units) {
    std::size_t samples = 0;
    for (const std::size_t unit : units) {
      const WorkUnit& u = plan.units[unit];
      samples += u.count * plan.motion(u.record).horizontal_mps2[0].size();
    }
    return samples;
  };
  const std::vector<std::size_t> all = units_of(plan, {});
  EXPECT_EQ(all, longest_first(plan, 0));
  for (const std::uint64_t count : {1u, 2u, 3u, 1000u}) {
    std::multiset<std::size_t> together, costs;
    for (std::uint64_t number = 1; number <= count; ++number) {
      const std::vector<std::size_t> units = units_of(plan, {number, count});
      together.insert(units.begin(), units.end());
      costs.insert(cost(units));
    }
    EXPECT_EQ(together, std::multiset(all.begin(), all.end())) << count;
    EXPECT_LE(*costs.rbegin() - *costs.begin(), cost({all.front()})) << count;
  }
}

TEST(plan, gives_a_sample_its_numbers_whatever_else_is_sampled) {
  StudyConfig config = small_config();
  const Plan plan = small_plan(config);
  config.sampling.samples = 64;
  config.quantities.at("building", "period_s") = fixed(0.3);
  const Plan other = small_plan(config);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(plan.cases[i].friction, other.cases[i].friction);
    EXPECT_EQ(plan.cases[i].slope_deg, other.cases[i].slope_deg);
    EXPECT_EQ(plan.cases[i].orientation, other.cases[i].orientation);
  }
}

TEST(plan, scales_each_record_to_the_intensity_measure) {
  StudyConfig config = small_config();
  config.standards.compare.clear();
  const Suite suite = small_suite();
  const auto combined = HorizontalCombination::geometric_mean;

  config.intensity.measure = *IntensityMeasure::named("pga_g");
  Plan plan = make_plan(config, {suite});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(plan.factor_at_unit_level[i] * horizontal_pga_mps2(suite.motions[i], combined), g,
                1e-12 * g);
  }
  config.intensity.measure = *IntensityMeasure::named("sa_g");
  config.intensity.sa_period_s = 0.3;
  plan = make_plan(config, {suite});
  for (std::size_t i = 0; i < 3; ++i) {
    const double sa =
        horizontal_spectrum_mps2(suite.motions[i], std::vector<double>{0.3}, combined).front();
    EXPECT_NEAR(plan.factor_at_unit_level[i] * sa, g, 1e-12 * g);
  }
  config.intensity.measure = *IntensityMeasure::named("avg_sa_g");
  config.intensity.avg_sa_periods_s = {0.2, 0.5, 1.0};
  plan = make_plan(config, {suite});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(plan.factor_at_unit_level[i] *
                    average_sa_mps2(suite.motions[i], config.intensity.avg_sa_periods_s),
                g, 1e-12 * g);
  }
}

// Walters (2012): the average of the SRSS spectra is nowhere below the target from 0 to 2 s, and
// touches it.
TEST(plan, scales_the_suite_as_one_to_the_design_spectrum_of_each_sds) {
  const Suite suite = small_suite();
  const Plan plan = make_plan(small_config(), {suite});
  EXPECT_NEAR(plan.factor_at_unit_level[2] / plan.factor_at_unit_level[0],
              suite.motions[2].scale / suite.motions[0].scale, 1e-12);
  const TargetSpectrum target(*suite.target);
  double least = 1e9;
  for (double period = 0.0; period <= 2.0; period += 0.05) {
    double average = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      average += plan.factor_at_unit_level[i] / g / 3 *
                 horizontal_spectrum_mps2(suite.motions[i], std::vector<double>{period},
                                          HorizontalCombination::srss)
                     .front();
    }
    least = std::min(least, average / (target.design_sa_g(period) / target.sds_g()));
  }
  EXPECT_GE(least, 1 - 1e-9);
  EXPECT_LE(least, 1.1);  // touches at a period of the finer list of suite_scaling.hpp
}

TEST(plan, has_another_hash_when_the_motions_or_the_study_change_and_the_same_when_not) {
  const Plan plan = small_plan(small_config());
  EXPECT_EQ(plan.hash, small_plan(small_config()).hash);
  Suite changed = small_suite();
  Samples& vertical_mps2 = changed.motions[1].vertical_mps2;
  std::vector<double> nearly = vertical_mps2.copy();
  nearly[17] += 1e-12;
  vertical_mps2 = nearly;
  EXPECT_NE(plan.hash, make_plan(small_config(), {changed}).hash);
  changed = small_suite();
  changed.target->s1_g += 0.1;
  EXPECT_NE(plan.hash, make_plan(small_config(), {changed}).hash);
  changed = small_suite();
  changed.motions[2].scale = 1.01;
  EXPECT_NE(plan.hash, make_plan(small_config(), {changed}).hash);
  // What the results say of them.
  using Change = std::function<void(Suite&)>;
  for (const Change& change :
       {Change([](Suite& s) { s.description += "."; }), Change([](Suite& s) { s.name += "."; }),
        Change([](Suite& s) { s.motions[1].event = "Other"; }),
        Change([](Suite& s) { s.motions[1].station = "Other"; }),
        Change([](Suite& s) { s.motions[1].magnitude += 0.1; }),
        Change([](Suite& s) { s.motions[1].distance_km += 1.0; }),
        Change([](Suite& s) { s.motions[1].vs30_mps += 1.0; }),
        Change([](Suite& s) { s.motions[1].contradictions = {"its file says otherwise"}; })}) {
    changed = small_suite();
    change(changed);
    const Plan other = make_plan(small_config(), {changed});
    EXPECT_NE(plan.hash, other.hash);
    EXPECT_NE(plan.motions_text, other.motions_text);
  }
  StudyConfig config = small_config();
  config.source_text += " ";  // a number with another unit
  EXPECT_EQ(plan.hash, small_plan(config).hash);
  config.hashed_text += " ";
  EXPECT_NE(plan.hash, small_plan(config).hash);
}

TEST(plan, reports_everything_in_which_study_and_suite_do_not_fit) {
  StudyConfig config = small_config();
  config.vertical = {VerticalChoice::required};
  config.orientation.component = ComponentChoice::second;
  Suite suite = small_suite();
  suite.target.reset();
  suite.motions[0].vertical_mps2 = {};
  suite.motions[1].horizontal_mps2[1] = {};
  suite.motions[2].horizontal_mps2[0] = std::vector<double>(600, 0.0);
  suite.motions[2].horizontal_mps2[1] = std::vector<double>(600, 0.0);
  try {
    make_plan(config, {suite});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 4u) << error.what();
  }
}

TEST(plan, notes_records_that_lack_a_component) {
  Suite suite = small_suite();
  suite.motions[0].vertical_mps2 = {};
  suite.motions[1].horizontal_mps2[1] = {};
  StudyConfig config = small_config();
  config.standards.compare.clear();
  EXPECT_THAT(make_plan(config, {suite}).notes,
              testing::IsSupersetOf({states("no vertical component"), states("one horizontal")}));
}

TEST(plan, notes_quantities_without_effect) {
  StudyConfig config = small_config();
  const auto of_damping = testing::Contains(states("building.damping has no effect"));
  config.quantities.at("building", "period_s") = {{0.0}, {}};
  EXPECT_THAT(small_plan(config).notes, testing::Not(of_damping));
  config.quantities.at("building", "damping").is_stated = true;  // with its usual value
  EXPECT_THAT(small_plan(config).notes, of_damping);
  config.quantities.at("building", "period_s") = {{0.5}, {}};
  EXPECT_THAT(small_plan(config).notes, testing::Not(of_damping));
}

TEST(plan, notes_directions_and_a_seed_without_effect) {
  StudyConfig config = small_config();
  config.seed = 0;
  config.standards.compare.clear();
  config.model.axes = SlidingAxes::two;
  config.quantities.at("roof", "slope_deg") = {{0.0}, {}};
  const auto notes = [&] { return small_plan(config).notes.size(); };
  const std::size_t before = notes();
  config.orientation.sign = SignChoice::positive;
  EXPECT_EQ(notes(), before + 1);
  config.orientation.second_sign = SignChoice::negative;
  EXPECT_EQ(notes(), before + 2);
  config.orientation.slope_axis = {SlopeAxis::n_s};
  EXPECT_EQ(notes(), before + 3);
  config.friction.across_is_given = true;
  config.quantities.at("roof", "azimuth_deg") = {{30.0}, {}};
  EXPECT_EQ(notes(), before);
  for (const char* key : {"mu", "across_mu"}) config.quantities.at("friction", key) = {{0.5}, {}};
  config.orientation.choice = OrientationChoice::as_recorded;
  config.quantities.at("building", "period_s") = {{0.5}, {}};
  Suite suite = small_suite();
  suite.motions.resize(1);
  ASSERT_FALSE(config.draws());
  const std::size_t of_one = make_plan(config, {suite}).notes.size();
  config.seed = 7;
  EXPECT_EQ(make_plan(config, {suite}).notes.size(), of_one + 1);
}

TEST(plan, notes_cases_outside_the_range_of_the_prescriptive_value) {
  // Slope 4 degrees in a third of the samples; mu below 0.4 in half of them, but 0.4 in the mean.
  const auto outside = [](const char* standard) {
    return testing::Contains(states("outside the range", standard));
  };
  StudyConfig config = small_config();
  config.friction.values = {FrictionValue::as_drawn};
  EXPECT_THAT(small_plan(config).notes, outside("SEAOC PV1-2012"));
  EXPECT_THAT(small_plan(config).notes, outside("ASCE 7-16"));
  config.quantities.at("roof", "slope_deg") = fixed(1.19);
  EXPECT_THAT(small_plan(config).notes, testing::Not(outside("of")));
  config.quantities.at("friction", "mu") = fixed(0.39);
  EXPECT_THAT(small_plan(config).notes, outside("100 %"));
}

TEST(plan, warns_that_one_mass_gives_too_little_slip_on_several_storeys) {
  const auto of_one_mass = testing::Contains(states("one mass", "too little slip", "3.2 to 11"));
  StudyConfig config = small_config();
  EXPECT_THAT(small_plan(config).warnings, of_one_mass);
  EXPECT_THAT(small_plan(config).notes, testing::Not(of_one_mass));
  config.building.is_one_storey = true;
  EXPECT_THAT(small_plan(config).warnings, testing::Not(of_one_mass));
  config.building.is_one_storey = false;
  config.quantities.at("building", "period_s") = fixed(0.3);
  EXPECT_THAT(small_plan(config).warnings, testing::Not(of_one_mass));
  EXPECT_THAT(small_plan(config).notes, of_one_mass);
  for (const double period_s : {0.0, 0.15}) {  // rigid, or of one storey
    config.quantities.at("building", "period_s") = fixed(period_s);
    EXPECT_THAT(small_plan(config).notes, testing::Not(of_one_mass));
  }
}

TEST(plan, warns_of_a_rigid_building_and_a_flat_roof_that_nobody_stated) {
  StudyConfig config = small_config();
  config.base_shear = true;
  for (const auto& [table, key] :
       {std::pair{"building", "period_s"}, {"roof", "slope_deg"}, {"building", "mass_ratio"}}) {
    Quantity& quantity = config.quantities.at(table, key);
    const auto warned =
        testing::Contains(states(std::string(table) + "." + key + " is not stated", "= 0"));
    quantity = fixed(0.0);
    EXPECT_THAT(small_plan(config).warnings, warned);
    quantity.is_stated = true;
    EXPECT_THAT(small_plan(config).warnings, testing::Not(warned));
  }
}

// Factors from the suite's: level 1 is each motion as its file scales it, by 1, 1.5 and 2.
TEST(plan, warns_of_records_that_are_scaled_by_more_than_five) {
  StudyConfig config = small_config();
  config.standards.compare.clear();
  config.intensity.measure = IntensityMeasure::factor;
  config.intensity.levels = {0.5, 2.5, 4.0};
  const auto warned = [](const auto&... parts) { return testing::Contains(states(parts...)); };
  EXPECT_THAT(small_plan(config).warnings, warned("scaled by more than 5", "2 of 3 records",
                                                  "motion2 8 times at 4; motion1 6 times at 4."));
  config.intensity.levels = {0.5, 2.6, 4.0};
  EXPECT_THAT(small_plan(config).warnings, warned("motion2 8 times at 4, from 2.6; motion1"));
  config.intensity.levels = {0.5, 2.5};  // five times
  EXPECT_THAT(small_plan(config).warnings, testing::Not(warned("scaled by more than")));
  // Of the peak acceleration of a rigid roof the stronger component decides.
  config.intensity.measure = IntensityMeasure::ppa_g;
  config.quantities.at("building", "period_s") = fixed(0.0);
  const Suite suite = small_suite();
  double peak_mps2 = 0.0;
  for (const auto& component : suite.motions[0].horizontal_mps2)
    for (const double a : component) peak_mps2 = std::max(peak_mps2, std::abs(a));
  config.intensity.levels = {0.5, 6.0 * peak_mps2 / standard_gravity_mps2};
  EXPECT_THAT(small_plan(config).warnings, warned("motion0 6 times at"));
}

TEST(plan, lists_what_is_stated_where_it_is_as_usual_and_what_holds_where_it_is_not) {
  StudyConfig config = small_config();
  config.quantities.at("friction", "mu") = fixed(0.5);
  EXPECT_THAT(to_string(small_plan(config)), testing::Not(testing::HasSubstr("friction.mu 0.5")));
  config.quantities.at("friction", "mu").is_stated = true;
  config.not_stated = {
      {"building.period_s: 0", &parameters()[parameter_index("building", "period_s")]},
      {"model.axes: 2"}};
  EXPECT_THAT(
      to_string(small_plan(config)),
      states("            friction.mu 0.5\n", "not stated  building.period_s: 0, model.axes: 2\n"));
  Suite roof = small_suite();
  roof.of_roof = true;
  config.intensity.measure = IntensityMeasure::factor;
  for (const char* key : {"period_s", "mass_ratio"})
    config.quantities.at("building", key) = fixed(0.0);
  EXPECT_THAT(to_string(make_plan(config, {roof})), states("not stated  model.axes: 2\n"));
}

TEST(plan, writes_a_count_of_one_in_the_singular) {
  StudyConfig config = small_config();
  for (const auto& [table, key] : {std::pair{"building", "period_s"}, {"roof", "slope_deg"}})
    config.quantities.at(table, key) = fixed(0.1);
  config.quantities.at("friction", "mu") = fixed(0.5);
  config.orientation.choice = OrientationChoice::as_recorded;
  config.intensity.levels = {1.0};
  config.sampling.samples = 1;
  Suite suite = small_suite();
  suite.motions.resize(1);
  const std::string text = to_string(make_plan(config, {suite}));
  EXPECT_THAT(text, states("small: 1 motion\n", "1 level, 1\n",
                           "1 combination x 1 sample x 1 orientation, of which 1 differs",
                           "1 history in 1 unit"));
}

// S_DS of the small suite's target is 1 g.
TEST(plan, notes_DBE_and_MCE_that_are_no_levels) {
  StudyConfig config = small_config();
  const auto missing = testing::Contains(states("not among intensity.levels"));
  EXPECT_THAT(small_plan(config).notes, testing::Not(missing));
  config.intensity.levels = {0.99, 1.5};
  EXPECT_THAT(small_plan(config).notes,
              testing::Contains(states("not among intensity.levels", "DBE, 1 g. ")));
  config.fragility.reset();
  config.standards.compare.clear();
  EXPECT_THAT(small_plan(config).notes, testing::Not(missing));  // it gives no probability
}

TEST(plan, refuses_parts_of_an_MCE_that_the_suite_has_not_and_names_the_factor) {
  StudyConfig config = small_config();
  config.standards.compare.clear();
  config.intensity.levels = {1.0};
  Suite suite = small_suite();
  suite.target.reset();
  config.intensity.measure = IntensityMeasure::mce_fraction;
  try {
    make_plan(config, {suite});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), states("[target]", "measure = \"factor\""));
  }
  config.intensity.measure = IntensityMeasure::factor;
  const Plan plan = make_plan(config, {suite});
  EXPECT_EQ(plan.factor_at_unit_level, (std::vector<double>{1.0, 1.5, 2.0}));  // the suite's scales
  EXPECT_THAT(to_string(plan), testing::Not(states("MCE")));
  EXPECT_THAT(to_string(plan), states("orientation drawn for each sample"));
}

/// But those of the small study itself: of one mass, and of motions that are scaled to 4 g.
std::ptrdiff_t other_warnings(const Plan& plan) {
  return std::ranges::count_if(plan.warnings, [](const std::string& text) {
    return !text.starts_with("scaled by more than") && text.find("one mass") == std::string::npos;
  });
}

TEST(plan, warns_of_what_is_possible_and_not_probable) {
  const auto warnings = [](const std::function<void(StudyConfig&)>& change) {
    StudyConfig config = small_config();
    config.model.axes = SlidingAxes::two;
    config.quantities.at("roof", "slope_deg") = fixed(1.19);
    change(config);
    return other_warnings(small_plan(config));
  };
  EXPECT_EQ(warnings([](StudyConfig&) {}), 0);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.model.axes = SlidingAxes::one; }), 1);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.intensity.levels.push_back(50.0); }), 1);
  // and that the suite is made for another target
  EXPECT_EQ(warnings([](StudyConfig& c) { c.intensity.target = {.ss_g = 1.0, .s1_g = 1.5}; }), 2);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.intensity.target = {.ss_g = 150.0, .s1_g = 0.6}; }), 2);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.quantities.at("friction", "mu") = fixed(1.5); }), 1);
  EXPECT_EQ(
      warnings([](StudyConfig& c) { c.quantities.at("building", "period_s") = fixed(300.0); }), 1);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.fragility->thresholds_m.push_back(50.0); }), 1);
  // Rates of 50 years, and levels beyond the curve's points.
  const auto with_curve = [](double rate, double part = 1.0) {
    return [=](StudyConfig& c) {
      const double low = c.intensity.levels.front(), high = part * c.intensity.levels.back();
      c.hazard = HazardConfig{HazardCurve({{low, 4.0 * rate}, {1.0, rate}, {high, 1e-6 * rate}}),
                              "curve.csv",
                              25.0,
                              {1e-3}};
    };
  };
  EXPECT_EQ(warnings(with_curve(0.014)), 0);
  EXPECT_EQ(warnings(with_curve(0.02)), 1);  // a probability in 50 years
  EXPECT_EQ(warnings(with_curve(1e-6)), 1);
  EXPECT_EQ(warnings(with_curve(0.014, 0.99)), 1);
  StudyConfig us = small_config();
  us.units = UnitSystem::us_customary;
  us.fragility->thresholds_m = {0.1524, 12.7};
  EXPECT_THAT(to_string(small_plan(us)), testing::HasSubstr("thresholds  6, 500 in"));
  EXPECT_THAT(to_string(small_plan(us)), testing::HasSubstr("a clearance of 500 in"));
  EXPECT_EQ(warnings([](StudyConfig& c) {
              c.quantities.at("friction", "mu") = drawn(TruncatedNormal{0.3, 0.2, 0.0, INFINITY});
              c.model.axes = SlidingAxes::one;
            }),
            3);  // and one axis, and some of what is drawn is below the slope
  EXPECT_EQ(warnings([](StudyConfig& c) { c.quantities.at("roof", "slope_deg") = fixed(30.0); }),
            1);
  EXPECT_EQ(warnings([](StudyConfig& c) { c.quantities.at("roof", "slope_deg") = fixed(0.25); }),
            1);
  EXPECT_EQ(
      warnings([](StudyConfig& c) { c.quantities.at("building", "mass_ratio") = fixed(1e-5); }), 1);
  EXPECT_EQ(warnings([](StudyConfig& c) {
              c.unmarked_numbers = {"fragility.thresholds_m = 1 (3.28 ft)"};
            }),
            1);
  Suite twins = small_suite();
  for (Motion& motion : twins.motions) motion.horizontal_mps2[1] = motion.horizontal_mps2[0];
  EXPECT_EQ(other_warnings(make_plan(small_config(), {twins})), std::ssize(twins.motions) + 1);
  for (Motion& motion : twins.motions) motion.dt_s = 0.5;  // five are named, the others counted
  EXPECT_EQ(other_warnings(make_plan(small_config(), {twins})), 5 + 1 + 1);
}

TEST(plan, warns_of_each_parameter_beyond_what_is_probable) {
  for (const ProbableRange& range : probable_ranges()) {
    StudyConfig config = small_config();
    config.model.axes = SlidingAxes::two;
    config.quantities.at("building", "period_s") = fixed(0.5);
    config.quantities.at(range.table, range.key) = fixed(1.4 * range.most);
    EXPECT_THAT(small_plan(config).warnings, testing::Contains(testing::HasSubstr(range.reason)))
        << range.table << "." << range.key;
  }
  for (const Parameter& p : parameters())
    EXPECT_EQ(improbable_value(p, value_of(p, Case())), "") << p.name();
}

TEST(plan, warns_of_storeys_and_stated_modes_that_no_building_has) {
  const auto warnings = [](const BuildingModel& building, double period_s) {
    StudyConfig config = small_config();
    config.building = building;
    config.quantities.at("building", "period_s") = fixed(period_s);
    return small_plan(config).warnings;
  };
  const std::vector<double> ones(20, 1.0);
  BuildingModel storeys{BuildingModel::Kind::storeys};
  storeys.modes[0] = storeys.modes[1] = with_first_period(shear_building_modes(ones, ones), 1.0);
  EXPECT_THAT(warnings(storeys, 2.0),
              testing::Not(testing::Contains(testing::HasSubstr("storey"))));
  EXPECT_THAT(warnings(storeys, 0.3), testing::Contains(testing::HasSubstr("20 storeys")));
  const BuildingModel stated{
      BuildingModel::Kind::modes, {{{{1.0, 1.0, 1.0, 0.4}}, {{1.0, 1.0, 1.0, 0.4}}}}, true};
  EXPECT_THAT(warnings(stated, 60.0), testing::Contains(testing::HasSubstr("60 s is above 10 s")));
  EXPECT_THAT(warnings(stated, 1.0), testing::Contains(testing::HasSubstr("damping 0.4")));
}

TEST(plan, warns_of_a_period_along_the_second_axis_that_no_building_has) {
  using Kind = BuildingModel::Kind;
  const std::vector<Mode> whole{{1.0, 1.0, 1.0}};
  for (const BuildingModel& building : {BuildingModel{}, BuildingModel{Kind::cantilever},
                                        BuildingModel{Kind::modes, {{whole, whole}}}}) {
    StudyConfig config = small_config();
    config.model.axes = SlidingAxes::two;
    config.building = building;
    config.quantities.at("building", "period_s") = listed({0.5, 15.0});
    config.quantities.at("building", "period_ratio") = listed({1.0, 4.0});
    EXPECT_THAT(small_plan(config).warnings,
                testing::Contains(test::states("along the second axis", "60 s is above 10 s")));
    config.quantities.at("building", "period_ratio") = fixed(1.0);
    EXPECT_THAT(
        small_plan(config).warnings,
        testing::Not(testing::Contains(testing::HasSubstr("along the second axis: building"))));
  }
}

TEST(plan, refuses_periods_below_a_hundredth_of_a_second_which_are_rigid) {
  for (const char* table : {"building", "vertical"}) {
    StudyConfig config = small_config();
    config.quantities.at(table, "period_s") = fixed(4e-4);
    EXPECT_THROW(small_plan(config), InputError) << table;
  }
}

/// A building that is hardly damped, or much stiffer than the step, costs more, and its units are
/// smaller.
TEST(plan, predicts_the_cost_of_hardly_damped_and_of_stiff_buildings) {
  const auto cost = [](double period_s, double damping) {
    StudyConfig config = small_config();
    config.model.axes = SlidingAxes::two;
    config.quantities.at("building", "period_s") = fixed(period_s);
    config.quantities.at("building", "damping") = fixed(damping);
    return history_cost(Kernel::full, config, 0.01).mean_us;
  };
  EXPECT_EQ(cost(0.5, 0.05), cost(1.5, 0.1));
  EXPECT_NEAR(cost(0.02, 0.05) / cost(0.5, 0.05), 8.0, 1e-12);  // 16 steps a period
  // 67 s of 264 histories of 7,999 samples (issue 48): 254 ms each.
  EXPECT_GT(cost(0.02, 0.0), 0.5 * 254e3);
  EXPECT_LT(cost(0.02, 0.0), 2.0 * 254e3);
}

TEST(plan, warns_of_gaps_between_the_periods_of_which_the_worst_counts) {
  StudyConfig config = small_config();
  config.quantities.at("building", "period_s") = listed({0.2, 0.25, 0.5, 0.7});
  const auto warned = testing::Contains(test::states("0.25 and 0.5, 0.5 and 0.7 s", "1.3 times"));
  EXPECT_THAT(small_plan(config).warnings, testing::Not(warned));
  config.clearance = ClearanceConfig{.without_target = true};
  EXPECT_THAT(small_plan(config).warnings, warned);
  config.quantities.at("building", "period_s") = listed({0.0, 0.075, 0.09});
  EXPECT_THAT(small_plan(config).warnings,
              testing::Not(testing::Contains(test::states("1.3 times"))));
}

TEST(plan, notes_records_whose_components_are_assumed_to_start_together) {
  Suite suite = small_suite();
  suite.motions[1].starts_are_assumed = true;
  EXPECT_THAT(make_plan(small_config(), {suite}).notes,
              testing::Contains(test::states("1 of 3 records", "start together", "motion1")));
}

TEST(plan, warns_of_one_motion_under_two_ids) {
  Suite suite = small_suite();
  suite.motions.push_back(suite.motions.front());
  suite.motions.back().id = "again";
  EXPECT_THAT(make_plan(small_config(), {suite}).warnings,
              testing::Contains("records motion0, again are the same motion: it counts 2 times"));
}

TEST(plan, warns_of_probabilities_from_records_that_are_the_nearest_to_a_target) {
  Suite suite = small_suite();
  suite.nearest_to_target = true;
  StudyConfig config = small_config();
  const auto warnings = [&] { return make_plan(config, {suite}).warnings; };
  const auto of_selection = testing::HasSubstr("nearest to a target spectrum");
  EXPECT_THAT(warnings(), testing::Contains(of_selection));
  config.fragility.reset();
  config.standards.compare.clear();
  EXPECT_THAT(warnings(), testing::Not(testing::Contains(of_selection)));
}

TEST(plan, runs_the_records_a_study_names) {
  StudyConfig config = small_config();
  config.records = {"motion2", "motion0"};
  const Plan plan = small_plan(config);
  ASSERT_EQ(plan.records.size(), 2u);
  EXPECT_EQ(plan.motion(0).id, "motion0");
  EXPECT_EQ(plan.motion(1).id, "motion2");
  config.normalise_by_pgv = true;
  const Plan normalised = small_plan(config);
  EXPECT_THAT(normalised.notes, testing::Contains(testing::HasSubstr("median PGV")));
  const auto pgv_mps = [](const Motion& motion) {
    return motion.scale * horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean);
  };
  EXPECT_NEAR(pgv_mps(normalised.motion(0)) / pgv_mps(normalised.motion(1)), 1.0, 1e-13);
  EXPECT_GT(std::abs(pgv_mps(plan.motion(0)) / pgv_mps(plan.motion(1)) - 1.0), 0.01);
  config.records = {"motoin1"};
  EXPECT_THROW(small_plan(config), InputError);
}

TEST(plan, refuses_a_factor_that_no_kernel_takes) {
  StudyConfig config = small_config();
  config.intensity.measure = IntensityMeasure::pga_g;
  config.intensity.levels.back() = 1e15;
  EXPECT_THROW(small_plan(config), InputError);
}

TEST(plan, has_the_records_of_every_suite) {
  StudyConfig config = small_config();
  config.suite_files = {"a.toml", "b.toml"};
  Suite second = small_suite();
  second.motions.resize(1);
  second.target->ss_g = 3.0;
  const Plan plan = make_plan(config, {small_suite(), second});
  ASSERT_EQ(plan.records.size(), 4u);
  EXPECT_EQ(plan.records[3].suite, 1u);
  EXPECT_EQ(plan.motion(3).id, "motion0");
  EXPECT_EQ(plan.target(3)->ss_g, 3.0);
  EXPECT_EQ(plan.target(0)->ss_g, 1.5);
  EXPECT_EQ(plan.factor_at_unit_level.size(), 4u);
}

}  // namespace
}  // namespace glissade
