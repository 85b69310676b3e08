// SPDX-License-Identifier: GPL-3.0-or-later
//
// `glissade slide` beyond one axis on a building that is not coupled with the array.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/shaking.hpp"
#include "facts.hpp"
#include "glissade/block/coupled.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade::test {
namespace {

using Json = nlohmann::json;

class SlideModel : public testing::Test {
 protected:
  Json slide_json(std::vector<std::string> options) const {
    options.insert(options.begin(), {"slide", first_, "--json"});
    const Finished child = run_program(options);
    EXPECT_EQ(child.status, 0) << child.err;
    return Json::parse(child.out);
  }
  /// `mu` and slope are given already.
  Finished run(std::vector<std::string> options) const {
    options.insert(options.begin(), {"slide", first_, "--mu", "0.2", "--slope-deg", "2"});
    return run_program(options);
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
    EXPECT_EQ(json["residual_displacement_m"], expected.slip.residual_displacement_m);
    EXPECT_EQ(json["peak_base_shear"][0], expected.peak_base_shear);
    EXPECT_THAT(json["model"].get<std::string>(), states("slide_coupled"));
  }
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
  const Finished child = run_program(
      {"slide", push, "--json", "--mu", "0.2", "--slope-deg", "0", "--clearance-m", "0.5"});
  const Json json = Json::parse(child.out);
  const double t = std::sqrt(0.5 / (0.15 * standard_gravity_mps2));
  EXPECT_NEAR(json["crossing_time_s"].get<double>(), t, 1e-12);
  EXPECT_NEAR(json["crossing_speed_mps"].get<double>(), 0.3 * standard_gravity_mps2 * t, 1e-12);
  const Json never = slide_json({"--mu", "2", "--slope-deg", "0", "--clearance-m", "0.5"});
  EXPECT_TRUE(never["crossing_time_s"].is_null());
}

TEST_F(SlideModel, friction_that_is_stronger_at_rest_holds_a_push_below_it) {
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(51, 0.23)));
  const auto peak = [&](const char* ratio) {
    return Json::parse(run_program({"slide", push, "--json", "--mu", "0.2", "--slope-deg", "0",
                                    "--static-over-sliding", ratio})
                           .out)["peak_displacement_m"]
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
  expect_refused(run({"--static-over-sliding", "0.5"}), {"static friction is not below"});
  expect_refused(run({"--fast-over-slow", "1.5"}), {"--fast-over-slow: needs --rate-s-per-m"});
  expect_refused(run({"--rate-s-per-m", "10"}), {"--rate-s-per-m: needs --fast-over-slow"});
  expect_refused(run({"--mass-ratio", "0.1"}), {"--mass-ratio: has no effect without a building"});
  expect_refused(run({"--vertical-period-s", "0.2"}), {"needs --vertical"});
  expect_refused(run({"--vertical-damping", "0.3"}), {"--vertical-damping"});
  expect_refused(run({"--damping", "0.2"}), {"--damping"});
  expect_refused(run({"--substeps", "64"}), {"--substeps"});
  expect_refused(run({"--second", second_, "--history", folder_.path("h.csv").string()}),
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
