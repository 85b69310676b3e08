// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "glissade/io/study_file.hpp"
#include "glissade/study/analysis/chart.hpp"
#include "run_study.hpp"
#include "verification/chapters.hpp"

namespace glissade::verification {
namespace {

/// Clearances interpolated halfway between a chart's slopes and frictions, over those run there, at
/// the first level: only those of a centimetre and more.
std::vector<double> interpolated_over_run(const StudyConfig& config, const Results& results) {
  const auto halfway = [](const std::vector<double>& axis) {
    std::vector<double> between;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      between.push_back(0.5 * (axis[i] + axis[i + 1]));
    return between;
  };
  StudyConfig shifted = config;
  shifted.intensity.levels.resize(1);
  for (const auto& [table, key] : {std::pair{"roof", "slope_deg"}, std::pair{"friction", "mu"}})
    shifted.quantities.at(table, key).values = halfway(config.quantities.at(table, key).values);
  shifted.chart->questions.clear();
  const Results run_there = run_study(plan_of(shifted));
  std::vector<double> ratios;
  for (const ChartPoint& p : run_there.chart->points) {
    if (p.clearance_m < 0.01) continue;
    const ChartReading read =
        read_off(*results.chart, results.levels, {p.level, p.slope_deg, p.mu, std::nullopt});
    ratios.push_back(read.clearance / p.clearance_m);
  }
  std::ranges::sort(ratios);
  return ratios;
}

constexpr double walters_periods[] = {0.2, 0.4, 0.7, 1.0, 1.5, 2.0};

/// Over some of the chart's periods.
double largest_mean_m(const Chart& chart, const ChartPoint& point,
                      std::span<const double> periods_s) {
  double largest = 0.0;
  for (std::size_t i = 0; i < chart.period_s.size(); ++i) {
    if (std::ranges::find(periods_s, chart.period_s[i]) != periods_s.end())
      largest = std::max(largest, point.by_period[i].mean_m);
  }
  return largest;
}

}  // namespace

Chapter first_paper_charts(const Folders& folders) {
  std::string table =
      "| Intensity Level | S_DS, g | clearance, mm (in) | of six periods, mm | interval of the "
      "mean, mm | 84th "
      "percentile, mm "
      "| governing period, s | SEAOC PV1-2012, mm (in) |\n|---|---|---|---|---|---|---|---|\n";
  std::vector<Case> cases;
  std::vector<Finding> findings;
  for (int level = 0; level <= 4; ++level) {
    StudyConfig config = read_study(
        folders.studies / fmt::format("{:02d}_design_chart_level{}.toml", 9 + level, level));
    config.intensity.levels.resize(1);
    config.model.axes = SlidingAxes::one;
    config.quantities.at("building", "mass_ratio") = {{0.0}, {}};
    const Results results = run_study(plan_of(config));
    const Chart& chart = *results.chart;
    const ChartReading& read = chart.readings.front();
    const auto near = [](const std::vector<double>& axis, double value) {
      return static_cast<std::size_t>(std::ranges::lower_bound(axis, value) - axis.begin());
    };
    const ChartPoint& point = chart.at(0, near(chart.slope_deg, 1.0), near(chart.mu, 0.45));
    const double seaoc_m = chart.standards.front().prescribed.value_m;
    table += fmt::format(
        "| {} | {:g} | {:.0f} ({:.1f}) | {:.0f} | {:.0f} to {:.0f} | {:.0f} | {:g} | {:.0f} "
        "({:.1f}) |\n",
        level, results.levels[0], 1e3 * point.clearance_m, point.clearance_m / inch_m,
        1.1e3 * largest_mean_m(chart, point, walters_periods), 1e3 * point.mean_interval.low,
        1e3 * point.mean_interval.high, 1e3 * point.largest.p84_m, point.governing_period_s,
        1e3 * seaoc_m, seaoc_m / inch_m);
    if (level != 2) continue;
    table += fmt::format(
        "| 2, at 1.19 deg and mu 0.47 | {:g} | {:.0f} ({:.1f}) | | | {:.0f} | | |\n",
        results.levels[0], 1e3 * read.clearance, read.clearance / inch_m, 1e3 * read.p84);
    findings = {
        {"future work: design charts; clearance of the example of Walters et al. (2012): 286 mm",
         fmt::format("charts of studies 09 to 13; that clearance is {:.0f} mm",
                     1e3 * read.clearance),
         std::abs(read.clearance / 0.286 - 1.0) < 0.25 ? "within 25 %" : "no"}};
    const std::vector<double> ratios = interpolated_over_run(config, results);
    const std::string name = "study 11, halfway between all its slopes and frictions";
    const auto add = [&](const char* which, double ratio, double low, double high) {
      cases.push_back(within({name, "clearance read off / clearance run there", "the run itself",
                              ReferenceFrom::this_code},
                             {which, ratio, low, high}));
    };
    add("smallest", ratios.front(), 0.98, INFINITY);
    add("median", ratios[ratios.size() / 2], 0.98, 1.02);
    add("largest", ratios.back(), 0.98, 1.10);
  }
  return {
      "1.5 Design charts",
      "none; its cases are in chapter 10",
      R"(Studies 09 to 13 with the model of the first paper: one axis, no mass of the array. The clearance is 1.1
times the mean of a suite, the largest over 37 buildings of 0.2 to 2 s, for each Intensity Level of Walters
et al. (2012). Linear interpolation reads slightly too much. Walters et al. use six periods, between which the
mean may have its maximum.

The table is at 1 degree and mu 0.45; one row is the example of Walters et al., who give 286 mm (11.2 in)
from seven recorded motions, both axes and an array mass of 5 to 10 %.)",
      std::move(cases),
      "",
      table,
      findings};
}

}  // namespace glissade::verification
