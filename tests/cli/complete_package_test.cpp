// SPDX-License-Identifier: GPL-3.0-or-later
// A calculation package whose premises are all met, and the same without one.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/one_package.hpp"
#include "cli/shaking.hpp"
#include "complete_project.hpp"
#include "facts.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/suite_file.hpp"

namespace glissade::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The built-in motions in files, as if they were recorded.
void write_recorded(const ScratchFolder& folder) {
  const Suite suite = load_suite(GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml");
  std::string text = "[suite]\nname = \"recorded\"\n";
  for (const Motion& motion : suite.motions) {
    std::string table = "Time (s),U1 (g),U2 (g),U3 (g)\n";
    const auto in_g = [&](const Samples& a, std::size_t i) {
      return exact(motion.scale * a[i] / standard_gravity_mps2);
    };
    for (std::size_t i = 0; i < motion.vertical_mps2.size(); ++i)
      table += exact(motion.dt_s * static_cast<double>(i)) + "," +
               in_g(motion.horizontal_mps2[0], i) + "," + in_g(motion.horizontal_mps2[1], i) + "," +
               in_g(motion.vertical_mps2, i) + "\n";
    folder.write(motion.id + ".csv", table);
    text += "[[record]]\nid = \"" + motion.id + "\"\n";
    for (const auto& [key, column] :
         {std::pair{"first", "U1"}, {"second", "U2"}, {"vertical", "U3"}})
      text += std::string(key) + " = \"" + motion.id + ".csv#" + column + "\"\n";
  }
  folder.write("recorded.toml", text);
}

TEST(CompletePackage, is_sufficient_and_without_a_premise_open) {
  const ScratchFolder folder;
  write_recorded(folder);
  const WithoutWeasyprint path;
  const auto package_of = [&](const std::string& name, const std::string& text) {
    succeeding(
        {"clearance", folder.write(name + ".toml", text), "--out", folder.path(name).string()});
    return nlohmann::json::parse(read_file(folder.path(name) / "package.json"));
  };
  const auto whole = package_of("whole", complete_project);
  EXPECT_EQ(whole.at("verdict"), "sufficient") << whole.at("warnings").dump(1);
  EXPECT_GT(whole.at("premises").size(), 10u);
  for (const auto& premise : whole.at("premises")) EXPECT_TRUE(premise.at("is_met")) << premise;
  const std::string page = read_file(folder.path("whole") / "package.html");
  EXPECT_THAT(page, states("The available separations are sufficient", "Roof of x_1, complete"));
  EXPECT_THAT(page, Not(HasSubstr("OPEN")));

  const auto open = package_of("open", replaced(complete_project, "diaphragm = \"rigid\"\n", ""));
  EXPECT_EQ(open.at("verdict"), "open");
  EXPECT_EQ(open.at("governing_m"), whole.at("governing_m"));
  EXPECT_THAT(read_file(folder.path("open") / "package.html"),
              states("Roof diaphragm: not stated", "NOT STATED: computed as rigid", ">OPEN<"));
  EXPECT_THAT(read_file(folder.path("open") / "tables/premises.csv"),
              states("building.diaphragm", "not stated"));
}

// Issue 48: demand.toml was named, by `glissade clearance` alone.
TEST(CompletePackage, of_a_period_below_two_steps_is_a_fault_of_the_project) {
  const ScratchFolder folder;
  folder.write("recorded.toml",
               "[suite]\nname = \"r\"\n[[record]]\nid = \"a\"\nfirst = \"a.txt\"\nsecond = "
               "\"b.txt\"\n");
  folder.write("a.txt", two_columns(shaking_g()));
  folder.write("b.txt", two_columns(shaking_g(1.0)));
  const std::string file =
      folder.write("stiff.toml", replaced(complete_project, "period_s = 0.35", "period_s = 0.03"));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"check", file},
        {"clearance", file, "--out", folder.path("stiff").string()}}) {
    const Finished child = run_program(command);
    expect_refused(child, {"stiff.toml", "building.period_s"});
    EXPECT_THAT(child.err, Not(HasSubstr("demand.toml")));
  }
}

}  // namespace
}  // namespace glissade::test
