// SPDX-License-Identifier: GPL-3.0-or-later
// Study files of every kind. A suite named "suite.toml" is there; a study does not read it.
#include <algorithm>
#include <cmath>
#include <functional>

#include "check.hpp"
#include "glissade/io/clearance_file.hpp"
#include "glissade/io/study_file.hpp"

namespace {

using glissade::fuzz::check;

bool increases(const std::vector<double>& values) {
  return !values.empty() && std::isfinite(values.front()) && std::isfinite(values.back()) &&
         std::is_sorted(values.begin(), values.end(), std::less_equal<>());
}

bool is_on(const std::vector<double>& axis, double value) {
  return std::find(axis.begin(), axis.end(), value) != axis.end();
}

void check_samples(const glissade::StudyConfig& study) {
  check(increases(study.intensity.levels) && study.intensity.levels.front() > 0.0,
        "levels increase");
  check(increases(study.thresholds_m) && study.thresholds_m.front() > 0.0, "thresholds increase");
  check(study.sampling.samples > 0, "there is a sample");
}

void check_chart(const glissade::StudyConfig& study) {
  const glissade::ChartConfig& chart = *study.chart;
  check(increases(study.intensity.levels) && study.intensity.levels.front() >= 0.0 &&
            study.intensity.levels.back() > 0.0,
        "levels increase");
  check(increases(chart.slope_deg) && chart.slope_deg.size() > 1 && chart.slope_deg.back() > 0.0,
        "slopes increase");
  check(increases(chart.mu) && chart.mu.size() > 1 && chart.mu.front() >= 0.0,
        "frictions increase");
  check(increases(chart.period_s) && chart.period_s.front() >= 0.0, "periods increase");
  check(is_on(chart.slope_deg, chart.shown_slope_deg) && chart.shown_slope_deg >= 0.0 &&
            is_on(chart.mu, chart.shown_mu) && is_on(study.intensity.levels, chart.shown_level),
        "figures cut through the chart at its values");
  for (const double slope : chart.slope_deg)
    check(slope >= 0.0 || is_on(chart.slope_deg, -slope), "a negative slope has its mirror image");
  for (const glissade::ChartQuestion& q : chart.questions) {
    check(is_on(study.intensity.levels, q.level), "a question is asked at a level");
    check(q.slope_deg >= 0.0 && q.slope_deg <= chart.slope_deg.back(), "and within the slopes");
    check(q.mu.has_value() != q.displacement_m.has_value(), "it asks for one thing");
    check(!q.mu || (*q.mu >= chart.mu.front() && *q.mu <= chart.mu.back()),
          "and within the frictions");
  }
}

void check_clearance(const glissade::ClearanceConfig& study) {
  const glissade::ClearanceGrid& grid = study.grid;
  for (const glissade::ClearanceAxis axis : glissade::clearance_axes)
    check(grid.size(axis) > 0, "no axis is empty");
  for (const auto* axis : {&grid.response_modification, &grid.mass_ratio, &grid.slope_deg,
                           &grid.fraction_of_mce, &grid.period_s})
    check(increases(*axis), "axes increase");
  check(grid.mass_ratio.front() >= 0.0 && grid.mass_ratio.back() <= 1.0, "m/M from 0 to 1");
  for (const glissade::TestedFriction& friction : study.friction)
    check(friction.design() > 0.0, "there is friction");
  check(!study.slope_axes.empty() && !study.suite_files.empty(), "there is a suite and a slope");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto suite = glissade::fuzz::folder().write("suite.toml", "");
  const auto file = glissade::fuzz::input_file(data, size, "study.toml");
  glissade::fuzz::may_refuse([&] {
    if (glissade::is_clearance_study(file)) {
      check_clearance(glissade::read_clearance_study(file));
      return;
    }
    const glissade::StudyConfig study = glissade::read_study(file);
    check(!study.name.empty(), "a study has a name");
    check(study.source_text.size() == size, "the text is kept whole");
    study.chart ? check_chart(study) : check_samples(study);
  });
  return 0;
}
