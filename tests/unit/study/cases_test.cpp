// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "glissade/study/cases/case_set.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::listed;
using test::small_config;

/// Two periods and three slopes are listed, friction is drawn five times, each on four
/// orientations.
StudyConfig mixed_config() {
  StudyConfig config = small_config();
  config.quantities.at("building", "period_s") = listed({0.25, 0.5});
  config.quantities.at("roof", "slope_deg") = listed({-2.5, 0.0, 2.5});
  config.sampling.samples = 5;
  config.orientation.choice = OrientationChoice::all_permutations;
  return config;
}

TEST(cases, are_combinations_by_samples_by_orientations) {
  const CaseSet set = PlannedCases(mixed_config()).stored();
  ASSERT_EQ(set.axes.size(), 3u);
  EXPECT_EQ(set.axes[0].key, "friction.value");
  EXPECT_EQ(set.axes[1].key, "building.period_s");
  EXPECT_EQ(set.axes[2].key, "roof.slope_deg");
  EXPECT_EQ(set.combinations(), 2u * 2u * 3u);
  EXPECT_EQ(set.samples, 5u);
  EXPECT_EQ(set.orientations, 4u);  // of one axis: nothing acts across
  ASSERT_EQ(set.size(), 12u * 5u * 4u);
  EXPECT_EQ(set.axis("roof.slope_deg"), 2u);
  EXPECT_EQ(set.axis("building.damping"), 3u);  // one value
  const Case& first = set.cases[set.index(0, 3, 1)];
  std::size_t number = 0;
  for (std::size_t combination = 0; combination < set.combinations(); ++combination) {
    const auto places = set.places(combination);
    EXPECT_EQ(set.combination(places), combination);
    for (std::size_t sample = 0; sample < set.samples; ++sample) {
      for (std::size_t o = 0; o < set.orientations; ++o, ++number) {
        EXPECT_EQ(set.index(combination, sample, o), number);
        const Case& c = set.cases[number];
        EXPECT_EQ(static_cast<double>(c.friction_value), set.axes[0].values[places[0]]);
        EXPECT_EQ(c.period_s, set.axes[1].values[places[1]]);
        EXPECT_EQ(c.slope_deg, set.axes[2].values[places[2]]);
        if (sample == 3 && c.friction_value == FrictionValue::as_drawn) {
          EXPECT_EQ(c.friction, first.friction);  // a sample is the same in every combination
        }
        EXPECT_EQ(c.orientation, set.cases[o].orientation);
      }
    }
  }
}

TEST(cases, are_described_in_words_and_not_in_keys) {
  const CaseSet set = PlannedCases(mixed_config()).stored();
  EXPECT_EQ(set.describe(0), "sampled friction, building period 0.25 s, slope -2.5 deg");
  EXPECT_EQ(set.describe(0, {"friction.value"}), "building period 0.25 s, slope -2.5 deg");
  for (const Parameter& p : parameters()) {
    const CaseAxis axis{std::string(p.table) + "." + p.key, p.unit, {1.0}, {}};
    EXPECT_EQ(axis.describe(0).find_first_of("_.="), std::string::npos) << axis.describe(0);
  }
}

TEST(cases, friction_value_is_that_of_the_sample_or_mean_less_two_standard_deviations) {
  StudyConfig config = small_config();
  CaseSet set = PlannedCases(config).stored();
  ASSERT_EQ(set.combinations(), 2u);
  EXPECT_EQ(set.label(0), "sampled");
  EXPECT_EQ(set.label(1), "design");
  std::set<double> frictions;
  for (std::size_t s = 0; s < set.samples; ++s) {
    frictions.insert(set.cases[s].friction);
    EXPECT_DOUBLE_EQ(set.cases[set.index(1, s, 0)].friction, 0.3);  // 0.4 - 2 * 0.05
    EXPECT_EQ(set.cases[set.index(1, s, 0)].period_s, set.cases[s].period_s);
  }
  EXPECT_EQ(frictions.size(), 40u);
  config.friction.values = {FrictionValue::design};
  set = PlannedCases(config).stored();
  EXPECT_EQ(set.combinations(), 1u);
  for (const Case& c : set.cases) EXPECT_DOUBLE_EQ(c.friction, 0.3);
  EXPECT_EQ(set.label(0), "design");
  config = small_config();
  config.quantities.at("friction", "mu") = fixed(0.4);  // one number: nothing to choose from
  EXPECT_EQ(PlannedCases(config).stored().combinations(), 1u);
  EXPECT_EQ(PlannedCases(config).stored().label(0), "constant");
}

