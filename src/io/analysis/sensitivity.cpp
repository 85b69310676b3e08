// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/in_files.hpp"
#include "glissade/study/cases/sample_points.hpp"

namespace glissade {
namespace {

bool has_one_orientation(const TomlTable&, const StudyConfig& study) {
  const OrientationConfig& o = study.orientation;
  return (o.choice == OrientationChoice::random || o.choice == OrientationChoice::as_recorded) &&
         o.slope_axis.size() == 1;
}

}  // namespace

AnalysisInFiles SensitivityAnalysis::in_files() {
  return {
      .table = "sensitivity",
      .keys =
          {{"", is_there<&StudyConfig::sensitivity>(),
            "Sobol indices of the records and of each drawn quantity; runs samples x (2 + drawn "
            "quantities) samples. Added to finished results: first order alone, of 32 samples or "
            "more in 8 scrambles or more, or by method monte_carlo"}},
      .needs = {needs_fragility,
                {"a quantity that is drawn",
                 [](auto&, auto& s) { return !drawn_factors(s).empty(); }},
                {"sampling.samples of 2 or more",
                 [](auto&, auto& s) { return s.sampling.samples >= 2; }},
                {"one orientation of a sample (orientation.choice = \"random\" or \"as_recorded\", "
                 "one slope_axis)",
                 has_one_orientation}},
      .of_any_run = true};
}

}  // namespace glissade
