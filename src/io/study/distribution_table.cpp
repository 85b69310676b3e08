// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/distribution_table.hpp"

#include <cmath>
#include <limits>

namespace glissade {
namespace {

enum class Kind { normal, truncated_normal, lognormal, uniform, triangular, discrete, empirical };

Discrete read_discrete(const TomlTable& table) {
  Discrete discrete{table.numbers("values").value_or(std::vector<double>{}), {}};
  if (!table.has("values")) table.report_missing("values");
  discrete.weights =
      table.numbers("weights").value_or(std::vector<double>(discrete.values.size(), 1.0));
  return discrete;
}

Empirical read_empirical(const TomlTable& table) {
  if (!table.has("values")) table.report_missing("values");
  return {table.numbers("values").value_or(std::vector<double>{})};
}

Distribution read_kind(const TomlTable& table, Kind kind) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto number = [&](const char* key) { return table.required_number(key); };
  switch (kind) {
    case Kind::normal:
      return Normal{number("mean"), number("std")};
    case Kind::truncated_normal:
      return TruncatedNormal{number("mean"), number("std"), table.number("min").value_or(-infinity),
                             table.number("max").value_or(infinity)};
    case Kind::lognormal:
      return LogNormal{number("median"), number("log_std")};
    case Kind::uniform:
      return Uniform{number("min"), number("max")};
    case Kind::triangular:
      return Triangular{number("min"), number("mode"), number("max")};
    case Kind::discrete:
      return read_discrete(table);
    case Kind::empirical:
      return read_empirical(table);
  }
  return Fixed{0.0};
}

std::optional<Distribution> read_table(const TomlTable& table) {
  const auto kind =
      table.choice<Kind>("distribution", {{"normal", Kind::normal},
                                          {"truncated_normal", Kind::truncated_normal},
                                          {"lognormal", Kind::lognormal},
                                          {"uniform", Kind::uniform},
                                          {"triangular", Kind::triangular},
                                          {"discrete", Kind::discrete},
                                          {"empirical", Kind::empirical}});
  if (kind) return read_kind(table, *kind);
  if (!table.has("distribution")) {
    table.report_missing("distribution",
                         "give distribution = \"uniform\" or another, or give a plain number");
  }
  table.ignore_unknown();
  return std::nullopt;
}

}  // namespace

std::optional<Distribution> read_distribution(const TomlTable& table, const char* key,
                                              const Bounds& bounds) {
  if (!table.has(key)) return std::nullopt;
  const bool is_table = table.is_table(key);
  const std::size_t problems_before = table.problem_count();
  std::optional<Distribution> distribution;
  if (is_table) {
    distribution = read_table(table.table(key));
  } else if (const auto value = table.number(key)) {
    distribution = Fixed{*value};
  }
  if (!distribution || table.problem_count() > problems_before) return std::nullopt;
  try {
    validate(*distribution);
  } catch (const InputError& error) {
    table.report(key, error);
    return std::nullopt;
  }
  // A tail of one in a million may be outside: it is set to the limit when drawn.
  const Support all = support(*distribution);
  const Support range{
      std::isinf(all.min) || all.min == 0.0 ? quantile(*distribution, 1e-6) : all.min,
      std::isinf(all.max) ? quantile(*distribution, 1.0 - 1e-6) : all.max};
  const bool too_high =
      bounds.top == Bounds::Top::open ? range.max >= bounds.max : range.max > bounds.max;
  if (range.min < bounds.min || too_high) {
    table.report(
        key, table.name_of(key) + (is_table ? " can take values" : " is") + " outside its range",
        std::string("it must be ") + bounds.text +
            (is_table ? ": narrow it, or use truncated_normal with min and max" : ""));
    return std::nullopt;
  }
  return distribution;
}

}  // namespace glissade
