// SPDX-License-Identifier: GPL-3.0-or-later
// Calculation packages on motions of a roof.
#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/shaking.hpp"
#include "facts.hpp"
#include "glissade/block/two_axis.hpp"
#include "glissade/core/units.hpp"

namespace glissade::test {
namespace {

/// Seven motions of a roof, the components of each in one table.
class RoofPackage : public testing::Test {
 protected:
  static constexpr int records = 7;
  static constexpr double factor = 1.2, mu = 0.36, slope_deg = 1.2;

  static std::array<std::vector<double>, 3> components_g(int record) {
    const double phase = 0.7 * record;
    return {times(1.0 + 0.1 * record, shaking_g(phase)), times(0.8, shaking_g(2.0 + 1.3 * phase)),
            times(0.3, shaking_g(1.0 + phase))};
  }
  std::string write_suite() const {
    std::string suite = "[suite]\nname = \"roofs\"\nmotions = \"roof\"\n";
    for (int record = 0; record < records; ++record) {
      const auto a_g = components_g(record);
      std::string table = "Time (s),U1 (g),U2 (g),U3 (g)\n";
      for (std::size_t i = 0; i < a_g[0].size(); ++i)
        table += exact(shaking_dt_s * static_cast<double>(i)) + "," + exact(a_g[0][i]) + "," +
                 exact(a_g[1][i]) + "," + exact(a_g[2][i]) + "\n";
      const std::string name = "roof_" + std::to_string(record);
      folder_.write(name + ".csv", table);
      suite += "[[record]]\nid = \"" + name + "\"\n";
      for (const auto& [key, column] :
           {std::pair{"first", "U1"}, {"second", "U2"}, {"vertical", "U3"}})
        suite += std::string(key) + " = \"" + name + ".csv#" + column + "\"\n";
    }
    return folder_.write("roofs.toml", suite);
  }
  std::string project(const std::string& more, const std::string& suite = "roofs.toml",
                      const std::string& of_suite = "factor = 1.2\n") const {
    return folder_.write(
        "project.toml",
        "[project]\nname = \"Three storeys\"\nunits = \"si\"\n"
        "[site]\nedition = \"asce7_16\"\nsds_g = 1.0\nsd1_g = 0.6\nrisk_category = \"II\"\n"
        "[roof]\nslope_deg = 1.2\n[sampling]\nsamples = 4\n"
        "[friction]\nmu = { mean = 0.40, std = 0.02 }\nsource = \"test\"\n"
        "[suite]\nfile = \"" +
            suite + "\"\n" + of_suite + more);
  }
  /// Of a record, with the second component along the slope or the first, each with a sign.
  static double displacement_m(int record, bool swapped, double along, double across,
                               bool with_vertical) {
    const auto a_g = components_g(record);
    const auto first = times(along * standard_gravity_mps2, a_g[swapped ? 1 : 0]),
               second = times(across * standard_gravity_mps2, a_g[swapped ? 0 : 1]),
               up = times(standard_gravity_mps2, a_g[2]);
    TwoAxisAcceleration roof{shaking_dt_s, {first, second}, {}, factor, factor};
    if (with_vertical) roof.vertical_mps2 = up;
    return srss_of_maxima_m(
        slide_two_axis(roof, {.friction = mu, .slope_rad = slope_deg * rad_per_deg}, 1e-8));
  }

