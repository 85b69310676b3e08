// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/conditions/condition_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// The axes of a study's cases that make up the grid of conditions.
struct GridAxes {
  std::size_t friction_value, support, vertical, vertical_period, response_modification, mass,
      slope, period;
  std::vector<std::size_t> others;  ///< together ConditionAxis::listed
  CaseSet listed;                   ///< with those axes only

  explicit GridAxes(const CaseSet& set)
      : friction_value(set.axis("friction.value")),
        support(set.axis("array.support")),
        vertical(set.axis("vertical.use")),
        vertical_period(set.axis("vertical.period_s")),
        response_modification(set.axis("building.response_modification")),
        mass(set.axis("building.mass_ratio")),
        slope(set.axis("roof.slope_deg")),
        period(set.axis("building.period_s")) {
    for (std::size_t i = 0; i < set.axes.size(); ++i) {
      const std::array own{friction_value,        support, vertical, vertical_period,
                           response_modification, mass,    slope,    period};
      if (std::ranges::find(own, i) != own.end()) continue;
      others.push_back(i);
      listed.axes.push_back(set.axes[i]);
    }
  }
};

std::vector<double> values_on(const CaseSet& set, std::size_t axis, double otherwise) {
  return axis < set.axes.size() ? set.axes[axis].values : std::vector{otherwise};
}

/// The value of every sample; NaN where they differ.
double only_value(const CaseSet& set, double Case::*member) {
  for (std::size_t sample = 1; sample < set.samples; ++sample) {
    if (set.cases[set.index(0, sample, 0)].*member != set.cases.front().*member)
      return std::numeric_limits<double>::quiet_NaN();
  }
  return set.cases.front().*member;
}

/// The roof's vertical and its period; with no vertical the period has no part.
std::vector<VerticalCondition> verticals_of(const CaseSet& set, const GridAxes& axes) {
  const Case& c = set.cases.front();
  std::vector<VerticalCondition> conditions;
  for (const double use : values_on(set, axes.vertical, static_cast<double>(c.vertical))) {
    for (const double period_s : values_on(set, axes.vertical_period, c.vertical_period_s)) {
      const auto choice = static_cast<VerticalChoice>(static_cast<int>(use));
      const VerticalCondition condition{choice, choice == VerticalChoice::none ? 0.0 : period_s};
      if (std::ranges::find(conditions, condition) == conditions.end())
        conditions.push_back(condition);
    }
  }
  return conditions;
}

ConditionGrid grid_of(const Results& results, const GridAxes& axes) {
  const CaseSet& set = results.cases;
  const Case& c = set.cases.front();
  ConditionGrid grid;
  grid.listed.clear();
  grid.listed_but_friction.clear();
  for (std::size_t i = 0; i < axes.listed.combinations(); ++i) {
    grid.listed.push_back(axes.listed.describe(i));
    grid.listed_but_friction.push_back(axes.listed.describe(i, "friction.mu"));
  }
  grid.support.clear();
  for (const double support : values_on(set, axes.support, static_cast<double>(c.support)))
    grid.support.push_back(static_cast<ArraySupport>(static_cast<int>(support)));
  grid.vertical = verticals_of(set, axes);
  grid.response_modification =
      values_on(set, axes.response_modification, only_value(set, &Case::response_modification));
  grid.mass_ratio = values_on(set, axes.mass, only_value(set, &Case::mass_ratio));
  grid.slope_deg = values_on(set, axes.slope, only_value(set, &Case::slope_deg));
  grid.level = results.levels;
  if (results.measure != IntensityMeasure::mce_fraction)
    grid.level_symbol = results.intensity_symbol;
  grid.dbe_level =
      results.measure == IntensityMeasure::mce_fraction ? 2.0 / 3 : results.model.dbe_level;
  grid.level_unit = results.measure.unit();
  grid.period_s = values_on(set, axes.period, only_value(set, &Case::period_s));
  return grid;
}

