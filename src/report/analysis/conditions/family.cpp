// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/conditions/view.hpp"
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

View medians_over(const Results& results, ConditionAxis x, const Table& table,
                  const Places& members, const std::function<std::string(const Condition&)>& name) {
  View view{table, condition_column_of(results, x).stem, {}};
  view.spread_name = "lowest and highest";
  if (results.suites.size() > 1) view.where = {{"suite", results.suites.front().name}};
  for (const Condition& at : members) {
    view.lines.push_back({name(at), family_look(view.lines.size(), members.size()),
                          as_line_and_points, "median", rows_at(results, table, at, x)});
    if (results.cases.orientations < 2) continue;
    view.lines.back().low = "lowest";
    view.lines.back().high = "highest";
  }
  return view;
}

namespace {

bool is_spread(const DataSeries& series) { return !series.low.empty(); }

/// Takes out spreads that cannot be seen, or not be distinguished: of more than a few bands over
/// one another the first stays. Says in the key what those are that stay.
void thin_out_spreads(const Results& results, Panel& panel) {
  const double visible = 0.01 * (panel.y.high - panel.y.low);
  const auto is_wide = [&](const DataSeries& series) {
    for (std::size_t i = 0; i < series.low.size(); ++i)
      if (series.high[i] - series.low[i] > visible) return true;
    return false;
  };
  if (std::ranges::none_of(panel.series, is_wide)) {
    std::erase_if(panel.series, is_spread);
    return;
  }
  const DataSeries first = *std::ranges::find_if(panel.series, is_spread);
  const bool bars = first.kind == DataSeries::Kind::bars,
             all = bars || std::ranges::count_if(panel.series, is_spread) <= 3;
  if (!all)
    std::erase_if(panel.series, [&](const DataSeries& series) {
      return is_spread(series) && series.name != first.name;
    });
  panel.series.push_back({first.kind, all ? look(Role::largest) : first.look, "",
                          fmt::format("{}: lowest to highest of the {}{}; {}: median",
                                      bars ? "bars" : "shaded", orientations_text(results),
                                      all ? "" : " (first line)", bars ? "points" : "lines")});
}

double smallest_y(const Panel& panel) {
  double found = largest_y(panel);
  for (const DataSeries& series : panel.series)
    for (const std::vector<double>* values : {&series.y, &series.low})
      for (const double y : *values) found = std::fmin(found, y);
  return found;
}

}  // namespace

Panel means_panel(const Results& results, const std::vector<View>& views,
                  const std::string& x_label, const std::vector<Rule>& rules, const MeansAxis& y) {
  Panel panel = panel_of(views.front(), x_label);
  for (std::size_t i = 1; i < views.size(); ++i) add_lines(panel, views[i]);
  const double room = (views.front().spread == DataSeries::Kind::bars ? 0.3 : 0.05) *
                      std::max(panel.x.high - panel.x.low, 1e-9);
  panel.x.low -= room;
  panel.x.high += room;
  panel.rules = rules;
  const double top = largest_y(panel) > 0.0 ? largest_y(panel) : 1.0;
  if (y.kind == ColumnKind::length)
    panel.y = length_axis(y.label, 1.12 * top);
  else if (y.from_zero)
    panel.y = {y.label, 0.0, 1.12 * top};
  else
    panel.y = {y.label, 0.97 * smallest_y(panel), 1.03 * top};
  thin_out_spreads(results, panel);
  return panel;
}

std::string below_text(const Results& results, std::vector<ConditionAxis> shown) {
  shown.insert(shown.end(), {ConditionAxis::period, ConditionAxis::support});
  return results.suites.front().name + "; " +
         conditions_text(results, shown_condition(ConditionGrid(results)), shown);
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
