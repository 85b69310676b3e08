// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "block_cases.hpp"
#include "chapters.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/io/suite_file.hpp"
#include "unit/block/reference.hpp"

namespace glissade::verification {
namespace {

using test::made_up_record;
using test::Reference;

constexpr double g = standard_gravity_mps2;

// -- against 50 digits

/// Residual and both peaks relative to the larger peak, velocity relative to itself.
double difference(const SlipResult& r, const Reference& exact) {
  const auto number = [](const test::Real& x) { return static_cast<double>(x); };
  const double size = std::max(number(exact.down), number(exact.up));
  double worst = std::abs(r.residual.along_m - number(exact.slip)) / size;
  worst = worse(worst, std::abs(r.peak_downslope_m - number(exact.down)) / size);
  worst = worse(worst, std::abs(r.peak_upslope_m - number(exact.up)) / size);
  return worse(worst, std::abs(r.peak_velocity_mps / number(exact.peak_velocity) - 1.0));
}

struct Scene {
  RoofAcceleration roof;
  Block block;
};

Case against_fifty_digits(const std::string& name, const std::vector<Scene>& scenes) {
  double worst = 0.0;
  for (const auto& [roof, block] : scenes) {
    const SlipResult r = slide(roof, block);
    if (!r.uplift && r.peak_displacement_m > 0.0)
      worst = worse(worst, difference(r, Reference(roof, block)));
  }
  return limit({name, "residual, both peaks, peak velocity",
                "equation of motion solved in 50 digits, events bisected"},
               {"largest relative difference", worst, 1e-12});
}

Case made_up(const std::string& name, bool with_vertical) {
  std::vector<std::vector<double>> samples;
  for (const unsigned seed : {1u, 2u, 101u, 102u})
    samples.push_back(made_up_record(1200, seed, seed < 100 ? 6.0 : 3.0));
  std::vector<Scene> scenes;
  for (const std::size_t record : {0u, 1u})
    for (const double scale : {0.4, 1.0, 2.0})
      for (const double mu : {0.0, 0.1, 0.3, 0.5, 0.7})
        for (const double slope_deg : {0.0, 1.19, 4.0, 7.0, 30.0}) {
          if (mu == 0.0 && slope_deg == 0.0) continue;  // coasts for ever: frictionless() below
          RoofAcceleration roof{0.005, samples[record], {}, scale, scale};
          if (with_vertical) roof.vertical_mps2 = samples[record + 2];
          scenes.push_back({roof, {mu, slope_deg * rad_per_deg}});
        }
  return against_fifty_digits(name, scenes);
}

Case simulated(const Suite& suite) {
  std::vector<Scene> scenes;
  for (const Motion& m : suite.motions)
    for (const double slope_deg : {0.0, 4.0})
      scenes.push_back({{m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, m.scale, m.scale},
                        {0.3, slope_deg * rad_per_deg}});
  return against_fifty_digits(
      "7 motions of suite level 2, slopes 0 and 4 deg, mu 0.3, vertical included", scenes);
}

// -- closed forms

/// Flat roof, mu 0.2, acceleration up to A = 4 m/s2 in 0.1 s, held 0.4 s, back in 0.1 s. Slip
/// starts at the yield crossing and stops long after the pulse under mu g alone.
std::vector<Case> trapezoidal_pulse() {
  const double mu = 0.2, A = 4.0, dt = 0.1, yield = mu * g, n = A - yield;
  const double rise = dt * (1.0 - yield / A), plateau = 4.0 * dt, k = -A / dt;
  const double v1 = 0.5 * n * rise, v2 = v1 + n * plateau, v3 = v2 + n * dt + 0.5 * k * dt * dt;
  const double slip = n * rise * rise / 6.0 + v1 * plateau + 0.5 * n * plateau * plateau + v2 * dt +
                      0.5 * n * dt * dt + k * dt * dt * dt / 6.0 + v3 * v3 / (2.0 * yield);
  const SlipResult r = slide({dt, std::vector<double>{0.0, A, A, A, A, A, 0.0}}, {.friction = mu});
  const auto row = [](const std::string& quantity, double value, double expected) {
    return compare(
        {"trapezoidal pulse, flat roof, mu 0.2", quantity, "closed form, piecewise polynomial"},
        {value, expected, 1e-13});
  };
  return {row("peak slip, m", r.peak_upslope_m, slip),
          row("residual slip, m", r.residual.along_m, -slip),
          row("time of sliding, s", r.slip_duration_s, rise + plateau + dt + v3 / yield),
          row("peak velocity, m/s", r.peak_velocity_mps, v2 + 0.5 * n * n / -k)};
}

Case constant_vertical() {
  const std::vector<double> pulse = {0.0, 6.0, 6.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                            w(pulse.size(), 0.25 * g);
  const Block block{.friction = 0.2, .slope_rad = 0.05};
  Block heavier = block;
  heavier.gravity_mps2 = 1.25 * g;
  return limit({"constant vertical acceleration of g/4", "peak slip",
                "the same pulse under 1.25 g and no vertical"},
               {"relative difference",
                std::abs(slide({0.01, pulse, w}, block).peak_displacement_m /
                             slide({0.01, pulse}, heavier).peak_displacement_m -
                         1.0),
                1e-13});
}

/// A frictionless block stays where it is in space: its slip is minus the roof's own displacement.
Case frictionless() {
  const double dt = 0.01;
  std::vector<double> a(201, 0.0);
  for (std::size_t i = 0; i < 200; ++i)
    a[i] = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 200.0);
  double v = 0.0, u = 0.0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    u += v * dt + dt * dt * (2.0 * a[i] + a[i + 1]) / 6.0;
    v += 0.5 * dt * (a[i] + a[i + 1]);
  }
  return compare({"no friction, flat roof, one sine of acceleration", "slip at the end, m",
                  "minus the roof's displacement, integrated"},
                 {slide({dt, a}, {.friction = 0.0}).residual.along_m, -u, 1e-13});
}

}  // namespace

Chapter sliding_block(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  return {
      "3.1 Sliding block: exactness", "equation of motion in 50 digits",
      R"(`slide()` should be exact for a piecewise-linear motion. It is compared with the equation of motion
(Rodriguez-Nikl et al. 2019, eqs 6-18, with the vertical) solved in 50 digits by bisection, with closed
forms, and with laws that hold to the last bit.)",
      joined(
          {{made_up("144 made-up histories: mu 0 to 0.7, slopes 0 to 30 deg, three scales", false),
            made_up("144 made-up histories, with a vertical", true), simulated(suite)},
           trapezoidal_pulse(),
           {constant_vertical(), frictionless()},
           invariants(suite)})};
}

}  // namespace glissade::verification
