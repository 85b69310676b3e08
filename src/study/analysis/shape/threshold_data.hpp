// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/fragility/shape.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

// What the histories of some cases give of one threshold.

std::vector<std::size_t> all_of(CaseSlice cases);

/// Capacities, exact or above the highest level.
std::vector<Bracket> capacities_of(const HistoryTable& histories,
                                   const std::vector<std::size_t>& cases, std::size_t threshold,
                                   double highest_level);
std::vector<Bracket> capacities_of(const Results& results, CaseSlice cases, std::size_t threshold);

/// With the independent unit in the place of the record.
std::vector<Bracket> by_unit(std::vector<Bracket> rows, const HistoryTable& histories);

/// Counts at the levels, by independent unit. Of multiple stripes without events a motion that is
/// in several stripes is one.
std::vector<Stripe> stripes_of(const Results& results, const std::vector<std::size_t>& cases,
                               std::size_t threshold);

/// Of all thresholds, with the displacements where all of them are known.
ShapeData shape_data(const Results& results, CaseSlice cases);

}  // namespace glissade
