// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The rule of the folders that commands write into, where the user may keep files of his own.
// report_files.txt lists what is the program's: no other file is replaced or removed.
namespace glissade {

/// Every name that commands write below a results folder: # is a whole number, * a FileName, and
/// that of a folder ends with "/".
std::vector<std::string> output_names();
bool is_output_name(const std::string& name);

/// Throws InputError where one of these names is a link, or no file (folder): what it leads to is
/// not the program's. Names with * are looked at when they are written.
void check_own(const std::filesystem::path& folder);

/// Throws InputError where one of the files is there, and is not listed.
/// @param names below the folder: "report.html", "tables/slip.csv", "figures/ida.svg"
void check_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// The same; then lists them, before they are written.
void begin_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Once a report is written whole: removes the pages, tables and figures of an earlier one that
/// are not among `names`.
void end_report(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Removes all that is listed, also what its writer had not ended when it was killed.
void remove_listed(const std::filesystem::path& folder);

/// Whether all that is listed is there and not empty; false where nothing is listed.
bool is_whole(const std::filesystem::path& folder);

}  // namespace glissade
