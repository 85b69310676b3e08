// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/error.hpp"

#include <gtest/gtest.h>

#include "glissade/core/printable.hpp"

namespace glissade {
namespace {

TEST(problem, reads_where_what_and_what_to_do) {
  EXPECT_EQ(
      to_string({"study.toml:3", "mu = -1 is negative", "give mu >= 0", "  mu = -1\n       ^"}),
      "study.toml:3: mu = -1 is negative; give mu >= 0\n  mu = -1\n       ^");
}

TEST(problem, shows_what_acts_on_a_terminal_by_its_number) {
  EXPECT_EQ(to_string({"a\x1b[31m\nb.toml", "\xe2\x80\xae", "", "  x\n\t^\a"}),
            "a\\u001b[31m\\u000ab.toml: \\u202e\n  x\n\t^\\u0007");
}

TEST(printable, keeps_text_of_any_language_and_shows_what_is_no_text) {
  const std::string fine = "Gülerce \u65e5\u672c \U0001F600\n\tx";
  EXPECT_EQ(printable(fine), fine);
  // Escape, delete, C1, direction of text, line separator.
  EXPECT_EQ(printable("\x1b[2J\x7f\xc2\x9b\u200f\u202e\u2066\u2028"),
            "\\u001b[2J\\u007f\\u009b\\u200f\\u202e\\u2066\\u2028");
  // Latin-1, cut short, overlong, a surrogate, beyond Unicode.
  EXPECT_EQ(printable("\xe9 \xe2\x80 \xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80"),
            "\\xe9 \\xe2\\x80 \\xc0\\xaf \\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80");
}

TEST(problem_list, throws_all_problems_at_once) {
  ProblemList problems;
  EXPECT_NO_THROW(problems.throw_if_any());
  problems.add({"a", "first", "", ""});
  problems.add({"b", "second", "", ""});
  try {
    problems.throw_if_any();
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
    EXPECT_STREQ(error.what(), "a: first\nb: second");
  }
}

TEST(problem_list, shows_a_hundred_problems_and_counts_the_others) {
  ProblemList problems;
  for (int i = 0; i < 100; ++i) problems.add({"a", "wrong", "", ""});
  try {
    problems.throw_if_any();
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 100u);
    EXPECT_EQ(error.problems().back().what, "wrong");
  }
  problems.add({"a", "wrong", "", ""});
  problems.add({"a", "wrong", "", ""});
  try {
    problems.throw_if_any();
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 101u);
    EXPECT_EQ(error.problems().back().what, "2 more problems");
  }
}

TEST(problem, cuts_a_name_that_is_as_long_as_a_file_between_two_letters) {
  const std::string fits(4000, 'x');
  EXPECT_EQ(to_string({"", fits, "", ""}), fits);
  std::string greek;
  for (int i = 0; i < 3000; ++i) greek += "α";
  EXPECT_EQ(to_string({"", "x" + greek, "", ""}), "x" + greek.substr(0, 3998) + "...");
}

TEST(nearest_word, is_none_of_a_word_that_is_no_slip_of_the_pen) {
  EXPECT_EQ(nearest_word(std::string(97, 'x') + "_mu", {"mu"}), "");
  EXPECT_EQ(nearest_word(std::string(98, 'x') + "mu", {"x", "mu_x"}), "");
}

TEST(nearest_word, finds_the_key_with_a_wrong_unit_or_a_slip_of_the_pen) {
  const std::vector<std::string> keys = {"period_s", "damping", "slope_deg", "thresholds_m"};
  EXPECT_EQ(nearest_word("period_ms", keys), "period_s");
  EXPECT_EQ(nearest_word("threshold_m", keys), "thresholds_m");
  EXPECT_EQ(nearest_word("dampign", keys), "damping");
  EXPECT_EQ(nearest_word("perod", keys), "period_s");
  EXPECT_EQ(nearest_word("colour", keys), "");
  EXPECT_EQ(nearest_word("slope", keys), "slope_deg");
  EXPECT_EQ(nearest_word("tilt_deg", keys), "slope_deg");
  EXPECT_EQ(nearest_word("--slope", {"--scale", "--slope-deg"}), "--slope-deg");
  EXPECT_EQ(nearest_word("--hlep", {"--help", "--out"}), "--help");
  EXPECT_EQ(nearest_word("--output", {"--help", "--out"}), "--out");
}

// A wall is no frame: T_a would be another.
TEST(nearest_word, is_none_of_a_word_that_means_another_thing) {
  const std::vector<std::string> systems = {"steel_moment_frame", "concrete_moment_frame", "other"};
  EXPECT_EQ(nearest_word("concrete_shear_wall", systems), "");
  EXPECT_EQ(nearest_word("steel_braced_frame", systems), "");
  EXPECT_EQ(nearest_word("concrete_momment_frame", systems), "concrete_moment_frame");
  EXPECT_EQ(nearest_word("cov", {"mean", "std", "from", "to", "count"}), "");
}

TEST(nearest_word, suggests_nothing_where_every_letter_or_only_digits_differ) {
  const std::vector<std::string> classes = {"A", "B", "C", "D", "E", "default"};
  EXPECT_EQ(nearest_word("F", classes), "");
  EXPECT_EQ(nearest_word("d", classes), "D");
  EXPECT_EQ(nearest_word("D-default", classes), "default");  // D gives less
  EXPECT_EQ(nearest_word("G", classes), "");
  EXPECT_EQ(nearest_word("V", {"I", "II", "III", "IV"}), "");
  EXPECT_EQ(nearest_word("asce7_22", {"asce7_10", "asce7_16"}), "");
  EXPECT_EQ(nearest_word("asce_716", {"asce7_10", "asce7_16"}), "asce7_16");
  EXPECT_EQ(nearest_word("SI", {"si", "us"}), "si");
}

}  // namespace
}  // namespace glissade
