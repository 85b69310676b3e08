// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

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
  double worst = std::abs(r.residual_displacement_m - number(exact.slip)) / size;
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
    if (!r.uplift && r.peak_displacement_m > 0.0) worst = worse(worst, difference(r, Reference(roof, block)));
  }
  return limit({name, "residual, both peaks, peak velocity", "equation of motion solved in 50 digits, events bisected"},
               {"largest relative difference", worst, 1e-12});
}

Case made_up(const std::string& name, bool with_vertical) {
  std::vector<std::vector<double>> samples;
  for (const unsigned seed : {1u, 2u, 101u, 102u}) samples.push_back(made_up_record(1200, seed, seed < 100 ? 6.0 : 3.0));
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
      scenes.push_back({{m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, m.scale, m.scale}, {0.3, slope_deg * rad_per_deg}});
  return against_fifty_digits("7 motions of suite level 2, slopes 0 and 4 deg, mu 0.3, vertical included", scenes);
}

// -- closed forms

/// Flat roof, mu 0.2, acceleration up to A = 4 m/s2 in 0.1 s, held 0.4 s, back in 0.1 s. Slip starts at the yield crossing
/// and stops long after the pulse under mu g alone.
std::vector<Case> trapezoidal_pulse() {
  const double mu = 0.2, A = 4.0, dt = 0.1, yield = mu * g, n = A - yield;
  const double rise = dt * (1.0 - yield / A), plateau = 4.0 * dt, k = -A / dt;
  const double v1 = 0.5 * n * rise, v2 = v1 + n * plateau, v3 = v2 + n * dt + 0.5 * k * dt * dt;
  const double slip = n * rise * rise / 6.0 + v1 * plateau + 0.5 * n * plateau * plateau + v2 * dt + 0.5 * n * dt * dt +
                      k * dt * dt * dt / 6.0 + v3 * v3 / (2.0 * yield);
  const SlipResult r = slide({dt, std::vector<double>{0.0, A, A, A, A, A, 0.0}}, {.friction = mu});
  const auto row = [](const std::string& quantity, double value, double expected) {
    return compare({"trapezoidal pulse, flat roof, mu 0.2", quantity, "closed form, piecewise polynomial"}, {value, expected, 1e-13});
  };
  return {row("peak slip, m", r.peak_upslope_m, slip), row("residual slip, m", r.residual_displacement_m, -slip),
          row("time of sliding, s", r.slip_duration_s, rise + plateau + dt + v3 / yield),
          row("peak velocity, m/s", r.peak_velocity_mps, v2 + 0.5 * n * n / -k)};
}

Case constant_vertical() {
  const std::vector<double> pulse = {0.0, 6.0, 6.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, w(pulse.size(), 0.25 * g);
  const Block block{.friction = 0.2, .slope_rad = 0.05};
  Block heavier = block;
  heavier.gravity_mps2 = 1.25 * g;
  return limit({"constant vertical acceleration of g/4", "peak slip", "the same pulse under 1.25 g and no vertical"},
               {"relative difference",
                std::abs(slide({0.01, pulse, w}, block).peak_displacement_m / slide({0.01, pulse}, heavier).peak_displacement_m - 1.0),
                1e-13});
}

/// A frictionless block stays where it is in space: its slip is minus the roof's own displacement.
Case frictionless() {
  const double dt = 0.01;
  std::vector<double> a(201, 0.0);
  for (std::size_t i = 0; i < 200; ++i) a[i] = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 200.0);
  double v = 0.0, u = 0.0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    u += v * dt + dt * dt * (2.0 * a[i] + a[i + 1]) / 6.0;
    v += 0.5 * dt * (a[i] + a[i + 1]);
  }
  return compare({"no friction, flat roof, one sine of acceleration", "slip at the end, m", "minus the roof's displacement, integrated"},
                 {slide({dt, a}, {.friction = 0.0}).residual_displacement_m, -u, 1e-13});
}

