// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "glissade/motion/simulation/synthetic_suite.hpp"
#include "glissade/motion/walters_level.hpp"

namespace glissade {

/// The seven scenarios we spread over the level's ranges: larger magnitudes and shorter distances
/// at higher levels.
const std::array<Scenario, 7>& level_scenarios(int level);

/// Designs the built-in suite of a level: simulates thirty candidates for each scenario, calibrates
/// the suite's gain on all of them, takes one of each scenario so that the SRSS spectra of the
/// seven are closest to the level's MCE spectrum, and scales them as Walters does
/// (suite_scaling.hpp). Deterministic in (level, seed); about half a minute. InputError for a level
/// outside 0-4 or where the scale limit cannot be kept.
SyntheticRecipe design_suite(int level, std::uint64_t seed);

}  // namespace glissade
