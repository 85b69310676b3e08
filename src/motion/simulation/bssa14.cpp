// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/bssa14.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bssa14_coefficients.hpp"
#include "glissade/core/contract.hpp"
#include "period_table.hpp"

namespace glissade {
namespace {

constexpr double centimetre_m = 0.01;
const Bssa14Row& pgv_row = bssa14_rows[0];
const Bssa14Row& pga_row = bssa14_rows[1];

double event_and_path(const Bssa14Row& k, const Scenario& scenario) {
  const double beyond_hinge = scenario.magnitude - k.mh;
  const double style =
      scenario.mechanism == FaultMechanism::reverse ? k.e_reverse : k.e_strike_slip;
  const double source = beyond_hinge <= 0.0  // eq. 2
                            ? style + k.e4 * beyond_hinge + k.e5 * beyond_hinge * beyond_hinge
                            : style + k.e6 * beyond_hinge;
  const double distance_km =
      std::hypot(scenario.distance_km, k.h_km);  // eq. 4, with M_ref 4.5, R_ref 1 km (eq. 3)
  return source + (k.c1 + k.c2 * (scenario.magnitude - 4.5)) * std::log(distance_km) +
         k.c3 * (distance_km - 1.0);
}

double site(const Bssa14Row& k, double vs30_mps, double rock_pga_g) {
  const double linear = k.c * std::log(std::min(vs30_mps, k.vc_mps) / 760.0);  // eq. 6
  const double f2 =
      k.f4 * (std::exp(k.f5 * (std::min(vs30_mps, 760.0) - 360.0)) - std::exp(k.f5 * 400.0));
  return linear + f2 * std::log((rock_pga_g + 0.1) / 0.1);  // eqs. 7, 8
}

double median(const Bssa14Row& k, const Scenario& scenario) {
  const double rock_pga_g =
      std::exp(event_and_path(pga_row, scenario));  // at 760 m/s the site term is zero
  return std::exp(event_and_path(k, scenario) + site(k, scenario.vs30_mps, rock_pga_g));
}

/// The value at x of the line through (x0, y0) and (x1, y1), constant outside.
double ramp(double x, double x0, double x1, double y0, double y1) {
  return std::lerp(y0, y1, std::clamp((x - x0) / (x1 - x0), 0.0, 1.0));
}

/// The coefficients at a period, interpolated in ln T.
Bssa14Row coefficients(double period_s) {
  const auto [below, above, weight] = bracket_period(std::span(bssa14_rows).subspan(1), period_s);
  const auto mix = [&](double Bssa14Row::*member) {
    return std::lerp(below.*member, above.*member, weight);
  };
  Bssa14Row row{};
  for (const auto member : {&Bssa14Row::e_strike_slip,
                            &Bssa14Row::e_reverse,
                            &Bssa14Row::e4,
                            &Bssa14Row::e5,
                            &Bssa14Row::e6,
                            &Bssa14Row::mh,
                            &Bssa14Row::c1,
                            &Bssa14Row::c2,
                            &Bssa14Row::c3,
                            &Bssa14Row::h_km,
                            &Bssa14Row::c,
                            &Bssa14Row::vc_mps,
                            &Bssa14Row::f4,
                            &Bssa14Row::f5,
                            &Bssa14Row::r1_km,
                            &Bssa14Row::r2_km,
                            &Bssa14Row::dphi_r,
                            &Bssa14Row::dphi_v,
                            &Bssa14Row::phi1,
                            &Bssa14Row::phi2,
                            &Bssa14Row::tau1,
                            &Bssa14Row::tau2})
    row.*member = mix(member);
  return row;
}

struct PredictorRange {
  const char *what, *unit;
  double least, most;
};

}  // namespace

std::vector<std::string> outside_bssa14(const Scenario& scenario) {
  std::vector<std::string> found;
  const auto check = [&](const PredictorRange& range, double value) {
    if (value >= range.least && value <= range.most) return;
    found.push_back(fmt::format(
        "{} of {:g}{} is outside {:g} to {:g}{}, the range of BSSA14 (Boore et al. 2014; "
        "recalled): its spectra are extrapolated",
        range.what, value, range.unit, range.least, range.most, range.unit));
  };
  check({"magnitude", "", 3.0, 8.5}, scenario.magnitude);
  check({"distance", " km", 0.0, 400.0}, scenario.distance_km);
  check({"V_S30", " m/s", 150.0, 1500.0}, scenario.vs30_mps);
  return found;
}

double bssa14_median_sa_g(const Scenario& scenario, double period_s) {
  GLISSADE_EXPECTS(scenario.distance_km >= 0.0 && scenario.vs30_mps > 0.0);
  return median(coefficients(period_s), scenario);
}

double bssa14_median_pgv_mps(const Scenario& scenario) {
  return median(pgv_row, scenario) * centimetre_m;
}

double Bssa14Dispersion::total() const { return std::hypot(between_events, within_event); }

Bssa14Dispersion bssa14_dispersion(const Scenario& scenario, double period_s) {
  const Bssa14Row k = coefficients(period_s);
  const double tau = ramp(scenario.magnitude, 4.5, 5.5, k.tau1, k.tau2);  // eq. 14
  const double phi =
      ramp(scenario.magnitude, 4.5, 5.5, k.phi1, k.phi2) +  // eqs. 15-17
      ramp(std::log(scenario.distance_km), std::log(k.r1_km), std::log(k.r2_km), 0.0, k.dphi_r) -
      ramp(std::log(scenario.vs30_mps), std::log(225.0), std::log(300.0), k.dphi_v, 0.0);
  return {tau, phi};
}

}  // namespace glissade
