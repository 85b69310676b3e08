// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/slide.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "cli/json_of.hpp"
#include "cli/shaking.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

constexpr double g = standard_gravity_mps2;
constexpr double dt_s = shaking_dt_s;

class Slide : public testing::Test {
 protected:
  Json slide_json(const std::string& file, const std::vector<std::string>& options) const {
    return json_of({"slide", file}, options);
  }
  ScratchFolder folder_;
  std::string record_ = folder_.write("shaking.txt", two_columns(shaking_g()));
};

TEST_F(Slide, json_holds_every_key_scripts_rely_on) {
  const Json json = slide_json(record_, {"--mu", "0.2", "--slope-deg", "2"});
  for (const char* key :
       {"peak_displacement_m", "residual_displacement_m", "peak_downslope_m", "peak_upslope_m",
        "peak_velocity_mps", "slip_duration_s", "dt_s", "pga_g"}) {
    EXPECT_TRUE(json.at(key).is_number_float()) << key;
  }
  EXPECT_TRUE(json.at("slip_phases").is_number_unsigned());
  EXPECT_TRUE(json.at("uplift").is_boolean());
  EXPECT_EQ(json.at("samples"), 400);
  EXPECT_EQ(json.at("dt_s"), dt_s);
}

TEST_F(Slide, gives_what_the_library_gives_to_the_last_bit) {
  std::vector<double> a = times(g, shaking_g());
  const Block block{.friction = 0.2, .slope_rad = 2.0 * rad_per_deg};
  const SlipResult expected = slide({.dt_s = dt_s, .horizontal_mps2 = a}, block);
  const Json json = slide_json(record_, {"--mu", "0.2", "--slope-deg", "2"});
  ASSERT_GT(expected.peak_upslope_m, 0.0);  // a history worth comparing
  EXPECT_EQ(json["peak_displacement_m"], expected.peak_displacement_m);
  EXPECT_EQ(json["residual_displacement_m"], expected.residual.along_m);
  EXPECT_EQ(json["peak_downslope_m"], expected.peak_downslope_m);
  EXPECT_EQ(json["peak_upslope_m"], expected.peak_upslope_m);
  EXPECT_EQ(json["peak_velocity_mps"], expected.peak_velocity_mps);
  EXPECT_EQ(json["slip_duration_s"], expected.slip_duration_s);
  EXPECT_EQ(json["slip_phases"], expected.slip_phases);
  EXPECT_EQ(json["uplift"], false);
}

TEST_F(Slide, a_steady_push_on_a_flat_roof_has_its_closed_form) {
  // a = A for T, then linearly to zero over one step; relative to the roof the block is left
  // behind, toward -x.
  const double push = 0.5 * g, hold = 0.2 * g, t = 50 * dt_s;
  const double v1 = (push - hold) * t, d1 = v1 * t / 2;
  const double v2 = v1 + (push / 2 - hold) * dt_s,
               d2 = v1 * dt_s + (push / 3 - hold / 2) * dt_s * dt_s;
  const double distance = d1 + d2 + v2 * v2 / (2 * hold);
  const Json json = slide_json(folder_.write("push.txt", two_columns(std::vector<double>(51, 0.5))),
                               {"--mu", "0.2", "--slope-deg", "0"});
  EXPECT_NEAR(json["residual_displacement_m"], -distance, 1e-12 * distance);
  EXPECT_NEAR(json["peak_displacement_m"], distance, 1e-12 * distance);
  EXPECT_NEAR(json["slip_duration_s"], t + dt_s + v2 / hold, 1e-11);
  const double fade = dt_s * (1 - hold / push);  // until the push falls to the friction
  EXPECT_NEAR(json["peak_velocity_mps"],
              v1 + push * (fade - fade * fade / (2 * dt_s)) - hold * fade, 1e-12);
  EXPECT_EQ(json["slip_phases"], 1);
  EXPECT_NEAR(json["pga_g"], 0.5, 1e-15);
}

TEST_F(Slide, on_a_still_plane_too_steep_it_slides_by_half_a_t_squared) {
  const double slope = 7.0 * rad_per_deg, t = 100 * dt_s;
  const double distance =
      g * (std::sin(slope) - 0.1 * std::cos(slope)) * t * t / 2 * std::cos(slope);  // in plan
  const Json json =
      slide_json(folder_.write("still.txt", two_columns(std::vector<double>(101, 0.0))),
                 {"--mu", "0.1", "--slope-deg", "7"});
  EXPECT_NEAR(json["residual_displacement_m"], distance, 1e-12 * distance);
  EXPECT_EQ(json["free_sliding"], true);
}

