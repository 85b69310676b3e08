// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys/quantity_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "text/scan.hpp"
#include "toml/number_list.hpp"
#include "toml/written_units.hpp"

namespace glissade {
namespace {

std::optional<Quantity> read_list(const TomlTable& table, const char* key,
                                  const ParameterRange& range) {
  const std::size_t problems = table.problem_count();
  const std::vector<double> values = read_increasing(table, key, any_finite);
  if (table.problem_count() > problems || values.empty()) return std::nullopt;
  for (const double value : values) {
    if (value >= range.min && value <= range.max) continue;
    table.report(key,
                 table.name_of(key) + ": " + with_unit_of(table.name_of(key), value) +
                     " is outside its range",
                 std::string("it must be ") + range.text);
    return std::nullopt;
  }
  return Quantity{values, {}};
}

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

const DistributionForm forms[] = {
    {"normal", "mean, std",
     [](const TomlTable& t) -> Distribution {
       return Normal{t.required_number("mean"), t.required_number("std")};
     }},
    {"truncated_normal", "mean, std, min, max",
     [](const TomlTable& t) -> Distribution {
       return TruncatedNormal{t.required_number("mean"), t.required_number("std"),
                              t.number("min").value_or(-infinity),
                              t.number("max").value_or(infinity)};
     }},
    {"lognormal", "median, log_std",
     [](const TomlTable& t) -> Distribution {
       return LogNormal{t.required_number("median"), t.required_number("log_std")};
     }},
    {"uniform", "min, max",
     [](const TomlTable& t) -> Distribution {
       return Uniform{t.required_number("min"), t.required_number("max")};
     }},
    {"triangular", "min, mode, max",
     [](const TomlTable& t) -> Distribution {
       return Triangular{t.required_number("min"), t.required_number("mode"),
                         t.required_number("max")};
     }},
    {"discrete", "values, weights (equal where absent)",
     [](const TomlTable& t) -> Distribution { return read_discrete(t); }},
    {"empirical", "values", [](const TomlTable& t) -> Distribution { return read_empirical(t); }}};

std::optional<Distribution> read_table(const TomlTable& table) {
  const auto form =
      table.choice<const DistributionForm*>("distribution", {{forms[0].name, &forms[0]},
                                                             {forms[1].name, &forms[1]},
                                                             {forms[2].name, &forms[2]},
                                                             {forms[3].name, &forms[3]},
                                                             {forms[4].name, &forms[4]},
                                                             {forms[5].name, &forms[5]},
                                                             {forms[6].name, &forms[6]}});
  if (form) return (*form)->read(table);
  if (!table.has("distribution")) {
    table.report_missing(
        "distribution", table.has("median")
                            ? "give distribution = \"lognormal\" with median and log_std"
                            : "give distribution = \"uniform\" or another, or give a plain number");
  }
  table.ignore_unknown();
  return std::nullopt;
}

/// A plain number, or a table { distribution = "uniform", ... } with the fields of the struct as
/// keys (weights of discrete values default to equal ones).
std::optional<Distribution> read_distribution(const TomlTable& table, const char* key,
                                              const ParameterRange& bounds) {
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
  if (range.min < bounds.min || range.max > bounds.max) {
    table.report(
        key, table.name_of(key) + (is_table ? " can take values" : " is") + " outside its range",
        std::string("it must be ") + bounds.text +
            (is_table ? ": narrow it, or use truncated_normal with min and max" : ""));
    return std::nullopt;
  }
  return distribution;
}

/// { mean, std }: a normal distribution cut at the lower end of the range, as of tested friction.
std::optional<Quantity> read_moments(const TomlTable& table, const char* key,
                                     const ParameterRange& range) {
  const TomlTable moments = table.table(key);
  const std::size_t problems = table.problem_count();
  const double mean = moments.required_number("mean");
  if (!moments.has("std"))
    moments.report_missing("std", std::string("give it, or one number, for a constant: ") + key +
                                      " = " + shortest_decimal(mean));
  const double std = moments.number("std", not_negative).value_or(0.0);
  if (table.problem_count() > problems) return std::nullopt;
  if (mean < range.min || mean > range.max) {
    moments.report("mean",
                   moments.name_of("mean") + " = " + with_unit_of(moments.name_of("mean"), mean) +
                       " is outside its range",
                   std::string("it must be ") + range.text);
    return std::nullopt;
  }
  if (std == 0.0) return Quantity{{mean}, {}};
  return Quantity{{},
                  TruncatedNormal{mean, std, range.min, std::numeric_limits<double>::infinity()}};
}

}  // namespace

bool refuse_cov(const TomlTable& moments, bool of_median) {
  return moments.refuse_unknown(
      "cov", of_median ? "of a lognormal distribution give log_std = sqrt(ln(1 + cov^2)) (cov 0.2: "
                         "0.198), with distribution = \"lognormal\" and median"
                       : "give the standard deviation, std = cov x mean (0.08 x 0.50: std = 0.04)");
}

std::span<const DistributionForm> distribution_forms() { return forms; }

Quantity quantity_of(const Distribution& distribution) {
  if (const auto* fixed = std::get_if<Fixed>(&distribution)) return {{fixed->value}, {}};
  return {{}, distribution};
}

std::optional<Quantity> read_quantity(const TomlTable& table, const char* key,
                                      const ParameterRange& range) {
  if (!table.has(key)) return std::nullopt;
  if (table.is_array(key)) return read_list(table, key, range);
  if (table.is_table(key)) {
    const TomlTable value = table.table(key);
    if (value.has("from") || value.has("to")) return read_list(table, key, range);
    if (refuse_cov(value, value.has("median"))) return std::nullopt;
    if (!value.has("distribution") && value.has("mean")) return read_moments(table, key, range);
  }
  const auto distribution = read_distribution(table, key, range);
  return distribution ? std::optional(quantity_of(*distribution)) : std::nullopt;
}

std::optional<Quantity> read_rise_in_12(const TomlTable& table) {
  constexpr ParameterRange rises{-100.0, 100.0, "a rise in 12, -100 to 100"};
  std::optional<Quantity> quantity = read_quantity(table, "rise_in_12", rises);
  if (!quantity) return std::nullopt;
  auto* discrete = quantity->drawn ? std::get_if<Discrete>(&*quantity->drawn) : nullptr;
  std::vector<double>& values = discrete != nullptr ? discrete->values : quantity->values;
  std::ranges::transform(values, values.begin(), slope_of_rise_deg);
  quantity->drawn_as_rise_in_12 = quantity->is_drawn() && discrete == nullptr;
  return quantity;
}

}  // namespace glissade
