// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figures.hpp"
#include "glissade/study/results.hpp"

// What the figures share: titles, axes, counts.
namespace glissade {

/// `'NAME.dat'`
std::string quoted_file(const FileName& name);
/// Title in bold with a smaller line below.
std::string title_of(const Figure& figure, const std::string& below);
/// `set xlabel '...'`
std::string axis(const std::string& which, const std::string& label);
/// The opposite axis in inches, for an axis of slip from 0 to `largest_m`.
std::string inches_beside(const std::string& which, double largest_m,
                          const std::string& label = "Peak slip in plan");
/// "S_DS = 0.840 g" from the axis label "S_DS (g)".
std::string at_intensity(const Results& results, double value);
/// "22 records x 1024 samples"
std::string counts_of(const Results& results);
/// "friction mu normal, mean 0.55, std 0.04" where a line has room for it, else "sampled friction":
/// captions tell it all.
std::string friction_of(const RunResults& run);
/// "0.15 m (5.91 in), 0.30 m (11.8 in)"
std::string list_of_lengths(const std::vector<double>& lengths_m);
/// Up to `count` of the levels, spread evenly, the highest included.
std::vector<double> some_levels(const std::vector<double>& levels, std::size_t count);
/// A gnuplot point type: filled shapes of different outline, in turn.
int point_symbol(std::size_t index);

/// The finite slips of records first <= i < last at a level, over all samples.
std::vector<double> histories_at(const HistoryTable& histories, CaseSlice cases,
                                 std::size_t first, std::size_t last, std::size_t level);

}  // namespace glissade
