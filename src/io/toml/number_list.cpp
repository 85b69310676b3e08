// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml/number_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "toml/written_units.hpp"

namespace glissade {
namespace {

constexpr std::uint64_t largest_list = 10000;

/// { from, to, count, spacing = "linear" | "log" }, both ends included.
std::vector<double> read_range(const TomlTable& range, const NumberRule& rule) {
  enum class Spacing { linear, log };
  const std::size_t problems_before = range.problem_count();
  const double from = range.required_number("from", rule);
  const double to = range.required_number("to", rule);
  if (!range.has("count")) range.report_missing("count");
  const std::uint64_t count = range.whole("count", 2, largest_list).value_or(2);
  const Spacing spacing =
      range.choice<Spacing>("spacing", {{"linear", Spacing::linear}, {"log", Spacing::log}})
          .value_or(Spacing::linear);
  if (range.problem_count() == problems_before && to <= from) {
    range.report("to", range.name_of("to") + " = " + with_unit_of(range.name_of("to"), to) +
                           " is not above from = " + with_unit_of(range.name_of("from"), from));
  }
  if (range.problem_count() == problems_before && spacing == Spacing::log && from <= 0.0) {
    range.report("from", range.name_of("from") + " is 0, which has no logarithm",
                 "begin above 0, or use linear spacing");
  }
  if (range.problem_count() > problems_before) return {};
  std::vector<double> values(count);
  const auto fill = [&](auto write) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count - 1);
      values[i] = write(spacing == Spacing::linear ? from + (to - from) * share
                                                   : from * std::pow(to / from, share));
    }
    values.front() = from;
    values.back() = to;
    return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
  };
  if (!fill(to_twelve_digits) && !fill([](double value) { return value; })) {
    range.report("count", range.name_of("count") + " is more values than there are between " +
                              with_unit_of(range.name_of("from"), from) + " and " +
                              with_unit_of(range.name_of("to"), to));
    return {};
  }
  return values;
}

}  // namespace

std::vector<double> read_increasing(const TomlTable& table, const char* key,
                                    const NumberRule& rule) {
  if (!table.has(key)) {
    table.report_missing(key, "give a list, or { from, to, count }");
    return {};
  }
  if (table.is_table(key)) return read_range(table.table(key), rule);
  const auto values = table.numbers(key, rule);
  if (!values) return {};
  const std::string name = table.name_of(key);
  if (values->empty()) table.report(key, name + " is empty", "give at least one value");
  if (values->size() > largest_list)
    table.report(key, name + " has more than " + std::to_string(largest_list) + " values");
  for (std::size_t i = 1; i < values->size(); ++i) {
    if ((*values)[i] > (*values)[i - 1]) continue;
    table.report(key,
                 name + " is not increasing: " + with_unit_of(name, (*values)[i - 1]) +
                     " is followed by " + with_unit_of(name, (*values)[i]),
                 "list each value once, the smallest first");
    break;
  }
  return *values;
}

}  // namespace glissade
