// SPDX-License-Identifier: GPL-3.0-or-later
//
// `glissade slide` beyond one axis on a building that is not coupled with the array.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/json_of.hpp"
#include "cli/shaking.hpp"
#include "facts.hpp"
#include "glissade/block/coupled.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/building_model.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade::test {
namespace {

class SlideModel : public testing::Test {
 protected:
  Json slide_json(const std::vector<std::string>& options) const {
    return json_of({"slide", first_}, options);
  }
  /// `mu` and slope are given already.
  Finished run(const std::vector<std::string>& options) const {
    return run_program(with({"slide", first_, "--mu", "0.2", "--slope-deg", "2"}, options));
  }

  ScratchFolder folder_;
  std::vector<double> first_g_ = shaking_g(0.0), second_g_ = times(0.8, shaking_g(2.0));
  std::string first_ = folder_.write("first.txt", two_columns(first_g_));
  std::string second_ = folder_.write("second.txt", two_columns(second_g_));
};

TEST_F(SlideModel, on_two_axes_it_gives_what_the_library_gives_to_the_last_bit) {
  const Json json = slide_json({"--second", second_, "--mu", "0.2", "--across-mu", "0.15",
                                "--slope-deg", "2", "--azimuth-deg", "30", "--period-s", "0.5",
                                "--period-ratio", "1.4", "--mass-ratio", "0.1"});
  Motion motion;
  motion.dt_s = shaking_dt_s;
  motion.horizontal_mps2 = {times(standard_gravity_mps2, first_g_),
                            times(standard_gravity_mps2, second_g_)};
  const BuildingSlip expected = slide_on_building(
      building_ground(motion, {}, {}), {},
      {.horizontal = {Oscillator{0.5, 0.05}, Oscillator{1.4 * 0.5, 0.05}}, .mass_ratio = 0.1},
      {.friction = {0.2, 0.15}, .slope_rad = 2.0 * rad_per_deg, .azimuth_rad = 30.0 * rad_per_deg});
  ASSERT_GT(expected.slip.peak_by_axis.across_m, 0.01);  // a history worth comparing
  EXPECT_EQ(json["peak_vector_m"], expected.slip.peak_displacement_m);
  EXPECT_EQ(json["peak_x_m"], expected.slip.peak_by_axis.along_m);
  EXPECT_EQ(json["peak_y_m"], expected.slip.peak_by_axis.across_m);
  EXPECT_EQ(json["srss_m"], srss_of_maxima_m(expected.slip));
  EXPECT_EQ(json["peak_displacement_m"], json["peak_vector_m"]);
  EXPECT_EQ(json["residual_displacement_m"],  // of the vector, as peak_displacement_m
            std::hypot(expected.slip.residual.along_m, expected.slip.residual.across_m));
  EXPECT_EQ(json["residual_y_m"], expected.slip.residual.across_m);
  EXPECT_EQ(json["path_length_m"], expected.slip.path_length_m);
  EXPECT_EQ(json["peak_base_shear"][1], expected.peak_base_shear[1]);
  EXPECT_EQ(json["peak_x_m"],
            std::max(json["peak_downslope_m"].get<double>(), json["peak_upslope_m"].get<double>()));
  EXPECT_THAT(json["model"].get<std::string>(), states("full model"));
}

/// Time, accelerations and displacements of --history on two axes.
std::vector<std::array<double, 5>> plane_history(const std::string& file) {
  const std::vector<std::string> lines = lines_of(read_file(file));
  EXPECT_EQ(lines[0],
            "time_s,roof_acceleration_1_mps2,roof_acceleration_2_mps2,displacement_along_m,"
            "displacement_across_m");
  std::vector<std::array<double, 5>> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = cells_of(lines[i]);
    EXPECT_EQ(cells.size(), 5u) << lines[i];
    for (std::size_t k = 0; auto& value : rows.emplace_back()) value = std::stod(cells[k++]);
  }
  return rows;
}

