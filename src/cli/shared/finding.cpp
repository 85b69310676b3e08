// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"

namespace glissade::cli {
namespace {

std::string value_text(const Finding& f) {
  if (f.unit == "m") return fmt::format("{:.4f} m ({:.2f} in)", f.value, f.value / inch_m);
  return f.unit.empty() ? fmt::format("{:.6g}", f.value)
                        : fmt::format("{:.4f} {}", f.value, f.unit);
}

std::string interval_text(const Finding& f) {
  return f.interval && !std::isnan(f.interval->low)
             ? fmt::format("{:.4g} to {}", f.interval->low,
                           std::isinf(f.interval->high) ? "unbounded"
                                                        : fmt::format("{:.4g}", f.interval->high))
             : "";
}

}  // namespace

nlohmann::ordered_json to_json(const Interval& interval) { return {interval.low, interval.high}; }

nlohmann::ordered_json to_json(const std::vector<Finding>& findings) {
  nlohmann::ordered_json json;
  for (const Finding& f : findings) {
    json[f.key] = f.value;
    if (f.interval) json[f.key + "_interval_95"] = to_json(*f.interval);
  }
  return json;
}

Table to_table(const std::string& title, const std::vector<Finding>& findings) {
  Table table{"findings",
              title,
              {text_column("quantity", "Quantity"), text_column("value", "Value")},
              {},
              {}};
  const bool has_intervals =
      std::ranges::any_of(findings, [](const Finding& f) { return !interval_text(f).empty(); });
  if (has_intervals) table.columns.push_back(text_column("interval", "95 % interval"));
  for (const Finding& f : findings) {
    if (f.label.empty() || std::isnan(f.value)) continue;
    std::vector<Cell> row{f.label, value_text(f)};
    if (has_intervals) row.emplace_back(interval_text(f));
    table.add(row);
  }
  return table;
}

}  // namespace glissade::cli
