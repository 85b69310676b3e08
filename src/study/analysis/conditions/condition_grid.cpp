// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/conditions/condition_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr const char* friction_key = "friction.value";  // one of its values counts

ConditionAxis axis_of(const CaseAxis& of_cases) {
  if (of_cases.key == "array.support") return ConditionAxis::support;
  if (of_cases.key == "vertical.use" || of_cases.key == "vertical.period_s")
    return ConditionAxis::vertical;
  const auto found = std::ranges::find_if(condition_axes, [&](ConditionAxis axis) {
    const Parameter* parameter = parameter_of(axis);
    return parameter != nullptr && parameter->name() == of_cases.key;
  });
  return found == condition_axes.end() ? ConditionAxis::listed : *found;
}

double mean_over_samples(const ConditionHistory& of, const auto& value) {
  const CaseSet& set = of.results.cases;
  double sum = 0.0;
  for (std::size_t sample = 0; sample < set.samples; ++sample)
    sum += value(of.first_case + sample * set.orientations);
  return sum / static_cast<double>(set.samples);
}

}  // namespace

const Parameter* parameter_of(ConditionAxis axis) {
  const auto row = [](const char* table, const char* key) {
    return &parameters()[parameter_index(table, key)];
  };
  switch (axis) {
    case ConditionAxis::response_modification:
      return row("building", "response_modification");
    case ConditionAxis::mass:
      return row("building", "mass_ratio");
    case ConditionAxis::slope:
      return row("roof", "slope_deg");
    case ConditionAxis::period:
      return row("building", "period_s");
    default:
      return nullptr;
  }
}

Condition Condition::with(ConditionAxis axis, std::size_t place) const {
  Condition changed = *this;
  changed[axis] = place;
  return changed;
}

double ConditionHistory::mean(HistoryValues<double> HistoryFields::*field) const {
  const HistoryTable& table = results.histories;
  const HistoryValues<double>& values = table.fields.*field;
  if (values.empty()) return nan;
  return mean_over_samples(*this,
                           [&](std::size_t i) { return values[table.at(record, i, level)]; });
}

double ConditionHistory::displacement_m() const {
  return mean_over_samples(
      *this, [&](std::size_t i) { return glissade::displacement_m(results, record, i, level); });
}

double ConditionHistory::peak_m() const {
  const HistoryTable& table = results.histories;
  const HistoryValues<double>& values = table.fields.peak_vector_m;
  if (values.empty()) return displacement_m();
  return mean_over_samples(*this, [&](std::size_t i) {
    return slides_freely(results.cases.cases[i]) ? infinity : values[table.at(record, i, level)];
  });
}

double ConditionHistory::base_shear() const {
  return std::hypot(mean(&HistoryFields::shear_along), mean(&HistoryFields::shear_across));
}

bool ConditionHistory::lifts_off() const {
  const HistoryTable& table = results.histories;
  return mean_over_samples(*this, [&](std::size_t i) {
           return table.fields.uplift[table.at(record, i, level)];
         }) > 0.0;
}

ConditionGrid::ConditionGrid(const Results& results) : results_(results) {
  const CaseSet& set = results.cases;
  steps_.fill({0});
  std::size_t stride = set.combinations();
  for (const CaseAxis& axis : set.axes) {
    stride /= axis.size();
    if (axis.key == friction_key) {
      const auto design =
          std::ranges::find(axis.values, static_cast<double>(FrictionValue::design));
      if (design != axis.values.end())
        first_ = stride * static_cast<std::size_t>(design - axis.values.begin());
      continue;
    }
    Steps both;
    for (const std::size_t step : steps(axis_of(axis)))
      for (std::size_t place = 0; place < axis.size(); ++place)
        both.push_back(step + place * stride);
    steps(axis_of(axis)) = both;
  }
  // With no vertical its period has no part: the first is all of them.
  std::erase_if(steps(ConditionAxis::vertical), [&, has_none = false](std::size_t step) mutable {
    const Case& c = set.cases[set.index(first_ + step, 0, 0)];
    return c.vertical == VerticalChoice::none && std::exchange(has_none, true);
  });
  steps(ConditionAxis::level).assign(results.levels.size(), 0);
}

std::size_t ConditionGrid::count() const {
  std::size_t count = 1;
  for (const ConditionAxis axis : condition_axes) count *= size(axis);
  return count;
}

Condition ConditionGrid::position(std::size_t i) const {
  GLISSADE_EXPECTS(i < count());
  Condition position;
  for (const ConditionAxis axis : condition_axes | std::views::reverse) {
    position[axis] = i % size(axis);
    i /= size(axis);
  }
  return position;
}

std::size_t ConditionGrid::first_case(const Condition& at) const {
  std::size_t combination = first_;
  for (const ConditionAxis axis : condition_axes) {
    GLISSADE_EXPECTS(at[axis] < size(axis));
    combination += steps(axis)[at[axis]];
  }
  return results_.cases.index(combination, 0, 0);
}

const Case& ConditionGrid::case_at(const Condition& at) const {
  return results_.cases.cases[first_case(at)];
}

double ConditionGrid::value(ConditionAxis axis, std::size_t place) const {
  if (axis == ConditionAxis::level) return results_.levels[place];
  const std::size_t first = first_case(Condition().with(axis, place));
  const auto of = [&](std::size_t i) {
    return value_of(*parameter_of(axis), results_.cases.cases[i]);
  };
  for (std::size_t sample = 1; sample < results_.cases.samples; ++sample)
    if (of(first + sample * results_.cases.orientations) != of(first)) return nan;
  return of(first);
}

std::string ConditionGrid::listed_text(std::size_t place, const std::string& without) const {
  std::vector<std::string> left_out{friction_key, without};
  for (const CaseAxis& axis : results_.cases.axes)
    if (axis_of(axis) != ConditionAxis::listed) left_out.push_back(axis.key);
  return results_.cases.describe(first_ + steps(ConditionAxis::listed)[place], left_out);
}

ConditionHistory ConditionGrid::history(std::size_t record, std::size_t orientation,
                                        const Condition& at) const {
  return {results_, record, first_case(at) + orientation, at[ConditionAxis::level]};
}

std::vector<Condition> along(const ConditionGrid& grid, ConditionAxis axis,
                             const Condition& position) {
  std::vector<Condition> places;
  for (std::size_t i = 0; i < grid.size(axis); ++i) places.push_back(position.with(axis, i));
  return places;
}

std::vector<Condition> all_conditions(const ConditionGrid& grid) {
  std::vector<Condition> places;
  for (std::size_t i = 0; i < grid.count(); ++i) places.push_back(grid.position(i));
  return places;
}

std::vector<Condition> all_but(const ConditionGrid& grid, ConditionAxis axis) {
  std::vector<Condition> places = all_conditions(grid);
  std::erase_if(places, [&](const Condition& at) { return at[axis] != 0; });
  return places;
}

const Orientation& orientation_at(const Results& results, std::size_t i) {
  return results.cases.cases[i].orientation;
}

std::vector<CaseNumber> same_orientations(const Results& results) {
  return same_as(
      CaseGrid{.axes = {}, .orientations = results.cases.orientations},
      [&](std::size_t i) { return results.cases.cases[i]; }, slides_on_two_axes(results));
}

}  // namespace glissade