TEST_F(SlideModel, a_history_on_two_axes_has_every_sample_and_ends_where_the_json_says) {
  const std::string file = folder_.path("plane.csv").string();
  const Json json = slide_json({"--second", second_, "--mu", "0.2", "--slope-deg", "2",
                                "--azimuth-deg", "30", "--scale", "1.5", "--history", file});
  const auto rows = plane_history(file);
  double peak_m = 0.0;
  std::vector<bool> has_sample(first_g_.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [time_s, first_mps2, second_mps2, along_m, across_m] = rows[i];
    EXPECT_GE(time_s, rows[i > 0 ? i - 1 : 0][0]);
    peak_m = std::max(peak_m, std::hypot(along_m, across_m));
    const double position = time_s / shaking_dt_s;
    const auto k = static_cast<std::size_t>(std::lround(position));
    if (k >= has_sample.size() || std::abs(position - static_cast<double>(k)) > 1e-9) continue;
    has_sample[k] = true;
    EXPECT_NEAR(first_mps2, 1.5 * standard_gravity_mps2 * first_g_[k], 1e-7);
    EXPECT_NEAR(second_mps2, 1.5 * standard_gravity_mps2 * second_g_[k], 1e-7);
  }
  EXPECT_EQ(std::ranges::count(has_sample, false), 0);
  // A path that is kept is followed to the stop, another is brought to rest near it.
  EXPECT_NEAR(rows.back()[3], json["residual_x_m"], 1e-8);
  EXPECT_NEAR(rows.back()[4], json["residual_y_m"], 1e-8);
  const double expected_m = json["peak_displacement_m"];
  EXPECT_LE(peak_m, expected_m);
  EXPECT_GT(peak_m, 0.99 * expected_m);
}

TEST_F(SlideModel, a_motion_of_a_suite_has_all_its_components_and_its_factor) {
  std::string table = "Time (s),U1 (g),U2 (g),U3 (g)\n";
  for (std::size_t i = 0; i < first_g_.size(); ++i)
    table += exact(shaking_dt_s * static_cast<double>(i)) + "," + exact(first_g_[i]) + "," +
             exact(second_g_[i]) + "," + exact(0.3 * second_g_[i]) + "\n";
  folder_.write("roof.csv", table);
  const std::string suite = folder_.write("roofs.toml",
                                          "[suite]\nname = \"roofs\"\nmotions = \"roof\"\n"
                                          "[[record]]\nid = \"bolu\"\nscale = 0.5\n"
                                          "first = \"roof.csv#U1\"\nsecond = \"roof.csv#U2\"\n"
                                          "vertical = \"roof.csv#U3\"\n");
  const auto slide = [&](const std::string& record, const std::vector<std::string>& more) {
    return run_program(with({"slide", record, "--mu", "0.2", "--slope-deg", "2"}, more));
  };
  const std::string csv = folder_.path("roof.csv").string(), file = folder_.path("h.csv").string();
  const Finished of_suite = slide(suite + "#bolu", {"--scale", "3", "--json", "--history", file}),
                 of_file = slide(csv + "#U1", {"--second", csv + "#U2", "--vertical", csv + "#U3",
                                               "--scale", "1.5", "--json"});
  EXPECT_EQ(of_suite.status, 0) << of_suite.err;
  EXPECT_EQ(of_suite.out, of_file.out);
  EXPECT_NEAR(plane_history(file).back()[3], Json::parse(of_file.out)["residual_x_m"], 1e-8);
  const Finished printed = slide(suite + "#bolu", {});
  EXPECT_THAT(printed.out, states("peak roof acceleration"));
  EXPECT_EQ(printed.out.find("PGA"), std::string::npos);
  expect_refused(slide(suite, {}), {"no motion is named", "bolu"});
  expect_refused(slide(suite + "#kobe", {}), {"has no motion kobe", "bolu"});
  expect_refused(slide(suite + "#bolu", {"--second", second_}), {"--second", "all its components"});
  expect_refused(slide(suite + "#bolu", {"--units", "g"}), {"--units", "from its suite"});
  expect_refused(slide(suite + "#bolu", {"--period-s", "0.5"}),
                 {"--period-s", "motion of a roof", "leave it out"});
}

TEST_F(SlideModel, a_second_component_of_zero_changes_nothing) {
  const std::string still =
      folder_.write("still.txt", two_columns(std::vector<double>(first_g_.size(), 0.0)));
  const Json one = slide_json({"--mu", "0.2", "--slope-deg", "2"});
  const Json two = slide_json({"--mu", "0.2", "--slope-deg", "2", "--second", still});
  for (const char* key : {"peak_displacement_m", "residual_displacement_m", "peak_downslope_m",
                          "peak_upslope_m", "peak_velocity_mps", "slip_duration_s"}) {
    const double expected = one[key];
    EXPECT_NEAR(two[key].get<double>(), expected, 1e-6 * std::abs(expected) + 1e-12) << key;
  }
  EXPECT_EQ(two["peak_y_m"], 0.0);
}