TEST_F(Slide, a_mirrored_record_on_a_mirrored_roof_slides_downslope_alike) {
  const std::string mirrored = folder_.write("mirrored.txt", two_columns(times(-1.0, shaking_g())));
  const Json there = slide_json(record_, {"--mu", "0.2", "--slope-deg", "3"});
  const Json here = slide_json(mirrored, {"--mu", "0.2", "--slope-deg", "-3"});
  for (const char* key :
       {"residual_displacement_m", "peak_downslope_m", "peak_upslope_m", "slip_duration_s"})
    EXPECT_EQ(there[key], here[key]) << key;
}

TEST_F(Slide, twice_the_motion_on_twice_the_friction_slides_twice_as_far) {
  // theory.md, 1.7; a factor of two is exact in binary.
  const double once =
      slide_json(record_, {"--mu", "0.2", "--slope-deg", "0"})["peak_displacement_m"];
  const Json twice = slide_json(record_, {"--mu", "0.4", "--slope-deg", "0", "--scale", "2"});
  EXPECT_EQ(twice["peak_displacement_m"], 2.0 * once);
  EXPECT_EQ(twice["scale"], 2.0);
}

TEST_F(Slide, pga_g_scales_to_that_peak) {
  const double recorded_g = slide_json(record_, {"--mu", "0.2", "--slope-deg", "0"})["pga_g"];
  const Json wanted = slide_json(record_, {"--mu", "0.2", "--slope-deg", "0", "--pga-g", "1.25"});
  const Json scaled =
      slide_json(record_, {"--mu", "0.2", "--slope-deg", "0", "--scale", exact(1.25 / recorded_g)});
  EXPECT_NEAR(wanted["pga_g"], 1.25, 1e-14);
  EXPECT_NEAR(wanted["peak_displacement_m"], double(scaled["peak_displacement_m"]), 1e-12);
}

TEST_F(Slide, an_undamped_building_doubles_a_sudden_push) {
  // Absolute acceleration A (1 - cos 2 pi t / T): peak 2 A at T/2, a sample. The array does not
  // slide at 0.5 g with friction 0.75, and slides at 1 g.
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(101, 0.5)));
  const Json rigid = slide_json(push, {"--mu", "0.75", "--slope-deg", "0"});
  const Json soft =
      slide_json(push, {"--mu", "0.75", "--slope-deg", "0", "--period-s", "1", "--damping", "0"});
  EXPECT_EQ(rigid["peak_displacement_m"], 0.0);
  EXPECT_NEAR(soft["ppa_g"], 1.0, 1e-12);
  EXPECT_NEAR(soft["pga_g"], 0.5, 1e-15);
  EXPECT_GT(soft["peak_displacement_m"], 0.0);
}

TEST_F(Slide, the_vertical_changes_the_normal_force_as_in_the_library) {
  std::vector<double> a = times(g, shaking_g()), w = times(-0.5 * g, shaking_g());
  const std::string vertical = folder_.write("up.txt", two_columns(times(-0.5, shaking_g())));
  const SlipResult expected = slide({.dt_s = dt_s, .horizontal_mps2 = a, .vertical_mps2 = w},
                                    {.friction = 0.2, .slope_rad = 0.0});
  const Json json =
      slide_json(record_, {"--mu", "0.2", "--slope-deg", "0", "--vertical", vertical});
  EXPECT_EQ(json["residual_displacement_m"], expected.residual.along_m);
  EXPECT_NE(json["residual_displacement_m"],
            slide_json(record_, {"--mu", "0.2", "--slope-deg", "0"})["residual_displacement_m"]);
  EXPECT_EQ(json["vertical"], true);
}

TEST_F(Slide, reports_uplift_instead_of_passing_it_as_a_slip) {
  const std::string falling =
      folder_.write("falling.txt", two_columns(std::vector<double>(51, -1.5)));
  EXPECT_EQ(
      slide_json(record_, {"--mu", "0.5", "--slope-deg", "0", "--vertical", falling})["uplift"],
      true);
}

TEST_F(Slide, one_way_never_goes_upslope_and_ends_at_its_peak) {
  const Json json = slide_json(record_, {"--mu", "0.2", "--slope-deg", "1", "--one-way"});
  EXPECT_EQ(json["peak_upslope_m"], 0.0);
  EXPECT_GT(json["peak_downslope_m"], 0.0);
  EXPECT_EQ(json["residual_displacement_m"], json["peak_downslope_m"]);
}

