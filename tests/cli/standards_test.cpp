// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/json_of.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

Json standards_json(const std::vector<std::string>& options) {
  return json_of({"standards"}, options);
}

TEST(Standards, rodriguez_nikls_example_is_2_07_m) {
  // Rodriguez-Nikl et al. 2019: S_DS 1.566 g: 60 (1.566 - 0.4)^2 in = 81.6 in.
  EXPECT_NEAR(standards_json({"--sds-g", "1.566"})["seaoc_pv1_2012_m"], 60 * 1.166 * 1.166 * 0.0254,
              1e-9);
}

TEST(Standards, a_stamped_calculation_and_its_separations_come_out) {
  // S_DS 1.050, I_e 1: 5 (0.65)^2 ft = 25.35 in (a permit calculation); separations 0.5, 1, 1 and 2
  // times that.
  const Json json = standards_json({"--sds-g", "1.05"});
  const double prescribed = json["asce7_16_m"];
  EXPECT_NEAR(prescribed, 5 * 0.65 * 0.65 * 0.3048, 1e-9);
  std::vector<double> factors;
  for (const Json& separation : json.at("separations")) {
    factors.push_back(separation.at("factor"));
    EXPECT_NEAR(separation.at("separation_m"), factors.back() * prescribed, 1e-12);
    EXPECT_TRUE(separation.at("between").is_string());
  }
  EXPECT_THAT(factors, testing::UnorderedElementsAre(0.5, 1.0, 1.0, 2.0));
}

TEST(Standards, importance_multiplies_asce_7_16) {
  const double once = standards_json({"--sds-g", "1.5"})["asce7_16_m"],
               more = standards_json({"--sds-g", "1.5", "--importance", "1.5"})["asce7_16_m"];
  EXPECT_NEAR(more, 1.5 * once, 1e-12);
}

TEST(Standards, a_risk_category_gives_its_importance_factor) {
  EXPECT_EQ(standards_json({"--sds-g", "1", "--risk-category", "III"})["importance"], 1.25);
  EXPECT_EQ(run_program({"standards", "--sds-g", "1", "--risk-category", "V"}).status, 2);
}

// Both standards are for risk categories I to III (recalled).
TEST(Standards, of_risk_category_IV_give_no_displacement_and_no_separations) {
  const Json json = standards_json({"--sds-g", "1.05", "--risk-category", "IV"});
  for (const char* key : {"asce7_16", "seaoc_pv1_2012"}) {
    EXPECT_FALSE(json[key]["applies"]);
    EXPECT_TRUE(json[key]["value_m"].is_null());
    EXPECT_TRUE(json[key]["separations"].empty());
    EXPECT_TRUE(json[std::string(key) + "_m"].is_null());
  }
  const std::string text =
      run_program({"standards", "--sds-g", "1.05", "--risk-category", "IV"}).out;
  EXPECT_THAT(text, states("not applicable", "risk category"));
  EXPECT_THAT(text, testing::Not(states("similar")));
}

TEST(Standards, list_conditions_with_limit_clause_mark_and_what_is_found) {
  const std::vector<std::string> options{
      "--sds-g",   "1.2", "--slope-deg",       "1.2", "--mu", "0.5",
      "--storeys", "7",   "--interconnection", "0.15"};
  const Json json = standards_json(options);
  std::size_t known = 0;
  for (const Json& c : json["asce7_16"]["conditions"]) {
    EXPECT_EQ(c["provenance"], "recalled: verify against the standard");
    EXPECT_THAT(c["clause"].get<std::string>(), states("13.6.12"));
    if (!c["is_met"].is_null()) ++known;
    if (c["condition"] == "storeys") {
      EXPECT_EQ(c["is_met"], false);
    }
  }
  EXPECT_EQ(known, 4u);
  EXPECT_THAT(json["asce7_16"]["not_met"].get<std::string>(),
              states("storeys: 7, required 6 or fewer", "0.133 S_DS"));
}

TEST(Standards, name_the_pull_tests_and_the_roof_motions_of_seaoc_pv1) {
  EXPECT_THAT(run_program({"standards", "--sds-g", "1"}).out, states("G115", "AC156", "1.1 times"));
}

TEST(Standards, sdc_c_asks_for_six_inches) {
  EXPECT_NEAR(standards_json({"--sds-g", "1.5", "--sdc", "C"})["seaoc_pv1_2012_m"], 6 * 0.0254,
              1e-12);
}

TEST(Standards, says_how_well_each_value_is_known) {
  const Finished child = run_program({"standards", "--sds-g", "1.566"});
  EXPECT_EQ(child.status, 0);
  for (const char* part : {"2.072  81.6", "checked", "in plan"})
    EXPECT_THAT(child.out, testing::HasSubstr(part));
}

TEST(Standards, what_is_no_sds_importance_or_category_is_refused) {
  expect_refused(run_program({"standards", "--sds-g", "-1"}), {"-1", "S_DS"});
  expect_refused(run_program({"standards", "--sds-g", "nan"}), {"nan"});
  expect_refused(run_program({"standards", "--sds-g", "105"}), {"percent", "1.05"});
  expect_refused(run_program({"standards", "--sds-g", "1", "--sdc", "Q"}), {"Q", "A to F"});
  expect_refused(run_program({"standards", "--sds-g", "1", "--importance", "0"}),
                 {"importance", "0"});
  expect_refused(run_program({"standards"}), {"--sds-g"});
}

}  // namespace
}  // namespace glissade::test
