// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "closed_forms/friction_oscillator.hpp"
#include "glissade/block/coupled.hpp"

namespace glissade::closed_forms {

/// Half the range of slip over the last cycle, by slide_coupled(). The base's acceleration is given
/// in samples, 1,000 a cycle; a straight line between them has the sine's own amplitude times
/// sinc^2(pi / n), which is taken out, and overtones of n^-2, which an oscillator's displacement
/// shows to n^-4.
inline double steady_slip_m(const FrictionOscillator& o, int cycles) {
  constexpr int samples_per_cycle = 1000;
  const double n = samples_per_cycle, dt = 2.0 * std::numbers::pi / (o.drive_radps * n);
  const double sinc = std::sin(std::numbers::pi / n) / (std::numbers::pi / n);
  const double amplitude = o.base_amplitude_m * o.drive_radps * o.drive_radps / (sinc * sinc);
  std::vector<double> base;
  for (int i = 0; i <= cycles * samples_per_cycle; ++i)
    base.push_back(-amplitude * std::cos(2.0 * std::numbers::pi * (i % samples_per_cycle) / n));
  std::vector<CoupledPoint> history;
  slide_coupled({dt, base}, {}, {{2.0 * std::numbers::pi / o.omega_radps, 0.0}, o.mass_ratio, {}},
                {.friction = o.friction, .gravity_mps2 = o.gravity_mps2}, history);
  const double end = static_cast<double>(cycles * samples_per_cycle) * dt;
  double least = 1e300, most = -1e300;
  for (const CoupledPoint& p : history) {
    if (p.time_s < end - samples_per_cycle * dt || p.time_s > end) continue;
    least = std::min(least, p.displacement_m);
    most = std::max(most, p.displacement_m);
  }
  return 0.5 * (most - least);
}

}  // namespace glissade::closed_forms