TEST_F(SlideModel, a_coupled_building_gives_what_the_library_gives) {
  const std::vector<double> a = times(standard_gravity_mps2, first_g_);
  for (const bool yields : {false, true}) {
    CoupledBuilding building{{0.4, 0.03}, 0.25};
    std::vector<std::string> options{"--mu",         "0.2", "--slope-deg", "-3",
                                     "--period-s",   "0.4", "--damping",   "0.03",
                                     "--mass-ratio", "0.25"};
    if (yields) {
      building.yielding = yielding_for(YieldCoefficient{0.3}, 0.02);
      options.insert(options.end(), {"--yield-coefficient", "0.3", "--hardening-ratio", "0.02"});
    }
    const CoupledResult expected = slide_coupled(
        {shaking_dt_s, a}, {}, building, {.friction = 0.2, .slope_rad = -3.0 * rad_per_deg});
    const Json json = slide_json(options);
    EXPECT_EQ(json["peak_displacement_m"], expected.slip.peak_displacement_m);
    EXPECT_EQ(json["residual_displacement_m"], expected.slip.residual.along_m);
    EXPECT_EQ(json["peak_base_shear"][0], expected.peak_base_shear);
    EXPECT_THAT(json["model"].get<std::string>(), states("slide_coupled"));
  }
}

TEST_F(SlideModel, alpha_is_a_building_of_several_modes_as_the_library_computes_it) {
  const BuildingModel cantilever{BuildingModel::Kind::cantilever};
  for (const double mass_ratio : {0.0, 0.1}) {
    Motion motion;
    motion.dt_s = shaking_dt_s;
    motion.horizontal_mps2[0] = times(standard_gravity_mps2, first_g_);
    const Modes modes = modes_along(cantilever, 0, {0.6, 0.05}, 5.0);
    ASSERT_GT(modes.size(), 2u);
    const BuildingSlip expected =
        slide_on_building(building_ground(motion, {}, {}), {},
                          {.horizontal = {modes, modes}, .mass_ratio = mass_ratio},
                          {.friction = 0.2, .slope_rad = 2.0 * rad_per_deg});
    const Json json = slide_json({"--mu", "0.2", "--slope-deg", "2", "--period-s", "0.6", "--alpha",
                                  "5", "--mass-ratio", fmt::format("{}", mass_ratio)});
    const double peak_m = expected.slip.peak_displacement_m;
    EXPECT_GT(peak_m, 0.01);
    // Coupled by the same scheme; else by exact events.
    EXPECT_NEAR(json["peak_displacement_m"], peak_m, mass_ratio > 0.0 ? 0.0 : 2e-6 * peak_m);
    EXPECT_EQ(json["alpha"], 5.0);
    EXPECT_THAT(json["model"].get<std::string>(), states("one axis"));
  }
}

TEST_F(SlideModel, takes_the_buildings_that_studies_take) {
  const auto peak = [&](const std::vector<std::string>& options) {
    return slide_json(with({"--mu", "0.2", "--slope-deg", "2"}, options))["peak_displacement_m"]
        .get<double>();
  };
  // Three equal storeys are their modes, of a first period of 0.6 s.
  const std::vector<double> ones(3, 1.0);
  std::string plain = "period_s,participation,mass_share\n", damped = plain;
  damped.insert(damped.size() - 1, ",damping");
  for (const Mode& m : governing_modes(with_first_period(shear_building_modes(ones, ones), 0.6))) {
    const std::string row = fmt::format("{},{},{}", m.period_s, m.participation, m.mass_share);
    plain += row + "\n";
    damped += row + ",2 %\n";
  }
  const std::string modes = folder_.write("m.csv", plain), two = folder_.write("d.csv", damped);
  const double by_storeys = peak({"--period-s", "0.6", "--storeys", "3"});
  EXPECT_EQ(by_storeys, peak({"--period-s", "0.6", "--storey-masses", "2", "2", "2",
                              "--storey-stiffnesses", "7", "7", "7"}));
  EXPECT_NEAR(peak({"--modes", modes}), by_storeys, 1e-9 * by_storeys);
  const double at_2_percent = peak({"--modes", two});
  EXPECT_GT(std::abs(at_2_percent / by_storeys - 1.0), 0.005);
  EXPECT_NEAR(at_2_percent, peak({"--modes", modes, "--damping", "0.02"}), 1e-12);
  // Unlike axes: the second is that of a building alike along both, stiffer.
  const auto across = [&](const std::vector<std::string>& options) {
    return slide_json(
               with({"--second", second_, "--mu", "0.2", "--slope-deg", "2", "--modes", modes},
                    options))["peak_y_m"]
        .get<double>();
  };
  const std::string stiffer =
      folder_.write("s.csv", "period_s;participation;mass_share\n0,3;1,2;88 %\n");
  EXPECT_NE(across({"--modes-across", stiffer}), across({}));
  const auto history = folder_.path("modes.csv").string();
  EXPECT_EQ(slide_json({"--mu", "0.2", "--slope-deg", "2", "--modes", modes, "--history", history})
                .count("peak_base_shear"),
            0u);
  EXPECT_GT(lines_of(read_file(history)).size(), 100u);
}

