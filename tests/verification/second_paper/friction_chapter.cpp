// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "glissade/block/coupled.hpp"
#include "verification/chapters.hpp"
#include "verification/second_paper/biaxial.hpp"

namespace glissade::verification {
namespace {

using test::OnBuilding;

constexpr double g = standard_gravity_mps2;

template <class F>
double integral(F f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, from, to, 10, 1e-14);
}

// -- static friction

const double mu = 0.2, static_over_sliding = 1.3;
const Block sticky{.friction = mu, .law = {.static_over_sliding = static_over_sliding}};
const CoupledBuilding rigid{{0.0, 0.05}, 0.2, {}};

OnBuilding pushed(const std::vector<double>& a, const FrictionLaw& law) {
  OnBuilding scene = at_rest(a.size());
  scene.dt_s = 0.01;
  scene.first = a;
  scene.block.friction = mu;
  scene.block.law = law;
  return scene;
}

/// A push that is constant for 2 s: below mu_static g it moves nothing, above it the block is left
/// behind with what is above mu g.
std::vector<Case> constant_push() {
  const std::vector<double> weak(200, -0.999 * static_over_sliding * mu * g),
      strong(200, -1.001 * static_over_sliding * mu * g);
  const int moved = (slide_coupled({0.01, weak}, {}, rigid, sticky).slip.slip_phases > 0 ? 1 : 0) +
                    (pushed(weak, sticky.law).result().slip.slip_phases > 0 ? 1 : 0);
  const double gain = 1.001 * static_over_sliding * mu * g - mu * g;
  const std::vector<double> distance{0.5 * gain};  // after 1 s
  std::vector<Crossing> one(1), two(1);
  slide_coupled({0.01, strong}, {}, rigid, sticky, distance, one);
  pushed(strong, sticky.law).result(distance, two);
  double worst = 0.0;
  for (const Crossing& c : {one[0], two[0]})
    worst = worse(worse(worst, std::abs(c.time_s - 1.0)), std::abs(c.speed_mps / gain - 1.0));
  return {
      all_equal({"constant push of 0.999 mu_static g, 2 s, mu 0.2, static 1.3 times that, "
                 "slide_coupled() and slide_on_building()",
                 "phases of sliding", "none"},
                {moved, 2}),
      limit({"the same at 1.001 mu_static g", "when and how fast it has gone (a - mu g)/2 x 1 s2",
             "after 1 s, at (a - mu g) x 1 s"},
            {"largest relative difference", worst, 1e-10})};
}

/// The push grows as c t: it breaks away when that is mu_static g.
Case growing_push() {
  std::vector<double> ramp(100);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = -0.05 * static_cast<double>(i);
  const double c = 5.0, start_s = static_over_sliding * mu * g / c;
  std::vector<CoupledPoint> history;
  slide_coupled({0.01, ramp}, {}, rigid, sticky, history);
  double worst = 0.0;
  for (const CoupledPoint& p : history) {
    if (p.time_s > 0.985) break;
    const double d = std::max(p.time_s - start_s, 0.0), jump = (static_over_sliding - 1.0) * mu * g;
    worst = worse(worst, std::abs(p.velocity_mps - (jump * d + 0.5 * c * d * d)));
    worst = worse(worst, std::abs(p.displacement_m - (0.5 * jump * d * d + c * d * d * d / 6.0)));
  }
  return limit({"push that grows at 5 m/s3, mu 0.2, static 1.3 times that, slide_coupled()",
                "displacement and velocity at every sample",
                "from mu_static g on, (mu_static - mu) g d + c d^2/2 and its integral"},
               {"largest difference, m and m/s", worst, 1e-13});
}

/// Where tan(slope) lies between mu and mu_static the block rests, and once loose slides for ever.
Case metastable_slope() {
  const Block block{
      .friction = mu, .slope_rad = std::atan(0.25), .law = {.static_over_sliding = 1.5}};
  const std::vector<double> still(100, 0.0), nudge{0.0, -2.0, 0.0};
  const SlipResult rests = slide_coupled({0.01, still}, {}, rigid, block).slip,
                   loose = slide_coupled({0.01, nudge}, {}, rigid, block).slip;
  return all_equal({"slope of tan 0.25 between mu 0.2 and mu_static 0.3",
                    "rests; once moved, slides freely", "no phase of sliding; free sliding"},
                   {(rests.slip_phases == 0 ? 0 : 1) + (loose.free_sliding ? 0 : 1), 2});
}

// -- friction that depends on speed

/// A block on a flat roof that is jerked to 1 m/s in 2 ns coasts under v' = -g mu(v).
std::vector<Case> coasting() {
  std::vector<Case> cases;
  const double speed_mps = 1.0;
  for (const FrictionLaw& law :
       {FrictionLaw{1.0, 2.0, 20.0}, FrictionLaw{1.0, 1.5, 3.0}, FrictionLaw{1.0, 0.6, 10.0}}) {
    OnBuilding scene = at_rest(8);
    scene.dt_s = 1e-9;
    scene.first[1] = -speed_mps / scene.dt_s;
    scene.block.friction = mu;
    scene.block.law = law;
    const SlipResult r = scene.result().slip;
    const double fast = law.fast_over_slow, rate = law.rate_s_per_m;
    const auto slows = [&](double v) {
      return g * mu * (fast - (fast - 1.0) * std::exp(-rate * v));
    };
    const std::string name =
        fmt::format("coasting from 1 m/s, mu 0.2, {} times that when fast, a = {} s/m", fast, rate);
    cases.push_back(compare(
        {name, "time to rest, s", "ln(f exp(a v) - f + 1)/(a f mu g), f = mu_fast/mu"},
        {r.slip_duration_s,
         std::log(fast * std::exp(rate * speed_mps) - (fast - 1.0)) / (rate * fast * mu * g),
         1e-7}));
    cases.push_back(
        compare({name, "distance, m", "integral of v/(g mu(v)) dv by quadrature"},
                {r.residual.along_m,
                 integral([&](double v) { return v / slows(v); }, 0.0, speed_mps), 1e-7}));
  }
  return cases;
}

/// Left behind by a constant push: v' = a - g mu(v) from rest.
std::vector<Case> pushed_past_speeds() {
  const FrictionLaw law{1.0, 2.0, 20.0};
  const double a = 5.0, reached_mps = 1.5;
  const auto gains = [&](double v) {
    return a -
           g * mu *
               (law.fast_over_slow - (law.fast_over_slow - 1.0) * std::exp(-law.rate_s_per_m * v));
  };
  const std::vector<double> distance{
      integral([&](double v) { return v / gains(v); }, 0.0, reached_mps)};
  std::vector<Crossing> found(1);
  pushed(std::vector<double>(400, -a), law).result(distance, found);
  const std::string name =
      "constant push of 5 m/s2, mu 0.2, twice that when fast, a = 20 s/m, up to 1.5 m/s";
  return {compare({name, "time to go that far, s", "integral of 1/(a - g mu(v)) dv by quadrature"},
                  {found[0].time_s,
                   integral([&](double v) { return 1.0 / gains(v); }, 0.0, reached_mps), 1e-7}),
          compare({name, "speed there, m/s", "the distance is the integral of v/(a - g mu(v)) dv"},
                  {found[0].speed_mps, reached_mps, 1e-7})};
}

}  // namespace

Chapter second_paper_friction() {
  return {
      "2.4 Friction laws", "closed forms",
      R"(Static friction above sliding friction, and friction by speed (Constantinou, Mokha & Reinhorn 1990).
`slide_coupled()` solves the first exactly; `slide_on_building()` solves both, here with a tolerance of
1e-9.)",
      joined({constant_push(),
              {growing_push(), metastable_slope()},
              coasting(),
              pushed_past_speeds()})};
}

}  // namespace glissade::verification