// -- the physical checks of Rodriguez-Nikl et al. (2019), in their order

const std::string paper = "Rodriguez-Nikl et al. 2019, physical check ";

/// The smallest upslope-pushing pulse that loosens the block, by bisection of slide().
double loosening_acceleration_mps2(const Block& block) {
  double holds = 0.0, slips = g;
  for (int i = 0; i < 60; ++i) {
    const double peak = 0.5 * (holds + slips);
    (slide({0.01, std::vector<double>{0.0, -peak, 0.0}}, block).slip_phases > 0 ? slips : holds) = peak;
  }
  return slips;
}

std::vector<Case> physical_checks(const Suite& suite) {
  const Block steep{1.0, 30.0 * rad_per_deg}, gentle{0.1, 7.0 * rad_per_deg};
  const std::vector<double> still(1001, 0.0);
  const Motion& m = suite.motions.front();
  const auto peak_at = [&](double slope_deg) {
    return slide({m.dt_s, m.horizontal_mps2[0], {}, m.scale}, {0.4, slope_deg * rad_per_deg}).peak_displacement_m;
  };
  const double critical = std::tan(0.5 * rad_per_deg);
  const auto still_slip = [&](double share) { return slide({0.01, still}, {share * critical, 0.5 * rad_per_deg}).peak_displacement_m; };
  return {
      all_equal({"holds on a still slope of 30 deg with mu 1.0", "slip phases", paper + "1"},
                {slide({0.01, still}, steep).slip_phases == 0 ? 0 : 1, 1}),
      compare({"and is knocked loose by a large enough acceleration", "acceleration, m/s2", paper + "1; g tan(45 - 30 deg)"},
              {loosening_acceleration_mps2(steep), g * std::tan(15.0 * rad_per_deg), 1e-12}),
      compare({"slides down a still slope of 7 deg with mu 0.1 for 10 s", "slip in plan, m",
               paper + "2; (g sin - mu g cos) t^2/2, times cos"},
              {slide({0.01, still}, gentle).residual_displacement_m,
               50.0 * g * (std::sin(gentle.slope_rad) - 0.1 * std::cos(gentle.slope_rad)) * std::cos(gentle.slope_rad), 1e-12}),
      within({"slopes of +4 and -4 deg, mu 0.4, first motion of suite level 2", "peak slips", paper + "3: they differ"},
             {"relative difference", std::abs(peak_at(4.0) / peak_at(-4.0) - 1.0), 1e-3, INFINITY}),
      all_equal({"slides on 0.5 deg at 0.999 of the critical friction and not at 1.000", "statements", paper + "4"},
                {(still_slip(0.999) > 0.0 ? 0 : 1) + (still_slip(1.0) == 0.0 ? 0 : 1), 2}),
  };
}

// -- invariants

bool same(const SlipResult& a, const SlipResult& b) {
  return a.peak_displacement_m == b.peak_displacement_m && a.residual_displacement_m == b.residual_displacement_m &&
         a.peak_downslope_m == b.peak_downslope_m && a.peak_upslope_m == b.peak_upslope_m &&
         a.peak_velocity_mps == b.peak_velocity_mps && a.slip_duration_s == b.slip_duration_s && a.slip_phases == b.slip_phases;
}

/// `b` with lengths scaled by one factor and times by another, both powers of two.
SlipResult scaled(SlipResult b, double length, double time) {
  for (double* x : {&b.peak_displacement_m, &b.residual_displacement_m, &b.peak_downslope_m, &b.peak_upslope_m}) *x *= length;
  b.peak_velocity_mps *= length / time;
  b.slip_duration_s *= time;
  return b;
}

std::vector<double> with_midpoints(const std::vector<double>& x) {
  std::vector<double> y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    y.push_back(x[i]);
    y.push_back(0.5 * (x[i] + (i + 1 < x.size() ? x[i + 1] : 0.0)));
  }
  return y;
}

