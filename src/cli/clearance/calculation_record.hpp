// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glissade/report/package.hpp"
#include "glissade/report/product_sheet.hpp"
#include "glissade/report/site_sheets.hpp"
#include "run/run_record.hpp"

// run.json and package.json of a calculation, in the folder above those of its studies.
namespace glissade::cli {

/// What a calculation rests on.
struct CalculationIdentity {
  std::filesystem::path project;  ///< absolute
  std::string project_sha256;
};

/// Throws InputError where run.json could not state the path of the project.
void check_project_path(const std::filesystem::path& project);

/// Whether `glissade clearance` began in the folder.
bool is_calculation(const std::filesystem::path& folder);
bool is_finished_calculation(const std::filesystem::path& folder);

/// Throws InputError where none began in the folder.
CalculationIdentity read_calculation(const std::filesystem::path& folder);

/// Throws InputError where it is the folder of one site in that of several.
void check_is_no_site(const std::filesystem::path& folder);

/// Started, or stopped, with what goes on with it.
void write_begun_calculation(const CalculationIdentity& identity, RunState state,
                             const std::filesystem::path& folder);

/// run.json, and package.json: what a program takes from the calculation, all digits, metres.
void write_finished_calculation(const CalculationIdentity& identity,
                                const CalculationPackage& package, int ranks,
                                const std::filesystem::path& folder);

/// The same of several sites: run.json and sites.json.
void write_finished_sites(const CalculationIdentity& identity, const SiteSheets& sheets, int ranks,
                          const std::filesystem::path& folder);
/// The same of a product sheet: run.json and product.json.
void write_finished_product(const CalculationIdentity& identity, const ProductSheet& sheet,
                            int ranks, const std::filesystem::path& folder);

/// "glissade clearance --resume DIR": of a site that of all sites.
std::string resume_calculation_command(const std::filesystem::path& folder);

}  // namespace glissade::cli
