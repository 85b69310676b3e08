// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/format.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace glissade {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(format_number, keeps_three_significant_digits_without_exponent) {
  EXPECT_EQ(format_number(0.3), "0.300");
  EXPECT_EQ(format_number(12.345), "12.3");
  EXPECT_EQ(format_number(9.996), "10.0");  // rounds up into the next decade
  EXPECT_EQ(format_number(1024.0), "1024");
  EXPECT_EQ(format_number(-0.01234), "-0.0123");
  EXPECT_EQ(format_number(1.5e-9), "1.50e-09");
  EXPECT_EQ(format_number(0.0), "0");
}

TEST(format, shows_what_is_not_finite_as_a_dash) {
  for (const double value : {nan, infinity, -infinity}) {
    EXPECT_EQ(format_number(value), "-");
    EXPECT_EQ(format_length(value), "-");
    EXPECT_EQ(format_share(value), "-");
  }
}

TEST(format_length, gives_inches_in_brackets) {
  EXPECT_EQ(format_length(0.3048), "0.305 m (12.0 in)");  // one foot
}

TEST(format_share, does_not_round_the_rare_to_never_nor_the_frequent_to_always) {
  EXPECT_EQ(format_share(0.0004), "< 0.1 %");
  EXPECT_EQ(format_share(0.0), "0 %");
  EXPECT_EQ(format_share(0.123), "12 %");
  EXPECT_EQ(format_share(0.996), "99.6 %");
  EXPECT_EQ(format_share(1.0), "100 %");
}

TEST(format_exact, reads_back_as_the_same_double) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 123456789.125})
    EXPECT_EQ(std::stod(format_exact(value)), value);
  EXPECT_EQ(format_exact(nan), "");
  EXPECT_EQ(format_exact(infinity), "inf");
}

}  // namespace
}  // namespace glissade
