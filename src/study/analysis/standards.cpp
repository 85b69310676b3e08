// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/standards.hpp"

namespace glissade {

Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards) {
  return standard == Standard::seaoc_pv1_2012
             ? seaoc_pv1_2012_displacement(sds_g, standards.category)
             : asce7_16_displacement(sds_g, standards.importance);
}

}  // namespace glissade
