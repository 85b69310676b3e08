// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/io/suite_file.hpp"

namespace glissade {

/// A record (or simulated motion) of a library, and the factor it gets in a suite made from it.
struct ScaledRecord {
  std::string id;
  double scale = 1.0;
};

/// The head of a suite made from a library's records.
struct SuiteHead {
  std::string name, description;
  std::optional<StatedTarget> target;  ///< none: that of the library
  std::vector<std::string> comments;   ///< lines at the head of the file
  bool nearest_to_target = false;      ///< as that of Suite
};

/// The suite file, to be written into `folder`, of some [[record]] or [[motion]] entries of the
/// suite file `library`: their metadata and files as they stand there, every number exact, with new
/// factors. A file the library has beside itself is named relative to `folder`; others keep their
/// name, to be found by GLISSADE_RECORDS. Throws InputError as load_suite does where the library
/// cannot be read, and where it has no record of an id.
std::string suite_of_records_toml(const std::filesystem::path& library, const SuiteHead& head,
                                  const std::vector<ScaledRecord>& records,
                                  const std::filesystem::path& folder);

}  // namespace glissade
