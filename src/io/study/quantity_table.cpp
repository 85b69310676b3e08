// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/quantity_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/units.hpp"
#include "scan.hpp"
#include "study/distribution_table.hpp"
#include "study/number_list.hpp"

namespace glissade {
namespace {

std::optional<Quantity> read_list(const TomlTable& table, const char* key,
                                  const ParameterRange& range) {
  const std::size_t problems = table.problem_count();
  const std::vector<double> values = read_increasing(table, key, any_finite);
  if (table.problem_count() > problems || values.empty()) return std::nullopt;
  for (const double value : values) {
    if (value >= range.min && value <= range.max) continue;
    table.report(key, table.name_of(key) + ": " + shortest_decimal(value) + " is outside its range",
                 std::string("it must be ") + range.text);
    return std::nullopt;
  }
  return Quantity{values, {}};
}

std::optional<Quantity> from_distribution(const std::optional<Distribution>& distribution) {
  if (!distribution) return std::nullopt;
  if (const auto* fixed = std::get_if<Fixed>(&*distribution)) return Quantity{{fixed->value}, {}};
  return Quantity{{}, *distribution};
}

/// { mean, std }: a normal distribution cut at the lower end of the range, as of tested friction.
std::optional<Quantity> read_moments(const TomlTable& table, const char* key,
                                     const ParameterRange& range) {
  const TomlTable moments = table.table(key);
  const std::size_t problems = table.problem_count();
  const double mean = moments.required_number("mean");
  const double std = moments.number("std", not_negative).value_or(0.0);
  if (table.problem_count() > problems) return std::nullopt;
  if (mean < range.min || mean > range.max) {
    moments.report(
        "mean", moments.name_of("mean") + " = " + shortest_decimal(mean) + " is outside its range",
        std::string("it must be ") + range.text);
    return std::nullopt;
  }
  if (std == 0.0) return Quantity{{mean}, {}};
  return Quantity{{},
                  TruncatedNormal{mean, std, range.min, std::numeric_limits<double>::infinity()}};
}

double slope_of_rise_deg(double rise) { return std::atan(rise / 12.0) / rad_per_deg; }

}  // namespace

std::optional<Quantity> read_quantity(const TomlTable& table, const char* key,
                                      const ParameterRange& range) {
  if (!table.has(key)) return std::nullopt;
  if (table.is_array(key)) return read_list(table, key, range);
  if (table.is_table(key)) {
    const TomlTable value = table.table(key);
    if (value.has("from") || value.has("to")) return read_list(table, key, range);
    if (!value.has("distribution") && value.has("mean")) return read_moments(table, key, range);
  }
  return from_distribution(
      read_distribution(table, key, {range.min, range.max, Bounds::Top::closed, range.text}));
}

std::optional<Quantity> read_rise_in_12(const TomlTable& table) {
  constexpr ParameterRange rises{-100.0, 100.0, "a rise in 12, -100 to 100"};
  std::optional<Quantity> quantity = read_quantity(table, "rise_in_12", rises);
  if (!quantity) return std::nullopt;
  std::vector<double>* values = &quantity->values;
  if (quantity->drawn) {
    auto* discrete = std::get_if<Discrete>(&*quantity->drawn);
    if (discrete == nullptr) {
      table.report("rise_in_12", table.name_of("rise_in_12") + " is drawn from a continuum",
                   "give a number, a list or a discrete distribution, or slope_deg");
      return std::nullopt;
    }
    values = &discrete->values;
  }
  std::ranges::transform(*values, values->begin(), slope_of_rise_deg);
  return quantity;
}

}  // namespace glissade
