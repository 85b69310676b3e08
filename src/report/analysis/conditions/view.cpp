// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string level_text(const Results& results, double level) {
  const std::string name = level_name(results, level);
  if (results.measure == IntensityMeasure::mce_fraction)
    return name.empty() ? fmt::format("{:.3g} MCE", level) : name;
  return fmt::format("{}{} = {}", name.empty() ? "" : name + ", ", results.intensity_symbol,
                     with_unit(results, format_number(level)));
}

std::string value_text(double value) {
  return std::isnan(value) ? "drawn" : fmt::format("{:g}", value);
}

std::string vertical_text(const Case& c, bool of_roof) {
  if (c.vertical == VerticalChoice::none) return "no vertical motion";
  if (c.vertical_period_s == 0.0)
    return std::string("vertical motion of the ") + (of_roof ? "roof" : "ground");
  return fmt::format("vertical motion, roof period {:g} s", c.vertical_period_s);
}

std::string support_text(ArraySupport support) {
  switch (support) {
    case ArraySupport::isolated:
      return "isolated array";
    case ArraySupport::anchored:
      return "anchored array";
    case ArraySupport::no_array:
      return "no array";
  }
  return {};
}

std::string number_in_words(std::size_t n) {
  if (n == 2) return "both";
  return n == 16 ? "sixteen" : fmt::format("{}", n);
}

/// "1/4" of a slope that rises by quarters in 12; "" of others.
std::string rise_in_12(double slope_deg) {
  const double quarters = 48.0 * std::tan(slope_deg * rad_per_deg);
  const double whole = std::round(quarters);
  if (std::abs(quarters - whole) > 1e-6 || whole == 0.0) return "";
  return whole == 1.0   ? "1/4"
         : whole == 2.0 ? "1/2"
         : whole == 3.0 ? "3/4"
                        : fmt::format("{:g}", whole / 4.0);
}

}  // namespace

std::string slope_name(double slope_deg) {
  if (std::isnan(slope_deg)) return "drawn";
  const std::string rise = rise_in_12(slope_deg);
  return rise.empty() ? fmt::format("{:.3g} deg", slope_deg) : rise + ":12";
}

std::string slope_text(double slope_deg) {
  const bool has_both = !std::isnan(slope_deg) && !rise_in_12(slope_deg).empty();
  return slope_name(slope_deg) + (has_both ? fmt::format(" ({:.3g} deg)", slope_deg) : "");
}

std::string level_name(const Results& results, double level) {
  return earthquake_name(level, results.measure == IntensityMeasure::mce_fraction
                                    ? 1.0 / mce_over_dbe
                                    : results.model.dbe_level);
}

std::string label_of(const ConditionGrid& grid, ConditionAxis axis, std::size_t place) {
  const auto value = [&] { return grid.value(axis, place); };
  switch (axis) {
    case ConditionAxis::listed:
      return grid.listed_text(place);
    case ConditionAxis::support:
      return support_text(grid.case_at(Condition().with(axis, place)).support);
    case ConditionAxis::vertical:
      return vertical_text(grid.case_at(Condition().with(axis, place)),
                           grid.results().suites.front().of_roof);
    case ConditionAxis::response_modification:
      return value() == 0.0 ? "elastic building" : "R " + value_text(value());
    case ConditionAxis::mass:
      return "m/M " + value_text(value());
    case ConditionAxis::slope:
      return "slope " + slope_text(value());
    case ConditionAxis::level:
      return level_text(grid.results(), value());
    case ConditionAxis::period:
      return std::isnan(value()) ? "T drawn" : fmt::format("T {:g} s", value());
  }
  return {};
}

std::string label_of(const ConditionGrid& grid, ConditionAxis axis, const Condition& at) {
  return label_of(grid, axis, at[axis]);
}

namespace {

std::string joined(const ConditionGrid& grid, const Condition& at,
                   const std::vector<ConditionAxis>& without, std::size_t least,
                   const std::string& listed_without = "") {
  std::string text;
  for (const ConditionAxis axis :
       {ConditionAxis::level, ConditionAxis::slope, ConditionAxis::mass,
        ConditionAxis::response_modification, ConditionAxis::vertical, ConditionAxis::support,
        ConditionAxis::period, ConditionAxis::listed}) {
    if (grid.size(axis) < least || std::ranges::find(without, axis) != without.end()) continue;
    const std::string label = axis == ConditionAxis::listed
                                  ? grid.listed_text(at[axis], listed_without)
                                  : label_of(grid, axis, at);
    if (!label.empty()) text += (text.empty() ? "" : ", ") + label;
  }
  return text;
}

}  // namespace

