// SPDX-License-Identifier: GPL-3.0-or-later
// A calculation package whose premises are all met, and the same without one.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/one_package.hpp"
#include "cli/shaking.hpp"
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

std::string complete_project() {
  return R"([project]
name = "Roof of x_1, complete"
[site]
edition = "asce7_16"
ss_g = 1.3
s1_g = 0.45
site_class = "C"
tl_s = 8
risk_category = "II"
fault_distance_km = 30
[building]
period_s = 0.35
mass_ratio = 0.02
storeys = 2
diaphragm = "rigid"
[roof]
slope_deg = "0.25:12"
[friction]
mu = { mean = 0.7, std = 0.02 }
source = "report 7"
tests = 9
laboratory = "Own laboratory"
tested_on = "2026-10-14"
test_standard = "ASTM G115"
surface = "wet TPO"
[array]
centre_of_mass_m = "11 in"
support_spacing_m = "32 in"
interconnection = 0.2
[suite]
file = "recorded.toml"
[sampling]
samples = 2
[clearances]
similar_array_m = "30 ft"
obstruction_m = "30 ft"
parapet_edge_m = "30 ft"
open_edge_m = "30 ft"
)";
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
  const auto whole = package_of("whole", complete_project());
  EXPECT_EQ(whole.at("verdict"), "sufficient") << whole.at("warnings").dump(1);
  EXPECT_GT(whole.at("premises").size(), 10u);
  for (const auto& premise : whole.at("premises")) EXPECT_TRUE(premise.at("is_met")) << premise;
  const std::string page = read_file(folder.path("whole") / "package.html");
  EXPECT_THAT(page, states("The available separations are sufficient", "Roof of x_1, complete"));
  EXPECT_THAT(page, Not(HasSubstr("OPEN")));

  const auto open = package_of("open", replaced(complete_project(), "diaphragm = \"rigid\"\n", ""));
  EXPECT_EQ(open.at("verdict"), "open");
  EXPECT_EQ(open.at("governing_m"), whole.at("governing_m"));
  EXPECT_THAT(read_file(folder.path("open") / "package.html"),
              states("Roof diaphragm: not stated", "NOT STATED: computed as rigid", ">OPEN<"));
  EXPECT_THAT(read_file(folder.path("open") / "tables/premises.csv"),
              states("building.diaphragm", "not stated"));
}

}  // namespace
}  // namespace glissade::test
