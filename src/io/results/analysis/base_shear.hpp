// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/analysis/suite_mean.hpp"

namespace glissade {

template <class Archive, class B>
void exchange_base_shear(const Archive& archive, const IntensityScale& scale, B& base_shear) {
  exchange_suite_means(
      archive, scale,
      {"base_shear", "-",
       "SRSS of the peak base shears, over the building's weight without the array"},
      base_shear.means, std::identity{});
}

}  // namespace glissade
