// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// First crossings of some cases, by (threshold, level). Records are the independent unit:
/// intervals resample them whole, and percentiles of speed are over those histories of
/// the drawn records that reach it.
std::vector<ImpactStatistics> impact_statistics(const HistoryTable& histories, CaseSlice cases,
                                                std::span<const double> levels,
                                                std::span<const double> thresholds_m,
                                                const BootstrapOptions& options);

}  // namespace glissade
