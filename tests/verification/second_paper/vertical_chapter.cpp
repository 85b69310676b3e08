// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "glissade/block/peak_slip.hpp"
#include "glissade/io/suite_file.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/biaxial.hpp"
#include "verification/second_paper/scenes.hpp"

namespace glissade::verification {
namespace {

constexpr double g = standard_gravity_mps2;

// -- closed form

/// A rigid flat roof is pushed at `a` for good while the ground below an undamped vertical
/// oscillator is lifted at `w` for good: the roof goes up at w (1 - cos omega t), and the block,
/// sliding from the first moment, is left behind by
///   s = (a - mu (g + w)) t^2/2 + mu w (1 - cos omega t)/omega^2.
std::vector<Case> lifted_roof() {
  const double a = 5.0, w = 2.0, mu = 0.25, at_s = 1.0;
  double table_time = 0.0, table_speed = 0.0, full_time = 0.0, full_speed = 0.0;
  for (const double period_s : {0.1, 0.2, 0.3, 0.5}) {
    const double omega = 2.0 * std::numbers::pi / period_s, gain = a - mu * (g + w);
    for (const double share : {0.13, 0.5, 1.0}) {
      const double t = share * at_s;
      const std::vector<double> distance_m{0.5 * gain * t * t +
                                           mu * w * (1.0 - std::cos(omega * t)) / (omega * omega)};
      const double speed_mps = gain * t + mu * w * std::sin(omega * t) / omega;
      test::OnBuilding scene = at_rest(400);
      scene.first.assign(400, -a);
      scene.up.assign(400, w);
      scene.vertical = {period_s, 0.0};
      scene.block.friction = mu;
      std::vector<Crossing> full(1), table(1);
      scene.result(distance_m, full);
      peak_slip(
          tabulate_roof({scene.dt_s, scene.first, scene.up}, {.vertical = scene.vertical}, {}),
          {.friction = mu}, {}, distance_m, table);
      table_time = worse(table_time, relative(table[0].time_s, t));
      table_speed = worse(table_speed, relative(table[0].speed_mps, speed_mps));
      full_time = worse(full_time, relative(full[0].time_s, t));
      full_speed = worse(full_speed, relative(full[0].speed_mps, speed_mps));
    }
  }
  const std::string name =
                        "push of 5 m/s2 and lift of 2 m/s2 for good, undamped vertical of 0.1 to "
                        "0.5 s, mu 0.25, ",
                    metric = "largest relative difference",
                    form = "(a - mu (g + w)) t^2/2 + mu w (1 - cos omega t)/omega^2";
  return {
      limit({name + "peak_slip()", "when it has gone that far", form}, {metric, table_time, 1e-8}),
      limit({name + "peak_slip()", "how fast then", "its derivative"}, {metric, table_speed, 1e-8}),
      limit({name + "slide_on_building() to 1e-9", "when it has gone that far", form},
            {metric, full_time, 1e-8}),
      limit({name + "slide_on_building() to 1e-9", "how fast then", "its derivative"},
            {metric, full_speed, 1e-8})};
}

// -- kernels against each other

/// A motion of the suite on a building whose two axes are oscillators, m/M = 0: the tables' kernel,
/// slide_on_building(), and slide() over the roof's motion sampled finely.
struct Roof {
  const Motion& motion;
  Building building;
  Block block;

  GroundMotion ground() const {
    return {motion.dt_s, motion.horizontal_mps2[0], motion.vertical_mps2};
  }
  RoofMotionOptions follow() const {
    return {.quiet_horizontal_mps2 = 0.05,
            .quiet_vertical_mps2 = 0.05,
            .settle_deceleration_mps2 = 0.2,
            .steps_per_period = 4000};
  }
  SlipPeak by_tables() const {
    return peak_slip(tabulate_roof(ground(), building, follow()), block,
                     {motion.scale, motion.scale});
  }
  SlipResult by_samples() const {
    const RoofMotion roof = roof_motion(ground(), building, follow());
    return slide({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2, motion.scale, motion.scale},
                 block);
  }
  SlipResult on_building() const {
    test::OnBuilding scene;
    scene.dt_s = motion.dt_s;
    scene.first = motion.horizontal_mps2[0].copy();
    scene.second.clear();
    scene.up = motion.vertical_mps2.copy();
    scene.vertical = building.vertical;
    scene.factor = motion.scale;
    scene.building = {{building.horizontal, Oscillator{0.0}}, {}, 0.0};
    scene.block = block;
    scene.tolerance = 1e-8;
    return scene.result().slip;
  }
};

std::vector<Case> three_ways(const Suite& suite) {
  double full = 0.0, samples = 0.0;
  int scenes = 0;
  for (std::size_t m = 0; m < 2; ++m)
    for (const double period_s : {0.1, 0.2, 0.5})
      for (const double slope_deg : {0.0, 4.0}) {
        const Roof roof{suite.motions[m],
                        {{0.4, 0.05}, {period_s, 0.05}},
                        {.friction = 0.3, .slope_rad = slope_deg * rad_per_deg}};
        const SlipPeak tables = roof.by_tables();
        const SlipResult other = roof.on_building();
        const double size = tables.peak_displacement_m + 1e-4;
        ++scenes;
        full = worse(full, std::abs(other.peak_displacement_m - tables.peak_displacement_m) / size);
        full = worse(full, std::abs(other.residual.along_m - tables.residual.along_m) / size);
        samples = worse(samples, slip_difference(tables, roof.by_samples()));
      }
  const std::string name = fmt::format(
      "{} scenes: 2 motions of suite level 2, building of 0.4 s, vertical of 0.1, 0.2 and 0.5 s, "
      "slopes 0 and 4 deg, mu 0.3, m/M 0",
      scenes);
  const std::string metric = "largest difference, relative to the slip and 0.1 mm";
  return {
      limit({name, "slip, slide_on_building() to 1e-8", "peak_slip()", ReferenceFrom::this_code},
            {metric, full, 2e-6}),
      limit({name, "slip, peak_slip()", "slide() over the roof's motion in 4,000 samples a period",
             ReferenceFrom::this_code},
            {metric, samples, 2e-5})};
}

/// No period at all: the ground's own vertical.
Case rigid_vertical(const Suite& suite) {
  int differing = 0;
  for (std::size_t m = 0; m < 2; ++m) {
    const Motion& motion = suite.motions[m];
    const Roof roof{motion, {{0.0, 0.05}, {0.0, 0.05}}, {.friction = 0.3}};
    const SlipPeak through = roof.by_tables(),
                   direct = peak_slip(
                       RoofTable(motion.dt_s, motion.horizontal_mps2[0], motion.vertical_mps2),
                       roof.block, {motion.scale, motion.scale});
    differing += through.peak_displacement_m == direct.peak_displacement_m ? 0 : 1;
  }
  return all_equal({"vertical oscillator of period 0", "slip", "the ground's own vertical",
                    ReferenceFrom::this_code},
                   {differing, 2});
}

}  // namespace

Chapter second_paper_vertical(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  return {
      "2.6 Vertical through the building", "closed form of a lifted roof",
      R"(The paper recommends a study of vertical periods of 0.1 to 0.5 s. One case, in which the block slides from
the start, has a closed form. The three solvers are compared for a block without mass.)",
      joined({lifted_roof(), three_ways(suite), {rigid_vertical(suite)}})};
}

}  // namespace glissade::verification
