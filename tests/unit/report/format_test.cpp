// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/format.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "glissade/fragility/goodness_of_fit.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"

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
  EXPECT_EQ(format_number(9593.2), "9590");
  EXPECT_EQ(format_number(5.77e-5), "5.77e-05");
  EXPECT_EQ(format_number(1.5e-9), "1.50e-09");
  EXPECT_EQ(format_number(0.0), "0");
}

// Found by fuzzing: a level of a results file may be any number that is finite.
TEST(rounded_to, takes_numbers_of_any_size) {
  EXPECT_EQ(rounded_to(0.12345, 4), 0.1235);
  EXPECT_EQ(rounded_to(-12345.0, 2), -12000.0);
  EXPECT_EQ(rounded_to(1.26e-315, 2), 1.3e-315);
  EXPECT_EQ(rounded_to(1.797693e308, 4), std::numeric_limits<double>::infinity());
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

TEST(length_number, has_no_digits_below_a_tenth_of_a_millimetre) {
  EXPECT_EQ(length_number(0.3048, UnitSystem::us_customary), "12.0");
  EXPECT_EQ(length_number(0.00554, UnitSystem::si), "0.0055");
  EXPECT_EQ(length_number(0.000458, UnitSystem::si), "< 0.001");
  EXPECT_EQ(length_number(1.41e-7, UnitSystem::us_customary), "< 0.02");
  EXPECT_EQ(length_number(0.0, UnitSystem::si), "0");
}

TEST(LengthUnits, customary_puts_inches_first_while_it_lives) {
  {
    const LengthUnits units(UnitSystem::us_customary);
    EXPECT_EQ(format_length(0.3), "11.8 in (0.300 m)");
    EXPECT_EQ(short_length(0.3), "11.8 in");
    EXPECT_EQ(format_length_interval({0.254, 0.508}), "10.0 to 20.0 in");
    EXPECT_EQ(format_length_interval({0.254, std::numeric_limits<double>::infinity()}),
              "10.0 in or more");
    const Table table{
        "t", "", {{"slip", "m", "Slip, m (in) [95 %, m]", ColumnKind::length, "", true}}, {}};
    Table filled = table;
    filled.add({Estimate{0.254, {0.127, 0.508}}});
    EXPECT_NE(to_text(filled).find("Slip, in (m) [95 %, in]"), std::string::npos);
    EXPECT_NE(to_text(filled).find("10.0 (0.254) [5.00, 20.0]"), std::string::npos);
    EXPECT_NE(to_csv(filled).find("slip_m"), std::string::npos);  // files stay in metres
    EXPECT_NE(to_csv(filled).find("0.254,0.127,0.508"), std::string::npos);
    const Axis axis = length_axis("Slip", 0.508);
    EXPECT_EQ(axis.label, "Slip (in)");
    EXPECT_EQ(axis.ticks.back().label, "20");
    EXPECT_NEAR(axis.ticks.back().at, 0.508, 1e-12);
  }
  EXPECT_EQ(format_length(0.3), "0.300 m (11.8 in)");
}

TEST(format_share, does_not_round_the_rare_to_never_nor_the_frequent_to_always) {
  EXPECT_EQ(format_share(0.0004), "< 0.1 %");
  EXPECT_EQ(format_share(0.0), "0 %");
  EXPECT_EQ(format_share(0.123), "12 %");
  EXPECT_EQ(format_share(0.996), "99.6 %");
  EXPECT_EQ(format_share(0.9996), "> 99.9 %");
  EXPECT_EQ(format_share(1.0), "100 %");
}

TEST(format_p, is_a_bound_where_no_replicate_was_as_far) {
  EXPECT_EQ(format_p(least_p_value), "p <= 0.005");
  EXPECT_EQ(format_p(0.01), "p = 0.01");
}

TEST(format_exact, reads_back_as_the_same_double) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 123456789.125})
    EXPECT_EQ(std::stod(format_exact(value)), value);
  EXPECT_EQ(format_exact(nan), "");
  EXPECT_EQ(format_exact(infinity), "inf");
}

}  // namespace
}  // namespace glissade