/// The combination of cases at a place of the grid.
std::size_t combination_at(const CaseSet& set, const GridAxes& axes, const ConditionGrid& grid,
                           const Condition& at) {
  std::vector<std::size_t> places(set.axes.size(), 0);
  const auto put = [&](std::size_t axis, std::size_t place) {
    if (axis < places.size()) places[axis] = place;
  };
  const auto put_value = [&](std::size_t axis, double value) {
    if (axis == places.size()) return;
    const std::vector<double>& values = set.axes[axis].values;
    places[axis] = static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
    if (places[axis] == values.size()) places[axis] = 0;  // with no vertical: any period
  };
  const VerticalCondition& vertical = grid.vertical[at[ConditionAxis::vertical]];
  put_value(axes.friction_value, static_cast<double>(FrictionValue::design));
  const std::vector<std::size_t> listed = axes.listed.places(at[ConditionAxis::listed]);
  for (std::size_t i = 0; i < listed.size(); ++i) put(axes.others[i], listed[i]);
  put(axes.support, at[ConditionAxis::support]);
  put_value(axes.vertical, static_cast<double>(vertical.use));
  put_value(axes.vertical_period, vertical.period_s);
  put(axes.response_modification, at[ConditionAxis::response_modification]);
  put(axes.mass, at[ConditionAxis::mass]);
  put(axes.slope, at[ConditionAxis::slope]);
  put(axes.period, at[ConditionAxis::period]);
  return set.combination(places);
}

/// The mean over the samples of one record in one orientation of one combination.
ConditionHistory history_of(const Results& results, std::size_t record, std::size_t combination,
                            std::size_t orientation, std::size_t level) {
  const CaseSet& set = results.cases;
  const HistoryTable& table = results.histories;
  const auto mean = [&](const HistoryValues<double>& field) {
    if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    for (std::size_t sample = 0; sample < set.samples; ++sample)
      sum += field[table.at(record, set.index(combination, sample, orientation), level)];
    return sum / static_cast<double>(set.samples);
  };
  const HistoryFields& f = table.fields;
  ConditionHistory history{
      .displacement_m = mean(f.peak_displacement_m),
      .peak_m = mean(f.peak_vector_m.empty() ? f.peak_displacement_m : f.peak_vector_m),
      .peak_along_m = mean(f.peak_along_m),
      .peak_across_m = mean(f.peak_across_m),
      .residual_along_m = mean(f.residual_along_m),
      .residual_across_m = mean(f.residual_across_m),
      .shear_along = mean(f.shear_along),
      .shear_across = mean(f.shear_across)};
  for (std::size_t sample = 0; sample < set.samples; ++sample) {
    const std::size_t at = table.at(record, set.index(combination, sample, orientation), level);
    history.uplift = std::max(history.uplift, f.uplift[at]);
    const Case& c = set.cases[set.index(combination, sample, orientation)];
    if (slides_freely(c))
      history.displacement_m = history.peak_m = std::numeric_limits<double>::infinity();
  }
  return history;
}

/// Friction at its design value by (listed, SlopeAxis): for the slope along either axis of the
/// array.
std::vector<double> design_frictions(const CaseSet& set, const GridAxes& axes,
                                     const ConditionGrid& grid) {
  std::vector<double> frictions;
  for (const Condition& at : along(grid, ConditionAxis::listed)) {
    const Case& c = set.cases[set.index(combination_at(set, axes, grid, at), 0, 0)];
    const bool along_e_w = c.orientation.slope_axis == SlopeAxis::e_w;
    frictions.push_back(along_e_w ? c.friction : c.friction_across);
    frictions.push_back(along_e_w ? c.friction_across : c.friction);
  }
  return frictions;
}

}  // namespace

double base_shear(const ConditionHistory& history) {
  return std::hypot(history.shear_along, history.shear_across);
}

ConditionTable condition_table(const Results& results) {
  const CaseSet& set = results.cases;
  const GridAxes axes(set);
  ConditionTable table;
  table.grid = grid_of(results, axes);
  table.friction = design_frictions(set, axes, table.grid);
  const std::vector<CaseNumber> same = same_as(
      set, [&](std::size_t i) { return set.cases[i]; }, slides_on_two_axes(results));
  for (std::size_t o = 0; o < set.orientations; ++o) {
    table.orientations.push_back(set.cases[set.index(0, 0, o)].orientation);
    table.same_as.push_back(same[set.index(0, 0, o)] % set.orientations);
  }
  std::vector<std::size_t> combinations;
  for (std::size_t i = 0; i < table.grid.count(); ++i) {
    combinations.push_back(combination_at(set, axes, table.grid, table.grid.position(i)));
    table.first_case.push_back(set.index(combinations.back(), 0, 0));
  }
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    for (std::size_t o = 0; o < set.orientations; ++o) {
      for (std::size_t i = 0; i < combinations.size(); ++i) {
        table.histories.push_back(history_of(results, record, combinations[i], o,
                                             table.grid.position(i)[ConditionAxis::level]));
      }
    }
  }
  return table;
}

void need_conditions(Results& results) {
  if (!results.conditions) results.conditions = condition_table(results);
}

}  // namespace glissade