TEST_F(Slide, the_published_scheme_comes_closer_with_its_substeps) {
  const auto peak = [&](std::vector<std::string> options) -> double {
    options.insert(options.begin(), {"--mu", "0.2", "--slope-deg", "2"});
    return slide_json(record_, options)["peak_displacement_m"];
  };
  const double event = peak({});
  const double coarse = peak({"--method", "rodriguez-nikl", "--substeps", "4"});
  const double fine = peak({"--method", "rodriguez-nikl", "--substeps", "4096"});
  EXPECT_NE(coarse, event);
  EXPECT_LT(std::abs(fine - event),
            0.01 * std::abs(coarse - event));  // first order: a factor of about 1000
}

TEST_F(Slide, history_ends_where_the_json_says) {
  const std::string file = folder_.path("history.csv").string();
  const Json json = slide_json(record_, {"--mu", "0.2", "--slope-deg", "2", "--history", file});
  std::vector<std::string> lines = lines_of(read_file(file));
  ASSERT_GT(lines.size(), 400u);  // every sample, and the events between them
  EXPECT_EQ(lines[0], "time_s,roof_acceleration_mps2,displacement_m,velocity_mps");
  double peak = 0.0, last_time = -1.0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = cells_of(lines[i]);
    ASSERT_EQ(cells.size(), 4u) << lines[i];
    EXPECT_GE(std::stod(cells[0]), last_time);
    last_time = std::stod(cells[0]);
    peak = std::max(peak, std::abs(std::stod(cells[2])));
  }
  EXPECT_EQ(std::stod(cells_of(lines.back())[2]), json["residual_displacement_m"]);
  EXPECT_EQ(std::stod(cells_of(lines.back())[3]), 0.0);
  EXPECT_EQ(peak, json["peak_displacement_m"]);
}

TEST_F(Slide, reads_an_at2_file_with_its_own_step) {
  std::string at2 =
      "PEER NGA STRONG MOTION DATABASE RECORD\nMade up, 2026, test, 090\nACCELERATION TIME SERIES "
      "IN UNITS OF G\n"
      "NPTS=    400, DT=   .0200 SEC,\n";
  const std::vector<double> a = shaking_g();
  for (std::size_t i = 0; i < a.size(); ++i) at2 += exact(a[i]) + (i % 5 == 4 ? "\r\n" : "  ");
  const Json from_at2 =
      slide_json(folder_.write("made_up.AT2", at2), {"--mu", "0.2", "--slope-deg", "2"});
  EXPECT_EQ(from_at2, slide_json(record_, {"--mu", "0.2", "--slope-deg", "2"}));
}

TEST_F(Slide, one_column_in_other_units_takes_dt_s_and_units) {
  std::string text;
  for (const double a : shaking_g()) text += exact(a * g * 100.0) + "\n";
  const Json json =
      slide_json(folder_.write("gal.txt", text),
                 {"--mu", "0.2", "--slope-deg", "2", "--dt-s", "0.02", "--units", "cm/s2"});
  const double expected =
      slide_json(record_, {"--mu", "0.2", "--slope-deg", "2"})["peak_displacement_m"];
  EXPECT_NEAR(json["peak_displacement_m"], expected, 1e-12);
}

TEST_F(Slide, text_fits_a_terminal) {
  for (const char* scale : {"1", "9"}) {
    const Finished child = succeeding({"slide", record_, "--mu", "0.2", "--slope-deg", "15",
                                       "--scale", scale, "--period-s", "0.5"});
    EXPECT_THAT(child.out, states("FREE SLIDING"));
    for (const std::string& line : lines_of(child.out)) EXPECT_LE(line.size(), 80u) << line;
  }
}

// -- tipping. The push of 0.5 g: a body of width / (2 height) = 0.25 rocks from 0.25 g on.

