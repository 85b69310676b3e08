// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/record_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double g = standard_gravity_mps2;

class RecordFile : public testing::Test {
 protected:
  /// In g where neither the file nor the options state the units.
  Record read(const std::string& content, RecordFileOptions options = {}) const {
    options.units_if_not_stated = AccelerationUnits::g;
    return read_record(folder_.write("record", content), options);
  }
  std::string error(const std::string& content, const RecordFileOptions& options = {}) const {
    return message_of([&] { read(content, options); });
  }
  TemporaryFolder folder_;
};

const std::string at2_head =
    "PEER NGA STRONG MOTION DATABASE RECORD\nEvent, Station, 0\nACCELERATION TIME SERIES IN UNITS "
    "OF G\n";

TEST_F(RecordFile, at2_with_filter_text_after_dt_is_read_in_g) {
  const Record record = read(
      at2_head +
      "NPTS=  5, DT=   .0100 SEC,  -5 POLE @  .05 HZ\n  -.1072237E-03  .5E+0 +1.0E-2\n 1 -2.\n");
  EXPECT_EQ(record.dt_s, 0.01);
  EXPECT_THAT(record.acceleration_mps2,
              ElementsAre(DoubleEq(-.1072237e-3 * g), DoubleEq(0.5 * g), DoubleEq(0.01 * g),
                          DoubleEq(g), DoubleEq(-2 * g)));
}

TEST_F(RecordFile, at2_header_variants_give_the_same) {
  for (const std::string header :
       {"NPTS=   3, dt=  .01000", "3    0.0100    NPTS, DT ", "NPTS= 3, DT= 0.01000000 SEC",
        "NPTS=3,DT=.01 SEC", "npts = 3 , dt = 1E-2 sec"}) {
    for (const std::string end : {"\n", "\r\n"}) {
      const Record record =
          read("title" + end + "Acceleration in g" + end + header + end + "1 2" + end + "3" + end);
      EXPECT_EQ(record.dt_s, 0.01) << header;
      EXPECT_EQ(record.acceleration_mps2.size(), 3u) << header;
      EXPECT_DOUBLE_EQ(record.acceleration_mps2[2], 3 * g) << header;
    }
  }
}

TEST_F(RecordFile, at2_is_known_by_its_header_however_many_lines_it_has) {
  EXPECT_EQ(read("NPTS= 2, DT= .02 SEC\n1 2\n").dt_s, 0.02);
  EXPECT_EQ(read(std::string(60, '\n') + "NPTS= 2, DT= .02 SEC\n1 2\n").dt_s, 0.02);
}

TEST_F(RecordFile, dt_option_overrides_the_one_in_the_header) {
  EXPECT_EQ(read(at2_head + "NPTS= 1, DT= .0039 SEC\n1\n", {.dt_s = 1.0 / 256, .units = {}}).dt_s,
            1.0 / 256);
}

TEST_F(RecordFile, header_units_are_followed_and_checked) {
  const std::string rest = "NPTS= 1, DT= .01 SEC\n100\n";
  EXPECT_DOUBLE_EQ(read("ACCELERATION IN UNITS OF CM/S/S\n" + rest).acceleration_mps2[0], 1.0);
  EXPECT_DOUBLE_EQ(read("ACCELERATION IN UNITS OF M/SEC**2\n" + rest).acceleration_mps2[0], 100.0);
  EXPECT_THAT(error("VELOCITY TIME SERIES IN UNITS OF CM/S\n" + rest),
              AllOf(HasSubstr("record:1"), HasSubstr("velocity file")));
  EXPECT_THAT(error("DISPLACEMENT TIME SERIES IN UNITS OF CM\n" + rest),
              HasSubstr("displacement file"));
  EXPECT_THAT(error("ACCELERATION TIME SERIES IN UNITS OF FURLONGS\n" + rest),
              HasSubstr("'furlongs' are not known"));
  EXPECT_THAT(error(at2_head + rest, {.dt_s = {}, .units = AccelerationUnits::mps2}),
              AllOf(HasSubstr("record:3"), HasSubstr("m/s2")));
}

TEST_F(RecordFile, npts_that_differs_from_the_values_reports_both_counts) {
  EXPECT_THAT(error(at2_head + "NPTS= 4, DT= .01 SEC\n1 2 3\n"),
              AllOf(HasSubstr("record:4"), HasSubstr("4"), HasSubstr("3 values")));
  EXPECT_THAT(error(at2_head + "NPTS= 2, DT= .01 SEC\n1 2 3\n"),
              HasSubstr("NPTS is 2, the file contains 3"));
  EXPECT_THAT(error(at2_head + "NPTS= 99999999999999999999999, DT= .01 SEC\n1\n"),
              HasSubstr("no whole number"));
  EXPECT_THAT(error(at2_head + "NPTS= 0, DT= .01 SEC\n"), HasSubstr("no samples"));
}

