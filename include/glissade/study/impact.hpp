// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// First crossings by (record, sample, level, threshold), the last fastest; NaN where a history
/// does not get there, in both.
struct CrossingArrays {
  std::size_t records = 0, samples = 0;
  std::span<const double> levels, thresholds_m;
  std::span<const double> time_s, speed_mps;
};

/// By (threshold, level). Records are the independent unit: intervals resample them whole, and
/// percentiles of speed are of what the drawn records' histories that get there bring.
std::vector<ImpactStatistics> impact_statistics(const CrossingArrays& crossings,
                                                const BootstrapOptions& options);

}  // namespace glissade
