// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/io/study_file.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// The study in a document, which may be a changed one (TomlDocument::put).
/// @param files that the document reads
StudyConfig read_study(TomlDocument& document, const std::filesystem::path& file,
                       const TextFiles& files);

}  // namespace glissade
