// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/design/product.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/standards/conditions.hpp"
#include "glissade/standards/prescriptive.hpp"

namespace glissade {
namespace {

std::size_t level_at(const Results& results, double level) {
  const auto& found = found_in(results.levels, level, "a level of the product");
  return static_cast<std::size_t>(&found - results.levels.data());
}

}  // namespace

const char* to_string(SheetUnit unit) {
  return unit == SheetUnit::inch ? "in" : unit == SheetUnit::foot ? "ft" : "m";
}

double in_unit(SheetUnit unit, double length_m) {
  return unit == SheetUnit::inch   ? length_m / inch_m
         : unit == SheetUnit::foot ? length_m / foot_m
                                   : length_m;
}

std::vector<double> levels_of(const Product& product, const ProductTarget& target) {
  std::vector<double> levels = {target.target.sds_g};
  if (target.hazard) {
    constexpr double lowest = 0.05;
    constexpr int steps = 14;
    const double event_g = target.hazard->curve.intensity_at(1.0 / product.event_years);
    for (int i = 0; i < steps; ++i)
      levels.push_back(event_g * std::pow(lowest, 1.0 - i / static_cast<double>(steps)));
    levels.push_back(event_g);
  }
  std::ranges::sort(levels);
  levels.erase(std::ranges::unique(levels).begin(), levels.end());
  return levels;
}

double accumulated_m(const HazardCurve& curve, const std::vector<double>& levels,
                     const std::vector<double>& mean_m, double most, double years) {
  GLISSADE_EXPECTS(levels.size() == mean_m.size());
  constexpr int parts = 100;
  double sum_m = 0.0;
  for (std::size_t i = 0; i + 1 < levels.size() && levels[i + 1] <= most; ++i) {
    double above = curve.annual_rate(levels[i]);
    for (int part = 1; part <= parts; ++part) {
      const double share = part / static_cast<double>(parts);
      const double rate = curve.annual_rate(std::lerp(levels[i], levels[i + 1], share));
      sum_m += (above - rate) * std::lerp(mean_m[i], mean_m[i + 1], share - 0.5 / parts);
      above = rate;
    }
  }
  return years * sum_m;
}

TargetDisplacements displacements_of(const Product& product, const ProductTarget& target,
                                     const Results& results) {
  expect_of_project(results.chart.has_value(), "a chart");
  const Chart& chart = *results.chart;
  TargetDisplacements found{.of_largest = results.records.size() < least_records,
                            .slope_deg = chart.slope_deg,
                            .mu = chart.mu,
                            .period_s = chart.period_s};
  const double least_m =
      least_share(Standard::asce7_16) * asce7_16_displacement(target.target.sds_g, 1.0).value_m;
  const auto analysis_m = [&](const ChartSlip& slip) {
    return found.factor * (found.of_largest ? slip.envelope_m : slip.mean_m);
  };
  const std::size_t sds = level_at(results, target.target.sds_g);
  std::size_t event = 0;
  if (target.hazard) {
    found.event_g = target.hazard->curve.intensity_at(1.0 / product.event_years);
    event = level_at(results, found.event_g);
  }
  for (std::size_t s = 0; s < chart.slope_deg.size(); ++s) {
    for (std::size_t m = 0; m < chart.mu.size(); ++m) {
      const ChartPoint& point = chart.at(sds, s, m);
      ProductDisplacement& row = found.points.emplace_back(
          ProductDisplacement{point.slope_deg, point.mu, point.largest, point.governing_period_s,
                              analysis_m(point.largest)});
      row.design_m = is_within(Standard::asce7_16, {.slope_deg = row.slope_deg, .friction = row.mu})
                         ? std::max(row.analysis_m, least_m)
                         : row.analysis_m;
      for (const ChartSlip& slip : point.by_period) row.by_period_m.push_back(analysis_m(slip));
      if (!target.hazard) continue;
      row.event_m = analysis_m(chart.at(event, s, m).largest);
      std::vector<double> means_m;
      for (std::size_t level = 0; level < results.levels.size(); ++level)
        means_m.push_back(chart.at(level, s, m).largest.mean_m);
      row.smaller_m = point.free_sliding
                          ? infinity
                          : accumulated_m(target.hazard->curve, results.levels, means_m,
                                          found.event_g, target.hazard->design_life_years);
      constexpr double no_slip_m = 1e-4;
      row.slides_below = means_m.front() > no_slip_m;
    }
  }
  return found;
}

}  // namespace glissade