TEST_F(RecordFile, samples_that_are_no_finite_numbers_are_reported_with_their_line) {
  const std::string header = at2_head + "NPTS= 3, DT= .01 SEC\n";
  EXPECT_THAT(error(header + "1 2\nNaN\n"),
              AllOf(HasSubstr("record:6"), HasSubstr("'NaN' is not finite")));
  EXPECT_THAT(error(header + "1 2\n1e999\n"), AllOf(HasSubstr("record:6"), HasSubstr("'1e999'")));
  EXPECT_THAT(error(header + "1 -inf 3\n"), AllOf(HasSubstr("record:5"), HasSubstr("'-inf'")));
  EXPECT_THAT(error(header + "1 two 3\n"),
              AllOf(HasSubstr("record:5"), HasSubstr("'two' is not a number")));
}

TEST_F(RecordFile, samples_that_are_finite_in_g_alone_are_reported_with_their_line) {
  EXPECT_THAT(error(at2_head + "NPTS= 2, DT= .01 SEC\n1\n1e308\n"),
              AllOf(HasSubstr("record:6"), HasSubstr("'1e308' is not finite in m/s2")));
  EXPECT_THAT(error("0 1\n0.01 -1e308\n", {.dt_s = {}, .units = AccelerationUnits::g}),
              AllOf(HasSubstr("record:2"), HasSubstr("'-1e308' is not finite in m/s2")));
}

TEST_F(RecordFile, steps_that_are_not_above_zero_or_missing_are_refused) {
  EXPECT_THAT(error(at2_head + "NPTS= 1, DT= 0.0 SEC\n1\n"), HasSubstr("not above 0"));
  EXPECT_THAT(error(at2_head + "NPTS= 1, DT= -.01 SEC\n1\n"), HasSubstr("not above 0"));
  EXPECT_THAT(error(at2_head + "NPTS= 1\n1\n"), HasSubstr("no DT"));
  for (const char* columns : {"1\n2\n", "0 1\n", "0 1\n0.01 2\n"}) {
    EXPECT_THAT(error(std::string("# DT = 0 s\n") + columns),
                AllOf(HasSubstr("record:1"), HasSubstr("dt = 0 s is not above 0")));
  }
  EXPECT_THAT(error("1\n2\n"), HasSubstr("give it with dt_s"));
  EXPECT_THAT(error("1\n2\n", {.dt_s = -1.0, .units = {}}), HasSubstr("not above 0"));
}

TEST_F(RecordFile, one_column_takes_step_and_units_from_the_options) {
  const RecordFileOptions options{.dt_s = 0.005, .units = AccelerationUnits::cmps2};
  const Record record = read("# a comment\n\n 100\n+2E2 # and another\n-.5\r\n", options);
  EXPECT_EQ(record.dt_s, 0.005);
  EXPECT_THAT(record.acceleration_mps2,
              ElementsAre(DoubleEq(1.0), DoubleEq(2.0), DoubleEq(-0.005)));
}

TEST_F(RecordFile, two_columns_give_their_step_with_any_separator) {
  for (const std::string separator : {" ", "\t", ",", " , ", "   "}) {
    const Record record =
        read("0.0" + separator + "1\n0.02" + separator + "2\n0.04" + separator + "3\n");
    EXPECT_EQ(record.dt_s, 0.02) << separator;
    EXPECT_DOUBLE_EQ(record.acceleration_mps2[1], 2 * g);
  }
}

TEST_F(RecordFile, times_may_begin_at_dt_and_be_printed_with_few_decimals) {
  EXPECT_EQ(read("0.01 1\n0.02 2\n0.03 3\n").dt_s, 0.01);
  std::string text;  // 1/256 s, times cut to three decimals: the last of 4096 intervals is 16 s
  for (int i = 0; i <= 4096; ++i) {
    char line[64];
    snprintf(line, sizeof line, "%.3f 0.1\n", i / 256.0);
    text += line;
  }
  EXPECT_NEAR(read(text).dt_s, 1.0 / 256, 0.001 / 4096);  // half a last decimal at both ends
  EXPECT_EQ(read(text, {.dt_s = 1.0 / 256, .units = {}}).dt_s, 1.0 / 256);
}

