// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

// The page, the tables and the figures of a report lie in folders where the user may keep files of
// his own. report_files.txt beside the page lists those of the report: no other file is removed.
namespace glissade {

/// Before a report is written: removes what is left of an earlier one, and lists what the next one
/// writes. Throws InputError, before anything is removed, where one of the files is a link or no
/// regular file, or, without `overwrite`, is there and not of the earlier report.
/// @param names below the folder: "report.html", "tables/slip.csv", "figures/ida.svg"
void begin_report(const std::filesystem::path& folder, const std::vector<std::string>& names,
                  bool overwrite);

/// Removes the files of a report, also those that its writer had not ended when it was killed.
void remove_report(const std::filesystem::path& folder);

}  // namespace glissade
