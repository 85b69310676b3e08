// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/report/table.hpp"

namespace glissade {

/// Writes the tables as sheets of an Excel workbook: a cell that is a number, with a unit or
/// without, is a number there, and its unit is its format. Nothing where the program was built
/// without libxlsxwriter. Throws InputError where it cannot be written.
void write_workbook(const std::vector<Table>& tables, const std::filesystem::path& file);

}  // namespace glissade
