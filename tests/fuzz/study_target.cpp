// SPDX-License-Identifier: GPL-3.0-or-later
// Study files. A suite named "suite.toml" is there; a study does not read it.
#include <algorithm>
#include <cmath>
#include <functional>

#include "check.hpp"
#include "glissade/io/study_file.hpp"

namespace {

/// Above zero and increasing, as levels and thresholds must be.
bool is_increasing(const std::vector<double>& values) {
  return !values.empty() && values.front() > 0.0 && std::isfinite(values.back()) &&
         std::is_sorted(values.begin(), values.end(), std::less_equal<>());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using glissade::fuzz::check;
  static const auto suite = glissade::fuzz::folder().write("suite.toml", "");
  const auto file = glissade::fuzz::input_file(data, size, "study.toml");
  glissade::fuzz::may_refuse([&] {
    const glissade::StudyConfig study = glissade::read_study(file);
    check(!study.name.empty(), "a study has a name");
    check(is_increasing(study.intensity.levels), "levels increase");
    check(is_increasing(study.thresholds_m), "thresholds increase");
    check(study.sampling.samples > 0, "there is a sample");
    check(study.source_text.size() == size, "the text is kept whole");
  });
  return 0;
}