std::string distinguished(const ConditionGrid& grid, const Condition& at,
                          const std::vector<ConditionAxis>& without) {
  return joined(grid, at, without, 2);
}

std::string friction_text(const Results& results, const Condition& at) {
  const Case& c = ConditionGrid(results).case_at(at);
  const double e_w = c.friction_on(SlopeAxis::e_w), n_s = c.friction_on(SlopeAxis::n_s);
  if (e_w == n_s) return fmt::format("{:.3g}", e_w);
  return fmt::format("E-W {:.3g}, N-S {:.3g}", e_w, n_s);
}

bool has_two_frictions(const Results& results) {
  const Case& c = ConditionGrid(results).case_at({});
  return c.friction != c.friction_across;
}

std::string conditions_text(const Results& results, const Condition& at,
                            const std::vector<ConditionAxis>& without) {
  const ConditionGrid grid(results);
  std::vector<ConditionAxis> left_out = without;
  if (!grid.has_several(ConditionAxis::support)) left_out.push_back(ConditionAxis::support);
  if (results.suites.front().of_roof)  // the building is in the motions
    left_out.insert(left_out.end(), {ConditionAxis::period, ConditionAxis::mass,
                                     ConditionAxis::response_modification});
  return joined(grid, at, left_out, 1, "friction.mu") + ", friction " + friction_text(results, at);
}

const char* over_building_periods(const Results& results) {
  return results.suites.front().of_roof ? "" : ", the largest over the building periods";
}

std::string clearance_text(double clearance_m) {
  return std::isfinite(clearance_m)
             ? format_length(clearance_m)
             : "none: the array slides freely, or a history did not converge";
}

Condition shown_condition(const ConditionGrid& grid) {
  const std::vector<Condition> levels = along(grid, ConditionAxis::level);
  const auto design = std::ranges::find_if(levels, [&](const Condition& at) {
    return level_name(grid.results(), grid.value(ConditionAxis::level, at)) == "DBE";
  });
  return design == levels.end() ? levels.back() : *design;
}

Places shown_along(const ConditionGrid& grid, ConditionAxis axis) {
  return along(grid, axis, shown_condition(grid));
}

Condition with_reference_strength(const ConditionGrid& grid, Condition at) {
  constexpr ConditionAxis axis = ConditionAxis::response_modification;
  for (const Condition& place : along(grid, axis, at))
    if (grid.value(axis, place) == 1.0) return place;
  return at.with(axis, 0);
}

std::string reference_strength_text(const ConditionGrid& grid) {
  const Condition reference = with_reference_strength(grid, shown_condition(grid));
  const double r = grid.value(ConditionAxis::response_modification, reference);
  return r == 0.0 ? "the elastic building" : "the building of R = " + value_text(r);
}

std::string orientation_text(const Results& results, const Orientation& orientation) {
  return to_string(orientation, slides_on_two_axes(results));
}

std::optional<std::size_t> place_of(const ConditionGrid& grid, ArraySupport support) {
  for (const Condition& at : along(grid, ConditionAxis::support))
    if (grid.case_at(at).support == support) return at[ConditionAxis::support];
  return std::nullopt;
}

std::string orientations_text(const Results& results) {
  const std::size_t n = results.cases.orientations;
  return n == 1 ? "" : number_in_words(n) + " orientations";
}

std::string rule_text(const Results& results) {
  if (results.cases.orientations < 2) return "";
  return fmt::format(", {} of the orientations", to_string(results.clearance->orientation));
}

std::string range_text(const Results& results, const OrientationRange& range) {
  std::string text = format_length(range.median);
  if (results.cases.orientations < 2) return text;
  const std::string lowest = format_length(range.lowest), highest = format_length(range.highest);
  return lowest == highest ? text + ", in all " + orientations_text(results)
                           : text + fmt::format(", from {} to {} over the {}", lowest, highest,
                                                orientations_text(results));
}

std::vector<double> ratios_by_orientation(const Results& results, const MeanQuestion& question,
                                          const Condition& at, const Condition& of) {
  const auto above = means_by_orientation(results, question, at, Periods::one);
  const auto below = means_by_orientation(results, question, of, Periods::one);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (below[i] > 0.0) ratios.push_back(above[i] / below[i]);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

}  // namespace glissade
