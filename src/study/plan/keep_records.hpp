// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// Which records of a suite a study file names.
struct RecordChoice {
  std::filesystem::path study_file, suite_file;  ///< for messages
  std::vector<std::string> ids;                  ///< empty: all
};

/// Leaves the records chosen, as the suite orders them. Throws InputError for ids it does not have.
void keep_records(const RecordChoice& choice, Suite& suite);

}  // namespace glissade
