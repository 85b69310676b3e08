// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/io/journal.hpp"

namespace glissade {

/// The files of a results folder that belong to its journals.
struct JournalNames {
  std::filesystem::path folder, identity, lock;
  explicit JournalNames(const std::filesystem::path& run_folder);
  /// Of the units of a rank: the first session, the second (the run is resumed) ...
  std::filesystem::path units(int rank, int session) const;
  std::vector<std::filesystem::path> all_units() const;  ///< that are there, sorted
};

/// The first record of a file of units: whose they are.
std::string units_head(const RunIdentity& run);

}  // namespace glissade
