// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/record_entry.hpp"

namespace glissade {

std::optional<AccelerationUnits> read_units(const TomlTable& table) {
  return table.choice<AccelerationUnits>("units", {{"g", AccelerationUnits::g},
                                                   {"m/s2", AccelerationUnits::mps2},
                                                   {"cm/s2", AccelerationUnits::cmps2},
                                                   {"gal", AccelerationUnits::cmps2}});
}

std::optional<ComponentEntry> read_component_entry(const TomlTable& record, const char* key) {
  if (!record.has(key)) return std::nullopt;
  ComponentEntry entry;
  if (!record.is_table(key)) {
    entry.file = record.required_text(key);
    return entry;
  }
  const TomlTable table = record.table(key);
  entry.file = table.required_text("file");
  entry.start_s = table.number("start_s", not_negative).value_or(0.0);
  entry.options.dt_s = table.number("dt_s", above_zero);
  entry.options.units = read_units(table);
  entry.options.counts_per_unit = table.number("counts_per_unit", above_zero);
  return entry;
}

Motion read_metadata(const TomlTable& record) {
  Motion motion;
  motion.id = record.required_text("id");
  motion.event = record.text("event").value_or("");
  motion.station = record.text("station").value_or("");
  constexpr NumberRule magnitude_rule{"above 0, up to 10",
                                      [](double x) { return x > 0.0 && x <= 10.0; }};
  motion.magnitude = record.number("magnitude", magnitude_rule).value_or(0.0);
  motion.distance_km = record.number("distance_km", not_negative).value_or(0.0);
  motion.vs30_mps = record.number("vs30_mps", above_zero).value_or(0.0);
  motion.scale = record.number("scale", above_zero).value_or(1.0);
  return motion;
}

}  // namespace glissade
