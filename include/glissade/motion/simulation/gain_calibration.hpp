// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/motion/simulation/components.hpp"

namespace glissade {

/// A simulated motion and its scenario.
struct EnsembleMember {
  Scenario scenario;
  RawMotion raw;
};

/// Target median spectra of the simulations, in m/s2: RotD50 of BSSA14, and that times the V/H of
/// Gulerce & Abrahamson.
std::vector<double> target_horizontal_mps2(const Scenario& scenario,
                                           std::span<const double> periods_s);
std::vector<double> target_vertical_mps2(const Scenario& scenario,
                                         std::span<const double> periods_s);

/// RotD50 of the horizontals, over six orientations 30 degrees apart (the shipped recipes are
/// calibrated with these; rotated_spectrum() has all), and the spectrum of the vertical, m/s2.
std::vector<double> horizontal_rotd50_mps2(const RawMotion& motion,
                                           std::span<const double> periods_s);
std::vector<double> vertical_spectrum_mps2(const RawMotion& motion,
                                           std::span<const double> periods_s);

/// The sixteen frequencies, 0.25 to 50 Hz, at which the gain is given.
std::span<const double> gain_frequencies_hz();

/// The gain for which the ensemble's median ratio (geometric mean) of simulated to target spectrum
/// is one, by five updates ln H -= 0.8 ln(ratio). Not published; RDK10 was calibrated on firm
/// ground beyond 10 km only.
SuiteGain calibrate_gain(std::span<const EnsembleMember> ensemble);

}  // namespace glissade
