// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/exchange.hpp"

#include <gtest/gtest.h>

#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_config;
using test::small_plan;
using test::small_suite;

TEST(exchange, brings_suites_over_to_the_last_bit) {
  std::vector<Suite> suites{small_suite(), small_suite()};
  suites[1].name = "other";
  suites[1].target.reset();
  suites[1].nearest_to_target = suites[1].of_roof = true;
  suites[1].motions[0].contradictions = {"one", "other"};
  suites[1].motions[0].starts_are_assumed = true;
  suites[1].motions[1].vertical_mps2 = suites[1].motions[0].vertical_mps2;  // sent once
  const PackedSuites packed = pack(suites);
  EXPECT_EQ(packed.samples_mps2.size(), 17u * 600u);
  const std::vector<Suite> copy = unpack_suites(packed.headers, packed.samples_mps2);
  ASSERT_EQ(copy.size(), 2u);
  // The plan's hash covers every sample, scale and id.
  EXPECT_EQ(make_plan(small_config(), {copy[0]}).hash, small_plan(small_config()).hash);
  EXPECT_EQ(copy[0].name, "small");
  EXPECT_EQ(copy[0].target->s1_g, suites[0].target->s1_g);
  EXPECT_EQ(copy[0].target->site_classes, suites[0].target->site_classes);
  EXPECT_EQ(copy[1].name, "other");
  EXPECT_FALSE(copy[1].target.has_value());
  EXPECT_TRUE(copy[1].nearest_to_target);
  EXPECT_TRUE(copy[1].of_roof);
  EXPECT_TRUE(copy[1].motions[0].starts_are_assumed);
  EXPECT_EQ(copy[1].motions[1].vertical_mps2, suites[1].motions[0].vertical_mps2);
  EXPECT_EQ(copy[1].motions[0].contradictions, suites[1].motions[0].contradictions);
}

TEST(exchange, brings_every_field_of_a_unit_result_over_to_the_last_bit) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.sampling.samples = 2;
  config.intensity.levels = {1.0, 2.0};
  config.clearance = ClearanceConfig{};
  config.impact = config.base_shear = true;
  config.quantities.at("friction", "neighbour_mu") = test::fixed(0.3);
  const Plan plan = small_plan(config);
  UnitResult unit = execute(plan, 2);
  unit.fields.tips = {1, 0};  // in no study on two axes
  const UnitResult copy = unpack_unit_result(pack(unit));
  EXPECT_EQ(copy.unit, unit.unit);
  EXPECT_EQ(copy.count, unit.count);
  EXPECT_EQ(test::bits_of({.fields = copy.fields}), test::bits_of({.fields = unit.fields}));
  for_each_history_field(
      [&](auto field) { EXPECT_FALSE((copy.fields.*field.of).empty()) << field.name; });
}

TEST(exchange, does_not_read_beyond_a_short_message) {
  const PackedSuites packed = pack(std::vector{small_suite()});
  const std::span<const char> headers(packed.headers);
  const std::span<const double> samples(packed.samples_mps2);
  EXPECT_THROW(unpack_suites(headers.first(headers.size() / 2), samples), std::logic_error);
  EXPECT_THROW(unpack_suites(headers, samples.first(samples.size() - 1)), std::logic_error);
}

}  // namespace
}  // namespace glissade
