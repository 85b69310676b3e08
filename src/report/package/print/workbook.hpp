// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "glissade/report/table.hpp"

namespace glissade {

/// The program was built with libxlsxwriter.
extern const bool makes_workbooks;

/// Whether a file as libxlsxwriter writes it has its directory, and each of its parts to its end.
bool is_whole_workbook(std::string_view bytes);

/// Writes the tables as sheets of an Excel workbook: a cell that is a number, with a unit or
/// without, is a number there, and its unit is its format. Throws InputError where it cannot be
/// written.
void write_workbook(const std::vector<Table>& tables, const std::filesystem::path& file);

}  // namespace glissade