TEST(cases, friction_across_the_slope_goes_along_it_where_the_slope_lies_along_n_s) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.quantities.at("friction", "mu") = fixed(0.4);
  config.quantities.at("friction", "across_mu") = fixed(0.3);
  config.friction.across_is_given = true;
  config.orientation.slope_axis = {SlopeAxis::e_w, SlopeAxis::n_s};
  const CaseSet set = PlannedCases(config).stored();
  EXPECT_EQ(set.orientations, 2u);
  EXPECT_EQ(set.cases[0].friction, 0.4);
  EXPECT_EQ(set.cases[0].friction_across, 0.3);
  EXPECT_EQ(set.cases[1].friction, 0.3);
  EXPECT_EQ(set.cases[1].friction_across, 0.4);
}

TEST(cases, labels_are_different_and_fit_for_file_names) {
  StudyConfig config = mixed_config();
  config.quantities.at("building", "damping") = listed({1e-9, 0.02});
  for (const bool many : {false, true}) {
    if (many) {  // too long for a name: numbered
      config.quantities.at("building", "mass_ratio") = listed({0.0123456, 0.1});
      config.quantities.at("building", "yield_coefficient") = listed({0.123456, 0.2});
    }
    const CaseSet set = PlannedCases(config).stored();
    std::set<std::string> labels;
    for (std::size_t i = 0; i < set.combinations(); ++i) {
      EXPECT_TRUE(std::regex_match(set.label(i), std::regex("[a-z0-9_-]+"))) << set.label(i);
      EXPECT_LE(set.label(i).size(), 48u);  // with "fragility_" before it, a FileName
      labels.insert(set.label(i));
    }
    EXPECT_EQ(labels.size(), set.combinations());
  }
}

// -- cases with the same histories

TEST(first_with_same_key, is_the_lowest_number) {
  const std::vector<double> of{3.0, 1.0, 3.0, 2.0, 1.0, 3.0};
  EXPECT_EQ(first_with_same_key(of.size(),
                                [&](std::size_t i) {
                                  return std::vector{of[i], 0.5};
                                }),
            (std::vector<CaseNumber>{0, 1, 0, 3, 1, 0}));
}

std::size_t different(const StudyConfig& config) {
  const PlannedCases set(config);
  const std::vector<CaseNumber> same = same_as(set, set, config.two_axes());
  std::size_t count = 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_LE(same[i], i);
    EXPECT_EQ(same[same[i]], same[i]);
    count += same[i] == i;
  }
  return count;
}

TEST(same_as, one_axis_ignores_what_acts_across_and_the_sign_on_a_flat_roof) {
  StudyConfig config = small_config();
  config.quantities = Quantities();
  config.orientation.choice = OrientationChoice::all_permutations;
  EXPECT_EQ(different(config), 2u);  // flat: two components
  config.quantities.at("roof", "slope_deg") = fixed(2.0);
  EXPECT_EQ(different(config), 4u);  // and two signs
  config.quantities.at("friction", "across_mu") = listed({0.3, 0.4});
  config.friction.across_is_given = true;
  EXPECT_EQ(different(config), 4u);
  config.quantities.at("vertical", "period_s") = listed({0.0, 0.2});
  EXPECT_EQ(different(config), 8u);
  config.vertical = {VerticalChoice::none};
  EXPECT_EQ(different(config), 4u);  // no vertical: its period has no part
}

