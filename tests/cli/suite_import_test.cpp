// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/json_of.hpp"
#include "cli/shaking.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

using testing::HasSubstr;

/// A folder with a record of two horizontals, one of one, and a file that is none.
class SuiteImportCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("in/PLC-000.txt", two_columns(shaking_g(0.1)));
    folder_.write("in/PLC-090.txt", two_columns(shaking_g(0.7)));
    folder_.write("in/ONE-090.txt", two_columns(shaking_g(1.3)));
    folder_.write("in/notes.md", "Some notes.\n");
  }
  Finished import(const std::vector<std::string>& arguments) const {
    return run_program(with(
        {"suite", "import", "--directions-from-names", folder_.path("in").string()}, arguments));
  }
  ScratchFolder folder_;
};

TEST_F(SuiteImportCommand, makes_a_suite_that_other_commands_read_and_lists_what_is_left_out) {
  const std::string out = folder_.path("mine.toml").string();
  const Finished child = import({"--out", out});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out,
              states("Imported records", "PLC", "000, 090", "ONE-090.txt: one horizontal",
                     "notes.md", "suggest: 000, 090", "suite file"));
  EXPECT_THAT(read_file(out),
              states("name = \"mine\"", "file = \"in/PLC-000.txt\", azimuth_deg = 0, sha256 = \""));
  const Finished show = succeeding({"suite", "show", out});
  EXPECT_THAT(show.out, HasSubstr("PLC"));
  expect_refused(import({"--out", out}), {"mine.toml", "--out"});
}

TEST_F(SuiteImportCommand, json_has_each_component_and_each_reason) {
  const Json result = json_of({"suite", "import", folder_.path("in").string()},
                              {"--keep-single", "--directions-from-names"});
  ASSERT_EQ(result["records"].size(), 2u);
  EXPECT_EQ(result["records"][0]["id"], "ONE");
  EXPECT_FALSE(result["records"][0].contains("second"));
  EXPECT_EQ(result["records"][1]["first"]["samples"], 400);
  EXPECT_EQ(result["records"][1]["magnitude"], nullptr);
  ASSERT_EQ(result["left_out"].size(), 1u);
  EXPECT_THAT(result["left_out"][0]["what"].get<std::string>(), HasSubstr("notes.md"));
}

TEST_F(SuiteImportCommand, show_lists_the_components_of_a_folder_and_of_a_file) {
  const std::string csv = folder_.path("table.csv").string();
  const Finished folder = succeeding({"suite", "show", folder_.path("in").string(), "--out", csv});
  EXPECT_THAT(folder.out, states("PLC-000.txt", "ONE-090.txt", "notes.md", "suite import"));
  EXPECT_THAT(read_file(csv), HasSubstr("file,component,format,unit,dt_s,samples,pga_g,processed"));
  const Finished file = succeeding({"suite", "show", folder_.path("in/PLC-090.txt").string()});
  EXPECT_THAT(file.out, states("PLC-090.txt", "090", "400"));
  expect_refused(run_program({"suite", "show", folder_.path("in/notes.md").string()}),
                 {"notes.md", "is not a number"});
}

TEST_F(SuiteImportCommand, mistakes_are_refused) {
  expect_refused(run_program({"suite", "import", folder_.path("none").string()}),
                 {"none", "No such"});
  expect_refused(run_program({"suite", "import", folder_.path("in/notes.md").string()}),
                 {"no record", "notes.md"});
  // Each file, also when nothing is imported.
  expect_refused(run_program({"suite", "import", folder_.path("in").string()}),
                 {"no record", "notes.md", "ONE-090.txt: nothing states", "PLC-000.txt: nothing",
                  "PLC-090.txt: nothing states", "its name suggests 090: --directions-from-names"});
  expect_refused(import({"--roof", "roof"}), {"--roof", "no file states a location"});
  expect_refused(import({"--units", "furlong"}), {"--units", "furlong", "m/s2"});
  expect_refused(import({"--dt-s", "-1"}), {"--dt-s", "not above 0"});
  expect_refused(import({"--report", folder_.path("in/notes.md").string()}),
                 {"notes.md", "Record Sequence Number"});
  expect_refused(run_program({"suite", "import"}), {"files", "required"});
}

}  // namespace
}  // namespace glissade::test
