// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/block/coupled_reference.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/scenes.hpp"

namespace glissade::verification {
namespace {

constexpr double g = standard_gravity_mps2;
const Block sticking{.friction = 10.0};

double omega_radps(double period_s) { return 2.0 * std::numbers::pi / period_s; }

// -- closed forms of the building alone, undamped, period 0.5 s

/// How far past yield the peak under a suddenly applied acceleration P is, in omega^2 u, for the
/// yield level A: the step's work is what the spring takes,
/// P x = A^2/2 + A (x - A) + alpha (x - A)^2/2.
double plastic_mps2(double P, double A, double alpha) {
  const double short_of = A - P, both = A * (P - 0.5 * A);
  if (alpha == 0.0) return both / short_of;
  return (std::sqrt(short_of * short_of + 2.0 * alpha * both) - short_of) / alpha;
}

std::vector<Case> suddenly_applied() {
  const std::vector<double> step(800, -2.0);
  const double per_omega2 = 1.0 / std::pow(omega_radps(0.5), 2);
  double ductility = 0.0, biggs = 0.0, residual = 0.0, taken = 0.0, shear = 0.0;
  for (const double level : {2.2, 2.7, 3.5})
    for (const double alpha : {0.0, 0.05, 0.3}) {
      const CoupledResult r =
          slide_coupled({0.005, step}, {}, {{0.5, 0.0}, 0.0, {level, alpha}}, sticking);
      const double past = plastic_mps2(2.0, level, alpha);
      ductility = worse(ductility, relative(r.ductility, 1.0 + past / level));
      if (alpha != 0.0) continue;
      biggs = worse(biggs, std::abs(2.0 / level - (1.0 - 0.5 / r.ductility)));
      residual = worse(residual, relative(r.residual_roof_displacement_m, past * per_omega2));
      taken = worse(taken, relative(r.energy.hysteretic_m2ps2, level * past * per_omega2));
      shear = worse(shear, relative(r.peak_base_shear, level / g));
    }
  const std::string name = "suddenly applied acceleration P of 2 m/s2",
                    perfect = ", three yield levels, elastic-perfectly plastic",
                    metric = "largest relative difference";
  return {limit({name + ", three yield levels, hardening 0, 0.05 and 0.3", "ductility",
                 "the step's work is what the spring takes, in closed form"},
                {metric, ductility, 1e-12}),
          limit({name + perfect, "P over the yield acceleration",
                 "Biggs 1964, Introduction to Structural Dynamics, eq 2.34: 1 - 1/(2 ductility)"},
                {"largest difference", biggs, 1e-13}),
          limit({name + perfect, "residual displacement", "plastic part of the peak"},
                {metric, residual, 1e-12}),
          limit({name + perfect, "energy of yielding", "yield force times plastic displacement"},
                {metric, taken, 5e-13}),
          limit({name + perfect, "base shear", "the yield force"}, {metric, shear, 1e-14})};
}

/// Ground acceleration c t: with s = omega t and q = c / omega, x = omega^2 u is q (s - sin s) up
/// to the yield level A at s_y, and then x'' = q s - A.
Case growing_pulse() {
  const double w0 = omega_radps(0.5), q = 10.0 / w0, level = 1.5;
  std::vector<double> pulse(50);
  for (std::size_t i = 0; i < pulse.size(); ++i) pulse[i] = -0.1 * static_cast<double>(i);
  std::vector<CoupledPoint> history;
  slide_coupled({0.01, pulse}, {}, {{0.5, 0.0}, 0.0, {level, 0.0}}, sticking, history);
  double low = 0.0, high = std::numbers::pi;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (q * (middle - std::sin(middle)) < level ? low : high) = middle;
  }
  const double rate = q * (1.0 - std::cos(low));
  double worst = 0.0;
  for (const CoupledPoint& p : history) {
    if (p.time_s > 0.49) break;
    const double s = w0 * p.time_s, d = s - low;
    const double x = d < 0.0
                         ? q * (s - std::sin(s))
                         : level + rate * d + (q * low - level) * d * d / 2.0 + q * d * d * d / 6.0;
    worst = worse(worst, std::abs(p.roof_displacement_m * w0 * w0 - x));
    worst = worse(worst, std::abs(p.spring_acceleration_mps2 - std::min(x, level)));
  }
  return limit(
      {"ground acceleration that grows at 10 m/s3, elastic-perfectly plastic at 1.5 m/s2",
       "omega^2 u and spring force over mass, at every sample", "sine up to yield, then a cubic"},
      {"largest difference, m/s2", worst, 2e-13});
}

/// The loop lies between two lines of the hardening stiffness, and every step is elastic or on one
/// of them.
Case textbook_loop() {
  const MadeUpGround ground;
  int wrong = 0;
  for (const double alpha : {0.0, 0.1}) {
    const CoupledBuilding building{{0.4, 0.05}, 0.2, {2.5, alpha}};
    const double square = std::pow(omega_radps(0.4), 2), half_width = (1.0 - alpha) * 2.5;
    std::vector<CoupledPoint> history;
    slide_coupled(ground.motion(), {}, building, {.friction = 0.15, .slope_rad = 0.04}, history);
    for (std::size_t i = 1; i < history.size(); ++i) {
      const CoupledPoint &p = history[i - 1], &q = history[i];
      const auto above = [&](const CoupledPoint& at) {
        return at.spring_acceleration_mps2 - alpha * square * at.roof_displacement_m;
      };
      const double force = q.spring_acceleration_mps2 - p.spring_acceleration_mps2,
                   way = square * (q.roof_displacement_m - p.roof_displacement_m);
      const bool within_lines = std::abs(above(q)) <= half_width + 1e-11,
                 elastic = std::abs(force - way) < 1e-11,
                 on_line = std::abs(above(q) - above(p)) < 1e-11 &&
                           std::abs(std::abs(above(q)) - half_width) < 1e-11;
      wrong += within_lines && (elastic || on_line) ? 0 : 1;
    }
  }
  return limit({"a made-up motion, yield level 2.5 m/s2, hardening 0 and 0.1, with a block",
                "spring force against displacement, step by step",
                "bilinear with kinematic hardening (Chopra 2017, fig. 7.1.3), to 1e-11 m/s2"},
               {"steps neither elastic nor on a line", static_cast<double>(wrong), 0.0});
}

// -- with the block

Case fifty_digits() {
  double worst = 0.0;
  unsigned seed = 200;
  for (CoupledScene s : yielding_scenes(3, 20)) {
    s.block.slope_rad = std::abs(s.block.slope_rad);
    s.building.yielding.yield_acceleration_mps2 = 2.0;
    s.building.horizontal.damping_ratio = 0.1;
    const auto a = test::made_up_record(100, seed, 12.0),
               w = test::made_up_record(100, ++seed, 4.0);
    const GroundMotion ground{0.02, a, w};
    std::vector<CoupledPoint> history;
    const CoupledResult r = slide_coupled(ground, {}, s.building, s.block, history);
    const double ring_down_s = std::max(history.back().time_s - 2.0, 0.0) + 0.01;
    const test::CoupledReference exact(ground, {}, s.building, s.block, ring_down_s, 12);
    const auto add = [&](double found, const test::Real& expected, double size) {
      worst = worse(worst, std::abs(static_cast<double>(found - expected)) / size);
    };
    const double slip = r.slip.peak_displacement_m + 1e-4;
    add(r.slip.peak_downslope_m, exact.down, slip);
    add(r.slip.peak_upslope_m, exact.up, slip);
    add(r.slip.residual.along_m, exact.slip, slip);
    add(r.residual_roof_displacement_m, exact.residual_roof, r.peak_roof_displacement_m);
  }
  return limit({"3 made-up scenes with a vertical", "slip, residual of the roof",
                "free bodies of block and building solved in 50 digits, events bisected"},
               {"largest relative difference", worst, 1e-11});
}

std::vector<Case> balance(const std::vector<CoupledScene>& scenes) {
  const MadeUpGround ground;
  double worst = 0.0, least = 1e300, share = 0.0;
  for (const CoupledScene& s : scenes) {
    const CoupledEnergy e = slide_coupled(ground.motion(), s.factors, s.building, s.block).energy;
    worst = worse(worst, energy_gap(e));
    least = std::min(least, e.hysteretic_m2ps2);
    share += e.hysteretic_m2ps2 / std::max(std::abs(e.input_m2ps2), e.hysteretic_m2ps2) /
             static_cast<double>(scenes.size());
  }
  const std::string name =
      fmt::format("{} made-up scenes with a vertical, strength 1/1.2 to 1/6 of the elastic demand",
                  scenes.size());
  return {
      limit({name, "energy", "input + gravity = kinetic + strain + damped + friction + hysteretic"},
            {"largest gap, relative to the largest part", worst, 1e-10}),
      within({name, "energy of yielding", "a loop gives nothing back"},
             {"smallest, J/kg", least, 0.0, INFINITY}),
      within({name, "energy of yielding over input", "it is no small part of the balance"},
             {"mean", share, 0.05, 1.0})};
}

/// R = 1: strength for the elastic demand.
std::vector<Case> stays_elastic(const std::vector<CoupledScene>& scenes) {
  const MadeUpGround ground;
  int differing = 0;
  double touched = 0.0;
  for (CoupledScene s : scenes) {
    s.building.yielding = {};
    const auto result = [&] {
      return slide_coupled(ground.motion(), s.factors, s.building, s.block);
    };
    const CoupledResult elastic = result();
    const double demand =
        std::pow(omega_radps(s.building.horizontal.period_s), 2) * elastic.peak_roof_displacement_m;
    s.building.yielding = {demand * (1.0 + 1e-12), 0.05};
    const CoupledResult strong = result();
    differing += strong.slip.peak_displacement_m == elastic.slip.peak_displacement_m &&
                         strong.slip.residual.along_m == elastic.slip.residual.along_m &&
                         strong.peak_base_shear == elastic.peak_base_shear &&
                         strong.energy.hysteretic_m2ps2 == 0.0 &&
                         strong.residual_roof_displacement_m == 0.0
                     ? 0
                     : 1;
    s.building.yielding = {demand, 0.05};
    const CoupledResult at_demand = result();
    touched = worse(touched, slip_difference(at_demand.slip, elastic.slip));
    touched = worse(touched, std::abs(at_demand.ductility - 1.0));
  }
  return {all_equal({"R = 1 and 1e-12 more", "slip, base shear, energy of yielding",
                     "the linear building, to the last bit"},
                    {differing, static_cast<int>(scenes.size())}),
          limit({"R = 1 exactly: rounding decides whether it yields", "slip; ductility",
                 "the linear building; 1"},
                {"largest relative difference", touched, 1e-10})};
}

}  // namespace

Chapter second_paper_yielding() {
  const std::vector<CoupledScene> scenes = yielding_scenes(150, 5);
  return {
      "2.2 Yielding building", "Biggs 1964; 50 digits; energy balance",
      R"(A bilinear spring whose strength is the elastic demand over R. The building alone has closed forms. With the
block the references are the equations solved in 50 digits and the energy balance with hysteresis. R = 1
must give the linear building.)",
      joined({suddenly_applied(),
              {growing_pulse(), textbook_loop(), fifty_digits()},
              balance(scenes),
              stays_elastic(scenes)})};
}

}  // namespace glissade::verification
