// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "chapters.hpp"
#include "closed_forms/cantilever.hpp"
#include "unit/block/truth_scenes.hpp"
#include "unit/study/shear_frame.hpp"

namespace glissade::verification {
namespace {

using std::numbers::pi;
using test::modes_of;
using test::OnBuilding;
using test::ShearBuilding;
using test::StoreyScene;
using test::three_storeys;

// -- modes

double difference(const Mode& a, const Mode& b) {
  return std::max({std::abs(a.period_s - b.period_s), std::abs(a.participation - b.participation),
                   std::abs(a.mass_share - b.mass_share)});
}

Case cantilever(double alpha) {
  const std::vector<Mode> modes = cantilever_modes(1.0, alpha, 5);
  const closed_forms::Cantilever reference(alpha);
  double worst = 0.0;
  for (int n = 0; n < 5; ++n)
    worst = worse(worst, difference(modes[static_cast<std::size_t>(n)], reference.mode(n)));
  return limit({fmt::format("cantilever of flexure and shear, alpha {:g}, five modes", alpha),
                "period ratio, participation, mass share",
                "equations of Miranda & Taghavi 2005 in 100 digits"},
               {"largest difference", worst, 2e-8});
}

Case equal_storeys(int storeys) {
  const std::vector<double> ones(static_cast<std::size_t>(storeys), 1.0);
  const std::vector<Mode> modes = shear_building_modes(ones, ones);
  double worst = 0.0;
  for (int n = 0; n < storeys; ++n) {
    const test::ChainMode chain(storeys, n + 1, 1.0, 1.0);
    worst = worse(
        worst, difference(modes[static_cast<std::size_t>(n)],
                          {2.0 * pi / chain.omega_radps, chain.participation, chain.mass_share}));
  }
  return limit({fmt::format("shear building of {} equal storeys", storeys),
                "period, participation, mass share", "closed form, 2 sin((2n - 1) pi/(4N + 2))"},
               {"largest difference", worst, 1e-11});
}

// -- the array without friction, and stuck

/// On a flat roof without friction the array does not move: its slip is the motion of the roof.
Case without_friction() {
  OnBuilding scene;
  scene.second.clear();
  scene.block = {};
  scene.tolerance = 1e-9;
  const Modes modes(cantilever_modes(0.6, 5.0, 4));
  const auto residual_m = [&](const Modes& axis, double mass_ratio) {
    scene.building = {{axis, Modes()}, {}, mass_ratio};
    return scene.result().slip.residual.along_m;
  };
  double sum_m = modes.ground_share() * residual_m(Modes(), 0.0), size_m = std::abs(sum_m);
  for (const Mode& mode : modes) {
    const double part_m = mode.participation * residual_m(mode.oscillator(), 0.0);
    sum_m += part_m;
    size_m += std::abs(part_m);
  }
  return limit({"array without friction, cantilever of four modes, m/M 0.3", "residual slip",
                "sum over one-mass buildings, by participation"},
               {"difference, relative to the sum of the parts",
                std::abs(residual_m(modes, 0.3) - sum_m) / size_m, 1e-7});
}

ShearBuilding with_the_array(ShearBuilding building, double mass_ratio) {
  building.masses.back() +=
      mass_ratio * std::accumulate(building.masses.begin(), building.masses.end(), 0.0);
  return building;
}

/// Undamped, both buildings have normal modes: those with M, and those with M + m at the roof.
/// Both are followed over two minutes.
std::vector<Case> stuck_in_free_vibration(double mass_ratio) {
  OnBuilding scene(2, 300, 4.0);
  scene.second.clear();
  scene.first.resize(12000, 0.0);
  scene.first.back() = 1e-9;
  scene.block.friction = 5.0;
  const ShearBuilding building = three_storeys(1.0, 0.0);
  scene.building = {{modes_of(building), Modes()}, {}, mass_ratio};
  const BuildingSlip carries = scene.result();
  scene.building = {{modes_of(with_the_array(building, mass_ratio)), Modes()}, {}, 0.0};
  const BuildingSlip heavier = scene.result();
  return compare_all(
      fmt::format("stuck array, m/M {}, three storeys, undamped: a motion of 3 s and two minutes "
                  "of free vibration",
                  mass_ratio),
      "normal modes of the building with M + m at the roof",
      {{"roof displacement, m",
        {carries.peak_roof_displacement_m[0], heavier.peak_roof_displacement_m[0], 1e-9}},
       {"base shear over weight",
        {carries.peak_base_shear[0], (1.0 + mass_ratio) * heavier.peak_base_shear[0], 1e-9}}});
}

/// The ground's harmonic grows for 40 s and fades for 40 s; being piecewise linear it has sinc^2 of
/// its amplitude.
Case stuck_in_harmonic_motion(double period_s) {
  constexpr double mass_ratio = 0.4, dt_s = 0.01, peak_mps2 = 0.5;
  OnBuilding scene;
  scene.dt_s = dt_s;
  scene.first.assign(10000, 0.0);
  scene.second.clear();
  scene.up.clear();
  const double omega = 2.0 * pi / period_s;
  for (std::size_t i = 0; i < scene.first.size(); ++i) {
    const double t = dt_s * static_cast<double>(i);
    const double rise = std::sin(0.5 * pi * std::min({t / 40.0, 1.0, (100.0 - t) / 40.0}));
    scene.first[i] = peak_mps2 * rise * rise * std::sin(omega * t);
  }
  scene.block = {{5.0, 5.0}};
  const ShearBuilding building = three_storeys();
  scene.building = {{modes_of(building), Modes()}, {}, mass_ratio};
  const test::ShearFrame frame(building.masses, building.stiffnesses, building.damping_ratio);
  const double arg = 0.5 * omega * dt_s;
  const double amplitude_mps2 = peak_mps2 * std::pow(std::sin(arg) / arg, 2);
  const double array =
      mass_ratio * std::accumulate(building.masses.begin(), building.masses.end(), 0.0);
  return compare(
      {fmt::format("stuck array, m/M 0.4, three storeys, 5 %, harmonic ground of {} s", period_s),
       "roof displacement, m", "dynamic stiffness of the full matrices with M + m"},
      {scene.result().peak_roof_displacement_m[0],
       amplitude_mps2 * frame.roof_amplitude_m(omega, array), 1e-3});
}

// -- the array sliding

Case sliding(bool two_axes, double mass_ratio) {
  double worst = 0.0;
  for (const unsigned seed : {3u, 8u}) {
    StoreyScene s(seed, mass_ratio, two_axes);
    s.scene.block.friction.across *= 0.7;
    s.scene.tolerance = 1e-10;
    worst = worse(worst, test::error_of(s.scene.result().slip, s.truth()));
  }
  return limit({fmt::format("three storeys, {}, m/M {}, two made-up scenes; tolerance 1e-10",
                            two_axes ? "two axes, ellipse of friction" : "one axis", mass_ratio),
                "displacement vector",
                "full matrices, Radau IIA of order 9 in long double (tests/two_axis_truth)"},
               {"largest difference, relative to the peak", worst, 2e-7});
}

Case on_roof_motions() {
  double worst = 0.0;
  for (const double mu : {0.1, 0.3}) {
    StoreyScene s(3, 0.0, false);
    s.scene.block.friction = mu;
    s.scene.up.clear();
    const double of_modes_m = s.scene.result().slip.peak_displacement_m;
    const ShearBuilding& building = s.storeys[0];
    constexpr int parts = 300;
    const test::ShearFrame frame(building.masses, building.stiffnesses, building.damping_ratio);
    s.scene.first = frame.roof_mps2(s.scene.dt_s, s.scene.first, parts, 8.0);
    s.scene.dt_s /= parts;
    s.scene.building = {};
    worst = worse(worst, std::abs(s.scene.result().slip.peak_displacement_m / of_modes_m - 1.0));
  }
  return limit({"roof motion of three storeys in 300 steps a sample, friction 0.1 and 0.3",
                "displacement", "full matrices by their exponential (tests/unit/study)"},
               {"largest relative difference to the building by its modes", worst, 1e-6});
}

// -- laws

Case mirrored_and_scaled(double mass_ratio) {
  const OnBuilding scene = StoreyScene(3, mass_ratio, true).scene;
  const std::vector<double> one = test::numbers(scene.result());
  OnBuilding mirrored = scene;
  mirrored.block.azimuth_rad = -scene.block.azimuth_rad;
  for (double& a : mirrored.second) a = -a;
  std::vector<double> image = test::numbers(mirrored.result());
  image[2] = -image[2];
  OnBuilding stronger = scene;
  stronger.factor *= 4.0;
  stronger.block.gravity_mps2 *= 4.0;
  std::vector<double> more = test::numbers(stronger.result());
  for (const std::size_t k : {0u, 1u, 2u, 3u, 4u, 8u, 9u}) more[k] /= 4.0;
  int differing = 0;
  for (std::size_t k = 0; k < one.size(); ++k)
    differing += (image[k] != one[k]) + (more[k] != one[k]);
  return all_equal({fmt::format("three storeys, two axes, m/M {}: the second axis mirrored; motion "
                                "and gravity four times as large",
                                mass_ratio),
                    "ten numbers of a history", "mirrored, and four times as large"},
                   {differing, 20});
}

void strong_coupling(const auto& add) {
  double worst = 0.0, worst_shear = 0.0;
  int differing = 0;
  for (const test::StrongCoupling& of : test::strong_couplings) {
    const test::ModesReference truth = of.truth();
    const BuildingSlip r = of.scene().result();
    worst = worse(worst, std::abs(r.slip.peak_displacement_m / truth.peak_m - 1.0));
    worst_shear = worse(worst_shear, std::abs(r.peak_base_shear[0] / truth.base_shear - 1.0));
    differing += r.slip.slip_phases != static_cast<std::size_t>(truth.phases);
  }
  const char* scene =
      "cantilevers of 0.9 s, m/M 0.05 to 1 (times the sum of gamma^2 / e: 0.9 to 12), harmonic "
      "ground, one axis";
  const char* reference = "Runge-Kutta between bisected events, in long double";
  add(limit({scene, "peak displacement", reference}, {"largest relative difference", worst, 1e-6}));
  add(limit({scene, "base shear", reference}, {"largest relative difference", worst_shear, 1e-3}));
  add(all_equal({scene, "number of phases", reference}, {differing, 4}));
}

Case one_mass_among_modes(double mass_ratio) {
  OnBuilding scene;
  scene.building.mass_ratio = mass_ratio;
  const std::vector<double> one = test::numbers(scene.result());
  for (Modes& axis : scene.building.horizontal) {
    const double period_s = axis.period_s();
    const Mode among[] = {
        {2.0 * period_s, 0.0, 0.1, 0.02}, {period_s, 1.0, 1.0, 0.05}, {0.05, 0.0, 0.1, 0.0}};
    axis = Modes(among);
  }
  const std::vector<double> three = test::numbers(scene.result());
  int differing = 0;
  for (std::size_t k = 0; k < one.size(); ++k) differing += three[k] != one[k];
  return all_equal({fmt::format("one mass among modes without participation, m/M {}", mass_ratio),
                    "ten numbers of a history", "one mass"},
                   {differing, 10});
}

}  // namespace

Chapter buildings_of_storeys() {
  Chapter chapter{
      "4.2 Buildings of several storeys",
      "full matrices in long double",
      R"(Modes are compared with closed forms and with the published equations in 100 digits. An array on them is
compared with the full matrices of mass, damping and stiffness: in closed form without friction and stuck,
by Radau IIA while it slides. One that is heavy for the modes must start and stop as between exact events.)",
      {}};
  const auto add = [&](Case c) { chapter.cases.push_back(std::move(c)); };
  for (const double alpha : {0.5, 2.0, 10.0, 30.0}) add(cantilever(alpha));
  for (const int storeys : {1, 3, 12}) add(equal_storeys(storeys));
  add(without_friction());
  for (const double mass_ratio : {0.1, 0.5})
    for (Case& c : stuck_in_free_vibration(mass_ratio)) add(std::move(c));
  for (const double period_s : {0.2, 0.5, 1.5}) add(stuck_in_harmonic_motion(period_s));
  for (const bool two_axes : {false, true})
    for (const double mass_ratio : {0.0, 0.1, 0.4}) add(sliding(two_axes, mass_ratio));
  strong_coupling(add);
  add(on_roof_motions());
  for (const double mass_ratio : {0.0, 0.2}) add(mirrored_and_scaled(mass_ratio));
  for (const double mass_ratio : {0.0, 0.2}) add(one_mass_among_modes(mass_ratio));
  return chapter;
}

}  // namespace glissade::verification
