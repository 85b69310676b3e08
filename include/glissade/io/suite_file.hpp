// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/motion/simulation/synthetic_suite.hpp"

namespace glissade {

/// The suite a TOML file describes (keys: suites/README.md): recorded motions ([[record]],
/// with the files of their components) or a recipe of simulated ones ([simulation], [[motion]]),
/// which are then simulated. Record files are looked for relative to the suite file, else below the
/// folders in the environment variable GLISSADE_RECORDS (colon-separated): by relative path, then
/// by file name anywhere below. Throws InputError with everything that is wrong: keys, missing
/// files (all of them), unreadable records.
Suite load_suite(const std::filesystem::path& file);

/// What the head of a suite file says, without its records: motions = "roof". Throws InputError
/// where the file is not TOML.
bool has_roof_motions(const std::filesystem::path& suite_file);

/// A design spectrum by points: CSV with period_s and design_sa_g (or mce_sa_g). Throws InputError.
DesignTarget read_spectrum(const std::filesystem::path& file);

/// A design target, and the file of one by points.
struct StatedTarget {
  DesignTarget target;
  std::filesystem::path spectrum_file;
};
/// That of a project's [site] or of a suite's [target]; nothing where the file has neither. Throws
/// InputError.
std::optional<StatedTarget> find_stated_target(const std::filesystem::path& file);
/// The same, which the file must have.
StatedTarget read_stated_target(const std::filesystem::path& file);

/// A file of a recorded suite.
struct RecordFile {
  std::string record;     ///< id of its record
  std::string component;  ///< "first", "second", "vertical"
  std::string name;       ///< as the suite file gives it
  std::filesystem::path path;
  std::string inside;  ///< what stands behind the file: a component, or a file of an archive
};
/// Those of a suite that load_suite() reads; none of simulated motions.
std::vector<RecordFile> record_files(const std::filesystem::path& suite_file);

/// SHA-256 of each; of a file in an archive that of this file.
std::vector<std::string> sha256_of(const std::vector<RecordFile>& files);

/// Whether a suite file is a recipe of simulated motions.
bool is_recipe(const std::filesystem::path& suite_file);

/// The recipe in a file with [simulation] and [[motion]]; nothing is simulated.
SyntheticRecipe read_recipe(const std::filesystem::path& file);

}  // namespace glissade
