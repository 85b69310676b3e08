// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "cli/shaking.hpp"
#include "cli/table_rows.hpp"

namespace glissade::test {
namespace {

const std::string level0 = GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml";

TEST(Suite, show_lists_every_motion_with_its_components) {
  const Finished child = succeeding({"suite", "show", level0});
  EXPECT_EQ(child.err, "");
  for (int i = 1; i <= 7; ++i)
    EXPECT_THAT(child.out, testing::HasSubstr("level0_" + std::to_string(i)));
  // Walters's Level 0: S_s 0.45, S_1 0.18; site class D, F_a = 1.44: S_DS = 2/3 1.44 0.45.
  EXPECT_THAT(child.out, testing::HasSubstr("S_DS 0.432 g"));
  EXPECT_THAT(child.out, testing::HasSubstr("Intensity Level 0"));
}

TEST(Suite, spectra_are_a_table_whose_average_stays_above_the_target_to_2_s) {
  const ScratchFolder folder;
  const std::string file = folder.path("spectra.csv").string();
  succeeding({"suite", "spectra", level0, "--out", file});
  const std::string text = read_file(file);
  EXPECT_EQ(run_program({"suite", "spectra", level0}).out, text);  // the same without --out
  EXPECT_THAT(text, testing::StartsWith("period_s,"));
  const std::vector<Row> rows = rows_of(text);
  ASSERT_GT(rows.size(), 48u);
  for (const Row& row : rows) {
    if (number(row, "period_s") > 2.0) continue;
    // The suite's factors were found at Walters's periods and are kept to four decimals: between,
    // the average may dip a little.
    EXPECT_GT(number(row, "average_srss_g"), 0.97 * number(row, "target_mce_g"))
        << row.at("period_s");
  }
}

TEST(Suite, scale_finds_the_factors_the_built_in_suite_was_made_with) {
  const Finished child = succeeding({"suite", "scale", level0});
  std::vector<std::string> lines = lines_of(child.out);
  const auto header = std::find(lines.begin(), lines.end(), "id,scale");
  ASSERT_EQ(lines.end() - header, 8);
  const std::string suite = read_file(level0);
  for (auto line = header + 1; line != lines.end(); ++line) {
    const std::vector<std::string> cells = cells_of(*line);
    const std::size_t motion = suite.find("id = \"" + cells[0] + "\"");
    ASSERT_NE(motion, std::string::npos);
    const double kept = std::stod(suite.substr(suite.find("scale = ", motion) + 8));
    EXPECT_NEAR(std::stod(cells[1]), kept, 5e-4) << cells[0];
  }
}

TEST(Suite, dbe_factors_are_two_thirds_of_mce_factors) {
  const std::vector<std::string> mce =
      lines_of(run_program({"suite", "scale", level0, "--target", "mce"}).out);
  const std::vector<std::string> dbe =
      lines_of(run_program({"suite", "scale", level0, "--target", "dbe"}).out);
  ASSERT_EQ(mce.size(), dbe.size());
  ASSERT_FALSE(mce.empty());
  EXPECT_NEAR(std::stod(cells_of(dbe.back())[1]), std::stod(cells_of(mce.back())[1]) * 2 / 3, 1e-4);
}

TEST(Suite, scale_names_the_clause_of_its_rule_and_warns_of_too_few_records) {
  const Finished srss = succeeding({"suite", "scale", level0, "--rule", "asce7_10", "--period-s",
                                    "0.5", "--target", "dbe", "--max-factor", "20"});
  EXPECT_THAT(srss.out, states("level0_7,"));
  EXPECT_THAT(srss.err,
              states("ASCE 7-10, 16.1.3.2", "dbe target", "0.1 to 0.75 s", "lowest 1 at"));
  EXPECT_THAT(srss.err, testing::Not(testing::HasSubstr("WARNING")));
  const Finished rotated = succeeding({"suite", "scale", level0, "--rule", "asce7_22", "--period-s",
                                       "0.6", "0.5", "--to-1.5t", "--max-factor", "20"});
  EXPECT_THAT(rotated.err, states("ASCE 7-22, 16.2.3.1", "RotD100", "0.1 to 0.9 s",
                                  "WARNING: 7 motions", "16.2.2", "11 at least"));
  const auto refused = [](std::vector<std::string> more, const std::vector<std::string>& facts) {
    more.insert(more.begin(), {"suite", "scale", level0});
    expect_refused(run_program(more), facts);
  };
  refused({"--rule", "asce7_05"}, {"--rule", "asce7_05", "asce7_16"});
  refused({"--rule", "asce7_16"}, {"--period-s", "missing"});
  refused({"--rule", "asce7_10", "--period-s", "0.5", "--to-1.5t"}, {"--to-1.5t", "not mixed"});
  refused({"--period-s", "0.5"}, {"--period-s", "Walters"});
  refused({"--rule", "asce7_10", "--period-s", "-1"}, {"--period-s", "above 0"});
}

TEST(Suite, scale_writes_a_suite_with_the_factors_of_its_rule) {
  const ScratchFolder folder;
  std::string text =
      "[suite]\nname = \"s\"\n[target]\nedition = \"asce7_16\"\nss_g = 1\ns1_g = 0.4\n"
      "site_class = \"C\"\n";
  for (const char* id : {"a", "b", "c"}) {
    for (const char* axis : {"1", "2"})
      folder.write(std::string("in/") + id + axis + ".txt",
                   two_columns(shaking_g(id[0] + 0.3 * axis[0])));
    text += std::string("[[record]]\nid = \"") + id + "\"\nmagnitude = 7\nfirst = \"" + id +
            "1.txt\"\nsecond = \"" + id + "2.txt\"\n";
  }
  const std::string suite = folder.write("in/suite.toml", text);
  const std::string out = folder.path("scaled.toml").string();
  const std::vector<std::string> arguments{"suite",    "scale",      suite, "--rule",
                                           "asce7_16", "--period-s", "0.6", "--max-factor",
                                           "100",      "--out",      out};
  const Finished child = succeeding(arguments);
  const std::string written = read_file(out);
  EXPECT_THAT(written, states("# one factor", "ASCE 7-16, 16.2.3.1", "WARNING: 3 motions",
                              "edition = \"asce7_16\"", "magnitude = 7", "in/a1.txt"));
  const std::vector<std::string> lines = lines_of(child.out);
  const double factor = std::stod(cells_of(lines.back())[1]);
  EXPECT_NEAR(std::stod(written.substr(written.rfind("scale = ") + 8)), factor, 1e-4);
  EXPECT_EQ(run_program({"suite", "show", out}).status, 0);
  expect_refused(run_program(arguments), {"scaled.toml", "--out"});
  expect_refused(run_program({"suite", "scale", suite, "--target", "dbe", "--out", out + "2"}),
                 {"--out", "MCE", "mce_fraction"});
}

TEST(Suite, mistakes_are_refused) {
  const ScratchFolder folder;
  expect_refused(run_program({"suite", "show", folder.path("none.toml").string()}),
                 {"none.toml", "No such file"});
  expect_refused(run_program({"suite", "scale", level0, "--target", "mean"}),
                 {"--target", "mean", "mce", "dbe"});
  expect_refused(run_program({"suite", "design", "--level", "9"}), {"9"});
  expect_refused(run_program({"suite"}), {"--help"});
}

TEST(Suite, design_does_not_begin_where_its_file_is_there) {
  const ScratchFolder folder;
  const std::string file = folder.write("suite.toml", "mine");
  expect_refused(
      run_program({"suite", "design", "--level", "2", "--out", folder.path("").string()}),
      {"is a folder"});
  expect_refused(run_program({"suite", "design", "--level", "2", "--out", file}),
                 {"--out", "is there already"});
  EXPECT_EQ(read_file(file), "mine");
}

TEST(Suite, names_do_not_act_on_the_terminal) {
  const ScratchFolder folder;
  const std::string name = "a\x1b[31m\xe2\x80\xae.txt";
  folder.write(name, "# acceleration_g\n0 .1\n0.01 .2\n");
  const std::string suite =
      folder.write("\x1b[2J.toml", "[suite]\nname = \"s\"\n[[record]]\nid = \"a\"\nfirst = \"" +
                                       std::string("none") + "\"\n");
  const Finished missing = run_program({"suite", "show", suite});
  expect_refused(missing, {"\\u001b[2J.toml"});
  const Finished slide =
      run_program({"slide", folder.path(name).string(), "--mu", "0.1", "--slope-deg", "1"});
  EXPECT_NE(slide.out.find("a\\u001b[31m\\u202e.txt"), slide.out.npos);
  const Finished id = run_program(
      {"suite", "show",
       folder.write("b.toml", "[suite]\nname = \"s\"\n[[record]]\nid = \"a\\u202e\"\n")});
  expect_refused(id, {"record.id", "\\u202e", "control character"});
  for (const std::string& text : {missing.err, slide.out, id.err}) {
    EXPECT_EQ(text.find('\x1b'), text.npos);
    EXPECT_EQ(text.find("\xe2\x80\xae"), text.npos);
  }
}

TEST(Suite, records_that_cannot_be_found_are_all_reported) {
  const ScratchFolder folder;
  const std::string suite =
      folder.write("suite.toml",
                   "[suite]\nname = \"s\"\n[[record]]\nid = \"a\"\nfirst = "
                   "\"here_not.AT2\"\nsecond = \"there_neither.AT2\"\n"
                   "[[record]]\nid = \"b\"\nfirst = \"nowhere.AT2\"\nmagnitud = 7\n");
  expect_refused(
      run_program({"suite", "show", suite}),
      {"suite.toml", "here_not.AT2", "there_neither.AT2", "nowhere.AT2", folder.path("").string(),
       "GLISSADE_RECORDS", "suite.toml:10", "did you mean magnitude?"});
}

}  // namespace
}  // namespace glissade::test
