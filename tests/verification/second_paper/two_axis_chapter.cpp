// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "glissade/block/coupled.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/biaxial.hpp"

namespace glissade::verification {
namespace {

using test::OnBuilding;

constexpr double pi = std::numbers::pi;
const std::string relative_to_slip = "largest difference, relative to the slip and 0.1 mm";

std::vector<double> made_up(unsigned seed, double peak_mps2) {
  return test::made_up_record(1200, seed, peak_mps2);
}

// -- where one axis or a rigid building is enough

Case one_axis() {
  double worst = 0.0;
  const std::vector<double> none(1200, 0.0);
  for (const unsigned seed : {1u, 2u})
    for (const double peak_mps2 : {4.0, 12.0})
      for (const double mu : {0.1, 0.3, 0.5})
        for (const double slope_deg : {0.0, 1.19, 4.0, 7.0})
          for (const double across : {1.0, 0.6}) {
            const auto a = made_up(seed, peak_mps2), w = made_up(seed + 100, 3.0);
            const SlipResult one = slide({0.005, a, w}, {mu, slope_deg * rad_per_deg});
            const SlipResult two =
                slide_two_axis({0.005, {a, none}, w}, {{mu, across * mu}, slope_deg * rad_per_deg});
            const double size = one.peak_displacement_m + 1e-4;
            for (const double d :
                 {two.peak_displacement_m - one.peak_displacement_m,
                  two.residual.along_m - one.residual.along_m,
                  two.peak_downslope_m - one.peak_downslope_m, two.residual.across_m})
              worst = worse(worst, std::abs(d) / size);
          }
  return limit({"slide_two_axis(), roof that moves along the slope, 96 made-up scenes", "slip",
                "slide()", ReferenceFrom::this_code},
               {relative_to_slip, worst, 1e-12});
}

/// The roofs of every other scene fall toward the motion's minus side.
Case coupled_one_axis() {
  std::mt19937 random(3);
  double worst = 0.0;
  for (unsigned k = 0; k < 40; ++k) {
    OnBuilding scene(random, k, 400);
    scene.second.clear();
    scene.tolerance = 1e-7;
    const double toward = k % 2 == 0 ? -1.0 : 1.0;
    scene.block.azimuth_rad = toward < 0.0 ? pi : 0.0;
    const SlipResult two = scene.result().slip;
    const SlipResult one =
        slide_coupled(
            {scene.dt_s, scene.first, scene.up}, {scene.factor, scene.factor},
            {scene.building.horizontal[0][0].oscillator(), scene.building.mass_ratio, {}},
            {.friction = scene.block.friction.along, .slope_rad = toward * scene.block.slope_rad})
            .slip;
    const double size = one.peak_displacement_m + 1e-4;
    for (const double d : {two.peak_displacement_m - one.peak_displacement_m,
                           two.residual.along_m - one.residual.along_m, two.residual.across_m})
      worst = worse(worst, std::abs(d) / size);
  }
  return limit({"slide_on_building() to 1e-7, ground that moves along the slope, 40 made-up scenes "
                "with m/M up to 0.5",
                "slip", "slide_coupled()", ReferenceFrom::this_code},
               {relative_to_slip, worst, 3e-6});
}

// -- which way it lies, and Walters et al.'s measure

/// A building alike on both axes, coupled with a block that slides by decimetres on its round
/// friction.
OnBuilding round_building(double slope_deg) {
  OnBuilding scene;
  scene.building = {{Oscillator{0.5, 0.05}, Oscillator{0.5, 0.05}}, {}, 0.1};
  scene.block = {{0.15, 0.15}, slope_deg * rad_per_deg, 0.0};
  scene.factor = 3.0;
  scene.tolerance = 1e-8;
  return scene;
}

/// On a flat roof no direction is marked.
Case round_scene() {
  OnBuilding scene = round_building(0.0);
  const SlipResult one = scene.result().slip;
  double worst = 0.0;
  for (const double angle : {0.3, 0.5 * pi, 2.0, 4.0}) {
    scene.block.azimuth_rad = angle;
    const SlipResult r = scene.result().slip;
    const double c = std::cos(angle), s = std::sin(angle), size = one.peak_displacement_m;
    for (const double d :
         {r.peak_displacement_m - one.peak_displacement_m, r.path_length_m - one.path_length_m,
          c * r.residual.along_m - s * r.residual.across_m - one.residual.along_m,
          s * r.residual.along_m + c * r.residual.across_m - one.residual.across_m})
      worst = worse(worst, std::abs(d) / size);
  }
  return limit(
      {"flat roof, circle of friction, building alike on both axes, m/M 0.1, four azimuths",
       "displacement vector, way", "azimuth 0"},
      {"largest difference, relative to the peak", worst, 1e-7});
}

/// With motion and slope turned together.
Case turned_scene() {
  const OnBuilding scene = round_building(2.0);
  const SlipResult one = scene.result().slip;
  double worst = 0.0;
  for (const double angle : {0.7, 2.0}) {
    OnBuilding turned = scene;
    turned.block.azimuth_rad += angle;
    for (std::size_t i = 0; i < scene.first.size(); ++i) {
      turned.first[i] = std::cos(angle) * scene.first[i] - std::sin(angle) * scene.second[i];
      turned.second[i] = std::sin(angle) * scene.first[i] + std::cos(angle) * scene.second[i];
    }
    worst = worse(worst, displacement_difference(turned.result().slip, one));
  }
  return limit({"slope of 2 deg, building alike on both axes; motion and slope turned together",
                "displacement vector", "not turned"},
               {relative_to_slip, worst, 1e-7});
}

/// Walters et al.'s displacement of a history, on rigid roofs.
Case srss_of_maxima() {
  std::mt19937 random(13);
  int wrong = 0, scenes = 0;
  for (unsigned k = 0; k < 40; ++k) {
    const OnBuilding scene(random, k, 400);
    const SlipResult r =
        slide_two_axis({scene.dt_s, {scene.first, scene.second}, scene.up}, scene.block);
    if (r.peak_displacement_m == 0.0) continue;
    ++scenes;
    const double ratio = srss_of_maxima_m(r) / r.peak_displacement_m;
    wrong += ratio >= 1.0 - 1e-12 && ratio <= std::numbers::sqrt2 + 1e-12 ? 0 : 1;
  }
  return all_equal({"SRSS of the axes' separate maxima over the longest vector", "ratio",
                    "Walters et al. 2012 call it conservative: from 1 to sqrt(2)"},
                   {wrong, scenes});
}

}  // namespace

Chapter second_paper_two_axes(const Folders& folders) {
  return {
      "2.3 Two axes", "Radau IIA of order 9 in long double",
      R"(Motion along both axes and the vertical at once. A curved path has a closed form in limits only.
`slide_two_axis()` (given roof) and `slide_on_building()` are compared with one axis, with closed forms,
with rotated versions of themselves, and with methods that share no code with them: Radau IIA in long double
(tests/two_axis_truth), and the implicit midpoint rule with small steps where springs yield.

The tolerance is the permitted error of the velocity in a step, relative to the largest speed. The error of
the longest displacement vector is in cases.csv for six tolerances, of 24 scenes: two motions of suite level
2; rigid building and buildings of 0.4 and 0.7 s with m/M 0 and 0.1; flat roof and 4 degrees at an azimuth
of 0.4 rad; mu 0.3 on a circle, and 0.3 by 0.2 on an ellipse.)",
      joined({{one_axis(), coupled_one_axis(), round_scene(), turned_scene(), srss_of_maxima()},
              two_axis_closed_forms(),
              two_axis_other_methods(),
              two_axis_convergence(folders)})};
}

}  // namespace glissade::verification