TEST_F(RecordFile, times_that_are_uneven_or_disagree_with_the_option_are_refused) {
  EXPECT_THAT(error("0 1\n0.01 2\n0.03 3\n0.04 3\n"),
              AllOf(HasSubstr("record:3"), HasSubstr("0.01 to 0.03")));
  std::string lost;  // a sample of many, where the times have as few decimals as the step
  for (int i = 0; i < 1000; ++i)
    lost += std::to_string((i < 500 ? i : i + 1) / 100) + "." +
            std::to_string(100 + (i < 500 ? i : i + 1) % 100).substr(1) + " 0.1\n";
  EXPECT_THAT(error(lost), AllOf(HasSubstr("record:501"), HasSubstr("4.99 to 5.01")));
  EXPECT_THAT(error("0 1\n0.01 2\n0.00 3\n0.03 1\n"), HasSubstr("record:3"));
  EXPECT_THAT(error("0 1\n0 2\n"), HasSubstr("not above 0"));
  EXPECT_THAT(error("0 1\n0.01 2\n0.02 3\n", {.dt_s = 0.02, .units = {}}), HasSubstr("0.02"));
}

TEST_F(RecordFile, columns_beyond_two_or_of_changing_number_are_refused) {
  EXPECT_THAT(error("0 1 2\n"), AllOf(HasSubstr("record:1"), HasSubstr("3 columns")));
  EXPECT_THAT(error("0 1\n0.01\n"), AllOf(HasSubstr("record:2"), HasSubstr("1 column, 2 above")));
  EXPECT_THAT(error("0,1\n0.01,\n"), AllOf(HasSubstr("record:2"), HasSubstr("''")));
}

TEST_F(RecordFile, units_that_are_not_stated_are_not_guessed) {
  const auto alone = [&](const std::string& text) {
    return read_record(folder_.write("record", text), {.dt_s = 0.01, .units = {}});
  };
  const std::string no_units = "EVENT\nNPTS= 2, DT= .01 SEC\n1 2\n";
  for (const std::string& text : {std::string("0 741\n0.01 2\n"), std::string("1\n2\n"), no_units})
    EXPECT_THAT(message_of([&] { alone(text); }), HasSubstr("units"));
  for (const char* comment :
       {"# units: cm/s2", "# acceleration in gal", "# time_s acceleration_gal",
        "# Time (s), Acceleration (cm/s2)", "#t, acceleration [cm/s/s] in gal"})
    EXPECT_DOUBLE_EQ(alone(comment + std::string("\n0 741\n0.01 2\n")).acceleration_mps2[0], 7.41)
        << comment;
  EXPECT_THAT(message_of([&] { alone("# velocity in cm/s\n1\n2\n"); }), HasSubstr("velocity"));
  EXPECT_THAT(error("# units: m/s2\n1\n2\n", {.dt_s = 0.01, .units = AccelerationUnits::g}),
              AllOf(HasSubstr("record:1"), HasSubstr("m/s2")));
}

TEST_F(RecordFile, comments_may_state_step_and_count_which_must_hold) {
  EXPECT_EQ(read("# DT = 0.02\n1\n2\n").dt_s, 0.02);
  EXPECT_EQ(read("# NPTS= 2, DT= .02 SEC\n1\n2\n").dt_s, 0.02);
  for (const char* lines : {"# DT = 0.02\n# NPTS = 2\n", "# NPTS = 2\n# DT = 0.02\n"}) {
    const std::string text = lines + std::string("1\n2\n");
    EXPECT_EQ(read(text).dt_s, 0.02) << lines;
    EXPECT_THAT(error(text, {.dt_s = 0.01, .units = {}}), HasSubstr("0.02")) << lines;
    EXPECT_THAT(error(text + "3\n"), HasSubstr("contains 3")) << lines;
  }
  EXPECT_THAT(error("# NPTS= 3, DT= .02 SEC\n1\n2\n"), HasSubstr("contains 2"));
  EXPECT_THAT(error("# DT = 0.02\n1\n2\n", {.dt_s = 0.01, .units = {}}), HasSubstr("0.02"));
  EXPECT_THAT(error("# DT = 0.02\n0 1\n0.01 2\n0.02 2\n"), HasSubstr("0.02"));
}

/// 0 to 0.019, with six digits.
std::string fine_samples() {
  std::string text;
  for (int i = 0; i < 20; ++i) text += fmt::format("{:.6f}\n", 0.001 * i);
  return text;
}

