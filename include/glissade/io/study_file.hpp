// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/io/text_files.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The study a TOML file describes (keys: studies/GRAMMAR.md), checked, with defaults
/// filled in; its suite is looked for beside it, not read. Throws InputError with everything that
/// is wrong: unknown keys (and the nearest known one), values outside their range, settings that
/// contradict each other.
StudyConfig read_study(const std::filesystem::path& file);
/// @param files those of the study, read before or now
StudyConfig read_study(const std::filesystem::path& file, TextFiles& files);

/// The study of finished results with other analyses. Throws InputError, beside what read_study()
/// throws, where it differs from the text of the study that was run in more than the tables that
/// are read from the same histories, or names a file that has changed since (but a hazard curve).
StudyConfig read_study_again(const std::filesystem::path& file, const Results& run);

}  // namespace glissade
