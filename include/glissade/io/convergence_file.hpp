// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/study/convergence.hpp"

namespace glissade {

/// Whether a study file has a [convergence] table: a cheap look, nothing else is checked. Throws
/// InputError where the file cannot be read or is not TOML.
bool is_convergence_study(const std::filesystem::path& file);

/// The convergence study a TOML file describes (studies/README.md tells the keys), checked; its
/// suite is looked for beside it, not read. Throws InputError with everything that is wrong.
ConvergenceConfig read_convergence_study(const std::filesystem::path& file);

/// The version of the layout of a convergence study's results file; a reader refuses others.
inline constexpr int convergence_format_version = 1;

/// Writes an HDF5 file that holds all of `results` and nothing else, as write_results() does.
void write_convergence(const std::filesystem::path& file, const ConvergenceResults& results);

/// Whether a file is a convergence study's results; false also where it cannot be read.
bool is_convergence_results(const std::filesystem::path& file);

/// Reads what write_convergence wrote: equal to the last bit. Throws InputError for files that are
/// no such results, of another format version, cut short or damaged.
ConvergenceResults read_convergence(const std::filesystem::path& file);

}  // namespace glissade
