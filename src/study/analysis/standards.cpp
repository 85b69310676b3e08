// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/standards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/plan_notes.hpp"

namespace glissade {

Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards) {
  return standard == Standard::seaoc_pv1_2012
             ? seaoc_pv1_2012_displacement(sds_g, standards.category)
             : asce7_16_displacement(sds_g, standards.importance);
}

/// Cases that SEAOC PV1-2012 does not prescribe for.
std::vector<std::string> StandardsAnalysis::plan_notes(const StudyOutline& study) {
  const auto& compare = study.config.standards.compare;
  if (std::ranges::find(compare, Standard::seaoc_pv1_2012) == compare.end()) return {};
  std::size_t outside = 0;
  for (std::size_t i = 0; i < study.cases; ++i) {
    const Case c = study.case_of(i);
    if (!seaoc_pv1_2012_applies(std::abs(c.slope_deg), c.friction)) ++outside;
  }
  if (outside == 0) return {};
  return {fmt::format(
      "{:.0f} % of the cases are outside the range of SEAOC PV1's prescriptive value (slope under "
      "3 degrees and mu above 0.4); {}",
      100.0 * static_cast<double>(outside) / static_cast<double>(study.cases),
      study.config.chart ? "the chart gives no value of it for them"
                         : "they are compared with it all the same")};
}

}  // namespace glissade
