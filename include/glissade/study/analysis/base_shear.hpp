// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/analysis/suite_mean.hpp"

namespace glissade {

/// Peak base shear of the building over its weight without the array: the SRSS of the peaks along
/// both axes.
struct BaseShearResults {
  std::vector<SuiteMean> means;  ///< by (suite, condition)
};

BaseShearResults base_shear_results(const Results& results);

}  // namespace glissade