TEST_F(RecordFile, a_header_that_is_no_comment_is_not_taken_for_samples) {
  EXPECT_THAT(error("0.01\n1\n2\n", {.dt_s = 0.01, .units = {}}), HasSubstr("begins with 0.01"));
  const std::string samples = "1\n2\n3\n2\n1\n0\n-1\n-2\n";
  EXPECT_THAT(error("1\n0.01\n" + samples, {.dt_s = 0.01, .units = AccelerationUnits::g}),
              HasSubstr("begins with 1, a count, and a time step"));
  // The step that is stated elsewhere is another one.
  EXPECT_THAT(error("1\n1e-2\n" + samples, {.dt_s = 0.005, .units = AccelerationUnits::g}),
              HasSubstr("begins with 1, a count, and a time step"));
  EXPECT_THAT(
      error("0.01\n1e-5\n2e-5\n3e-5\n1e-5\n0\n-1e-5\n1e-5\n0\n", {.dt_s = 0.02, .units = {}}),
      HasSubstr("begins with 0.01, a time step"));
  EXPECT_EQ(read("0.01\n0.02\n0.01\n0\n0.01\n0\n0.01\n0.02\n", {.dt_s = 0.02, .units = {}})
                .acceleration_mps2.size(),
            8u);
  // A step before the count, a count that is off, a scale before both; a step in other digits.
  for (const char* header : {"0.01\n3000\n", "2990\n", "2.5\n3000\n0.01\n"})
    EXPECT_THAT(error(header + samples, {.dt_s = 0.005, .units = AccelerationUnits::g}),
                HasSubstr("a count"))
        << header;
  EXPECT_THAT(
      error("29.99\n0.02\n" + fine_samples(), {.dt_s = 0.005, .units = AccelerationUnits::g}),
      HasSubstr("far above"));
  const std::string fine = fine_samples();
  EXPECT_EQ(read(fine, {.dt_s = 0.005, .units = {}}).acceleration_mps2.size(), 20u);
  EXPECT_THAT(error("0.01\n" + fine, {.dt_s = 0.005, .units = {}}), HasSubstr("a time step"));
  EXPECT_THAT(error("0.4\n0.01\n" + fine, {.dt_s = 0.01, .units = AccelerationUnits::g}),
              HasSubstr("a time step"));
  EXPECT_DOUBLE_EQ(read("# DT = 10 ms\n1\n2\n").dt_s, 0.01);
  EXPECT_THAT(error("8\n" + samples, {.dt_s = 0.01, .units = {}}), HasSubstr("begins with 8"));
  EXPECT_THAT(
      error("5\n0.005\n0.1\n0.2\n0.1\n0.1\n0.2\n", {.dt_s = 0.005, .units = AccelerationUnits::g}),
      HasSubstr("begins with 5"));
  EXPECT_THAT(error("2\n0.1\n0.2\n0.1\n-0.3\n0.2\n0.1\n0.2\n0.1\n",
                    {.dt_s = 0.005, .units = AccelerationUnits::g}),
              HasSubstr("begins with 2, a whole number far above"));
  EXPECT_THAT(error("8 0.01\n" + samples, {.dt_s = 0.01, .units = {}}), HasSubstr("1 column"));
}

TEST_F(RecordFile, missing_files_folders_empty_files_and_binary_files_are_reported) {
  EXPECT_THAT(message_of([&] { read_record(folder_.path() / "none"); }), HasSubstr("none"));
  EXPECT_THAT(message_of([&] { read_record(folder_.path()); }), HasSubstr("directory"));
  EXPECT_THAT(error(""), HasSubstr("no samples"));
  EXPECT_THAT(error("# only a comment\n"), HasSubstr("no samples"));
  EXPECT_THAT(error(std::string("1\n\0\n2", 5)), HasSubstr("not a text file"));
  EXPECT_THAT(error("Origin Time 2011/03/11\n"),
              AllOf(HasSubstr("record:1"), HasSubstr("'Origin' is not a number")));
}

TEST_F(RecordFile, garbage_is_refused_and_never_crashes) {
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    std::string text = trial % 3 == 0 ? at2_head + "NPTS= 7, DT= .01\n" : "";
    const std::string alphabet =
        trial % 2 == 0 ? "0123456789.-+eE \n,#" : "NPTSDT=,.0123 \n\tnaif(g)/\x80\xff";
    for (std::uint32_t i = 0; i < 200; ++i) {
      const double u = keyed_uniform(1, RandomPurpose::test, trial, i);
      text += alphabet[static_cast<std::size_t>(u * static_cast<double>(alphabet.size()))];
    }
    try {
      const Record record = read(text, {.dt_s = 0.01, .units = {}});
      EXPECT_FALSE(record.acceleration_mps2.empty());
      EXPECT_GT(record.dt_s, 0.0);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("record"));
    }
  }
  EXPECT_THAT(error(std::string(5000000, '7')), HasSubstr("not a number"));  // one overlong line
  EXPECT_THAT(error("units of " + std::string(1000000, ' ') + "NPTS"), HasSubstr("record:1"));
}

TEST(acceleration_units, are_parsed_and_printed) {
  EXPECT_EQ(parse_acceleration_units("gal"), AccelerationUnits::cmps2);
  for (const auto units :
       {AccelerationUnits::g, AccelerationUnits::mps2, AccelerationUnits::cmps2}) {
    EXPECT_EQ(parse_acceleration_units(to_string(units)), units);
  }
  EXPECT_THAT(message_of([] { parse_acceleration_units("ft/s2"); }), HasSubstr("ft/s2"));
}

}  // namespace
}  // namespace glissade
