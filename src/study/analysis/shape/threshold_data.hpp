// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/fragility/shape.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// What the histories of some cases give of one threshold, by record. Those that slide freely are
/// counted beside the others.
struct ThresholdData {
  std::vector<RecordStripes> stripes;
  std::vector<RecordCapacities> capacities;
};
ThresholdData threshold_data(const Results& results, CaseSlice cases, std::size_t threshold);

/// Of multiple stripes, by motion: one that is in several stripes is one record of the data, whose
/// histories depend on each other.
std::vector<RecordStripes> multiple_stripes(const Results& results, CaseSlice cases,
                                            double threshold_m);

/// Of all thresholds, with the displacements where all of them are known.
ShapeData shape_data(const Results& results, CaseSlice cases);

}  // namespace glissade
