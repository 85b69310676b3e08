// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The rows of one kind of array and one standard, by S_DS.
using VerdictKind = std::span<const VerdictRow>;
std::vector<VerdictKind> verdict_kinds(const VerdictResults& verdict);

/// Of a row, by its position: "between arrays" first, where they have neighbours.
std::span<const VerdictSeparation> separations_of(const VerdictResults& verdict, std::size_t row);
/// Of some, the one that most probably is too small at DBE; null of none.
/// @param factor on the prescribed displacement
const VerdictSeparation* governing_of(std::span<const VerdictSeparation> separations,
                                      double factor);

/// "friction 0.4, slope 3 degrees"
std::string kind_text(const VerdictRow& row);

/// Where two arrays stand: "on one slope".
std::string neighbours_text(const Results& results);

/// R of the building; 0: it stays elastic.
double response_modification(const Results& results, const VerdictRow& row);

/// A row for each prescribed displacement.
Table verdict_table(const Results& results);
/// A row for each kind of array and standard.
Table verdict_summary_table(const Results& results);

/// A row for each separation of each prescribed displacement.
Table verdict_separations_table(const Results& results);
/// A row for each kind of array and standard: the largest probabilities.
Table verdict_separations_summary_table(const Results& results);

/// The displacement with the accepted probability over the prescribed one, by S_DS.
Figure verdict_figure(const Results& results);
/// The probability that two arrays need more than their separation, by S_DS.
Figure verdict_separations_figure(const Results& results);

}  // namespace glissade
