// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/conditions/view.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {

Places places_of(const ConditionGrid& grid, ConditionAxis slow, ConditionAxis fast) {
  Places places;
  for (const Condition& at : along(grid, slow, shown_condition(grid))) {
    for (const Condition& place : along(grid, fast, at)) places.push_back(place);
  }
  return places;
}

Family::Family(const Results& results, const std::string& x_label, std::vector<double> x,
               Spread spread)
    : results_(results),
      x_(std::move(x)),
      spread_(results.conditions->orientations.size() > 1 ? spread : Spread::none) {
  const auto [first, last] = std::ranges::minmax(x_);
  const double room = (spread == Spread::bars ? 0.3 : 0.05) * std::max(last - first, 1e-9);
  panel_.x = {x_label, first - room, last + room};
}

void Family::add_range(const std::string& label, Look look, const std::vector<double>& lowest,
                       const std::vector<double>& median, const std::vector<double>& highest) {
  const bool bars = spread_ == Spread::bars;
  std::vector<double> x = x_;
  // Places that are names have nothing between them: points, side by side.
  if (bars)
    for (double& at : x) at += 0.05 * static_cast<double>(spreads_.size());
  panel_.series.push_back({bars ? DataSeries::Kind::points : DataSeries::Kind::line_and_points,
                           look, label, label, x, median});
  if (bars) panel_.series.back().look.symbol_size = 1.4;
  if (spread_ == Spread::none) return;
  const auto kind = bars ? DataSeries::Kind::bars : DataSeries::Kind::band;
  spreads_.push_back({kind, look, label + ": lowest and highest", "", x, {}, lowest, highest});
}

void Family::add(const std::string& label, Look look, const Places& places,
                 const MeanQuestion& question, Periods periods) {
  std::vector<double> lowest, median, highest;
  for (const Condition& at : places) {
    const OrientationRange range = over_orientations(results_, question, at, periods);
    lowest.push_back(range.lowest);
    median.push_back(range.median);
    highest.push_back(range.highest);
  }
  add_range(label, look, lowest, median, highest);
}

void Family::add_numbers(const std::string& label, Look look,
                         const std::vector<std::vector<double>>& numbers) {
  std::vector<double> lowest, median, highest;
  for (const std::vector<double>& sorted : numbers) {
    lowest.push_back(sorted.empty() ? std::nan("") : sorted.front());
    median.push_back(quantile_of(sorted, 0.5));
    highest.push_back(sorted.empty() ? std::nan("") : sorted.back());
  }
  add_range(label, look, lowest, median, highest);
}

void Family::add_line(const std::string& label, Look look, std::vector<double> y) {
  const auto kind = look.symbol == 0 ? DataSeries::Kind::line : DataSeries::Kind::line_and_points;
  panel_.series.push_back({kind, look, label, label, x_, std::move(y)});
}

void Family::add_level(double y, const std::string& label, Look look) {
  panel_.rules.push_back({Rule::Kind::horizontal, y, look, label});
}

void Family::name_ticks(const std::vector<std::string>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) panel_.x.ticks.push_back({x_.at(i), labels[i]});
  panel_.x.values = Axis::Values::names;
}

double Family::largest_y() const {
  double found = 0.0;
  for (const DataSeries& series : panel_.series) found = std::max(found, largest(series.y));
  for (const DataSeries& series : spreads_) found = std::max(found, largest(series.high));
  for (const Rule& rule : panel_.rules) found = std::max(found, rule.at);
  return found > 0.0 ? 1.12 * found : 1.0;
}

double Family::smallest_y() const {
  double found = largest_y();
  for (const DataSeries& series : panel_.series)
    for (const double y : series.y) found = std::fmin(found, y);
  for (const DataSeries& series : spreads_)
    for (const double y : series.low) found = std::fmin(found, y);
  return found;
}

std::vector<Panel> Family::displacements(const std::string& label) {
  panel_.y = length_axis(label, largest_y());
  auto panels = ratios(panel_.y.label);
  panels[0].y = panel_.y;
  return panels;
}

std::vector<Panel> Family::ratios(const std::string& label, From from) {
  Panel panel = panel_;
  panel.y = {label, from == From::zero ? 0.0 : 0.97 * smallest_y(), largest_y()};
  if (from == From::lowest) panel.y.high *= 1.03 / 1.12;
  const double visible = 0.01 * (panel.y.high - panel.y.low);
  const auto is_thin = [&](const DataSeries& spread) {
    for (std::size_t i = 0; i < spread.high.size(); ++i)
      if (spread.high[i] - spread.low[i] > visible) return false;
    return true;
  };
  if (std::ranges::all_of(spreads_, is_thin)) return {panel};
  // More than a few bands over one another cannot be distinguished: then the first alone has one.
  const bool bars = spread_ == Spread::bars, all = bars || spreads_.size() <= 3;
  panel.series.insert(panel.series.begin(), spreads_.begin(),
                      all ? spreads_.end() : spreads_.begin() + 1);
  panel.series.push_back({bars ? DataSeries::Kind::bars : DataSeries::Kind::band,
                          all ? look(Role::largest) : spreads_.front().look, "",
                          fmt::format("{}: lowest to highest of the {}{}; {}: median",
                                      bars ? "bars" : "shaded", orientations_text(results_),
                                      all ? "" : " (first line)", bars ? "points" : "lines")});
  return {panel};
}

std::string below_text(const Results& results, std::vector<ConditionAxis> shown) {
  shown.insert(shown.end(), {ConditionAxis::period, ConditionAxis::support});
  return results.suites.front().name + "; " +
         conditions_text(results, shown_condition(results.conditions->grid), shown);
}

std::string what_is_averaged(const Results& results) {
  if (!slides_on_two_axes(results))
    return "Mean over the suite of each history's largest displacement along the slope, in plan, "
           "relative to the roof";
  return results.displacement == DisplacementMeasure::srss
             ? "Mean over the suite of each history's SRSS of the separate maxima along the roof's "
               "two axes, in plan, relative to the roof"
             : "Mean over the suite of each history's largest displacement, in plan, relative to "
               "the roof";
}

}  // namespace glissade
