// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/building/modes.hpp"

namespace glissade {

/// Modes of a building along one axis. CSV with the columns period_s, participation (at the array)
/// and mass_share, in any order, a row each, the longest period first. Throws InputError that names
/// the line where a number is out of its range, and where the mass shares are above 1 together.
std::vector<Mode> read_modes(const std::filesystem::path& file);

}  // namespace glissade
