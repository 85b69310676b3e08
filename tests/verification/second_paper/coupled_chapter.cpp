// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "closed_forms/steady_slip.hpp"
#include "unit/block/coupled_reference.hpp"
#include "unit/block/oscillator_reference.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/scenes.hpp"

namespace glissade::verification {
namespace {

const std::string relative_to_slip = "largest difference, relative to the slip and 0.1 mm";

// -- what it becomes where array or building is of one kind

Case without_mass() {
  const auto a = test::made_up_record(1000, 1, 7.0);
  double worst = 0.0;
  for (const double period_s : {0.1, 0.3, 0.6, 1.2})
    for (const double slope_deg : {0.0, 4.0})
      for (const double mu : {0.1, 0.25}) {
        const Block block{.friction = mu, .slope_rad = slope_deg * rad_per_deg};
        std::vector<CoupledPoint> history;
        const SlipResult r =
            slide_coupled({0.01, a}, {}, {{period_s, 0.05}, 0.0, {}}, block, history).slip;
        const double ring_down_s = std::max(history.back().time_s - 10.0, 0.0) + 0.5;
        const test::OscillatorReference exact(0.01, a, period_s, 0.05, 1.0, block, ring_down_s, 16);
        const double size = std::max(exact.down, exact.up) + 1e-4;
        for (const double d : {r.peak_downslope_m - exact.down, r.peak_upslope_m - exact.up,
                               r.residual.along_m - exact.residual})
          worst = worse(worst, std::abs(d) / size);
      }
  return limit({"m/M = 0, a made-up motion on buildings of 0.1 to 1.2 s, 16 scenes", "slip",
                "the uncoupled block: the oscillator in closed form between samples, events "
                "bisected"},
               {relative_to_slip, worst, 1e-10});
}

Case vanishing_mass(const std::vector<CoupledScene>& scenes) {
  const MadeUpGround ground;
  double worst = 0.0;
  for (const CoupledScene& s : scenes) {
    CoupledBuilding none = s.building, little = s.building;
    none.mass_ratio = 0.0;
    little.mass_ratio = 1e-13;
    const auto slip = [&](const CoupledBuilding& b) {
      return slide_coupled(ground.motion(), s.factors, b, s.block).slip;
    };
    worst = worse(worst, slip_difference(slip(little), slip(none)));
  }
  return limit({fmt::format("m/M = 1e-13, {} made-up scenes with a vertical", scenes.size()),
                "slip", "the same with m/M = 0", ReferenceFrom::this_code},
               {relative_to_slip, worst, 1e-10});
}

Case rigid_building(const std::vector<CoupledScene>& scenes) {
  const MadeUpGround ground;
  double worst = 0.0;
  for (const CoupledScene& s : scenes) {
    const SlipResult r =
        slide_coupled(ground.motion(), s.factors, {{0.0, 0.05}, 0.3, {}}, s.block).slip;
    worst = worse(worst, slip_difference(r, slide({0.01, ground.a, ground.w,
                                                   s.factors.horizontal[0], s.factors.vertical},
                                                  s.block)));
  }
  return limit({fmt::format("rigid building, m/M = 0.3, {} made-up scenes", scenes.size()), "slip",
                "slide(): a rigid building is not affected by the array", ReferenceFrom::this_code},
               {relative_to_slip, worst, 1e-12});
}

/// An array that never moves makes the building heavier by 1 + r and its period longer by the root
/// of that.
Case sticking_array() {
  const MadeUpGround ground;
  double worst = 0.0;
  for (const double r : {0.05, 0.1, 0.25, 0.5}) {
    const double root = std::sqrt(1.0 + r);
    const Block sticking{.friction = 5.0, .slope_rad = 0.05};
    const CoupledResult stuck = slide_coupled(ground.motion(), {}, {{0.5, 0.05}, r, {}}, sticking);
    const CoupledResult heavier =
        slide_coupled(ground.motion(), {}, {{0.5 * root, 0.05 / root}, 0.0, {}}, sticking);
    worst = worse(worst, relative(stuck.peak_base_shear, (1.0 + r) * heavier.peak_base_shear));
    worst =
        worse(worst, relative(stuck.peak_roof_displacement_m, heavier.peak_roof_displacement_m));
  }
  return limit({"array that does not slide, m/M 0.05 to 0.5", "base shear, roof displacement",
                "a building of mass 1 + m/M, whose period is longer by the root of that"},
               {"largest relative difference", worst, 1e-12});
}

// -- against 50 digits

Case fifty_digits() {
  double worst = 0.0;
  unsigned seed = 100;
  for (CoupledScene s : coupled_scenes(4, 8)) {
    s.block.slope_rad = std::abs(s.block.slope_rad);
    s.building.horizontal.period_s = std::max(s.building.horizontal.period_s, 0.1);
    const auto a = test::made_up_record(100, seed, 12.0),
               w = test::made_up_record(100, ++seed, 4.0);
    const GroundMotion ground{0.02, a, w};
    std::vector<CoupledPoint> history;
    const SlipResult r = slide_coupled(ground, {}, s.building, s.block, history).slip;
    const double ring_down_s = std::max(history.back().time_s - 2.0, 0.0) + 0.01;
    const test::CoupledReference exact(ground, {}, s.building, s.block, ring_down_s, 12);
    const double size = r.peak_displacement_m + 1e-4;
    for (const test::Real& d :
         {test::Real(r.peak_downslope_m - exact.down), test::Real(r.peak_upslope_m - exact.up),
          test::Real(r.residual.along_m - exact.slip)})
      worst = worse(worst, std::abs(static_cast<double>(d)) / size);
  }
  return limit({"4 made-up scenes with a vertical, m/M up to 0.5", "slip",
                "free bodies of block and building solved in 50 digits, events bisected"},
               {relative_to_slip, worst, 1e-11});
}

// -- dry friction under a harmonic

constexpr double far_heavier = 1e9;  // than the oscillator: it stands still, but for 1e-9

std::vector<Case> friction_oscillators() {
  using closed_forms::FrictionOscillator, closed_forms::OneStop, closed_forms::steady_slip_m;
  const double force_m = 0.05, omega = 10.0, g = 9.81;
  std::vector<Case> cases;
  for (const double beta : {0.7, 1.4}) {
    const FrictionOscillator o{omega, beta * omega, force_m, 0.5, 0.06, g};
    cases.push_back(compare(
        {fmt::format("undamped building driven at {} of its frequency, m/M 0.5, steady", beta),
         "half the range of slip, m", "closed form, half cycle by half cycle"},
        {steady_slip_m(o, 500), o.slip_amplitude_m(), 1e-9, Metric::absolute}));
  }
  // A fixed ground that rubs: an array so heavy that it stays where it is.
  const auto driven = [&](double beta, double friction_m) {
    return FrictionOscillator{
        omega, beta * omega, force_m, far_heavier, friction_m * omega * omega / (far_heavier * g),
        g};
  };
  for (const double beta : {0.8, 1.4}) {
    const double ratio = 0.2, v = 1.0 / (1.0 - beta * beta), psi = std::numbers::pi / beta,
                 u = std::sin(psi) / (beta * (1.0 + std::cos(psi)));
    cases.push_back(compare(
        {fmt::format("Coulomb oscillator driven at {} of its frequency, friction 0.2 of the force",
                     beta),
         "steady amplitude, m",
         "Den Hartog 1931, Trans. ASME 53:107-115: without stops, a sqrt(V^2 - (U F/P)^2)"},
        {steady_slip_m(driven(beta, ratio * force_m), 150),
         force_m * std::sqrt(v * v - u * u * ratio * ratio), 1e-9, Metric::absolute}));
  }
  for (const double beta : {0.6, 1.2}) {
    const double friction_m = 0.9 * force_m;
    cases.push_back(compare(
        {fmt::format("the same at {}, friction 0.9 of the force", beta), "steady amplitude, m",
         "Den Hartog 1931: one stop every half cycle, in closed form but for when it ends"},
        {steady_slip_m(driven(beta, friction_m), 60),
         OneStop{omega, beta * omega, friction_m, force_m}.amplitude_m(), 1e-9, Metric::absolute}));
  }
  return cases;
}

// -- laws

Case balance(const std::vector<CoupledScene>& scenes) {
  const MadeUpGround ground;
  double worst = 0.0;
  for (const CoupledScene& s : scenes)
    worst = worse(
        worst, energy_gap(slide_coupled(ground.motion(), s.factors, s.building, s.block).energy));
  return limit({fmt::format("{} made-up scenes with a vertical", scenes.size()), "energy",
                "input + gravity = kinetic + strain + damped + friction (Uang & Bertero 1990)"},
               {"largest gap, relative to the largest part", worst, 1e-10});
}

}  // namespace

Chapter second_paper_coupled() {
  const std::vector<CoupledScene> scenes = coupled_scenes(200, 3);
  return {
      "2.1 Coupled building and array", "Den Hartog 1931; 50 digits; energy balance",
      R"(An array of 5 to 10 % of the building's mass on a building of one degree of freedom. `slide_coupled()`
solves the phases of sticking and of sliding in closed form. The limits of no mass, a rigid building and no
sliding are known. Between them the references are Den Hartog (1931), the equations solved in 50 digits,
and the energy balance. Sampling at 1,000 samples a cycle alone causes an error of up to 1e-8 of the driving
amplitude of 0.05 m.)",
      joined({{without_mass(), vanishing_mass(scenes), rigid_building(scenes), sticking_array(),
               fifty_digits()},
              friction_oscillators(),
              {balance(scenes)}})};
}

}  // namespace glissade::verification
