// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

// Quantities that are written with their unit, "18 in" or "0.25:12", in place of a number in the
// unit of the key. One table of units for all files.
namespace glissade {

/// What a key holds, by the end of its name.
struct KeyUnits {
  struct Unit {
    const char* name;
    double factor;  ///< a number in this unit, times this: in the unit of the key
  };
  const char* suffix;  ///< "_m"
  const char* what;    ///< "a length"
  std::span<const Unit> units;
  /// Of a slope: rise over run, written "0.25:12", "0.25 in/ft" or "2 %", in the unit of the key.
  double (*of_ratio)(double rise, double run) = nullptr;

  /// Nothing where the text is no number with one of the units.
  std::optional<double> value_of(std::string_view text) const;
  std::string names() const;  ///< "m, cm, mm, in, ft"
};

/// By the last part of "fragility.thresholds_m.from" that ends with a unit; null: the key has none.
const KeyUnits* units_of_key(std::string_view key);
/// A number as a key has it, with the key's unit: "-0.6096 m".
std::string with_unit_of(const std::string& key, double value);
/// Feet or kip of keys in m or kN; null: no other.
const KeyUnits::Unit* customary_unit(const KeyUnits& units);
std::span<const KeyUnits> all_key_units();

}  // namespace glissade
