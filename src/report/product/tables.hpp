// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/product_sheet.hpp"
#include "glissade/report/table.hpp"

// The tables of a product sheet: lengths are numbers in its unit, which the names of columns state.
namespace glissade {

/// A row for each target and slope, a column for each friction, rounded up.
Table design_displacements_table(const ProductSheet& sheet);
/// The same by building period.
Table displacements_by_period_table(const ProductSheet& sheet);
/// The large event and the smaller ones of the design life, of a sheet with a hazard curve.
Table life_displacements_table(const ProductSheet& sheet);
/// A row for each target, slope and friction, with all digits.
Table all_displacements_table(const ProductSheet& sheet);
/// What a standard prescribes at each target.
Table prescribed_displacements_table(const ProductSheet& sheet);

/// "the largest of the table is 14 in, at S_DS 1.5 g, ..."
std::string largest_sentence(const ProductSheet& sheet);

}  // namespace glissade
