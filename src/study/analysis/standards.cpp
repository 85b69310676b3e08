// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/standards.hpp"

#include <fmt/format.h>

#include "glissade/standards/conditions.hpp"
#include "words/plan_notes.hpp"

namespace glissade {

Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards) {
  return standard == Standard::seaoc_pv1_2012
             ? seaoc_pv1_2012_displacement(sds_g, standards.category)
             : asce7_16_displacement(sds_g, standards.importance);
}

/// Cases that a standard does not prescribe for.
std::vector<std::string> StandardsAnalysis::plan_notes(const StudyOutline& study) {
  std::vector<std::string> notes;
  for (const Standard standard : study.config.standards.compare) {
    std::size_t outside = 0;
    for (std::size_t i = 0; i < study.cases; ++i) {
      const Case c = study.case_of(i);
      const double friction = stated_friction(study.config, c);
      if (!is_within(standard, {.slope_deg = c.slope_deg, .friction = friction})) ++outside;
    }
    if (outside == 0) continue;
    notes.push_back(
        fmt::format("{:.3g} % of the cases are outside the range of the prescribed value of {} "
                    "(slope of {:.3g} "
                    "degrees or less, friction of {:g} or more); {}",
                    100.0 * static_cast<double>(outside) / static_cast<double>(study.cases),
                    standard == Standard::seaoc_pv1_2012 ? "SEAOC PV1-2012" : "ASCE 7-16",
                    slope_limit_deg(standard), friction_limit(standard),
                    study.config.chart ? "the chart gives no value of it for them"
                                       : "they are compared with it all the same"));
  }
  return notes;
}

}  // namespace glissade
