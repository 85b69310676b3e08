// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "results/hdf5_file.hpp"

namespace glissade {

/// The kind of a results file, and its name in messages.
struct ResultsKind {
  const char* file_type;
  int format_version;
  const char* name;  ///< "glissade results file"
};

/// Writes an HDF5 file, and behind what HDF5 reads a checksum of it, to a temporary name, and
/// renames it when complete: the same content gives the same bytes. Throws InputError; an older
/// file stays as it was.
void write_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                      const std::function<void(const Hdf5Writer&)>& content);

/// Puts the checksum behind a file that ends with its HDF5 content, which `output` has open.
void append_checksum(const std::filesystem::path& file, OutputFile& output);

/// Throws InputError for files of another kind or version, cut short, damaged or changed.
void read_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                     const std::function<void(const Hdf5Reader&)>& content);

/// Parts of a file that do not fit each other.
inline void expect_fit(bool fits, const char* part, const char* whole) {
  if (!fits) throw Hdf5Error(std::string("fit ") + part + " to the " + whole);
}

}  // namespace glissade
