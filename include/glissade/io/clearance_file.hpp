// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/study/clearance_study.hpp"

namespace glissade {

/// Whether a study file has a [clearance_study] table: a cheap look, nothing else is checked.
/// Throws InputError where the file cannot be read or is not TOML.
bool is_clearance_study(const std::filesystem::path& file);

/// The clearance study a TOML file describes (studies/README.md tells the keys), checked; its
/// suites are looked for beside it, not read. Throws InputError with everything that is wrong.
ClearanceConfig read_clearance_study(const std::filesystem::path& file);

/// The version of the layout of a clearance study's results file; a reader refuses others.
inline constexpr int clearance_format_version = 1;

/// Writes an HDF5 file that holds all of `results` and nothing else, as write_results() does.
void write_clearance(const std::filesystem::path& file, const ClearanceResults& results);

/// Whether a file is a clearance study's results; false also where it cannot be read.
bool is_clearance_results(const std::filesystem::path& file);

/// Reads what write_clearance wrote: equal to the last bit. Throws InputError for files that are no
/// such results, of another format version, cut short or damaged.
ClearanceResults read_clearance(const std::filesystem::path& file);

}  // namespace glissade
