// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/quantile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glissade {
namespace {

// By hand, type 7: of n values the place of p is (n - 1) p, counted from 0. The 0.84 quantile of
// 1, 2, 4, 8 is at 2.52: 4 + 0.52 x 4 = 6.08.
TEST(quantile, is_linear_between_the_order_statistics_of_hyndman_and_fan_type_7) {
  EXPECT_DOUBLE_EQ(quantile_of({8.0, 1.0, 4.0, 2.0}, 0.84), 6.08);
  EXPECT_DOUBLE_EQ(quantile_of({8.0, 1.0, 4.0, 2.0}, 0.5), 3.0);
  EXPECT_EQ(quantile_of({8.0, 1.0, 4.0}, 0.5), 4.0);
  EXPECT_EQ(quantile_of({8.0, 1.0, 4.0, 2.0}, 0.0), 1.0);
  EXPECT_EQ(quantile_of({8.0, 1.0, 4.0, 2.0}, 1.0), 8.0);
  EXPECT_EQ(quantile_of({3.0}, 0.84), 3.0);
}

TEST(quantile, is_infinite_only_where_an_infinite_value_has_a_part) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantile_of({1.0, 2.0, infinity}, 0.5), 2.0);
  EXPECT_EQ(quantile_of({1.0, 2.0, infinity}, 0.5001), infinity);
  EXPECT_EQ(quantile_of({1.0, infinity, infinity}, 0.84), infinity);
}

TEST(quantile, of_nothing_is_nan) { EXPECT_TRUE(std::isnan(quantile_of({}, 0.5))); }

}  // namespace
}  // namespace glissade
