// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"

namespace glissade {
namespace {

const double slope_of_1_in_20_deg = std::atan(1.0 / 20.0) / rad_per_deg;
constexpr double most_storeys = 6.0, highest_centre_m = 36.0 * inch_m;
constexpr double rounding = 1e-9;  // of a rise, and of a list by steps

std::string degrees(double slope_deg) { return fmt::format("{:.3g} degrees", slope_deg); }
std::string inches(double length_m) {
  return fmt::format("{:.3g} in ({:.3g} m)", length_m / inch_m, length_m);
}
std::string number(double value) { return fmt::format("{:.3g}", value); }

template <class Value, class Text, class IsMet>
CodeCondition row(const char* what, std::string limit, const std::optional<Value>& value, Text text,
                  IsMet is_met) {
  CodeCondition condition{.what = what, .limit = std::move(limit), .found = "not stated"};
  if (!value) return condition;
  condition.found = text(*value);
  condition.is_met = is_met(*value);
  return condition;
}

/// Below half the least spacing of the supports, and 36 in at most.
CodeCondition centre_of_mass(const ArrayFacts& array) {
  CodeCondition condition = row(
      "height of the centre of mass above the roof",
      "less than half the least spacing of the supports, and 36 in (0.914 m) or less",
      array.centre_of_mass_m,
      [&](double height_m) {
        return inches(height_m) + (array.support_spacing_m
                                       ? ", spacing " + inches(*array.support_spacing_m)
                                       : ", spacing not stated");
      },
      [&](double height_m) {
        return height_m <= highest_centre_m &&
               (!array.support_spacing_m || height_m < 0.5 * *array.support_spacing_m);
      });
  if (!array.support_spacing_m && condition.is_met == true) condition.is_met.reset();
  return condition;
}

/// Where no tests are named, of the value alone.
CodeCondition tested_friction(double limit, const ArrayFacts& array) {
  constexpr const char* required = "ASTM G115";
  const std::string basis = array.friction_basis.empty() ? "" : " (" + array.friction_basis + ")";
  const std::string by = !array.test_standard           ? ""
                         : array.test_standard->empty() ? ", standard of the tests not stated"
                                                        : ", tests by " + *array.test_standard;
  CodeCondition condition = row(
      "coefficient of friction", fmt::format("{:g} or more (tests by {})", limit, required),
      array.friction, [&](double mu) { return number(mu) + basis + by; },
      [&](double mu) { return mu >= limit * (1.0 - rounding); });
  if (condition.is_met != true || !array.test_standard) return condition;
  if (array.test_standard->empty())
    condition.is_met.reset();
  else
    condition.is_met =
        *array.test_standard == required || array.test_standard->starts_with("ASTM G115-");
  return condition;
}

CodeCondition interconnection(const ArrayFacts& array) {
  const double required = std::max(0.133 * array.sds_g.value_or(0.0), 0.1);
  return row("horizontal strength across any section, over the weight of its lighter side",
             std::string("the larger of 0.133 S_DS and 0.1") +
                 (array.sds_g ? fmt::format(" ({:.3g})", required) : "") + " or more",
             array.interconnection, number, [&](double strength) { return strength >= required; });
}

}  // namespace

double slope_limit_deg(Standard standard) {
  return standard == Standard::seaoc_pv1_2012 ? 3.0 : slope_of_1_in_20_deg;
}

double friction_limit(Standard) { return 0.4; }

std::vector<CodeCondition> conditions_of(Standard standard, const ArrayFacts& array) {
  const bool pv1 = standard == Standard::seaoc_pv1_2012;
  const double slope_deg = slope_limit_deg(standard), friction = friction_limit(standard);
  std::vector<CodeCondition> rows{
      row("roof slope", (pv1 ? "" : "1 in 20, ") + degrees(slope_deg) + " or less", array.slope_deg,
          degrees, [&](double slope) { return std::abs(slope) <= slope_deg * (1.0 + rounding); }),
      tested_friction(friction, array),
      row(
          "risk category", "I, II or III", array.risk,
          [](RiskCategory risk) { return to_string(risk); },
          [](RiskCategory risk) { return risk != RiskCategory::iv; }),
      row("storeys", fmt::format("{:g} or fewer", most_storeys), array.storeys, number,
          [](double storeys) { return storeys <= most_storeys; }),
      centre_of_mass(array),
      interconnection(array)};
  for (CodeCondition& condition : rows)
    condition.clause = pv1 ? "PV1, unattached arrays" : "13.6.12";
  return rows;
}

bool is_within(Standard standard, const ArrayFacts& array) {
  return std::ranges::all_of(conditions_of(standard, array),
                             [](const CodeCondition& c) { return c.is_met.value_or(true); });
}

double least_share(Standard standard) { return standard == Standard::seaoc_pv1_2012 ? 0.5 : 0.8; }

std::string analysis_provision(Standard standard) {
  return standard == Standard::seaoc_pv1_2012
             ? "SEAOC PV1-2012 describes an analysis under 3 or more motions of the roof that "
               "match "
               "the spectrum of AC156, extended as 1/T, each of 30 s or more with three "
               "components; "
               "1.1 times their average with 7 or more motions, else 1.1 times the largest; half "
               "of "
               "the prescribed value or more, unless peer reviewed"
             : "ASCE 7-16 allows an analysis or shake-table tests in place of its value, not below "
               "80 % of that unless peer reviewed";
}

std::string not_met_text(const std::vector<CodeCondition>& conditions, bool unknown) {
  std::string text;
  for (const CodeCondition& c : conditions) {
    if (!c.is_met.value_or(!unknown))
      text +=
          fmt::format("{}{}: {}, required {}", text.empty() ? "" : "; ", c.what, c.found, c.limit);
  }
  return text;
}

}  // namespace glissade
