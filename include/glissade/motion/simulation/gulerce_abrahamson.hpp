// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/motion/simulation/scenario.hpp"

namespace glissade {

/// Median ratio of vertical to horizontal 5 % damped spectral acceleration (Gulerce & Abrahamson
/// 2011, Earthquake Spectra 27(4):1023-1047). The reference PGA on rock (Vs30 1100 m/s) is
/// BSSA14's. Period 0, or below 0.01 s, is PGA; ln(V/H) is interpolated in ln T. Periods to 10 s, M
/// 5-8.5, distance to 200 km.
double vertical_to_horizontal_ratio(const Scenario& scenario, double period_s);

}  // namespace glissade
