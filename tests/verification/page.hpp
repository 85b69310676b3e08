// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "case.hpp"

namespace glissade::verification {

/// Takes the cases whose reference is another part of this code out of their chapters, into one of
/// their own.
Chapter consistency(std::vector<Chapter>& chapters);

/// The manual in Markdown: totals, findings on the papers, chapters.
std::string page(const std::vector<Chapter>& chapters);

/// All cases, one a row.
std::string cases_csv(const std::vector<Chapter>& chapters);

/// Cells of a line; quotes may hold commas, but no ends of lines.
std::vector<std::string> csv_cells(const std::string& line);

/// A page without what another machine may measure otherwise: the last column of the totals and the
/// numbers in measured blocks.
std::string comparable_page(const std::string& page);

/// Cases without their results.
std::string comparable_cases(const std::string& csv);

/// The first line in which two texts differ, both versions; empty when equal.
std::string first_difference(const std::string& committed, const std::string& made);

/// The same of tables whose numbers may differ by one in the second decimal.
std::string first_difference_of_numbers(const std::string& committed, const std::string& made);

}  // namespace glissade::verification
