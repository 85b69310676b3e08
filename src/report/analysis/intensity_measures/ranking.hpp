// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Below it a measure is called insufficient.
inline constexpr double significant_p = 0.05;

/// The rows of one run and threshold, the best first.
using Ranking = std::span<const RankedMeasure>;
std::vector<Ranking> rankings_of(const Results& results);
/// The one that the figure shows: of the first run the middle threshold of those that are ranked.
Ranking shown_ranking(const Results& results);

/// Whether it is known that ln capacity in it depends on magnitude or distance.
bool is_insufficient(const RankedMeasure& row);

Table intensity_measures_table(const Results& results);
Figure intensity_measures_figure(const Results& results);

}  // namespace glissade
