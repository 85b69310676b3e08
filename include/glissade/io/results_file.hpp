// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glissade/study/results.hpp"

namespace glissade {

/// The version of the results file's layout; a reader refuses others.
inline constexpr int results_format_version = 15;

/// Writes an HDF5 file that holds all of `results` and nothing else: the same results give the same
/// bytes. Written to a temporary name beside `file`, read back and compared, then renamed. Throws
/// InputError, saying why and what to do, where it cannot be written or reads back otherwise;
/// nothing is left then, and an older file stays as it was. Precondition: run labels are distinct
/// and hold no '/'; per-record and per-level arrays fit the results' records and levels.
void write_results(const std::filesystem::path& file, const Results& results);

/// Reads what write_results wrote: equal to the last bit. Throws InputError for files that are no
/// glissade results, of another format version, cut short or damaged.
Results read_results(const std::filesystem::path& file);

/// Of what a results file is.
struct ResultsOrigin {
  std::string study_text, plan_hash;
};
/// Throws as read_results, where the file is not whole.
ResultsOrigin read_origin(const std::filesystem::path& file);

}  // namespace glissade
