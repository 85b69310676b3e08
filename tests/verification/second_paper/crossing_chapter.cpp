// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "glissade/block/peak_slip.hpp"
#include "glissade/io/suite_file.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/biaxial.hpp"
#include "verification/second_paper/scenes.hpp"

namespace glissade::verification {
namespace {

constexpr double g = standard_gravity_mps2;
const std::vector<double> thresholds_m{0.001, 0.01, 0.1, 1.0};

/// Differences of first crossings: in time as the way made meanwhile, so that near a stop, where
/// speed goes as the root of what is left, nothing is asked that cannot be had.
struct Difference {
  double time_s = 0.0, speed_mps = 0.0;
  int mismatches = 0, crossed = 0;

  void add(std::span<const Crossing> found, std::span<const Crossing> expected) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].happens() != expected[i].happens()) ++mismatches;
      if (!found[i].happens() || !expected[i].happens()) continue;
      ++crossed;
      time_s = worse(time_s, std::abs(found[i].time_s - expected[i].time_s));
      speed_mps = worse(speed_mps, std::abs(found[i].speed_mps - expected[i].speed_mps));
    }
  }
};

/// Against another scheme of this code.
std::vector<Case> rows(const std::string& name, const std::string& reference, const Difference& d,
                       double close) {
  return {all_equal({name, "thresholds that are reached", reference, ReferenceFrom::this_code},
                    {d.mismatches, d.crossed}),
          limit({name, "time of first crossing", reference, ReferenceFrom::this_code},
                {"largest difference, s", d.time_s, close}),
          limit({name, "speed there", reference, ReferenceFrom::this_code},
                {"largest difference, m/s", d.speed_mps, close})};
}

// -- constant push

std::vector<Case> constant_push() {
  const double mu = 0.3;
  double time = 0.0, speed = 0.0;
  for (const double slope_deg : {0.0, 4.0})
    for (const double push_mps2 : {-5.0, -9.0}) {
      const double slope = slope_deg * rad_per_deg, c = std::cos(slope), s = std::sin(slope);
      const double gain_mps2 =
          c * (g * s - push_mps2 * c - mu * (g * c + push_mps2 * s));  // in plan
      const Block block{.friction = mu, .slope_rad = slope};
      const std::vector<double> push(200, push_mps2), none(200, 0.0);
      std::vector<std::vector<Crossing>> found(4, std::vector<Crossing>(thresholds_m.size()));
      slide({0.01, push}, block, thresholds_m, found[0]);
      peak_slip(RoofTable(0.01, push), block, {}, thresholds_m, found[1]);
      slide_coupled({0.01, push}, {}, {{0.0, 0.05}, 0.2, {}}, block, thresholds_m, found[2]);
      test::OnBuilding scene = at_rest(200);
      scene.dt_s = 0.01;
      scene.first = push;
      scene.block = {{mu, mu}, slope, 0.0};
      scene.result(thresholds_m, found[3]);
      for (const std::vector<Crossing>& crossings : found)
        for (std::size_t i = 0; i < thresholds_m.size(); ++i) {
          const double expected_s = std::sqrt(2.0 * thresholds_m[i] / gain_mps2);
          time = worse(time, relative(crossings[i].time_s, expected_s));
          speed = worse(speed, relative(crossings[i].speed_mps, gain_mps2 * expected_s));
        }
    }
  const std::string name =
      "constant push of 5 and 9 m/s2 on slopes of 0 and 4 deg, mu 0.3, thresholds of 1 mm to 1 m, "
      "four kernels";
  return {
      limit({name, "time of first crossing", "sqrt(2 d/a), a what the block gains in plan"},
            {"largest relative difference", time, 1e-10}),
      limit({name, "speed there", "sqrt(2 a d)"}, {"largest relative difference", speed, 1e-10})};
}

/// Met only as the block stops, and not at all beyond.
Case at_the_peak() {
  const MadeUpGround ground;
  int wrong = 0, scenes = 0;
  for (const CoupledScene& s : coupled_scenes(60, 6)) {
    const auto result = [&](std::span<const double> thresholds, std::span<Crossing> crossings) {
      return slide_coupled(ground.motion(), s.factors, s.building, s.block, thresholds, crossings)
          .slip.peak_displacement_m;
    };
    const double peak_m = result({}, {});
    if (peak_m == 0.0) continue;
    ++scenes;
    const std::vector<double> around{peak_m, std::nextafter(peak_m, 1e9)};
    std::vector<Crossing> found(2);
    result(around, found);
    wrong += found[0].speed_mps == 0.0 && !found[1].happens() ? 0 : 1;
  }
  return all_equal({"thresholds of the peak displacement and one rounding above, slide_coupled()",
                    "crossings", "the first at speed 0, the second none"},
                   {wrong, scenes});
}

// -- kernels against each other

std::vector<Case> tabulated(const Suite& suite) {
  Difference d;
  for (const Motion& m : suite.motions) {
    const RoofTable table(m.dt_s, m.horizontal_mps2[0], m.vertical_mps2);
    for (const double mu : {0.2, 0.4})
      for (const double slope_deg : {0.0, 4.0}) {
        const Block block{.friction = mu, .slope_rad = slope_deg * rad_per_deg};
        std::vector<Crossing> found(thresholds_m.size()), expected(thresholds_m.size());
        peak_slip(table, block, {m.scale, m.scale}, thresholds_m, found);
        slide({m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, m.scale, m.scale}, block,
              thresholds_m, expected);
        d.add(found, expected);
      }
  }
  return rows(
      "peak_slip(), 7 motions of suite level 2 on a rigid roof, mu 0.2 and 0.4, slopes 0 and 4 deg",
      "slide()", d, 1e-9);
}

std::vector<Case> on_building() {
  std::mt19937 random(11);
  Difference d;
  for (unsigned k = 0; k < 30; ++k) {
    test::OnBuilding scene(random, k, 400);
    scene.second.clear();
    scene.block.azimuth_rad = 0.0;
    scene.tolerance = 1e-8;
    std::vector<Crossing> found(thresholds_m.size()), expected(thresholds_m.size());
    scene.result(thresholds_m, found);
    slide_coupled({scene.dt_s, scene.first, scene.up}, {scene.factor, scene.factor},
                  {scene.building.horizontal[0][0].oscillator(), scene.building.mass_ratio, {}},
                  {.friction = scene.block.friction.along, .slope_rad = scene.block.slope_rad},
                  thresholds_m, expected);
    d.add(found, expected);
  }
  return rows("slide_on_building() to 1e-8, 30 made-up scenes moved along the slope",
              "slide_coupled()", d, 1e-5);
}

}  // namespace

Chapter second_paper_crossings(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  return {
      "2.5 Impact", "closed forms",
      R"(Time and speed at which the block first reaches a given distance, by each kernel. Near a stop the speed, and
its error, is proportional to the square root of the remaining distance.)",
      joined({constant_push(), {at_the_peak()}, tabulated(suite), on_building()})};
}

}  // namespace glissade::verification
