// SPDX-License-Identifier: GPL-3.0-or-later
// Study files. A suite named "suite.toml" is there, which a study does not read, and pull tests.
#include <algorithm>
#include <cmath>
#include <functional>

#include "check.hpp"
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

void check_quantities(const glissade::StudyConfig& study) {
  for (std::size_t i = 0; i < glissade::parameters().size(); ++i) {
    const glissade::Quantity& quantity = study.quantities[i];
    const glissade::ParameterRange& range = glissade::parameters()[i].range;
    if (quantity.is_drawn()) continue;
    check(increases(quantity.values), "a list increases");
    check(quantity.values.front() >= range.min && quantity.values.back() <= range.max,
          "a value is in its range");
  }
  check(!study.support.empty() && !study.vertical.empty() && !study.friction.values.empty() &&
            !study.orientation.slope_axis.empty() && !study.suite_files.empty(),
        "no list is empty");
  check(study.support.front() == glissade::ArraySupport::isolated, "the array slides");
  check(study.sampling.samples > 0, "there is a sample");
  check(!study.sampling.target || study.sampling.target->error > 0.0, "an error is above zero");
}

void check_chart(const glissade::StudyConfig& study) {
  const glissade::ChartConfig& chart = *study.chart;
  const std::vector<double>& slopes = study.quantities.at("roof", "slope_deg").values;
  const std::vector<double>& mu = study.quantities.at("friction", "mu").values;
  const std::vector<double>& levels = study.intensity.levels;
  check(slopes.size() > 1 && slopes.back() > 0.0, "there are slopes");
  check(is_on(slopes, chart.shown_slope_deg) && chart.shown_slope_deg >= 0.0 &&
            (mu.empty() || is_on(mu, chart.shown_mu)) && is_on(levels, chart.shown_level),
        "figures cut through the chart at its values");
  for (const double slope : slopes)
    check(slope >= 0.0 || is_on(slopes, -slope), "a negative slope has its mirror image");
  for (const glissade::ChartQuestion& q : chart.questions) {
    check(is_on(levels, q.level), "a question is of a level");
    check(q.slope_deg >= 0.0 && q.slope_deg <= slopes.back(), "and within the slopes");
    check(q.mu.has_value() != q.displacement_m.has_value(), "it is for one thing");
    check(!q.mu || mu.size() < 2 || (*q.mu >= mu.front() && *q.mu <= mu.back()),
          "and within the frictions");
  }
}

void check_analyses(const glissade::StudyConfig& study) {
  const std::vector<double>& levels = study.intensity.levels;
  check(increases(levels) && levels.front() >= 0.0 && levels.back() > 0.0, "levels increase");
  if (study.fragility) {
    check(levels.front() > 0.0, "levels of a fragility are above 0");
    check(increases(study.thresholds_m()) && study.thresholds_m().front() > 0.0,
          "thresholds increase");
  }
  if (study.chart) check_chart(study);
  if (study.verdict) {
    const std::vector<double>& exceedance = study.verdict->exceedance;
    check(!exceedance.empty() && exceedance.front() < 1.0 && exceedance.back() > 0.0 &&
              std::ranges::adjacent_find(exceedance, std::less_equal<>()) == exceedance.end(),
          "probabilities fall");
  }
  if (study.clearance) check(study.clearance->factor >= 1.0, "the factor is 1 or more");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto suite = glissade::fuzz::folder().write("suite.toml", "");
  static const auto tests = glissade::fuzz::folder().write(
      "tests.csv",
      "test,direction,displacement_m,force_n,normal_n\n"
      "1,along,0,500,1000\n1,along,0.05,500,1000\n1,along,0.1,500,1000\n"
      "2,along,0,600,1000\n2,along,0.05,600,1000\n2,along,0.1,600,1000\n"
      "3,across,0,700,1000\n3,across,0.05,700,1000\n3,across,0.1,700,1000\n"
      "4,across,0,800,1000\n4,across,0.05,800,1000\n4,across,0.1,800,1000\n");
  static const auto hazard = glissade::fuzz::folder().write(
      "hazard.csv", "sds_g,annual_rate\n0.1,0.02\n0.5,0.002\n2,1e-5\n");
  const auto file = glissade::fuzz::input_file(data, size, "study.toml");
  glissade::fuzz::may_refuse([&] {
    const glissade::StudyConfig study = glissade::read_study(file);
    check(!study.name.empty(), "a study has a name");
    check(study.source_text.size() == size, "the text is kept whole");
    check(glissade::read_study(glissade::fuzz::write_input("plain.toml", study.hashed_text))
                  .hashed_text == study.hashed_text,
          "the text in the units of the keys is the same study");
    check_quantities(study);
    check_analyses(study);
  });
  return 0;
}
