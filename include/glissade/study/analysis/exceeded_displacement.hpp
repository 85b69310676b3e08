// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/results.hpp"

namespace glissade {

/// What some histories exceed with a probability.
struct ExceededDisplacement {
  double value_m = 0.0;  ///< infinite where so many slide freely
  Interval interval;     ///< 95 %, over records
};
ExceededDisplacement exceeded_displacement(const Results& results, CaseSlice cases,
                                           std::size_t level, double probability);

}  // namespace glissade
