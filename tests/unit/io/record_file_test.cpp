// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/record_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

constexpr double g = standard_gravity_mps2;

class RecordFile : public testing::Test {
 protected:
  /// In g where neither the file nor the options state the units.
  Record read(const std::string& content, RecordFileOptions options = {}) const {
    options.units_if_not_stated = AccelerationUnits::g;
    return read_record(folder_.write("record", content), options);
  }
  void refuses(const std::vector<Refusal>& refusals, const RecordFileOptions& options = {}) const {
    expect_refusals([&](const std::string& content) { read(content, options); }, refusals);
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
  const std::string rest = "NPTS= 1, DT= .01 SEC\n50\n";
  EXPECT_DOUBLE_EQ(read("ACCELERATION IN UNITS OF CM/S/S\n" + rest).acceleration_mps2[0], 0.5);
  EXPECT_DOUBLE_EQ(read("ACCELERATION IN UNITS OF M/SEC**2\n" + rest).acceleration_mps2[0], 50.0);
  refuses({{"VELOCITY TIME SERIES IN UNITS OF CM/S\n" + rest, "record:1", {"velocity"}},
           {"DISPLACEMENT TIME SERIES IN UNITS OF CM\n" + rest, "record:1", {"displacement"}},
           {"ACCELERATION TIME SERIES IN UNITS OF FURLONGS\n" + rest, "record:1", {"'furlongs'"}}});
  refuses({{at2_head + rest, "record:3", {"m/s2"}}},
          {.dt_s = {}, .units = AccelerationUnits::mps2});
}

// Of slide as of suites: 4264 m/s2.
TEST_F(RecordFile, more_than_any_ground_has_shaken_with_is_refused) {
  refuses({{"ACCELERATION IN UNITS OF M/SEC**2\nNPTS= 2, DT= .01 SEC\n0.5 4264\n",
            "record",
            {"435 g", "units"}}});
}

TEST_F(RecordFile, npts_that_differs_from_the_values_reports_both_counts) {
  refuses({{at2_head + "NPTS= 4, DT= .01 SEC\n1 2 3\n", "record:4", {"4", "3"}},
           {at2_head + "NPTS= 2, DT= .01 SEC\n1 2 3\n", "record:4", {"2", "3", "one off"}},
           {at2_head + "NPTS= 5, DT= .01 SEC\n1 2 3\n", "record:4", {"5", "3", "cut short"}},
           {at2_head + "NPTS= 99999999999999999999999, DT= .01 SEC\n1\n", "record:4", {"NPTS"}},
           {at2_head + "NPTS= 0, DT= .01 SEC\n", "record", {"no samples"}}});
}

TEST_F(RecordFile, samples_that_are_no_finite_numbers_are_reported_with_their_line) {
  const std::string header = at2_head + "NPTS= 3, DT= .01 SEC\n";
  refuses({{header + "1 2\nNaN\n", "record:6", {"'NaN'"}},
           {header + "1 2\n1e999\n", "record:6", {"'1e999'"}},
           {header + "1 -inf 3\n", "record:5", {"'-inf'"}},
           {header + "1 two 3\n", "record:5", {"'two'"}},
           {"0 1\n0.01 *******\n", "record:2", {"'*******'"}}});  // as Fortran overflows
}

TEST_F(RecordFile, samples_beyond_any_ground_motion_are_reported_with_their_line) {
  refuses({{at2_head + "NPTS= 2, DT= .01 SEC\n1\n1e308\n", "record:6", {"'1e308'", "100,000 g"}},
           {"0 1\n0.01 -1.1e5\n", "record:2", {"'-1.1e5'", "100,000 g"}}});
}

TEST_F(RecordFile, steps_that_are_not_above_zero_or_missing_are_refused) {
  refuses({{at2_head + "NPTS= 1, DT= 0.0 SEC\n1\n", "record:4", {"dt = 0.0 s"}},
           {at2_head + "NPTS= 1, DT= -.01 SEC\n1\n", "record:4", {"dt = -.01 s"}},
           {at2_head + "NPTS= 1\n1\n", "record:4", {"DT", "dt_s"}},
           {"1\n2\n", "record", {"dt_s"}}});
  refuses({{"1\n2\n", "record", {"dt = -1 s"}}}, {.dt_s = -1.0, .units = {}});
  for (const char* columns : {"1\n2\n", "0 1\n", "0 1\n0.01 2\n"})
    refuses({{std::string("# DT = 0 s\n") + columns, "record:1", {"dt = 0 s"}}});
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
  std::string lost;  // a sample of many, where the times have as few decimals as the step
  for (int i = 0; i < 1000; ++i)
    lost += std::to_string((i < 500 ? i : i + 1) / 100) + "." +
            std::to_string(100 + (i < 500 ? i : i + 1) % 100).substr(1) + " 0.1\n";
  refuses({{"0 1\n0.01 2\n0.03 3\n0.04 3\n", "record:3", {"0.01", "0.03"}},
           {lost, "record:501", {"4.99", "5.01"}},
           {"0 1\n0.01 2\n0.00 3\n0.03 1\n", "record:3", {"0.01", "0"}},
           {"0 1\n0 2\n", "record:2", {"from 0 to 0", "no time"}}});
  refuses({{"0 1\n0.01 2\n0.02 3\n", "record", {"0.01", "0.02"}}}, {.dt_s = 0.02, .units = {}});
}

TEST_F(RecordFile, columns_beyond_two_or_of_changing_number_are_refused) {
  refuses({{"0 1 2\n", "record:1", {"3"}},
           {"0 1\n0.01\n", "record:2", {"1", "2"}},
           {"0,1\n0.01,\n", "record:2", {"''"}}});
}

TEST_F(RecordFile, units_that_are_not_stated_are_not_guessed) {
  const auto alone = [&](const std::string& text) {
    return read_record(folder_.write("record", text), {.dt_s = 0.01, .units = {}});
  };
  expect_refusals(alone, {{"0 741\n0.01 2\n", "record", {"units"}},
                          {"1\n2\n", "record", {"units"}},
                          {"EVENT\nNPTS= 2, DT= .01 SEC\n1 2\n", "record", {"units"}},
                          {"# velocity in cm/s\n1\n2\n", "record:1", {"velocity"}}});
  for (const char* comment :
       {"# units: cm/s2", "# acceleration in gal", "# time_s acceleration_gal",
        "# Time (s), Acceleration (cm/s2)", "#t, acceleration [cm/s/s] in gal"})
    EXPECT_DOUBLE_EQ(alone(comment + std::string("\n0 741\n0.01 2\n")).acceleration_mps2[0], 7.41)
        << comment;
  refuses({{"# units: m/s2\n1\n2\n", "record:1", {"m/s2"}}},
          {.dt_s = 0.01, .units = AccelerationUnits::g});
}

TEST_F(RecordFile, comments_may_state_step_and_count_which_must_hold) {
  EXPECT_EQ(read("# DT = 0.02\n1\n2\n").dt_s, 0.02);
  EXPECT_EQ(read("# NPTS= 2, DT= .02 SEC\n1\n2\n").dt_s, 0.02);
  for (const char* lines : {"# DT = 0.02\n# NPTS = 2\n", "# NPTS = 2\n# DT = 0.02\n"}) {
    const std::string text = lines + std::string("1\n2\n");
    EXPECT_EQ(read(text).dt_s, 0.02) << lines;
    refuses({{text, text.starts_with("# DT") ? "record:1" : "record:2", {"0.02"}}},
            {.dt_s = 0.01, .units = {}});
    refuses({{text + "3\n", text.starts_with("# DT") ? "record:2" : "record:1", {"2", "3"}}});
  }
  refuses({{"# NPTS= 3, DT= .02 SEC\n1\n2\n", "record:1", {"3", "2"}},
           {"# DT = 0.02\n0 1\n0.01 2\n0.02 2\n", "record", {"0.01", "0.02"}}});
  refuses({{"# DT = 0.02\n1\n2\n", "record:1", {"0.02", "0.01"}}}, {.dt_s = 0.01, .units = {}});
}

/// 0 to 0.019, with six digits.
std::string fine_samples() {
  std::string text;
  for (int i = 0; i < 20; ++i) text += fmt::format("{:.6f}\n", 0.001 * i);
  return text;
}

TEST_F(RecordFile, a_header_that_is_no_comment_is_not_taken_for_samples) {
  const std::string samples = "1\n2\n3\n2\n1\n0\n-1\n-2\n", fine = fine_samples();
  const RecordFileOptions stated{.dt_s = 0.01, .units = {}};
  refuses({{"0.01\n1\n2\n", "record", {"0.01"}},
           {"1\n0.01\n" + samples, "record", {"1", "count", "step"}},
           {"0.4\n0.01\n" + fine, "record", {"step"}},
           {"8\n" + samples, "record", {"8"}},
           {"8 0.01\n" + samples, "record:2", {"1", "2"}}},
          stated);
  // The step that is stated elsewhere is another one; a step before the count, a count that is off,
  // a scale before both; a step in other digits.
  refuses({{"1\n1e-2\n" + samples, "record", {"1", "count", "step"}},
           {"0.01\n3000\n" + samples, "record", {"count"}},
           {"2990\n" + samples, "record", {"count"}},
           {"2.5\n3000\n0.01\n" + samples, "record", {"count"}},
           {"29.99\n0.02\n" + fine, "record", {"29.99"}},
           {"0.01\n" + fine, "record", {"step"}},
           {"5\n0.005\n0.1\n0.2\n0.1\n0.1\n0.2\n", "record", {"5"}},
           {"2\n0.1\n0.2\n0.1\n-0.3\n0.2\n0.1\n0.2\n0.1\n", "record", {"2"}}},
          {.dt_s = 0.005, .units = {}});
  refuses({{"0.01\n1e-5\n2e-5\n3e-5\n1e-5\n0\n-1e-5\n1e-5\n0\n", "record", {"0.01", "step"}}},
          {.dt_s = 0.02, .units = {}});
  EXPECT_EQ(read("0.01\n0.02\n0.01\n0\n0.01\n0\n0.01\n0.02\n", {.dt_s = 0.02, .units = {}})
                .acceleration_mps2.size(),
            8u);
  EXPECT_EQ(read(fine, {.dt_s = 0.005, .units = {}}).acceleration_mps2.size(), 20u);
  EXPECT_DOUBLE_EQ(read("# DT = 10 ms\n1\n2\n").dt_s, 0.01);
}

TEST_F(RecordFile, missing_files_folders_empty_files_and_binary_files_are_reported) {
  expect_refusals([&](const std::string& name) { read_record(folder_.path() / name); },
                  {{"none", "none", {}}, {".", ".", {"directory"}}});
  refuses({{"", "record", {"no samples"}},
           {"# only a comment\n", "record", {"no samples"}},
           {std::string("1\n\0\n2", 5), "record", {"text"}},
           {"Origin Time 2011/03/11\n", "record:1", {"'Origin'"}}});
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
      EXPECT_THAT(error.problems()[0].where, testing::ContainsRegex("record(:[0-9]+)?$"));
    }
  }
  refuses({{std::string(5000000, '7'), "record:1", {}},  // one overlong line
           {"units of " + std::string(1000000, ' ') + "NPTS", "record:1", {}}});
}

TEST(acceleration_units, are_parsed_and_printed) {
  EXPECT_EQ(parse_acceleration_units("gal"), AccelerationUnits::cmps2);
  for (const auto units :
       {AccelerationUnits::g, AccelerationUnits::mps2, AccelerationUnits::cmps2}) {
    EXPECT_EQ(parse_acceleration_units(to_string(units)), units);
  }
  expect_refusals(parse_acceleration_units, {{"ft/s2", "", {"'ft/s2'"}}});
}

}  // namespace
}  // namespace glissade
