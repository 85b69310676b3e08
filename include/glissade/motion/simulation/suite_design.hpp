// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "glissade/motion/simulation/synthetic_suite.hpp"
#include "glissade/motion/walters_level.hpp"

namespace glissade {

/// The seven scenarios, chosen over the ranges of the level: larger magnitudes and shorter
/// distances at higher levels.
const std::array<Scenario, 7>& level_scenarios(int level);

/// Designs the built-in suite of an Intensity Level: simulates thirty candidates for each scenario,
/// calibrates the gain of the suite on all of them, selects one of each scenario so that the SRSS
/// spectra of the seven are closest to the MCE spectrum of the level, and scales them as Walters
/// does (suite_scaling.hpp). Deterministic in (level, seed); about half a minute. InputError for a
/// level outside 0-4 or if the scale limit cannot be met.
SyntheticRecipe design_suite(int level, std::uint64_t seed);

}  // namespace glissade
