// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/json_of.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

Json building_json(const std::vector<std::string>& options) {
  return json_of({"building"}, options);
}

void expect_building_refused(const std::vector<std::string>& options, const std::string& what) {
  SCOPED_TRACE(what);
  expect_refused(run_program(with({"building"}, options)), {what});
}

TEST(Building, of_a_frame_amplifies_more_than_one_mass) {
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

// Three modes of which the second is along y; participations 1.22 and -0.28.
TEST(Building, takes_the_tables_of_etabs_and_sap_2000_and_the_report_of_opensees) {
  const ScratchFolder folder;
  const std::vector<std::string> files{
      folder.write("etabs.csv",
                   "TABLE:  Modal Participating Mass Ratios\n"
                   "Case,Mode,Period,UX,UY,UZ,SumUX,SumUY,participation\n"
                   ",,sec,,,,,,\n"
                   "Modal,1,0.5,0.91,0,0,0.91,0,1.22\n"
                   "Modal,2,0.4,0,0.9,0,0.91,0.9,0\n"
                   "Modal,3,0.18,0.07,0,0,0.98,0.9,-0.28\n"),
      folder.write("sap.csv",
                   "\"TABLE:  Modal Participating Mass Ratios\"\n"
                   "OutputCase;StepType;StepNum;Period;UX;UY;factor;roof_shape\n"
                   "Text;Text;Unitless;Sec;Unitless;Unitless;;\n"
                   "MODAL;Mode;1;0.5;0.91;0;-12.2;-0.1\n"
                   "MODAL;Mode;2;0.4;0;0.9;0;0.1\n"
                   "MODAL;Mode;3;0.18;0.07;0;2.8;-0.1\n"),
      folder.write("modal.txt",
                   "# MODAL ANALYSIS REPORT\n\n"
                   "* 2. EIGENVALUE ANALYSIS:\n"
                   "#          MODE        LAMBDA         OMEGA     FREQUENCY        PERIOD\n"
                   "# ------------- ------------- ------------- ------------- -------------\n"
                   "              1       157.914       12.5664             2           0.5\n"
                   "              2        246.74        15.708           2.5           0.4\n"
                   "              3       1218.47       34.9066       5.55556          0.18\n\n"
                   "* 6. MODAL PARTICIPATION FACTORS:\n"
                   "# The participation factor for a certain mode\n"
                   "#          MODE            MX            MY           RMZ\n"
                   "              1          12.2             0             0\n"
                   "              2             0          12.0             0\n"
                   "              3          -2.8             0             0\n\n"
                   "* 9. MODAL PARTICIPATION MASS RATIOS (%):\n"
                   "#          MODE            MX            MY           RMZ\n"
                   "              1            91             0             0\n"
                   "              2             0            90             0\n"
                   "              3             7             0             0\n\n"
                   "* 10. MODAL PARTICIPATION MASS RATIOS (%) (cumulative):\n"
                   "              1            91             0             0\n")};
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::vector<std::string> options{"--modes", files[i], "--axis", "x"};
    if (i == 2) options.insert(options.end(), {"--roof-shape", "0.1", "0.1", "0.1"});
    const Json modes = building_json(options).at("modes");
    ASSERT_EQ(modes.size(), 2u) << files[i];
    EXPECT_EQ(modes.at(0).at("period_s"), 0.5);
    EXPECT_EQ(modes.at(1).at("period_s"), 0.18);
    EXPECT_NEAR(modes.at(0).at("participation"), 1.22, 1e-12);
    EXPECT_NEAR(modes.at(1).at("participation"), -0.28, 1e-12);
    EXPECT_NEAR(modes.at(0).at("mass_share"), 0.91, 1e-12);
  }
  const auto refused = [](const std::vector<std::string>& options, const std::string& what) {
    expect_building_refused(with({"--modes"}, options), what);
  };
  refused({files[0]}, "--axis x or --axis y");
  refused({files[2], "--axis", "x"}, "--roof-shape");
  refused({files[2], "--axis", "y", "--roof-shape", "1", "1", "1"}, "is the vertical");
  refused({files[2], "--axis", "x", "--roof-shape", "1", "2"}, "has 3 modes");
  refused({files[0], "--axis", "x", "--roof-shape", "1", "2", "3"}, "leave it out");
  const std::string bare = folder.write("bare.csv", "Case,Mode,Period,UX,UY\nModal,1,0.5,0.91,0\n");
  refused({bare, "--axis", "x"}, "Modal Participation Factors");
  const std::string factors =
      folder.write("factors.csv", "Case,Mode,Period,UX,UY,Modal Mass\nModal,1,0.5,0.91,0,1\n");
  refused({factors, "--axis", "x"}, "which has no mass shares");
  const std::string cases = folder.write(
      "cases.csv", "Case,Period,UX,participation\nModal,0.5,0.9,1.2\nRitz,0.4,0.1,0.1\n");
  refused({cases, "--axis", "x"}, "another modal case");
}

