// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/motion/simulation/scenario.hpp"

namespace glissade {

/// Median RotD50 5 % damped pseudo-acceleration in g (Boore, Stewart, Seyhan & Atkinson 2014,
/// Earthquake Spectra 30(3):1057-1085, equations 1-11; no basin term, global anelastic
/// attenuation). Period 0, or below 0.01 s, is PGA; coefficients are interpolated in ln T between
/// the tabulated periods, as OpenQuake does. Periods to 10 s, M 3-8.5, R_JB <= 400 km.
double bssa14_median_sa_g(const Scenario& scenario, double period_s);

/// What of an earthquake and site is outside the ranges that the authors give for their model: M 3
/// to 8.5, R_JB to 400 km, V_S30 150 to 1500 m/s (their limits of the predictor variables;
/// recalled). Nothing: all is within.
std::vector<std::string> outside_bssa14(const Scenario& scenario);

/// Median RotD50 peak ground velocity in m/s (same source).
double bssa14_median_pgv_mps(const Scenario& scenario);

/// Standard deviations of ln Sa (their equations 13-17).
struct Bssa14Dispersion {
  double between_events = 0.0;  ///< tau
  double within_event = 0.0;    ///< phi
  double total() const;
};
Bssa14Dispersion bssa14_dispersion(const Scenario& scenario, double period_s);

}  // namespace glissade
