// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/block/on_building_reference.hpp"
#include "unit/block/truth_scenes.hpp"
#include "verification/second_paper/biaxial.hpp"

namespace glissade::verification {
namespace {

using test::OnBuilding;

constexpr double g = standard_gravity_mps2, pi = std::numbers::pi;

// -- closed forms

/// Thrown across a slope by a triangle of roof acceleration so short (2 ns) that friction and
/// gravity do nothing meanwhile.
Case curved_stop() {
  double worst = 0.0;
  for (const double speed_mps : {0.5, 2.0})
    for (const double mu : {0.2, 0.4})
      for (const double share : {0.0, 0.3, 0.8}) {
        const double slope = share * std::atan(mu), dt_s = 1e-9;
        std::vector<double> along(8, 0.0), across(8, 0.0);
        across[1] = -speed_mps / dt_s;
        const SlipResult r = slide_two_axis({dt_s, {along, across}}, {{mu, mu}, slope}, 1e-9);
        const double n = mu * g * std::cos(slope), d = g * std::sin(slope), margin = n * n - d * d;
        const double beta = 2.0 * n * speed_mps / (4.0 * n * n - d * d);
        worst = worse(worst, std::abs(r.slip_duration_s * margin / (n * speed_mps) - 1.0));
        worst = worse(worst, std::abs(r.residual.across_m / (beta * speed_mps) - 1.0));
        worst = worse(worst, std::abs(r.residual.along_m - std::cos(slope) * d * speed_mps *
                                                               speed_mps / (4.0 * margin)) /
                                 (beta * speed_mps));
      }
  return limit({"thrown at 0.5 and 2 m/s across slopes of 0 to 0.8 of the friction angle",
                "time to rest, and where",
                "n abs(v) + v.d is linear in time (two_axis.hpp), n friction and d drive"},
               {"largest relative difference", worst, 1e-7});
}

/// Friction mu g against the velocity, the rest of the drive A across it and turning it:
/// A^2 = (mu g)^2 + (omega v)^2. One cycle more adds one circle. 2,000 chords for a circle.
Case circling() {
  double worst = 0.0;
  const double peak_mps2 = 0.5 * g, omega = 2.0 * pi;
  for (const double mu : {0.1, 0.3, 0.45}) {
    const auto path_m = [&](int cycles) {
      std::vector<double> x, y;
      for (int i = 0; i <= cycles * 2000; ++i) {
        x.push_back(peak_mps2 * std::cos(pi * (i % 2000) / 1000.0));
        y.push_back(peak_mps2 * std::sin(pi * (i % 2000) / 1000.0));
      }
      return slide_two_axis({0.0005, {x, y}}, {{mu, mu}}).path_length_m;
    };
    const double speed_mps = std::sqrt(peak_mps2 * peak_mps2 - mu * g * mu * g) / omega;
    worst = worse(worst, std::abs((path_m(21) - path_m(20)) / speed_mps - 1.0));
  }
  return limit(
      {"roof that moves in a circle at 0.5 g once a second, mu 0.1, 0.3 and 0.45, steady",
       "way of a cycle", "sqrt((0.5 g)^2 - (mu g)^2)/omega times 1 s; 2,000 chords a cycle"},
      {"largest relative difference", worst, 1e-5});
}

// -- other methods

/// Made-up scenes that are quiet again soon.
OnBuilding quiet_scene(std::mt19937& random, unsigned seed) {
  OnBuilding scene(random, seed, 160);
  scene.factor = 2.0;
  for (Modes& o : scene.building.horizontal) o = {std::clamp(o.period_s(), 0.2, 1.0), 0.1};
  const double mu = std::max(scene.block.friction.along, 0.15);
  scene.block.friction = mu;
  scene.block.slope_rad *= 0.5;
  return scene;
}

Case yielding_by_the_midpoint_rule() {
  std::mt19937 random(7);
  double worst = 0.0;
  for (unsigned k = 0; k < 2; ++k) {
    OnBuilding scene = quiet_scene(random, k);
    scene.building.yielding = {Yielding{2.5, 0.05}, Yielding{2.0, 0.0}};
    const test::OnBuildingReference other(scene, 100, 4.0);
    const SlipResult r = scene.result().slip;
    for (const double d : {r.peak_displacement_m - other.peak_m, r.residual.along_m - other.along_m,
                           r.residual.across_m - other.across_m})
      worst = worse(worst, std::abs(d) / (other.peak_m + 1e-4));
  }
  return limit({"2 made-up scenes, m/M up to 0.5, both springs yield", "displacement vector",
                "implicit midpoint rule (Moreau 1988), 100 steps an interval: 1e-4 off itself"},
               {"largest difference, relative to the slip and 0.1 mm", worst, 5e-4});
}

struct Kind {
  std::string name;
  void (*make)(OnBuilding&);
};

Case independent_solver(const Kind& kind) {
  std::mt19937 random(7);
  double worst = 0.0;
  for (unsigned k = 0; k < 2; ++k) {
    OnBuilding scene = quiet_scene(random, k);
    kind.make(scene);
    scene.tolerance = 1e-10;
    const test::TwoAxisTruth truth(test::as_truth(scene));
    worst = worse(worst, test::error_of(scene.result().slip, truth));
  }
  return limit(
      {"2 made-up scenes, m/M up to 0.5, " + kind.name + "; tolerance 1e-10", "displacement vector",
       "Radau IIA of order 9 in long double (tests/two_axis_truth): 1e-12 off itself"},
      {"largest difference, relative to the peak", worst, 1e-9});
}

}  // namespace

std::vector<Case> two_axis_other_methods() {
  std::vector<Case> cases;
  for (const Kind& kind : std::vector<Kind>{
           {"circle of friction", [](OnBuilding&) {}},
           {"ellipse of friction, 0.7", [](OnBuilding& s) { s.block.friction.across *= 0.7; }},
           {"rigid on the second axis",
            [](OnBuilding& s) { s.building.horizontal[1][0].period_s = 0.0; }},
           {"static friction 1.3 times that of sliding",
            [](OnBuilding& s) { s.block.law.static_over_sliding = 1.3; }},
           {"friction that grows with speed by half", [](OnBuilding& s) {
              s.block.law = {1.0, 1.5, 30.0};
            }}})
    cases.push_back(independent_solver(kind));
  cases.push_back(yielding_by_the_midpoint_rule());
  return cases;
}

std::vector<Case> two_axis_closed_forms() { return {curved_stop(), circling()}; }

}  // namespace glissade::verification
