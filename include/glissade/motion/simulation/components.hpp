// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "glissade/motion/simulation/rdk10_parameters.hpp"
#include "glissade/motion/simulation/spectral_gain.hpp"

namespace glissade {

/// Key of the random numbers of one simulated motion.
struct RealizationKey {
  std::uint64_t seed = 0;
  std::uint64_t realization = 0;
};

/// Parameters of the three components before the horizontal ones are rotated.
struct ComponentParameters {
  Rdk10Parameters major, intermediate, vertical;
  double rotation_rad = 0.0;        ///< of the principal axes, uniform over the circle
  SuiteGain short_period_residual;  ///< of this motion; not published, see components.cpp
};

/// Draws them. The horizontal axes are principal: independent noise, correlated parameters
/// (Rezaeian & Der Kiureghian 2012, EESD 41:335-357, the principle; correlations and the Arias
/// ratio of the axes from Dabaghi & Der Kiureghian 2018). The construction for any distance, and
/// the parameters of the vertical, are not published.
ComponentParameters draw_component_parameters(const Scenario& scenario, RealizationKey key);

/// Two rotated horizontals and the vertical, m/s2, equal lengths: before gain and high-pass.
struct RawMotion {
  double dt_s = 0.0;
  std::array<std::vector<double>, 3> acceleration_mps2;
};
RawMotion simulate_raw_motion(const Scenario& scenario, RealizationKey key, double dt_s);

/// Gain, tapered ends, and then the high-pass filter (0.1 Hz): final velocity and displacement are
/// zero except for the remainder of the filter's decay over the 15 s after the motion.
RawMotion shape_motion(const RawMotion& raw, const SuiteGain& gain);

}  // namespace glissade