TEST(same_as, two_axes_mirror_what_acts_across_a_roof_that_falls_along_an_axis) {
  StudyConfig config = small_config();
  config.quantities = Quantities();
  config.quantities.at("roof", "slope_deg") = fixed(2.0);
  config.model.axes = SlidingAxes::two;
  config.orientation.choice = OrientationChoice::all_permutations;
  EXPECT_EQ(PlannedCases(config).stored().size(), 8u);
  EXPECT_EQ(different(config), 4u);
  config.orientation.slope_axis = {SlopeAxis::e_w, SlopeAxis::n_s};
  EXPECT_EQ(different(config), 4u);  // one friction along both
  config.quantities.at("friction", "across_mu") = fixed(0.3);
  config.friction.across_is_given = true;
  EXPECT_EQ(different(config), 8u);
  config.quantities.at("roof", "azimuth_deg") = fixed(30.0);
  EXPECT_EQ(different(config), 16u);
}

TEST(same_as, a_neighbour_across_the_slope_is_not_mirrored) {
  StudyConfig config = small_config();
  config.quantities = Quantities();
  config.model.axes = SlidingAxes::two;
  config.orientation.choice = OrientationChoice::all_permutations;
  EXPECT_EQ(different(config), 4u);
  config.quantities.at("friction", "neighbour_mu") = fixed(0.4);
  EXPECT_EQ(different(config), 8u);
}

TEST(cases, have_the_friction_of_a_neighbour_over_their_own) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.quantities.at("friction", "mu") = listed({0.3, 0.5});
  config.quantities.at("friction", "neighbour_over_mu") = drawn(Uniform{0.8, 1.2});
  EXPECT_TRUE(config.has_neighbours());
  std::set<double> ratios;
  for (const Case& c : PlannedCases(config).stored().cases) {
    EXPECT_EQ(c.neighbour_friction, c.neighbour_over_mu * c.friction);
    EXPECT_NEAR(c.neighbour_over_mu, 1.0, 0.2);
    ratios.insert(c.neighbour_over_mu);
  }
  EXPECT_EQ(ratios.size(), config.sampling.samples);  // the same for every listed friction
}

// -- orientations

TEST(orientation, quarter_turns_and_signed_components_are_each_others_inverse) {
  std::set<std::pair<double, int>> all;
  for (const int component : {0, 1}) {
    for (const int sign : {1, -1}) {
      for (const int second_sign : {1, -1}) {
        const Orientation o = quarter_turn({component, sign}, second_sign);
        EXPECT_TRUE(o.is_quarter_turn());
        EXPECT_EQ(along_axis(o, 0).component, component);
        EXPECT_EQ(along_axis(o, 0).sign, sign);
        EXPECT_EQ(along_axis(o, 1).component, 1 - component);
        EXPECT_EQ(along_axis(o, 1).sign, second_sign);
        all.insert({o.ground_azimuth_deg, o.across_sign});
      }
    }
  }
  EXPECT_EQ(all.size(), 8u);
}

TEST(orientation, what_acts_along_the_axes_is_the_ground_turned_by_its_azimuth) {
  for (const Orientation& o : orientations(OrientationChoice::all_permutations, {SlopeAxis::e_w})) {
    const Direction d = ground_direction(o);
    const double ground[] = {2.0, 5.0};
    const SignedComponent along = along_axis(o, 0), across = along_axis(o, 1);
    EXPECT_EQ(along.sign * ground[along.component], d.cosine * ground[0] + d.sine * ground[1]);
    EXPECT_EQ(across.sign * ground[across.component],
              o.across_sign * (d.cosine * ground[1] - d.sine * ground[0]));
  }
}

TEST(orientation, all_of_a_choice_are_different) {
  const std::vector<SlopeAxis> both{SlopeAxis::e_w, SlopeAxis::n_s};
  for (const auto& [choice, count] : {std::pair{OrientationChoice::all_permutations, 16u},
                                      std::pair{OrientationChoice::azimuths, 32u},
                                      std::pair{OrientationChoice::as_recorded, 2u}}) {
    std::set<std::string> names;
    for (const Orientation& o : orientations(choice, both)) names.insert(to_string(o));
    EXPECT_EQ(names.size(), count);
  }
  EXPECT_EQ(to_string(Orientation{SlopeAxis::e_w, 90.0, 1}),
            "slope E-W, along it +second, across -first");
  EXPECT_EQ(to_string(Orientation{SlopeAxis::n_s, 180.0, -1}),
            "slope N-S, along it -first, across +second");
}

}  // namespace
}  // namespace glissade
