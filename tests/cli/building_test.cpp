// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

using Json = nlohmann::json;

Json building_json(std::vector<std::string> options) {
  options.insert(options.begin(), "building");
  options.push_back("--json");
  const Finished child = run_program(options);
  EXPECT_EQ(child.status, 0) << child.err;
  return Json::parse(child.out);
}

TEST(Building, of_walls_with_frames_amplifies_more_than_one_mass) {
  // Period 0.6 s on the plateau: SRSS of the participations of its modes, and 1 less their sum
  // for what moves with the ground, S_a(0) = 0.4 S_DS.
  const Json json =
      building_json({"--period-s", "0.6", "--alpha", "10", "--sds-g", "1", "--sd1-g", "0.6"});
  ASSERT_EQ(json.at("modes").size(), 20u);
  EXPECT_EQ(json.at("governing"), 4);
  double sum = 0.0, left = 1.0;
  for (const Json& mode : json.at("modes")) {
    const double participation = mode.at("participation"), period_s = mode.at("period_s");
    const double t0_s = 0.12, sa_g = period_s >= t0_s ? 1.0 : 0.4 + 0.6 * period_s / t0_s;
    sum += participation * sa_g * participation * sa_g;
    left -= participation;
  }
  const Json& peak = json.at("peak_roof_acceleration_g");
  EXPECT_NEAR(peak.at("modes"), std::sqrt(sum + 0.16 * left * left), 1e-9);
  EXPECT_EQ(peak.at("one_mass"), 1.0);
  EXPECT_NEAR(peak.at("asce7_16"), 1.2, 1e-12);
  // 0.4 (1 + 1/0.6 + 1 - (0.4/0.6)^2)
  EXPECT_NEAR(peak.at("asce7_22"), 0.4 * (2.0 + 1.0 / 0.6 - 4.0 / 9.0), 1e-12);
}

TEST(Building, is_equal_storeys_their_masses_or_a_file_of_modes) {
  const Json equal = building_json({"--period-s", "0.5", "--storeys", "3"}),
             given = building_json({"--masses", "2", "2", "2", "--stiffnesses", "9", "9", "9"});
  EXPECT_EQ(equal.at("modes").at(0).at("period_s"), 0.5);
  EXPECT_NEAR(equal.at("modes").at(1).at("participation"),
              given.at("modes").at(1).at("participation"), 1e-12);
  const ScratchFolder folder;
  const auto file = folder.write(
      "modes.csv", "period_s,participation,mass_share\n0.5,1.22,0.91\n0.18,-0.28,0.07\n");
  const Json listed = building_json({"--modes", file});
  EXPECT_EQ(listed.at("modes").at(1).at("mass_share"), 0.07);
  EXPECT_TRUE(listed.at("warnings").empty());
}

TEST(Building, refuses_what_is_none_and_warns_of_missing_modes) {
  const ScratchFolder folder;
  const auto modes = [&](const std::string& rows) {
    return folder.write("m.csv", "period_s,participation,mass_share\n" + rows);
  };
  const auto refused = [](std::vector<std::string> options, const std::string& what) {
    options.insert(options.begin(), "building");
    const Finished child = run_program(options);
    EXPECT_EQ(child.status, 2) << child.out;
    EXPECT_THAT(child.err, testing::HasSubstr(what));
  };
  refused({}, "--alpha or --storeys");
  refused({"--period-s", "0.5", "--alpha", "nan"}, "--alpha");
  refused({"--period-s", "0.5", "--alpha", "2", "--sds-g", "nan"}, "--sds-g");
  refused({"--period-s", "0.5", "--masses", "2", "--stiffnesses", "3"}, "--period-s");
  refused({"--period-s", "0.5"}, "--storeys");
  refused({"--period-s", "0.5", "--alpha", "-1"}, "--alpha");
  refused({"--period-s", "-0.5", "--alpha", "2"}, "--period-s");
  refused({"--masses", "2", "--stiffnesses", "0"}, "not above 0");
  refused({"--masses", "2", "3", "--stiffnesses", "5"}, "2 masses and 1 stiffnesses");
  refused({"--modes", modes("0.5,1.2,0.8\n0.6,0.2,0.1\n")}, "periods must fall");
  refused({"--modes", modes("0.5,1.2,0.8\n0.2,-0.2,0.3\n")}, "more than 1");
  refused({"--modes", modes("0,1.2,0.8\n")}, "not above 0");
  refused({"--modes", folder.write("n.csv", "period_s,participation\n0.5,1\n")}, "mass_share");
  const Json few = building_json({"--modes", modes("0.5,1.6,0.6\n")});
  EXPECT_EQ(few.at("warnings").size(), 2u);
}

}  // namespace
}  // namespace glissade::test
