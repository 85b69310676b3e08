// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/io/suite_file.hpp"
#include "two_axis_truth/two_axis_truth.hpp"
#include "verification/second_paper/biaxial.hpp"

namespace glissade::verification {
namespace {

struct Scene {
  const Motion& motion;
  BuildingGround ground;
  MotionFactors factors;
  BiaxialBuilding building;
  Block block;

  double peak_m(double tolerance) const {
    return slide_on_building(ground, factors, building, block, tolerance).slip.peak_displacement_m;
  }
  double exact_peak_m() const {
    const auto& [first, second] = motion.horizontal_mps2;
    const test::TwoAxisTruth truth(
        {motion.dt_s, {first, second}, motion.vertical_mps2, factors, building, block}, 1e-9);
    return static_cast<double>(truth.peak_m);
  }
};

std::vector<Scene> scenes_of(const Suite& suite) {
  const BiaxialBuilding rigid{{Oscillator{0.0}, Oscillator{0.0}}, {}, 0.0},
      light{{Oscillator{0.4, 0.05}, Oscillator{0.7, 0.05}}, {}, 0.0},
      heavy{light.horizontal, {}, 0.1};
  std::vector<Scene> scenes;
  for (std::size_t m = 0; m < 2; ++m) {
    const Motion& motion = suite.motions[m];
    BuildingGround ground;
    for (std::size_t axis = 0; axis < 2; ++axis)
      ground.horizontal[axis] =
          std::make_shared<GroundTable>(motion.dt_s, motion.horizontal_mps2[axis]);
    ground.vertical = std::make_shared<const MotionTable>(
        tabulate_rigid(std::make_shared<GroundTable>(motion.dt_s, motion.vertical_mps2)));
    const double f = motion.scale;
    for (const BiaxialBuilding& building : {rigid, light, heavy})
      for (const double slope_deg : {0.0, 4.0})
        for (const double across : {0.3, 0.2})
          scenes.push_back({motion,
                            ground,
                            {{f, f}, f},
                            building,
                            {{0.3, across}, slope_deg * rad_per_deg, 0.4}});
  }
  return scenes;
}

}  // namespace

std::vector<Case> two_axis_convergence(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  const std::vector<Scene> scenes = scenes_of(suite);
  std::vector<double> truth;
  for (const Scene& s : scenes) truth.push_back(s.exact_peak_m());

  std::vector<Case> cases;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    std::vector<double> errors;
    double largest = 0.0;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      errors.push_back(std::abs(scenes[k].peak_m(tolerance) / truth[k] - 1.0));
      largest = worse(largest, errors[k]);
    }
    std::ranges::sort(errors);
    const std::string name = fmt::format("24 scenes, tolerance {:.0e}", tolerance);
    cases.push_back(limit({name, "longest displacement vector", "Radau IIA in long double"},
                          {"median relative difference", errors[errors.size() / 2], tolerance}));
    cases.push_back(limit({name, "longest displacement vector", "Radau IIA in long double"},
                          {"largest relative difference", largest, 3.0 * tolerance}));
  }
  return cases;
}

}  // namespace glissade::verification
