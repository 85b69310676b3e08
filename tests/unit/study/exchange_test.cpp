// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/exchange.hpp"

#include <gtest/gtest.h>

#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

TEST(exchange, brings_a_suite_over_to_the_last_bit) {
  const Suite suite = test::small_suite();
  const Suite copy = unpack_suite(pack(suite));
  // The plan's hash covers every sample, scale and id.
  EXPECT_EQ(make_plan(test::small_config(), copy).hash,
            make_plan(test::small_config(), suite).hash);
  EXPECT_EQ(copy.name, suite.name);
  EXPECT_EQ(copy.target->s1_g, suite.target->s1_g);
  EXPECT_EQ(copy.target->site_classes, suite.target->site_classes);
}

TEST(exchange, brings_unit_results_over_to_the_last_bit) {
  const Plan plan = make_plan(test::small_config(), test::small_suite());
  const std::vector<UnitResult> units{execute(plan, 2), execute(plan, 0)};
  const std::vector<UnitResult> copy = unpack_unit_results(pack(units));
  ASSERT_EQ(copy.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(copy[i].unit, units[i].unit);
    EXPECT_EQ(copy[i].count, units[i].count);
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_EQ(copy[i].runs[r].peak_displacement_m, units[i].runs[r].peak_displacement_m);
      EXPECT_EQ(copy[i].runs[r].uplift, units[i].runs[r].uplift);
      EXPECT_EQ(copy[i].runs[r].capacity, units[i].runs[r].capacity);
    }
  }
}

TEST(exchange, does_not_read_beyond_a_short_message) {
  std::vector<char> bytes = pack(test::small_suite());
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(unpack_suite(bytes), std::logic_error);
}

}  // namespace
}  // namespace glissade
