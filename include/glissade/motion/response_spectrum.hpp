// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace glissade {

/// Pseudo-spectral acceleration omega^2 max|u| of a linear SDOF oscillator at rest, for piecewise-linear ground
/// acceleration, by the recurrence that is exact at the samples (Nigam & Jennings 1969, BSSA 59(2):909-922). The
/// response goes on after the record (which ends as Record tells) for one full period of free vibration.
/// period 0 gives the peak ground acceleration. All periods are advanced together, sample by sample.
///
/// @param acceleration_mps2 ground acceleration, any length >= 1
/// @param periods_s each >= 0
/// @param damping_ratio in [0, 1)
/// @return one value per period, m/s2
std::vector<double> pseudo_acceleration_spectrum(double dt_s, std::span<const double> acceleration_mps2,
                                                 std::span<const double> periods_s, double damping_ratio = 0.05);

}  // namespace glissade
