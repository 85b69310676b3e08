// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// Counts of exceedances at intensity levels: header `im,num_gms,num_exceed`, then a row per level,
/// each level once; im > 0, num_gms a whole number above 0, num_exceed a whole number up to it.
/// Lines that begin with # are comments. Throws InputError with every wrong line.
std::vector<Stripe> read_counts(const std::filesystem::path& file);

/// Capacities: header `im_cap`, then one per line, >= 0 (0: exceeded without shaking, as by an
/// array that slides freely). Lines that begin with # are comments.
std::vector<double> read_capacities(const std::filesystem::path& file);

}  // namespace glissade