TEST(Building, amplifies_a_given_spectrum) {
  const ScratchFolder folder;
  const std::string modes = folder.write(
                        "m.csv", "period_s,participation,mass_share\n0.5,1.2,0.9\n0.1,-0.3,0.1\n"),
                    spectrum = folder.write("s.csv",
                                            "period_s,design_sa_g\n0,0.4\n0.2,1.2\n1,1.0\n2,0.5\n");
  const Json json = building_json({"--modes", modes, "--spectrum", spectrum});
  const double first_g = 1.2 - 0.2 * 0.3 / 0.8, second_g = 0.8, ground_g = 0.4;
  EXPECT_NEAR(json.at("peak_roof_acceleration_g").at("modes"),
              std::sqrt(std::pow(1.2 * first_g, 2) + std::pow(0.3 * second_g, 2) +
                        std::pow(0.1 * ground_g, 2)),
              1e-12);
  EXPECT_NEAR(json.at("peak_roof_acceleration_g").at("sds_g"), 0.9 * 1.2, 1e-12);
  EXPECT_TRUE(json.at("warnings").empty());
  const std::string late = folder.write("l.csv", "period_s,design_sa_g\n0.2,1.2\n0.4,1.0\n");
  EXPECT_FALSE(building_json({"--modes", modes, "--spectrum", late}).at("warnings").empty());
  expect_building_refused({"--modes", modes, "--spectrum", modes}, "design_sa_g");
}

TEST(Building, refuses_what_is_none_and_warns_of_missing_modes) {
  const ScratchFolder folder;
  const auto modes = [&](const std::string& rows) {
    return folder.write("m.csv", "period_s,participation,mass_share\n" + rows);
  };
  const auto refused = expect_building_refused;
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
  refused({"--modes", modes("inf,1.2,0.8\n")}, "not above 0");
  for (const char* participation : {"nan", "inf", "1e308"})
    refused({"--modes", modes("0.5," + std::string(participation) + ",0.9\n")}, "participation");
  refused(
      {"--modes", folder.write("t.csv", "period_s,participation,mass_share,Period\n0.5,1,1,2\n")},
      "the same number");
  refused(
      {"--modes", folder.write("p.csv", "period_s,participation,mass_share,damping\n0.5,1,1,5\n")},
      "5 %");
  refused({"--modes", folder.write("n.csv", "period_s,participation\n0.5,1\n")}, "mass_share");
  refused({"--modes", folder.write("f.csv", "f (Hz),participation,mass_share\n2,1,1\n")},
          "has no column period_s; not read: 'f (Hz)'; read are period_s, or T (s)");
  for (const char* period : {"T (s)", "T_s", "Period [sec]", "period_sec"})
    EXPECT_EQ(building_json({"--modes", folder.write("t.csv", std::string(period) +
                                                                  ",participation,mass_share\n"
                                                                  "0.5,1.2,0.9\n")})
                  .at("modes")
                  .at(0)
                  .at("period_s"),
              0.5)
        << period;
  for (const char* name : {"damping %", "Damping [%]", "xi"})
    refused({"--modes", folder.write("d.csv", std::string("period_s,participation,mass_share,") +
                                                  name + "\n0.5,1,1,5\n")},
            "is not read");
  const Json few = building_json({"--modes", modes("0.5,1.6,0.6\n")});
  EXPECT_EQ(few.at("warnings").size(), 2u);
  // 120 t on 9e4 kN/m: 0.23 s. In kg with kN/m 7.3 s is possible; 900 kN/m make it 73 s.
  const auto warnings = [](const char* mass, const char* stiffness) {
    return building_json({"--masses", mass, "--stiffnesses", stiffness}).at("warnings");
  };
  EXPECT_TRUE(warnings("120", "9e4").empty());
  EXPECT_THAT(building_json({"--storeys", "20", "--period-s", "0.3"}).at("warnings").dump(),
              states("20 storeys"));
  const std::string damped =
      folder.write("h.csv", "period_s,participation,mass_share,damping\n0.5,1,1,40 %\n");
  EXPECT_THAT(building_json({"--modes", damped}).at("warnings").dump(), states("damping 0.4"));
  for (const auto& [mass, stiffness] : {std::pair{"120", "9e7"}, {"120e3", "900"}})
    EXPECT_THAT(warnings(mass, stiffness).at(0).get<std::string>(), states("kN/m", "N/m"));
}

TEST(Building, reads_modes_with_decimal_commas_percent_and_their_damping) {
  const ScratchFolder folder;
  const Json json =
      building_json({"--modes", folder.write("m.csv",
                                             "period_s;participation;mass_share;damping\n"
                                             "0,5;1,22;91 %;2 %\n0,18;-0,28;0,07;0,03\n")});
  EXPECT_EQ(json.at("modes").at(0).at("period_s"), 0.5);
  EXPECT_EQ(json.at("modes").at(0).at("participation"), 1.22);
  EXPECT_NEAR(json.at("modes").at(0).at("mass_share"), 0.91, 1e-15);
  EXPECT_EQ(json.at("modes").at(0).at("damping"), 0.02);
  EXPECT_EQ(json.at("modes").at(1).at("damping"), 0.03);
}

}  // namespace
}  // namespace glissade::test
