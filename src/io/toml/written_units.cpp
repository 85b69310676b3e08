// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/written_number.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using Unit = KeyUnits::Unit;

constexpr std::array lengths = {Unit{"m", 1.0}, Unit{"cm", 0.01}, Unit{"mm", 0.001},
                                Unit{"in", inch_m}, Unit{"ft", foot_m}};
constexpr std::array distances = {Unit{"km", 1.0}, Unit{"mi", 1.609344}};
constexpr std::array times = {Unit{"s", 1.0}, Unit{"ms", 0.001}};
constexpr std::array years = {Unit{"years", 1.0}};
constexpr std::array angles = {Unit{"deg", 1.0}, Unit{"rad", 1.0 / rad_per_deg}};
constexpr std::array accelerations = {Unit{"g", 1.0}, Unit{"m/s2", 1.0 / standard_gravity_mps2},
                                      Unit{"cm/s2", 0.01 / standard_gravity_mps2},
                                      Unit{"ft/s2", foot_m / standard_gravity_mps2}};
constexpr std::array velocities = {Unit{"m/s", 1.0}, Unit{"cm/s", 0.01}, Unit{"in/s", inch_m},
                                   Unit{"ft/s", foot_m}};
constexpr std::array forces = {Unit{"kN", 1.0}, Unit{"N", 0.001}, Unit{"kip", pound_force_n},
                               Unit{"lb", 1e-3 * pound_force_n}};
constexpr std::array rates = {Unit{"s/m", 1.0}, Unit{"s/in", 1.0 / inch_m},
                              Unit{"s/ft", 1.0 / foot_m}};

double slope_deg(double rise, double run) { return std::atan(rise / run) / rad_per_deg; }
double rise_in_12(double rise, double run) { return rise * (12.0 / run); }

/// The first that fits counts.
constexpr std::array rows = {KeyUnits{"slope_deg", "a slope", angles, slope_deg},
                             KeyUnits{"rise_in_12", "a slope", {}, rise_in_12},
                             KeyUnits{"_deg", "an angle", angles},
                             KeyUnits{"_s_per_m", "a time over a length", rates},
                             KeyUnits{"_mps", "a velocity", velocities},
                             KeyUnits{"_km", "a distance", distances},
                             KeyUnits{"_kn", "a force", forces},
                             KeyUnits{"_m", "a length", lengths},
                             KeyUnits{"_s", "a time", times},
                             KeyUnits{"_g", "an acceleration", accelerations},
                             KeyUnits{"_years", "a time", years}};

/// "0.25" or "1/4".
std::optional<double> number_or_fraction(std::string_view text) {
  const std::size_t bar = text.find('/');
  const auto above = parse_number(text.substr(0, bar));
  if (bar == std::string_view::npos) return above;
  const auto below = parse_number(text.substr(bar + 1));
  if (!above || !below || !(*below > 0.0)) return std::nullopt;
  return *above / *below;
}

}  // namespace

std::optional<double> KeyUnits::value_of(std::string_view text) const {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE/"), text.size());
  const auto number = number_or_fraction(text.substr(0, end));
  std::string_view unit = trimmed(text.substr(end));
  if (unit == "'") unit = "ft";
  if (unit == "\"") unit = "in";
  if (!number) return std::nullopt;
  for (const Unit& known : units) {
    if (unit == known.name)
      return known.factor == 1.0 ? *number : to_twelve_digits(*number * known.factor);
  }
  if (of_ratio == nullptr) return std::nullopt;
  if (unit == "in/ft") return of_ratio(*number, 12.0);
  if (unit == "%") return of_ratio(*number, 100.0);
  if (unit == "deg") return of_ratio(std::tan(*number * rad_per_deg), 1.0);
  if (!unit.starts_with(':')) return std::nullopt;
  const auto run = parse_number(trimmed(unit.substr(1)));
  return run && *run > 0.0 ? std::optional(of_ratio(*number, *run)) : std::nullopt;
}

std::string KeyUnits::names() const {
  std::string text;
  for (const Unit& unit : units) text += std::string(text.empty() ? "" : ", ") + unit.name;
  if (of_ratio != nullptr) text += text.empty() ? "0.25:12, in/ft, %, deg" : ", 0.25:12, in/ft, %";
  return text;
}

const KeyUnits* units_of_key(std::string_view key) {
  while (!key.empty()) {
    const std::size_t dot = key.rfind('.');
    const std::string_view part = key.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (part == "log_std" || part == "weights") return nullptr;  // of a distribution in the unit
    for (const KeyUnits& row : rows) {
      if (part.ends_with(row.suffix)) return &row;
    }
    key = key.substr(0, dot == std::string_view::npos ? 0 : dot);
  }
  return nullptr;
}

const KeyUnits::Unit* customary_unit(const KeyUnits& units) {
  const std::string_view wanted = units.units.data() == lengths.data()  ? "ft"
                                  : units.units.data() == forces.data() ? "kip"
                                                                        : "";
  const auto at = std::ranges::find_if(
      units.units, [&](const KeyUnits::Unit& unit) { return unit.name == wanted; });
  return at == units.units.end() ? nullptr : &*at;
}

std::string with_unit_of(const std::string& key, double value) {
  const KeyUnits* units = units_of_key(key);
  const bool has_unit = units != nullptr && !units->units.empty();
  return shortest_decimal(value) + (has_unit ? std::string(" ") + units->units.front().name : "");
}

std::span<const KeyUnits> all_key_units() { return rows; }

std::string number_in_unit_of(std::string key, const std::string& text) {
  const std::string name = key;
  std::ranges::replace(key, '-', '_');
  const KeyUnits* units = units_of_key(key);
  if (units == nullptr || parse_number(trimmed(text))) return text;
  if (const auto value = units->value_of(text)) return fmt::format("{}", *value);
  throw InputError({name, "\"" + text + "\" is not " + units->what,
                    "give a number, or one with a unit in quotes: " + units->names(), ""});
}

}  // namespace glissade
