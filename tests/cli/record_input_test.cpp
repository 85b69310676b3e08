// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/json_of.hpp"
#include "sanitized.hpp"

namespace glissade::test {
namespace {

using testing::HasSubstr;

class RecordInput : public testing::Test {
 protected:
  /// `slide` on a file of this text must be refused, and leave no history behind.
  void expect_text_refused(const std::string& name, const std::string& text,
                           const std::vector<std::string>& parts,
                           std::vector<std::string> options = {}) const {
    SCOPED_TRACE(text);
    const std::string file = folder_.write(name, text);
    options.insert(options.begin(), {"slide", file, "--mu", "0.1", "--slope-deg", "2", "--json",
                                     "--history", folder_.path("history.csv").string()});
    expect_refused(run_program(options), parts);
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{name});
    std::filesystem::remove(file);
  }

  ScratchFolder folder_;
};

TEST_F(RecordInput, a_missing_file_is_named) {
  const std::string file = folder_.path("none.AT2").string();
  expect_refused(run_program({"slide", file, "--mu", "0.5", "--slope-deg", "1"}),
                 {file, "No such file"});
}

TEST_F(RecordInput, a_count_before_the_samples_is_not_taken_for_one) {
  const std::string samples = "0.1\n0.2\n0.3\n0.2\n0.1\n0\n-0.1\n-0.2\n";
  for (const char* header : {"8\n", "8\n0.01\n"})
    expect_text_refused("record.txt", header + samples, {"record.txt", "begins with 8"},
                        {"--dt-s", "0.01", "--units", "m/s2"});
}

TEST_F(RecordInput, a_folder_is_not_a_record) {
  expect_refused(
      run_program({"slide", folder_.path("").string(), "--mu", "0.5", "--slope-deg", "1"}),
      {"cannot be read", "directory"});
}

TEST_F(RecordInput, that_is_wrong_is_reported_by_its_line_and_the_options) {
  expect_text_refused("nan.txt", "# acceleration_g\n0.00 0.1\n0.01 nan\n0.02 0.1\n",
                      {"nan.txt:3", "nan", "not finite"});
  expect_text_refused("zero.AT2",
                      "ACCELERATION IN UNITS OF G\nNPTS= 5, DT= 0.0000 SEC,\n0.1 0.2 0.3 0.2 0.1\n",
                      {"zero.AT2:2", "dt", "0.0000", "--dt-s"});
  expect_text_refused("column.txt", "0.1\n0.2\n", {"--dt-s", "-0.01", "> 0"}, {"--dt-s", "-0.01"});
  expect_text_refused("column.txt", "# acceleration_g\n0.1\n0.2\n",
                      {"column.txt", "time step", "--dt-s"});
  expect_text_refused("column.txt", "12.0\n-355.0\n100\n", {"column.txt", "--units"},
                      {"--dt-s", "0.01"});
  expect_text_refused("column.txt", "0.1\n0.2\n", {"furlong", "m/s2"},
                      {"--dt-s", "0.01", "--units", "furlong"});
  expect_text_refused("column.txt", "0.1\n0.2\n", {"column.txt", "--units", "--dt-s"});
  expect_text_refused("step.txt", "dt=0.005\nacc: m/s2\n0.1\n0.2\n",
                      {"step.txt:1", "0.005", "--dt-s"}, {"--dt-s", "0.01"});
  expect_text_refused("up.csv", "time (s),U-D (m/s2)\n0,1\n0.01,2\n",
                      {"up.csv", "'UP'", "a vertical component, given as a horizontal one"});
  expect_text_refused("sa.csv", "period_s,sa_g\n0,0.1\n0.05,0.2\n0.1,0.1\n",
                      {"sa.csv:2", "'period_s'", "spectrum"});
  expect_text_refused("still.txt", "0\n0\n", {"still.txt", "--pga-g"},
                      {"--dt-s", "0.01", "--pga-g", "1", "--units", "g"});
  expect_text_refused("binary.sac", std::string("\0\1\2\3", 4), {"binary.sac", "not a text file"});
}

TEST_F(RecordInput, values_outside_what_was_recorded_have_a_warning_beside_the_result) {
  std::string text = "# acceleration_g\n";  // 2 s
  for (int i = 0; i < 200; ++i) text += i % 20 < 10 ? "8\n" : "-8\n";
  const std::vector<std::string> command{
      "slide", folder_.write("gal.txt", text), "--dt-s", "0.01", "--mu", "0.1", "--slope-deg", "2"};
  EXPECT_THAT(run_program(command).out, HasSubstr("WARNING: PGA of 8 g"));
  const Json json = json_of(command);
  EXPECT_EQ(json["warnings"].size(), 2u);  // PGA and PGV
  EXPECT_NEAR(json["as_recorded"][0]["pga_g"].get<double>(), 8.0, 1e-9);
  EXPECT_NEAR(json["as_recorded"][0]["duration_s"].get<double>(), 1.8, 0.01);
}

TEST_F(RecordInput, a_component_that_ends_early_has_its_own_count_and_a_warning) {
  const auto record = [&](const std::string& name, int samples) {
    std::string text = "# acceleration_g\n# DT = 0.01\n";
    for (int i = 0; i < samples; ++i) text += i % 20 < 10 ? ".2\n" : "-.2\n";
    return folder_.write(name, text);
  };
  const std::vector<std::string> command{
      "slide", record("a.txt", 300), "--second", record("b.txt", 150), "--mu",
      "0.1",   "--slope-deg",        "1"};
  const Finished text = run_program(command);
  EXPECT_THAT(text.out, HasSubstr("300 samples"));
  EXPECT_THAT(text.out, HasSubstr("150 samples"));
  EXPECT_THAT(text.out, HasSubstr("WARNING: its second component ends at 1.5 s"));
  EXPECT_THAT(text.out, HasSubstr("note  components of different steps or lengths"));
  const Json json = json_of(command);
  EXPECT_EQ(json["samples"], 300);
  EXPECT_EQ(json["as_recorded"][1]["samples"], 150);
  EXPECT_EQ(json["warnings"].size(), 1u);
  EXPECT_EQ(json["notes"].size(), 1u);
}

TEST_F(RecordInput, a_component_of_a_file_is_named_behind_it) {
  const std::string file =
      folder_.write("floor.csv", "time_s,ax_g,ay_g\n0,.1,.2\n0.01,.4,-.5\n0.02,0,0\n");
  const auto slide = [&](const std::string& component) {
    return std::vector<std::string>{"slide", file + component, "--mu", "0.1", "--slope-deg", "2"};
  };
  EXPECT_NEAR(json_of(slide("#ay"))["pga_g"].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(json_of(slide("#1"))["pga_g"].get<double>(), 0.4, 1e-12);
  expect_refused(run_program(slide("")), {"floor.csv", "#1 (ax)", "#2 (ay)"});
  expect_refused(run_program(slide("#az")), {"'az'", "#2 (ay)"});
}

// What is held is bounded by the samples that a record may have, and not by what a file makes of
// its bytes: a list of its cells, a tree of its elements, each a byte or two.
TEST_F(RecordInput, that_is_large_and_no_record_is_refused_in_little_memory) {
  if (slowdown > 1) GTEST_SKIP() << "the sanitizers need address space";
  constexpr std::size_t file_bytes = std::size_t{32} << 20;
  struct Large {
    const char* name;
    std::string begin, repeated, reason;
  };
  for (const Large& large :
       {Large{"commas.csv", "", ",", "number"}, Large{"comments.txt", "", "#\n", "lines"},
        Large{"touching.txt", "# units: g\n", "1.5", "number"},
        Large{"latin1.txt", "", "\xe9", "UTF-8"}, Large{"utf16.txt", "\xff\xfe", "B0", "UTF-8"},
        Large{"elements.xml", "<FDSNStationXML>", "<Channel/>", "million"},
        Large{"attributes.xml", "<FDSNStationXML", " a=\"\"", "million"}}) {
    std::string text = large.begin;
    while (text.size() < file_bytes) text += large.repeated;
    const std::string file = folder_.write(large.name, text);
    expect_refused(
        run_shell("ulimit -v 350000; \"$0\" suite import '" + file + "' --units g --dt-s 0.01"),
        {large.name, large.reason});
    std::filesystem::remove(file);
  }
}

TEST_F(RecordInput, counts_need_units_and_a_gain) {
  const std::string file = GLISSADE_SOURCE_DIR "/tests/fuzz/corpus/record/miniseed.mseed";
  expect_refused(run_program({"slide", file, "--mu", "0.1", "--slope-deg", "2"}),
                 {"miniseed.mseed"});
  expect_refused(run_program({"slide", file, "--mu", "0.1", "--slope-deg", "2", "--units", "g",
                              "--counts-per-unit", "0"}),
                 {"--counts-per-unit", "> 0"});
}

TEST_F(RecordInput, a_vertical_with_another_step_is_reported) {
  const std::string horizontal = folder_.write("h.txt", "0.00 0.1\n0.01 0.1\n0.02 0.1\n");
  const std::string vertical = folder_.write("v.txt", "0.000 0.1\n0.007 0.1\n0.014 0.1\n");
  expect_refused(run_program({"slide", horizontal, "--vertical", vertical, "--mu", "0.1",
                              "--slope-deg", "1", "--units", "g"}),
                 {"0.007", "0.01"});
}

}  // namespace
}  // namespace glissade::test