// By the rule of studies and of `glissade building`.
TEST_F(SlideModel, warns_of_modes_and_storeys_that_no_building_has) {
  const auto file = [&](const std::string& name, const std::string& row) {
    return folder_.write(name, "period_s,participation,mass_share,damping\n" + row + "\n");
  };
  const std::string fair = file("f.csv", "0.6,1.2,0.95,5 %");
  const auto warnings = [&](const std::vector<std::string>& building) {
    return slide_json(with({"--second", second_, "--mu", "0.2", "--slope-deg", "2"}, building))
        .at("warnings")
        .dump();
  };
  EXPECT_EQ(warnings({"--modes", fair}), "[]");
  EXPECT_THAT(warnings({"--modes", fair, "--modes-across", file("l.csv", "60,1,1,5 %")}),
              states("along the second axis", "60 s is above 10 s"));
  EXPECT_THAT(warnings({"--modes", fair, "--modes-across", file("t.csv", "0.6,0.5,0.4,40 %")}),
              states("modes along the second axis", "40 % of the mass", "together", "damping 0.4"));
  EXPECT_THAT(warnings({"--storeys", "20", "--period-s", "0.3"}), states("20 storeys"));
}

TEST_F(SlideModel, a_very_light_array_slides_as_one_without_mass) {
  const auto peak = [&](const char* ratio) {
    return slide_json({"--mu", "0.2", "--slope-deg", "2", "--period-s", "0.4", "--mass-ratio",
                       ratio})["peak_displacement_m"]
        .get<double>();
  };
  EXPECT_NEAR(peak("0"), peak("1e-12"), 2e-7 * peak("0"));
}

TEST_F(SlideModel, a_constant_push_passes_a_clearance_with_the_speed_of_its_closed_form) {
  // 0.5 g for 1 s on mu = 0.2: v' = 0.3 g, so s = 0.15 g t^2 and v = 0.3 g t.
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(51, 0.5)));
  const Json json =
      json_of({"slide", push, "--mu", "0.2", "--slope-deg", "0", "--clearance-m", "0.5"});
  const double t = std::sqrt(0.5 / (0.15 * standard_gravity_mps2));
  EXPECT_NEAR(json["crossing_time_s"].get<double>(), t, 1e-8);
  EXPECT_NEAR(json["crossing_speed_mps"].get<double>(), 0.3 * standard_gravity_mps2 * t, 1e-8);
  const Json never = slide_json({"--mu", "2", "--slope-deg", "0", "--clearance-m", "0.5"});
  EXPECT_TRUE(never["crossing_time_s"].is_null());
}

TEST_F(SlideModel, friction_that_is_stronger_at_rest_holds_a_push_below_it) {
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(51, 0.23)));
  const auto peak = [&](const char* ratio) {
    return json_of({"slide", push, "--mu", "0.2", "--slope-deg", "0", "--static-over-sliding",
                    ratio})["peak_displacement_m"]
        .get<double>();
  };
  EXPECT_GT(peak("1.1"), 0.01);  // 0.22 g
  EXPECT_EQ(peak("1.2"), 0.0);   // 0.24 g
}

TEST_F(SlideModel, text_names_the_model_and_both_axes) {
  const Finished child = run(
      {"--second", second_, "--period-s", "0.5", "--mass-ratio", "0.05", "--clearance-m", "0.01"});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out, states("full model", "SRSS", "across", "base shear"));
}

