// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "chapters.hpp"
#include "closed_form_roof.hpp"
#include "closed_forms/measured.hpp"
#include "closed_forms/pulses.hpp"
#include "closed_forms/sine.hpp"

namespace glissade::verification {
namespace {

using namespace closed_forms;
using test::Solver;

constexpr double g = standard_gravity_mps2;
constexpr double rounding = 1e-13;
/// What extrapolation from 500 and 1,000 samples a cycle leaves.
constexpr double third_order = 1e-7;

/// The result that is farthest off, of all solvers.
template <class Result>
Case farthest_off(const Subject& subject, double expected, double tolerance, const Result& result) {
  double farthest = expected;
  for (const Solver& solver : test::solvers()) {
    const double value = result(solver);
    if (std::isnan(value) || std::abs(value - expected) > std::abs(farthest - expected))
      farthest = value;
  }
  return compare(subject, {farthest, expected, tolerance});
}

std::string described(const Block& block) {
  return fmt::format("slope {:.0f} deg, mu {}", block.slope_rad / rad_per_deg,
                     block.friction.along);
}

const Block flat{.friction = 0.2}, sloping{.friction = 0.3, .slope_rad = 4 * rad_per_deg};

// -- pulses

template <class Pulse>
Case single_slip(const std::string& name, const Pulse& pulse, const Block& block, Against against,
                 const std::string& source) {
  const bool down = against == Against::down;
  const Slider s = slider(block);
  return farthest_off(
      {fmt::format("{}, {}, {}", name, down ? "against down" : "against up", described(block)),
       "residual slip, m", source},
      (down ? 1 : -1) * s.plan * slip(pulse, down ? s.down : s.up), rounding,
      [&](const Solver& solver) {
        return under({pulse.dt_s, pulse.alpha()}, against, block, solver).residual.along_m;
      });
}

template <class Cycle>
std::vector<Case> two_strokes(const std::string& name, const Cycle& cycle, Block block,
                              const std::string& source) {
  const Strokes expected = strokes(cycle, slider(block));
  const auto row = [&](const std::string& way, double slip) {
    return farthest_off(
        {fmt::format("{}, {}, {}", name, described(block), way), "residual slip, m", source}, slip,
        rounding, [&](const Solver& solver) {
          return under({cycle.first.dt_s, cycle.alpha()}, Against::down, block, solver)
              .residual.along_m;
        });
  };
  const Case both = row("two-way", expected.down_m - expected.up_m);
  block.directions = SlipDirections::downslope_only;
  return {both, row("one-way", expected.down_m)};
}

std::vector<Case> pulses() {
  const std::string rectangle =
                        "k A (A - y) D^2 / (2 y), Newmark 1965, less k A dt^2/24 for the ramp",
                    triangle = "quadratics and cubics of time, derived in pulses.hpp",
                    jump = "k A (A - y) D^2 / (A + y) down, then as a pulse; derived in pulses.hpp";
  std::vector<Case> cases;
  for (const Block& block : {flat, sloping})
    for (const Against against : {Against::down, Against::up}) {
      cases.push_back(single_slip("rectangular pulse of 6 m/s2 for 0.505 s",
                                  RectangularPulse{6, 0.01, 50}, block, against, rectangle));
      for (const double A : {4.5, 12.0})
        cases.push_back(
            single_slip(fmt::format("triangular pulse of {} m/s2, 0.2 s up, 0.5 s back", A),
                        TriangularPulse{A, 0.01, 20, 50}, block, against, triangle));
    }
  for (const Block& block : {flat, sloping})
    for (const std::vector<Case>& rows :
         {two_strokes("6 m/s2 for 0.405 s, then -6 m/s2 for 0.6 s",
                      RectangularCycle{{6, 0.01, 40}, 60}, block, jump),
          two_strokes("triangles to 6 and -6 m/s2, 0.05, 0.8 and 0.12 s long",
                      TriangularCycle{{6, 0.01, 5, 40}, 12}, block, triangle)})
      cases.insert(cases.end(), rows.begin(), rows.end());
  return cases;
}

// -- sines

Case half_sine(double eta) {
  const Slider s = slider(sloping);
  const HalfSine pulse{s.down.yield_mps2 / eta, 0.8};
  return farthest_off(
      {fmt::format("half sine of 0.8 s, yield / amplitude {}, {}", eta, described(sloping)),
       "residual slip, m",
       eta < 0.7 ? "from asin(y/A) to the end and coasting" : "from asin(y/A) to the root of v"},
      s.plan * slip(pulse, s.down), third_order, [&](const Solver& solver) {
        return extrapolated(
            [&](int parts) {
              return under({0.8 / parts, pulse.alpha(parts)}, Against::down, sloping, solver)
                  .residual.along_m;
            },
            500);
      });
}

/// A result of a harmonic, from 500 and 1,000 samples a cycle.
template <class Result>
Case sine(const Subject& subject, double expected, const Result& result) {
  return farthest_off(subject, expected, third_order, [&](const Solver& solver) {
    return extrapolated([&](int parts) { return result(solver, parts); }, 500);
  });
}

const char* in_words(Regime regime) {
  switch (regime) {
    case Regime::one_way:
      return "one way";
    case Regime::two_stops:
      return "two stops a cycle";
    case Regime::one_stop:
      return "one stop a cycle";
    default:
      return "no stops";
  }
}

Case drift(const Shaken& scene) {
  const std::string vertical =
      scene.vertical_ratio == 0.0
          ? ""
          : fmt::format(" and {} times as much vertical", scene.vertical_ratio);
  const SteadyState steady = scene.steady();
  return sine(
      {fmt::format("sine of {:.2f} g{}, {}", scene.motion.amplitude_mps2 / g, vertical,
                   described(scene.block)),
       "drift of a cycle, m", fmt::format("{}; derived in sine.hpp", in_words(steady.regime))},
      steady.drift_m(),
      [&](const Solver& solver, int parts) { return scene.drift_m(solver, parts); });
}

std::vector<Case> drifts() {
  const double T = 0.9;
  const Block five{.friction = 0.3, .slope_rad = 5 * rad_per_deg},
      sixteen{.friction = 0.3, .slope_rad = 16 * rad_per_deg}, level{.friction = 0.3};
  std::vector<Case> cases;
  Block one_way = five;
  one_way.directions = SlipDirections::downslope_only;
  Shaken newmark{{0.6 * g, T}, one_way};
  Slider sliding = slider(one_way);
  sliding.up.yield_mps2 = 2 * newmark.motion.amplitude_mps2;  // out of reach
  cases.push_back(sine({"sine of 0.60 g, downslope only, " + described(one_way),
                        "drift of a cycle, m", "from asin(y/A) to the root of v (Newmark's block)"},
                       steady_state(newmark.motion, sliding).drift_m(),
                       [&](const Solver& s, int parts) { return newmark.drift_m(s, parts); }));
  for (const Shaken& scene :
       {Shaken{{0.3 * g, T}, five}, Shaken{{0.7 * g, T}, sixteen}, Shaken{{0.48 * g, T}, five},
        Shaken{{0.55 * g, T}, five}, Shaken{{1.2 * g, T}, five},
        Shaken{{0.35 * g, T}, level, 0.667}, Shaken{{0.45 * g, T}, level, 0.667},
        Shaken{{1.2 * g, T}, level, 0.667}, Shaken{{0.9 * g, T}, five, -0.5}})
    cases.push_back(drift(scene));
  return cases;
}

std::vector<Case> flat_roof() {
  const Block block{.friction = 0.3};
  std::vector<Case> cases;
  for (const double eta : {0.1, 0.3, 0.5, 0.6, 0.8}) {
    Shaken scene{{0.3 * g / eta, 1.1}, block};
    const SteadyState steady = scene.steady();
    const bool stops = steady.regime == Regime::two_stops;
    if (!stops) scene.motion.phase = steady.down_start;
    cases.push_back(
        sine({fmt::format("sine on a flat roof, mu g / A = {}, {}", eta, in_words(steady.regime)),
              "stroke after 40 cycles, m",
              stops ? "from asin(mu g / A) to the root of v"
                    : "2 A / w^2 sqrt(1 - (pi mu g / (2 A))^2), Westermo & Udwadia 1983"},
             steady.strokes.down_m, [&](const Solver& solver, int parts) {
               return scene.after(solver, 80, parts).peak_downslope_m;
             }));
  }
  for (const double eta : {0.1, 0.5}) {
    const Shaken scene{{0.3 * g / eta, 1.1}, block};
    cases.push_back(sine({fmt::format("the same from rest, mu g / A = {}", eta),
                          "between residuals of 100 and 100.5 cycles, m", "derived in sine.hpp"},
                         2 * rest_beyond_middle(scene.motion, scene.sliding()),
                         [&](const Solver& solver, int parts) {
                           return scene.after(solver, 201, parts).residual.along_m -
                                  scene.after(solver, 200, parts).residual.along_m;
                         }));
  }
  // Resting or not is decided where a stop and a start fall in one sample interval, so the third
  // order, (w dt)^3 = 2e-6 at 500 samples, weighs more than elsewhere.
  const auto bound = [&](const Solver& solver, int parts) {
    double never = 0.5, sometimes = 0.6;
    while (sometimes - never > 1e-9) {
      const double eta = (never + sometimes) / 2;
      const bool rests = Shaken{{0.3 * g / eta, 1.1}, block}.sliding_s(solver, parts) < 1.1 - 1e-9;
      (rests ? sometimes : never) = eta;
    }
    return (never + sometimes) / 2;
  };
  cases.push_back(farthest_off({"sine on a flat roof", "mu g / A above which it stops, bisected",
                                "1 / sqrt(1 + pi^2/4), Westermo & Udwadia 1983"},
                               flat_roof_stops_above(), 2e-6, [&](const Solver& solver) {
                                 return extrapolated(
                                     [&](int parts) { return bound(solver, parts); }, 500);
                               }));
  return cases;
}

}  // namespace

Chapter closed_form_solutions() {
  return {
      "3.3 Closed forms", "closed forms of pulses and harmonics",
      R"(Pulses, half sines and harmonics act on a block and on the building below it (derivations:
tests/closed_forms). Pulses that are linear between samples agree to rounding. Of a sine the value
extrapolated from two steps (Richardson) is compared. The stops under a sine are roots of one
transcendental equation. Of several solvers, the one with the largest error is given.

In cases.csv, k and y are gain and yield acceleration in the direction of sliding: v' = k (alpha - y),
with alpha the roof acceleration against it. A is an amplitude, D a duration, r = T / T_ground.)",
      joined({pulses(),
              {half_sine(0.2), half_sine(0.6), half_sine(0.9)},
              flat_roof(),
              drifts(),
              roof_after_steps(),
              transmissibility()})};
}

}  // namespace glissade::verification
