// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/io/suite_import.hpp"
#include "import/search_report.hpp"

namespace glissade {

/// Puts the components of one station and event together: those of a row of the report, else of one
/// event and station by their headers, else of one name but for the direction; adds the records,
/// and what belongs to none with its reason.
/// @param report null: none was given
void pair_components(SuiteImport& found, const SearchReport* report, const ImportOptions& options);

}  // namespace glissade