TEST_F(SlideModel, each_bad_input_gets_one_clear_message) {
  expect_refused(run({"--mass-ratio", "-0.1"}), {"--mass-ratio: -0.1", "must be 0 to 1"});
  expect_refused(run({"--mass-ratio", "1.5"}), {"--mass-ratio: 1.5", "must be 0 to 1"});
  expect_refused(run({"--neighbour-over-mu", "0.8"}), {"--neighbour-over-mu"});
  expect_refused(run({"--azimuth-deg", "20"}), {"--azimuth-deg: needs --second"});
  expect_refused(run({"--across-mu", "0.3"}), {"--across-mu: needs --second"});
  expect_refused(run({"--second", second_, "--across-mu", "0"}),
                 {"--across-mu: 0 leaves the friction ellipse"});
  expect_refused(run({"--yield-coefficient", "0.2"}), {"has no effect without a building"});
  expect_refused(run({"--period-s", "0.5", "--yield-coefficient", "0"}),
                 {"--yield-coefficient: must be > 0"});
  expect_refused(run({"--period-s", "0.5", "--hardening-ratio", "0.1"}),
                 {"needs --yield-coefficient"});
  expect_refused(run({"--alpha", "5"}), {"--alpha: needs --period-s"});
  expect_refused(run({"--alpha", "5", "--period-s", "0.5", "--yield-coefficient", "0.2"}),
                 {"--yield-coefficient: a building of several modes stays elastic"});
  expect_refused(run({"--alpha", "5", "--storeys", "3", "--period-s", "0.5"}), {"in two ways"});
  expect_refused(run({"--storeys", "3"}), {"--period-s"});
  expect_refused(run({"--storeys", "3", "--period-s", "0.5", "--storey-masses", "1", "2"}),
                 {"as many as the storeys"});
  expect_refused(run({"--modes", folder_.write("short.csv",
                                               "period_s,participation,mass_share\n"
                                               "0.5,1.2,0.8\n0.03,-0.2,0.1\n")}),
                 {"below twice the time step"});
  expect_refused(run({"--modes-across", "m.csv"}), {"--modes-across: needs --modes"});
  expect_refused(run({"--static-over-sliding", "0.5"}), {"static friction is not below"});
  expect_refused(run({"--fast-over-slow", "1.5"}), {"--fast-over-slow: needs --rate-s-per-m"});
  expect_refused(run({"--rate-s-per-m", "10"}), {"--rate-s-per-m: needs --fast-over-slow"});
  expect_refused(run({"--mass-ratio", "0.1"}), {"--mass-ratio: has no effect without a building"});
  expect_refused(run({"--vertical-period-s", "0.2"}), {"needs --vertical"});
  expect_refused(run({"--vertical-damping", "0.3"}), {"--vertical-damping"});
  expect_refused(run({"--damping", "0.2"}), {"--damping"});
  expect_refused(run({"--substeps", "64"}), {"--substeps"});
  const std::string history = folder_.path("h.csv").string();
  expect_refused(run({"--second", second_, "--history", history, "--period-s", "0.5"}),
                 {"--history: needs one axis, or two on a rigid roof", "both horizontal"});
  expect_refused(
      run({"--alpha", "5", "--period-s", "0.5", "--mass-ratio", "0.1", "--history", history}),
      {"--history", "several modes and is coupled"});
  expect_refused(run({"--method", "rodriguez-nikl", "--substeps", "2000000000"}),
                 {"--substeps", "steps"});
  expect_refused(run({"--fast-over-slow", "0.5", "--rate-s-per-m", "10", "--history", history}),
                 {"--history: needs one axis"});
  expect_refused(run({"--period-s", "0.5", "--mass-ratio", "0.1", "--method", "rodriguez-nikl"}),
                 {"--method: needs one axis"});
  expect_refused(run({"--second", "nowhere.txt"}), {"nowhere.txt"});
  expect_refused(
      run_program({"slide", first_, "--mu", "2", "--slope-deg", "45", "--period-s", "0.5",
                   "--mass-ratio", "1", "--fast-over-slow", "4", "--rate-s-per-m", "1"}),
      {"--mass-ratio", "no solution"});
  expect_refused(run_program({"slide", first_, "--mu", "10", "--slope-deg", "1"}),  // as studies
                 {"--mu: 10", "0 to 2"});
  expect_refused(run({"--period-s", "0.001", "--yield-coefficient", "0.2"}),
                 {"0.001 s", "rigid", "0.02 s"});
  const std::string nanoseconds =
      folder_.write("ns.txt", "# acceleration_g\n0 0\n1e-9 0.4\n2e-9 -0.4\n3e-9 0.1\n");
  expect_refused(run_program({"slide", nanoseconds, "--mu", "0.2", "--slope-deg", "0", "--period-s",
                              "0.5", "--mass-ratio", "0.1"}),
                 {"16,777,216 steps"});
}

}  // namespace
}  // namespace glissade::test