std::vector<Case> invariants(const Suite& suite) {
  int mirror = 0, field = 0, padding = 0, clock = 0, histories = 0;
  double midpoints = 0.0;
  for (const Motion& m : suite.motions)
    for (const double mu : {0.1, 0.3, 0.5})
      for (const double slope_deg : {0.0, 1.19, 4.0}) {
        ++histories;
        const auto &a = m.horizontal_mps2[0], &w = m.vertical_mps2;
        const double f = m.scale;
        const Block block{mu, slope_deg * rad_per_deg}, mirrored{mu, -slope_deg * rad_per_deg};
        Block twice_as_heavy = block;
        twice_as_heavy.gravity_mps2 *= 2.0;
        const SlipResult plain = slide({m.dt_s, a, w, f, f}, block);

        SlipResult reflected = slide({m.dt_s, a, w, -f, f}, mirrored);
        if (slope_deg == 0.0) {  // up and down change places
          std::swap(reflected.peak_downslope_m, reflected.peak_upslope_m);
          reflected.residual_displacement_m *= -1.0;
        }
        mirror += same(reflected, plain) ? 0 : 1;
        field += same(slide({m.dt_s, a, w, 2 * f, 2 * f}, twice_as_heavy), scaled(plain, 2.0, 1.0)) ? 0 : 1;
        clock += same(slide({4 * m.dt_s, a, w, f, f}, block), scaled(plain, 16.0, 4.0)) ? 0 : 1;
        auto long_a = a, long_w = w;
        long_a.resize(2 * a.size(), 0.0);
        long_w.resize(2 * w.size(), 0.0);
        padding += same(slide({m.dt_s, long_a, long_w, f, f}, block), plain) ? 0 : 1;
        const auto fine_a = with_midpoints(a), fine_w = with_midpoints(w);
        const SlipResult fine = slide({0.5 * m.dt_s, fine_a, fine_w, f, f}, block);
        if (plain.peak_displacement_m == 0.0) continue;
        midpoints = worse(midpoints, std::abs(fine.peak_displacement_m / plain.peak_displacement_m - 1.0));
        midpoints = worse(midpoints, std::abs(fine.residual_displacement_m - plain.residual_displacement_m) / plain.peak_displacement_m);
      }
  const std::string law = "similitude of the equation of motion";
  return {all_equal({"mirrored motion and slope", "all results, mirrored", "symmetry of the equation of motion"}, {mirror, histories}),
          all_equal({"motion and gravity doubled", "all results, doubled", law}, {field, histories}),
          all_equal({"step four times as long", "slips x 16, times x 4", law}, {clock, histories}),
          all_equal({"as many zeros appended as there are samples", "all results", "unchanged"}, {padding, histories}),
          limit({"interpolated samples inserted", "peak and residual slip", "unchanged: the motion is piecewise linear"},
                {"largest relative difference of " + std::to_string(histories), midpoints, 1e-11})};
}

}  // namespace

Chapter sliding_block(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  Chapter chapter{
      "1.1 Sliding block: exactness",
      "`slide()` takes every start and stop of slip in closed form and so should be exact for a piecewise-linear motion. It is\n"
      "compared with the equation of motion (Rodriguez-Nikl et al. 2019, eqs 6-18, with the vertical) solved in 50 digits by\n"
      "bisection, with closed forms, with the physical checks of that paper, and with laws that hold to the last bit.",
      {made_up("144 made-up histories: mu 0 to 0.7, slopes 0 to 30 deg, three scales", false),
       made_up("144 made-up histories, with a vertical", true), simulated(suite)}};
  const auto add = [&](const std::vector<Case>& cases) { chapter.cases.insert(chapter.cases.end(), cases.begin(), cases.end()); };
  add(trapezoidal_pulse());
  add({constant_vertical(), frictionless()});
  add(physical_checks(suite));
  add(invariants(suite));
  return chapter;
}

}  // namespace glissade::verification
