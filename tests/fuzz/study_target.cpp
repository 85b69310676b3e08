// SPDX-License-Identifier: GPL-3.0-or-later
// Study files. A suite named "suite.toml" is there; a study does not read it.
#include <algorithm>
#include <cmath>
#include <functional>

#include "check.hpp"
#include "glissade/io/study_file.hpp"

namespace {

using namespace glissade;
using fuzz::check;

bool increases(const std::vector<double>& values) {
  return !values.empty() && std::isfinite(values.front()) && std::isfinite(values.back()) &&
         std::is_sorted(values.begin(), values.end(), std::less_equal<>());
}

bool is_on(const std::vector<double>& axis, double value) {
  return std::find(axis.begin(), axis.end(), value) != axis.end();
}

void check_quantities(const StudyConfig& study) {
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Quantity& quantity = study.quantities[i];
    const ParameterRange range = parameters()[i].range;
    check(quantity.is_drawn() ? quantity.values.empty() : increases(quantity.values),
          "a quantity is a list that increases, or a distribution");
    for (const double value : quantity.values)
      check(value >= range.min && value <= range.max, "a value lies in its parameter's range");
  }
}

void check_chart(const StudyConfig& study) {
  const ChartConfig& chart = *study.chart;
  const Quantity& mu = study.quantities.at("friction", "mu");
  const std::vector<double>& slopes = study.quantities.at("roof", "slope_deg").values;
  const std::vector<double>& levels = study.intensity.levels;
  check(slopes.size() > 1 && slopes.back() > 0.0, "a chart has slopes");
  for (const double slope : slopes)
    check(slope >= 0.0 || is_on(slopes, -slope), "a negative slope has its mirror image");
  check(is_on(slopes, chart.shown_slope_deg) && chart.shown_slope_deg >= 0.0 &&
            (mu.is_drawn() || is_on(mu.values, chart.shown_mu)) && is_on(levels, chart.shown_level),
        "figures cut through the chart at its values");
  for (const ChartQuestion& q : chart.questions) {
    check(is_on(levels, q.level), "a question is asked at a level");
    check(q.slope_deg >= 0.0 && q.slope_deg <= slopes.back(), "and within the slopes");
    check(q.mu.has_value() != q.displacement_m.has_value(), "it asks for one thing");
    check(!q.mu || mu.is_drawn() || (*q.mu >= mu.values.front() && *q.mu <= mu.values.back()),
          "and within the frictions");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto suite = fuzz::folder().write("suite.toml", "");
  const auto file = fuzz::input_file(data, size, "study.toml");
  fuzz::may_refuse([&] {
    const StudyConfig study = read_study(file);
    check(!study.name.empty(), "a study has a name");
    check(study.source_text.size() == size, "the text is kept whole");
    check(!study.suite_files.empty() && study.sampling.samples > 0,
          "there is a suite and a sample");
    check(study.fragility || study.chart || study.clearance || study.base_shear,
          "there is an analysis");
    check(increases(study.intensity.levels) && study.intensity.levels.front() >= 0.0 &&
              study.intensity.levels.back() > 0.0,
          "levels increase");
    check(!study.fragility || (increases(study.thresholds_m()) && study.thresholds_m()[0] > 0.0),
          "thresholds increase");
    check_quantities(study);
    if (study.chart) check_chart(study);
  });
  return 0;
}
