// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <span>

#include "chapters.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/oscillator.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/response_spectrum.hpp"
#include "textbook_oscillator.hpp"

namespace glissade::verification {
namespace {

using std::numbers::pi;
using Real = boost::multiprecision::cpp_bin_float_50;
using Textbook = test::TextbookOscillator<Real>;

Case coefficients(double phase) {
  double worst = 0.0;
  for (const double zeta : {0.0, 0.02, 0.05, 0.3, 0.9}) {
    const Real w = 2;  // rad/s
    const Textbook t(w, zeta, Real(phase) / w);
    const OscillatorStep s = oscillator_step(phase, zeta);
    const auto add = [&](double got, const Real& expected) {
      const double want = static_cast<double>(expected);
      worst = worse(worst, std::abs(got - want) / std::max(std::abs(want), 1e-3 * phase));
    };
    add(s.xx, t.A);  // x = w^2 u, y = w v
    add(s.xy, t.B * w);
    add(-s.xy, t.A1 / w);
    add(s.yy, t.B1);
    add(s.x_start, t.C * w * w);
    add(s.x_end, t.D * w * w);
    add(s.y_start, t.C1 * w);
    add(s.y_end, t.D1 * w);
  }
  return limit({fmt::format("step of {} rad, damping 0 to 0.9", phase),
                "eight coefficients of the recurrence",
                "Nigam & Jennings 1969, as in Chopra table 5.2.1, in 50 digits"},
               {"largest relative difference", worst, 1e-13});
}

/// The record carries a harmonic times sinc^2(pi dt / T_g), being piecewise linear: allowed for.
Case transmissibility(double period_s) {
  const double dt = 0.01, ground_period_s = 0.8, zeta = 0.05, arg = pi * dt / ground_period_s;
  std::vector<double> a(20000);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = std::sin(2.0 * pi * dt * static_cast<double>(i) / ground_period_s);
  const RoofMotion roof = roof_motion({dt, a}, {.horizontal = {period_s, zeta}}, {});
  double largest = 0.0;
  for (std::size_t i = roof.horizontal_mps2.size() / 2; i < roof.horizontal_mps2.size(); ++i)
    largest = std::max(largest, std::abs(roof.horizontal_mps2[i]));
  const double r = period_s / ground_period_s, damping = std::pow(2.0 * zeta * r, 2);
  return compare({fmt::format("steady state, period {:.1f} s, 5 %, ground period 0.8 s", period_s),
                  "roof / ground acceleration", "closed-form transmissibility"},
                 {largest / std::pow(std::sin(arg) / arg, 2),
                  std::sqrt((1.0 + damping) / (std::pow(1.0 - r * r, 2) + damping)), 1e-3});
}

Case rigid(const Motion& m) {
  const RoofMotion roof =
      roof_motion({m.dt_s, m.horizontal_mps2[0], m.vertical_mps2}, Building{}, {});
  int differing = roof.vertical_mps2 == m.vertical_mps2 ? 0 : 1;
  differing += roof.horizontal_mps2 == m.horizontal_mps2[0] ? 0 : 1;
  return all_equal({"rigid building", "both components of the roof motion", "the ground motion"},
                   {differing, 2});
}

// -- response spectra

double sa(double dt_s, std::span<const double> a, double period_s, double damping) {
  return pseudo_acceleration_spectrum(dt_s, a, std::vector{period_s}, damping).front();
}

Case step_response(double damping) {
  return compare({fmt::format("suddenly applied acceleration, period 0.333 s, damping {}", damping),
                  "Sa", "1 + exp(-pi zeta/sqrt(1 - zeta^2)), Chopra section 4.3"},
                 {sa(0.01, std::vector<double>(1000, 1.0), 0.333, damping),
                  1.0 + std::exp(-pi * damping / std::sqrt(1.0 - damping * damping)), 1e-11});
}

Case ramp_response() {
  std::vector<double> ramp(1500, 1.0);
  for (std::size_t i = 0; i < 40; ++i) ramp[i] = static_cast<double>(i) / 40.0;
  const double x = pi * 0.4 / 0.9;
  return compare({"acceleration rising for 0.4 s, period 0.9 s, undamped", "Sa",
                  "1 + abs(sin x)/x, x = pi t_r/T, Chopra section 4.5"},
                 {sa(0.01, ramp, 0.9, 0.0), 1.0 + std::abs(std::sin(x)) / x, 1e-11});
}

/// The largest |omega^2 u| at `parts` points of each interval, and over one period after it, by the
/// textbook recurrence. Misses at most (omega dt / parts)^2 / 8 of a peak.
double textbook_sa(const Motion& m, double period_s, int parts) {
  const auto& a = m.horizontal_mps2[0];
  const auto sample = [&](std::size_t i) { return i < a.size() ? a[i] : 0.0; };
  const Real w = 2 * boost::math::constants::pi<Real>() / Real(period_s);
  const Textbook t(w, Real(0.05), Real(m.dt_s) / parts);
  const auto number = [](const Real& x) { return static_cast<long double>(x); };
  const long double A = number(t.A), B = number(t.B), C = number(t.C), D = number(t.D),
                    A1 = number(t.A1), B1 = number(t.B1), C1 = number(t.C1), D1 = number(t.D1),
                    stiffness = number(w * w);
  long double u = 0, v = 0, peak = 0;
  const std::size_t intervals = a.size() + static_cast<std::size_t>(period_s / m.dt_s);
  for (std::size_t i = 0; i < intervals; ++i) {
    for (int part = 0; part < parts; ++part) {
      const long double rise = (static_cast<long double>(sample(i + 1)) - sample(i)) / parts;
      const long double p0 = -(sample(i) + rise * part), p1 = p0 - rise;
      const long double next = A * u + B * v + C * p0 + D * p1;
      v = A1 * u + B1 * v + C1 * p0 + D1 * p1;
      u = next;
      peak = std::max(peak, stiffness * std::abs(u));
    }
  }
  return static_cast<double>(peak);
}

Case spectrum(const Motion& m, double period_s) {
  const int parts = period_s < 0.1 ? 400 : 40;
  return limit(
      {fmt::format("first motion of suite level 2, period {} s, 5 %", period_s), "Sa",
       fmt::format("textbook recurrence, 50-digit coefficients, {} points an interval", parts)},
      {"relative difference",
       std::abs(sa(m.dt_s, m.horizontal_mps2[0], period_s, 0.05) / textbook_sa(m, period_s, parts) -
                1.0),
       2e-6});
}

}  // namespace

Chapter buildings(const Folders& folders) {
  const Motion motion = load_suite(folders.suites / "synthetic_level2.toml").motions.front();
  Chapter chapter{
      "4.1 Buildings and response spectra",
      "Nigam & Jennings 1969, in 50 digits",
      R"(A linear oscillator under piecewise-linear ground acceleration is exact at its samples: its coefficients
are compared with the published ones in 50 digits, its steady state with the closed form. Response spectra
are compared with closed forms, and with the recurrence of the textbook on a fine grid.)",
      {}};
  for (const double phase : {1e-6, 1e-3, 0.0157, 0.3, 0.999, 1.001, 3.0, 40.0})
    chapter.cases.push_back(coefficients(phase));
  for (const double period_s : {0.2, 0.5, 0.8, 2.0})
    chapter.cases.push_back(transmissibility(period_s));
  chapter.cases.push_back(rigid(motion));
  for (const double damping : {0.0, 0.05, 0.3}) chapter.cases.push_back(step_response(damping));
  chapter.cases.push_back(ramp_response());
  for (const double period_s : {0.02, 0.05, 0.2, 1.0, 2.0})
    chapter.cases.push_back(spectrum(motion, period_s));
  return chapter;
}

}  // namespace glissade::verification
