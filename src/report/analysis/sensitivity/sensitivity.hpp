// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The places of records and all that is drawn in SensitivityResults::factors; then each quantity.
constexpr std::size_t records_factor = 0, all_drawn_factor = 1, first_drawn_factor = 2;

/// Of the capacities, a row for each; up to `count` of one combination.
std::vector<const SpreadRow*> capacity_rows(const SensitivityResults& found);
std::vector<const SpreadRow*> first_capacity_rows(const SensitivityResults& found,
                                                  std::size_t count);

/// A row for each capacity and factor.
Table spread_table(const Results& results);
/// The same for whether displacement reaches each threshold at each level.
Table exceedance_spread_table(const Results& results);
Table design_friction_table(const Results& results);

/// Shares of the variance of ln capacity, a bar for each factor.
Figure spread_figure(const Results& results);
/// Total indices of exceedance over intensity.
Figure spread_over_intensity_figure(const Results& results);

}  // namespace glissade
