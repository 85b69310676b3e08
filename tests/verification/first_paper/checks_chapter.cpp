// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "at_one_g.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/io/suite_file.hpp"
#include "unit/block/solvers.hpp"
#include "verification/chapters.hpp"

namespace glissade::verification {
namespace {

using test::Solver;

constexpr double g = standard_gravity_mps2;
const std::string check = "physical check ";

SlipPeak by_published_scheme(const RoofAcceleration& roof, const Block& block) {
  return slide_rodriguez_nikl(roof, block, 64);
}

/// The two that are exact, and the paper's own.
const std::vector<Solver>& three_solvers() {
  static const std::vector<Solver> three = {
      test::solvers()[0], test::solvers()[1], {"published scheme, P = 64", by_published_scheme}};
  return three;
}

/// The roof at rest for `seconds`, 100 samples a second as the paper's record.
std::vector<double> still(int seconds) {
  return std::vector<double>(static_cast<std::size_t>(100 * seconds + 1), 0.0);
}

// -- 1: slope 30 deg, mu 1.0

/// The smallest peak of a triangular pulse under which the block slides, by bisection.
double slip_onset_mps2(const Solver& solver, const Block& block, double sign) {
  double sticks = 0.0, slips = 10.0 * g;
  for (int i = 0; i < 60; ++i) {
    const double peak = 0.5 * (sticks + slips);
    const std::vector<double> pulse = {0.0, sign * peak, 0.0};
    (solver.solve({0.01, pulse}, block).slip_phases > 0 ? slips : sticks) = peak;
  }
  return slips;
}

std::vector<Case> sticks_until_a_peak_acceleration() {
  const Block block{1.0, 30.0 * rad_per_deg};
  int moved = 0;
  double downslope = 0.0, upslope = 0.0;
  for (const Solver& solver : three_solvers()) {
    for (const double slope_rad : {block.slope_rad, -block.slope_rad})
      moved += solver.solve({0.01, still(10)}, {block.friction, slope_rad}).slip_phases > 0 ? 1 : 0;
    const auto off = [&](double sign, double expected) {
      return std::abs(slip_onset_mps2(solver, block, sign) / expected - 1.0);
    };
    downslope = worse(downslope, off(-1.0, g * std::tan(15.0 * rad_per_deg)));
    upslope = worse(upslope, off(1.0, g * std::tan(75.0 * rad_per_deg)));
  }
  const std::string worst = "largest relative difference of three solvers";
  return {all_equal({"does not slide on a still slope of +-30 deg with mu 1.0, 10 s", "slip phases",
                     check + "1: none"},
                    {moved, 6}),
          limit({"and starts to slide down the slope", "smallest peak acceleration",
                 check + "1; g tan(45 - 30 deg) = 0.268 g"},
                {worst, downslope, 1e-12}),
          limit({"and up the slope", "smallest peak acceleration",
                 check + "1; g tan(45 + 30 deg) = 3.73 g"},
                {worst, upslope, 1e-12})};
}

// -- 2: slope 7 deg, mu 0.1

/// The published scheme on a still slope: as sgn(0) = 0 in its eq 13, its first substep has no
/// friction; from then on its acceleration is the exact one.
double published_on_still_slope_m(const Block& block, double time_s, double substep_s) {
  const double sin = std::sin(block.slope_rad), cos = std::cos(block.slope_rad);
  const double first = g * sin * cos, then = g * (sin - block.friction.along * cos) * cos;
  const double rest = time_s - substep_s;
  return first * substep_s * (0.5 * substep_s + rest) + 0.5 * then * rest * rest;
}

std::vector<Case> slides_down_a_still_slope() {
  const Block block{0.1, 7.0 * rad_per_deg};
  const std::string formula = check + "2; (g sin - mu g cos) t^2/2, times cos";
  const auto expected_m = [&](double t) {
    return 0.5 * g * (std::sin(block.slope_rad) - 0.1 * std::cos(block.slope_rad)) * t * t *
           std::cos(block.slope_rad);
  };
  double exact = 0.0, published = 0.0;
  for (const int t : {1, 2, 5, 10, 20}) {
    const auto slip_m = [&](const Solver& solver) {
      return solver.solve({0.01, still(t)}, block).residual.along_m;
    };
    for (const Solver& solver : test::solvers())
      exact = worse(exact, std::abs(slip_m(solver) / expected_m(t) - 1.0));
    published = worse(published, std::abs(slip_m(three_solvers()[2]) /
                                              published_on_still_slope_m(block, t, 0.01 / 64.0) -
                                          1.0));
  }
  const std::string name = "slides down a still slope of 7 deg with mu 0.1";
  return {compare({name + ", slide()", "slip in plan after 10 s, m", formula},
                  {three_solvers()[0].solve({0.01, still(10)}, block).residual.along_m,
                   expected_m(10.0), 1e-12}),
          limit({name + ", after 1, 2, 5, 10 and 20 s, slide() and peak_slip()", "slip in plan",
                 formula},
                {"largest relative difference", exact, 1e-12}),
          limit({name + ", the same times, published scheme, P = 64", "slip in plan",
                 "the same, but for a first substep without friction, as sgn(0) = 0 in its eq 13"},
                {"largest relative difference", published, 1e-10}),
          limit({name + ", published scheme, P = 64", "slip in plan after 10 s",
                 formula + "; its first substep makes 1.4e-4 of it"},
                {"relative difference",
                 std::abs(by_published_scheme({0.01, still(10)}, block).residual.along_m /
                              expected_m(10.0) -
                          1.0),
                 2e-4})};
}

// -- 3: slope +-4 deg, mu 0.4

std::vector<Case> differs_by_the_slopes_sign(const Suite& suite) {
  const RoofAcceleration roof = at_one_g(suite.motions.front());
  double peak = INFINITY, residual = INFINITY, agree = 0.0;
  const SlipPeak exact = three_solvers()[0].solve(roof, {0.4, 4.0 * rad_per_deg});
  for (const Solver& solver : three_solvers()) {
    const SlipPeak down = solver.solve(roof, {0.4, 4.0 * rad_per_deg});
    const SlipPeak up = solver.solve(roof, {0.4, -4.0 * rad_per_deg});
    const auto off = [](double a, double b) { return std::abs(a / b - 1.0); };
    peak = std::min(peak, off(up.peak_displacement_m, down.peak_displacement_m));
    residual = std::min(residual, off(up.residual.along_m, down.residual.along_m));
    agree = worse(agree, off(down.peak_displacement_m, exact.peak_displacement_m));
  }
  const std::string name = "slopes of +4 and -4 deg, mu 0.4, first motion of suite level 4 at 1 g";
  const std::string least = "smallest relative difference of three solvers";
  return {
      within({name, "peak slips", check + "3: they differ"}, {least, peak, 1e-3, INFINITY}),
      within({name, "residual slips", check + "3: they differ"}, {least, residual, 1e-3, INFINITY}),
      limit({name, "peak slip on +4 deg", "slide(); the scheme's 0.48 % at P = 64, its fig. 5",
             ReferenceFrom::this_code},
            {"largest relative difference of three solvers", agree, 0.0048})};
}

// -- 4: mu_crit = tan(slope), slope 0.5 deg

std::vector<Case> slides_below_the_critical_friction() {
  const double slope_rad = 0.5 * rad_per_deg, critical = std::tan(slope_rad);
  const auto peak_m = [&](const Solver& solver, double friction) {
    return solver.solve({0.01, still(10)}, {friction, slope_rad}).peak_displacement_m;
  };
  int wrong = 0, exact_solvers = 0;
  for (const Solver& solver : test::solvers()) {
    ++exact_solvers;
    wrong += (peak_m(solver, 0.999 * critical) > 0.0 ? 0 : 1) +
             (peak_m(solver, critical) == 0.0 ? 0 : 1);
  }
  const Solver &slide = three_solvers()[0], &published = three_solvers()[2];
  const double next = std::nextafter(std::nextafter(critical, 1.0), 1.0);
  const int published_wrong = (peak_m(published, 0.999 * critical) > 0.0 ? 0 : 1) +
                              (peak_m(published, next) == 0.0 ? 0 : 1);
  const std::string name = "still slope of 0.5 deg, mu_crit = tan(0.5 deg)";
  return {all_equal({name + ", slide() and peak_slip()", "slides at 0.999 mu_crit, rests at 1.000",
                     check + "4"},
                    {wrong, 2 * exact_solvers}),
          all_equal({name + ", published scheme, P = 64",
                     "slides at 0.999 mu_crit, rests two roundings above 1.000", check + "4"},
                    {published_wrong, 2}),
          compare({name + ", slide()", "slip in plan after 10 s at 0.999 mu_crit, m",
                   "0.001 g sin t^2/2, times cos"},
                  {peak_m(slide, 0.999 * critical),
                   50.0 * 0.001 * g * std::sin(slope_rad) * std::cos(slope_rad), 1e-11}),
          within({name + ", published scheme, P = 64", "slip after 10 s at 1.000 mu_crit, mm",
                  "none, or that of its first substep without friction: rounding decides its eq 9, "
                  "f_req < f_max"},
                 {"slip, mm", 1000.0 * peak_m(published, critical), 0.0,
                  1000.0 * published_on_still_slope_m({critical, slope_rad}, 10.01, 0.01 / 64.0) *
                      (1.0 + 1e-9)})};
}

}  // namespace

RoofAcceleration at_one_g(const Motion& motion) {
  const Samples& samples = motion.horizontal_mps2[0];
  const auto [lowest, highest] = std::ranges::minmax(samples);
  return {motion.dt_s, samples, {}, g / std::max(-lowest, highest)};
}

Chapter first_paper_checks(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level4.toml");
  Chapter chapter{
      "1.1 Physical checks", "the limits that the paper states",
      R"(The four limits of the model in the section "Physical checks" of the paper, with its numbers, for
`slide()`, the kernel `peak_slip()` and the published scheme at P = 64. Where a motion is needed it is the
first of suite level 4, scaled to a peak plane acceleration of 1.0 g, without vertical. Positions are in
plan. The paper does not state the acceleration that started its block, nor the time at which it
compared positions.

At exactly the critical friction, required and available friction are equal. Rounding decides whether
the published scheme rests, as in the paper, or moves in the first substep.)",
      joined({sticks_until_a_peak_acceleration(), slides_down_a_still_slope(),
              differs_by_the_slopes_sign(suite), slides_below_the_critical_friction()})};
  const auto passed = std::ranges::count_if(chapter.cases, [](const Case& c) { return c.pass; });
  const bool all = static_cast<std::size_t>(passed) == chapter.cases.size();
  chapter.findings = {
      {"physical checks: four limits of the model",
       fmt::format("{} of {} cases pass, with three solvers", passed, chapter.cases.size()),
       yes(all)}};
  return chapter;
}

}  // namespace glissade::verification
