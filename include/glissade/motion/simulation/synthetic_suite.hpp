// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/motion/simulation/scenario.hpp"
#include "glissade/motion/simulation/spectral_gain.hpp"

namespace glissade {

/// One simulated motion of a recipe. `realization` is the key of its random numbers; the same
/// recipe gives the same motion.
struct SyntheticMotion {
  std::string id;
  double magnitude = 0.0, distance_km = 0.0, vs30_mps = 0.0;
  FaultMechanism mechanism = FaultMechanism::strike_slip;
  std::uint64_t realization = 0;
  double scale = 1.0;
};

/// Recipe of a built-in suite (suites/synthetic_*.toml).
struct SyntheticRecipe {
  std::string name, description;
  bool nearest_to_target = false;  ///< as that of Suite
  std::uint64_t seed = 0;
  double dt_s = 0.005;
  double max_scale = 0.0;  ///< Walters (2012) Table 2
  DesignTarget target;
  std::vector<double> gain_frequencies_hz;  ///< increasing; the suite gain is ln-ln linear between,
                                            ///< constant outside
  std::vector<double> horizontal_gain;      ///< zero-phase amplitude gain toward the BSSA14 median:
                                            ///< not published
  std::vector<double> vertical_gain;
  std::vector<SyntheticMotion> motions;
};

Scenario scenario_of(const SyntheticMotion& motion);
SuiteGain gain_of(const SyntheticRecipe& recipe);

/// Simulates one motion (of the recipe, or a candidate for it); its scale is copied, not applied.
Motion simulate_motion(const SyntheticRecipe& recipe, const SyntheticMotion& source);

/// Simulates the recipe's motions. Deterministic: noise and parameters are keyed by (seed,
/// realization).
Suite simulate_suite(const SyntheticRecipe& recipe);

}  // namespace glissade
