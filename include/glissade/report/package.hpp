// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/design/design_clearance.hpp"
#include "glissade/study/results.hpp"

// The calculation package of a project: one screen for the terminal, and a page to hand in.
namespace glissade {

/// A file of a ground motion.
struct ComponentFile {
  std::string record;     ///< id of its record
  std::string component;  ///< "first", "second", "vertical"
  std::string file;       ///< as the suite names it
  std::string sha256;
};

struct CalculationPackage {
  const Project& project;
  const DesignClearance& design;
  const Results& demand;
  const Results& probability;
  std::vector<ComponentFile> files;  ///< none of simulated motions
  std::string project_sha256, suite_sha256;
  std::string build;  ///< commit and compiler
};

/// Open items among them.
std::vector<std::string> warnings_of(const DesignClearance& design);

/// Of all available separations, and of one: "sufficient", "not sufficient", "not applicable",
/// "open", "not stated".
const char* to_string(SeparationVerdict verdict);

/// Within 80 columns, in plain ASCII.
std::string package_screen(const CalculationPackage& package);

/// Writes out_dir/package.html, and package.xlsx, with figures and tables beside it, in the place
/// of an earlier one (results_folder.hpp), and prints it to package.pdf: false where WeasyPrint is
/// not installed. Throws InputError where a file cannot be written, or gnuplot or WeasyPrint does
/// not succeed.
bool write_package(const CalculationPackage& package, const std::filesystem::path& out_dir);

}  // namespace glissade