TEST_F(Slide, a_body_held_by_friction_tips_where_its_base_is_too_narrow) {
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(51, 0.5)));
  std::vector<std::string> options{
      "--mu", "0.9", "--slope-deg", "0", "--centre-of-mass-height-m", "1", "--base-width-m", "0.5"};
  for (const char* method : {"event", "rodriguez-nikl"}) {
    auto all = options;
    all.insert(all.end(), {"--method", method});
    const Json json = slide_json(push, all);
    EXPECT_EQ(json["tips"], true);
    EXPECT_NEAR(json["tipping_scale"], 0.5, 1e-15);
    EXPECT_EQ(json["peak_displacement_m"], 0.0);
  }
  options.insert(options.end(), {"--scale", "0.49"});
  EXPECT_EQ(slide_json(push, options)["tips"], false);
  EXPECT_NEAR(slide_json(push, options)["tipping_scale"], 0.5, 1e-15);  // on the record as it is
}

TEST_F(Slide, a_body_that_slides_first_never_tips) {
  const Json json =
      slide_json(record_, {"--mu", "0.25", "--slope-deg", "0", "--centre-of-mass-height-m", "1",
                           "--base-width-m", "0.5", "--scale", "9"});
  EXPECT_EQ(json["tips"], false);
  EXPECT_TRUE(json.at("tipping_scale").is_null());
}

TEST_F(Slide, a_building_tips_a_body_in_its_ring_down_at_any_scale_asked_for) {
  // A pulse much shorter than the period: the building swings furthest after it, while the ground
  // is quiet, and a small scale needs no ring-down.
  const std::vector<double> pulse(11, 0.1);
  const std::string file = folder_.write("pulse.txt", two_columns(pulse));
  const auto scale_of = [&](const char* scale) -> double {
    return slide_json(file, {"--mu", "0.9", "--slope-deg", "0", "--period-s", "1", "--damping",
                             "0.02", "--centre-of-mass-height-m", "1", "--base-width-m", "0.5",
                             "--scale", scale})["tipping_scale"];
  };
  const double well_followed = scale_of("100");
  EXPECT_NEAR(scale_of("1e-6"), well_followed, 1e-12 * well_followed);
}

TEST_F(Slide, without_a_base_the_json_has_no_tipping) {
  const Json json = slide_json(record_, {"--mu", "0.9", "--slope-deg", "0"});
  EXPECT_FALSE(json.contains("tips"));
  EXPECT_FALSE(json.contains("tipping_scale"));
}

TEST_F(Slide, refuses_a_factor_that_no_kernel_takes) {
  expect_refused(
      run_program({"slide", record_, "--mu", "0.9", "--slope-deg", "0", "--scale", "1e80"}),
      {"1e+80", "too large"});
}

TEST_F(Slide, refuses_half_a_base_and_sizes_that_are_none) {
  expect_refused(run_program({"slide", record_, "--mu", "0.9", "--slope-deg", "0",
                              "--centre-of-mass-height-m", "1"}),
                 {"--centre-of-mass-height-m", "give --base-width-m too"});
  expect_refused(
      run_program({"slide", record_, "--mu", "0.9", "--slope-deg", "0", "--base-width-m", "1"}),
      {"--base-width-m", "give --centre-of-mass-height-m too"});
  expect_refused(run_program({"slide", record_, "--mu", "0.9", "--slope-deg", "0",
                              "--centre-of-mass-height-m", "0", "--base-width-m", "inf"}),
                 {"--centre-of-mass-height-m: 0 must be > 0", "--base-width-m: inf must be > 0"});
}

TEST_F(Slide, text_reports_whether_the_body_tips) {
  const std::string push = folder_.write("push.txt", two_columns(std::vector<double>(51, 0.5)));
  const auto text = [&](const char* mu, const char* scale) {
    return run_program({"slide", push, "--mu", mu, "--slope-deg", "0", "--centre-of-mass-height-m",
                        "1", "--base-width-m", "0.5", "--scale", scale})
        .out;
  };
  EXPECT_THAT(text("0.9", "1"), states("TIPPING", "0.5", "PGA 0.25 g"));
  EXPECT_THAT(text("0.9", "0.4"), states("0.5", "PGA 0.25 g"));
  EXPECT_THAT(text("0.9", "0.4"), testing::Not(states("TIPPING")));
  EXPECT_THAT(text("0.2", "1"), states("cannot tip", "0.25"));
}

TEST_F(Slide, text_says_what_the_numbers_are) {
  const Finished child = run_program({"slide", record_, "--mu", "0.2", "--slope-deg", "2"});
  EXPECT_EQ(child.status, 0);
  EXPECT_EQ(child.err, "");
  EXPECT_THAT(child.out, states("400 samples, 0.02 s", "in plan", "peak", "residual", "downslope",
                                "upslope", "m"));
}

}  // namespace
}  // namespace glissade::test