  ScratchFolder folder_;
};

TEST_F(RoofPackage, is_that_of_an_array_on_the_motions_themselves) {
  write_suite();
  const fs::path out = folder_.path("out");
  const Finished finished =
      succeeding({"clearance", project("[building]\nstoreys = 3\n"), "--out", out.string()});
  double largest_m = 0.0;
  for (const bool with_vertical : {false, true})
    for (const bool swapped : {false, true})
      for (const double along : {1.0, -1.0})
        for (const double across : {1.0, -1.0}) {
          double sum_m = 0.0;
          for (int record = 0; record < records; ++record)
            sum_m += displacement_m(record, swapped, along, across, with_vertical);
          largest_m = std::max(largest_m, sum_m / records);
        }
  const auto json = nlohmann::json::parse(read_file(out / "package.json"));
  EXPECT_NEAR(json.at("analysis_m"), 1.1 * largest_m, 1e-5 * largest_m);
  EXPECT_EQ(json.at("governing_m"),
            std::max(json.at("analysis_m").get<double>(), json.at("least_value_m").get<double>()));
  EXPECT_EQ(json.at("motions"), "roof");
  std::vector<double> peaks_g;
  for (int record = 0; record < records; ++record) {
    const auto a_g = components_g(record);
    double product = 1.0;
    for (std::size_t axis = 0; axis < 2; ++axis)
      product *= std::abs(
          *std::ranges::max_element(a_g.at(axis), {}, [](double a) { return std::abs(a); }));
    peaks_g.push_back(factor * std::sqrt(product));
  }
  ASSERT_EQ(json.at("roof_acceleration").size(), 1u);
  EXPECT_NEAR(json.at("roof_acceleration").at(0).at("median_g"), quantile_of(peaks_g, 0.5), 1e-9);
  EXPECT_EQ(json.at("exceedance").at(1).at("factor"), 1.5 * factor);  // MCE
  for (const char* absent : {"period_s", "mass_ratio"}) EXPECT_FALSE(json.contains(absent));

  const std::string page = read_file(out / "package.html");
  EXPECT_THAT(page, states("motions of the roof", "Peak roof acceleration", "multiplied by 1.2"));
  for (const std::string& text : {page, finished.out})
    for (const char* absent : {"building period", "ground acceleration", "PGA", "Ground motions",
                               "S_DS scal", "period 0", "T, s 0", "mass ratio"})
      EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  EXPECT_FALSE(fs::exists(out / "figures/spectra.svg"));
}

TEST_F(RoofPackage, says_that_weak_motions_are_below_0_8_of_the_standards) {
  write_suite();
  const Finished checked = succeeding({"check", project("", "roofs.toml", "factor = 0.2\n")});
  EXPECT_THAT(checked.out, states("none is computed", "factor 0.2"));
  const fs::path out = folder_.path("out");
  const Finished finished = run_program(
      {"clearance", project("", "roofs.toml", "factor = 0.2\n"), "--out", out.string()});
  EXPECT_THAT(finished.out, states("median peak", "check is not met"));
}

TEST_F(RoofPackage, suite_commands_and_studies_say_that_the_motions_are_of_a_roof) {
  const std::string suite = write_suite();
  const Finished shown = succeeding({"suite", "show", suite});
  EXPECT_THAT(shown.out, states("Peak roof acceleration"));
  expect_refused(run_program({"suite", "select", suite, "--level", "2"}),
                 {"has motions of a roof", "spectrum of the ground"});
  const std::string study =
      folder_.write("study.toml",
                    "[study]\nname = \"roofs\"\n[suite]\nfile = \"roofs.toml\"\n"
                    "[intensity]\nmeasure = \"factor\"\nlevels = [1.0, 1.5]\n"
                    "[roof]\nslope_deg = [0, 1.2]\n[friction]\nmu = 0.3\n"
                    "[vertical]\nuse = [\"none\", \"if_available\"]\n"
                    "[orientation]\nchoice = \"all_permutations\"\n[clearance]\n");
  const fs::path out = folder_.path("study");
  const Finished run = succeeding({"run", study, "--out", out.string()});
  for (const std::string& text :
       {shown.out, run.out, read_file(out / "report.html"), read_file(out / "tables/records.csv"),
        read_file(out / "tables/clearances.csv")})
    for (const char* absent : {"PGA", "T, s", "T 0", "T = 0", "of the ground", "ground motion",
                               "building period", "over the periods"})
      EXPECT_EQ(text.find(absent), std::string::npos)
          << absent << ": " << text.substr(std::max<std::size_t>(text.find(absent), 60) - 60, 160);
}

TEST_F(RoofPackage, refuses_what_is_of_the_ground_or_of_a_building_below) {
  write_suite();
  const auto check = [&](const std::string& more) { return run_program({"check", project(more)}); };
  expect_refused(check("[building]\nperiod_s = 0.5\nmass_ratio = 0.05\nstoreys = 3\n"),
                 {"building.period_s, building.mass_ratio are of a building", "leave out"});
  expect_refused(check("[hazard]\nk0 = 1e-3\nk = 2.0\ndesign_life_years = 25\n"), {"[hazard]"});
  expect_refused(
      run_program({"check", project("[building]\nperiod_s = 0.5\nmass_ratio = 0.05\n",
                                    GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml")}),
      {"suite.factor", "of the ground"});
}

}  // namespace
}  // namespace glissade::test
