// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/motion/roof_words.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string level_text(const ConditionGrid& grid, double level) {
  const std::string name = earthquake_name(level, grid.dbe_level);
  if (!grid.level_symbol.empty()) {
    return fmt::format("{}{} = {}{}", name.empty() ? "" : name + ", ", grid.level_symbol,
                       format_number(level), grid.level_unit == "-" ? "" : " " + grid.level_unit);
  }
  return name.empty() ? fmt::format("{:.3g} MCE", level) : name;
}

std::string value_text(double value) {
  return std::isnan(value) ? "drawn" : fmt::format("{:g}", value);
}

std::string vertical_text(const VerticalCondition& condition) {
  if (condition.use == VerticalChoice::none) return "no vertical motion";
  if (condition.period_s == 0.0) return "vertical motion of the ground";
  return fmt::format("vertical motion, roof period {:g} s", condition.period_s);
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

std::string label_of(const ConditionGrid& grid, ConditionAxis axis, std::size_t place) {
  switch (axis) {
    case ConditionAxis::listed:
      return grid.listed[place];
    case ConditionAxis::support:
      return support_text(grid.support[place]);
    case ConditionAxis::vertical:
      return vertical_text(grid.vertical[place]);
    case ConditionAxis::response_modification:
      return grid.response_modification[place] == 0.0
                 ? "elastic building"
                 : "R " + value_text(grid.response_modification[place]);
    case ConditionAxis::mass:
      return "m/M " + value_text(grid.mass_ratio[place]);
    case ConditionAxis::slope:
      return "slope " + slope_text(grid.slope_deg[place]);
    case ConditionAxis::level:
      return level_text(grid, grid.level[place]);
    case ConditionAxis::period:
      return std::isnan(grid.period_s[place]) ? "T drawn"
                                              : fmt::format("T {:g} s", grid.period_s[place]);
  }
  return {};
}

std::string label_of(const ConditionGrid& grid, ConditionAxis axis, const Condition& at) {
  return label_of(grid, axis, at[axis]);
}

namespace {

std::string joined(const ConditionGrid& grid, const Condition& at,
                   const std::vector<ConditionAxis>& without, std::size_t least) {
  std::string text;
  for (const ConditionAxis axis :
       {ConditionAxis::level, ConditionAxis::slope, ConditionAxis::mass,
        ConditionAxis::response_modification, ConditionAxis::vertical, ConditionAxis::support,
        ConditionAxis::period, ConditionAxis::listed}) {
    if (axis == ConditionAxis::listed && !has_several(grid, axis)) continue;
    if (grid.size(axis) < least || std::ranges::find(without, axis) != without.end()) continue;
    text += (text.empty() ? "" : ", ") + label_of(grid, axis, at);
  }
  return text;
}

}  // namespace

std::string distinguished(const ConditionGrid& grid, const Condition& at,
                          const std::vector<ConditionAxis>& without) {
  return joined(grid, at, without, 2);
}

std::string friction_text(const Results& results, const Condition& at) {
  const std::size_t first = 2 * at[ConditionAxis::listed];
  const double e_w = results.conditions->friction[first],
               n_s = results.conditions->friction[first + 1];
  if (e_w == n_s) return fmt::format("{:.3g}", e_w);
  return fmt::format("E-W {:.3g}, N-S {:.3g}", e_w, n_s);
}

std::string conditions_text(const Results& results, const Condition& at,
                            const std::vector<ConditionAxis>& without) {
  std::vector<ConditionAxis> left_out = without;
  if (!has_several(results.conditions->grid, ConditionAxis::support))
    left_out.push_back(ConditionAxis::support);
  if (results.suites.front().of_roof)  // the building is in the motions
    left_out.insert(left_out.end(), {ConditionAxis::period, ConditionAxis::mass,
                                     ConditionAxis::response_modification});
  ConditionGrid grid = results.conditions->grid;
  grid.listed = grid.listed_but_friction;  // it follows
  if (grid.listed[at[ConditionAxis::listed]].empty()) left_out.push_back(ConditionAxis::listed);
  const std::string text =
      joined(grid, at, left_out, 1) + ", friction " + friction_text(results, at);
  return results.suites.front().of_roof ? in_words_of_roof(text) : text;
}

std::string clearance_text(double clearance_m) {
  return std::isfinite(clearance_m)
             ? format_length(clearance_m)
             : "none: the array slides freely, or a history did not converge";
}

Condition shown_condition(const ConditionGrid& grid) {
  std::size_t level = grid.level.size() - 1;
  const auto design = std::ranges::find_if(
      grid.level, [&](double one) { return earthquake_name(one, grid.dbe_level) == "DBE"; });
  if (design != grid.level.end()) level = static_cast<std::size_t>(design - grid.level.begin());
  return Condition().with(ConditionAxis::level, level);
}

Places shown_along(const ConditionGrid& grid, ConditionAxis axis) {
  return along(grid, axis, shown_condition(grid));
}

Condition with_reference_strength(const ConditionGrid& grid, Condition at) {
  const std::vector<double>& r = grid.response_modification;
  const auto place = std::ranges::find(r, 1.0);
  return at.with(ConditionAxis::response_modification,
                 place == r.end() ? 0 : static_cast<std::size_t>(place - r.begin()));
}

std::string reference_strength_text(const ConditionGrid& grid) {
  const Condition reference = with_reference_strength(grid, shown_condition(grid));
  const double r = grid.response_modification[reference[ConditionAxis::response_modification]];
  return r == 0.0 ? "the elastic building" : "the building of R = " + value_text(r);
}

std::string orientation_text(const Results& results, const Orientation& orientation) {
  return to_string(orientation, slides_on_two_axes(results));
}

bool has_several(const ConditionGrid& grid, ConditionAxis axis) { return grid.size(axis) > 1; }

std::optional<std::size_t> place_of(const ConditionGrid& grid, ArraySupport support) {
  const auto found = std::ranges::find(grid.support, support);
  if (found == grid.support.end()) return std::nullopt;
  return static_cast<std::size_t>(found - grid.support.begin());
}

std::string orientations_text(const Results& results) {
  const std::size_t n = results.conditions->orientations.size();
  return n == 1 ? "" : number_in_words(n) + " orientations";
}

std::string rule_text(const Results& results) {
  if (results.conditions->orientations.size() < 2) return "";
  return fmt::format(", {} of the orientations", to_string(results.clearance->orientation));
}

std::string range_text(const Results& results, const OrientationRange& range) {
  std::string text = format_length(range.median);
  if (results.conditions->orientations.size() < 2) return text;
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
