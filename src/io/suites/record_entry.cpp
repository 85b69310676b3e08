// SPDX-License-Identifier: GPL-3.0-or-later
#include "suites/record_entry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "toml/toml_text.hpp"

namespace glissade {
namespace {

std::string component_toml(const ComponentEntry& component) {
  std::string more;
  const RecordFileOptions& options = component.options;
  if (options.dt_s) more += fmt::format(", dt_s = {}", *options.dt_s);
  if (component.azimuth_deg) more += fmt::format(", azimuth_deg = {}", *component.azimuth_deg);
  if (component.start_s > 0.0) more += fmt::format(", start_s = {}", component.start_s);
  if (options.units) more += fmt::format(", units = {}", quoted(to_string(*options.units)));
  if (options.counts_per_unit)
    more += fmt::format(", counts_per_unit = {}", *options.counts_per_unit);
  if (!component.sha256.empty()) more += ", sha256 = " + quoted(component.sha256);
  return more.empty() ? quoted(component.file)
                      : fmt::format("{{ file = {}{} }}", quoted(component.file), more);
}

/// The line of a key, if it is given.
std::string line(const char* key, const std::string& text) {
  return text.empty() ? "" : fmt::format("{} = {}\n", key, quoted(text));
}
std::string line(const char* key, double value) {
  return value > 0.0 ? fmt::format("{} = {}\n", key, value) : "";
}

constexpr NumberRule azimuth_rule{"from 0 to 360", [](double x) { return x >= 0.0 && x <= 360.0; },
                                  "degrees clockwise from north"};

constexpr EnumNames<FaultAxis> fault_axes = {{"fault_normal", FaultAxis::normal},
                                             {"fault_parallel", FaultAxis::parallel}};

std::optional<ButterworthBand> read_band(const TomlTable& table) {
  if (!table.exists()) return std::nullopt;
  constexpr int highest_order = 8;
  ButterworthBand band;
  band.low_hz = table.number("low_hz", above_zero);
  band.high_hz = table.number("high_hz", above_zero);
  band.order = static_cast<int>(table.whole("order", 1, highest_order).value_or(band.order));
  if (!table.has("low_hz") && !table.has("high_hz"))
    table.report_missing("low_hz", "give low_hz, high_hz, or both");
  if (band.low_hz && band.high_hz && *band.low_hz >= *band.high_hz)
    table.report("low_hz", "the corners of band_pass are not in order",
                 "give low_hz below high_hz, in Hz");
  return band;
}

std::optional<std::array<double, 2>> read_arias(const TomlTable& table) {
  constexpr NumberRule percent_rule{"from 0 to 100",
                                    [](double x) { return x >= 0.0 && x <= 100.0; }};
  const auto given = table.numbers("arias_percent", percent_rule);
  if (!given) return std::nullopt;
  if (given->size() != 2 || !((*given)[0] < (*given)[1])) {
    table.report("arias_percent", "arias_percent is not two percentages, the smaller first",
                 "give [5, 95] for the significant duration");
    return std::nullopt;
  }
  return std::array{(*given)[0], (*given)[1]};
}

std::string processing_toml(const MotionProcessing& p) {
  std::vector<std::string> keys;
  if (p.baseline_degree) keys.push_back(fmt::format("baseline_degree = {}", *p.baseline_degree));
  if (p.band_pass) {
    std::string band;
    if (p.band_pass->low_hz) band += fmt::format("low_hz = {}, ", *p.band_pass->low_hz);
    if (p.band_pass->high_hz) band += fmt::format("high_hz = {}, ", *p.band_pass->high_hz);
    keys.push_back(fmt::format("band_pass = {{ {}order = {} }}", band, p.band_pass->order));
  }
  if (p.rotate_to_deg) keys.push_back(fmt::format("rotate_to_deg = {}", *p.rotate_to_deg));
  for (const auto& [name, axis] : fault_axes)
    if (p.rotate_to == axis) keys.push_back(fmt::format("rotate_to = {}", quoted(name)));
  if (p.arias_percent)
    keys.push_back(fmt::format("arias_percent = [{}]", fmt::join(*p.arias_percent, ", ")));
  if (p.step_s) keys.push_back(fmt::format("step_s = {}", *p.step_s));
  return keys.empty() ? "" : fmt::format("processing = {{ {} }}\n", fmt::join(keys, ", "));
}

/// FIPS 180-4, 64 hexadecimal digits.
std::string read_sha256(const TomlTable& table) {
  std::string text = table.text("sha256").value_or("");
  if (!text.empty() &&
      (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string::npos))
    table.report("sha256", "sha256 is not 64 digits 0-9, a-f", "take that of sha256sum FILE");
  return text;
}

}  // namespace

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
  entry.azimuth_deg = table.number("azimuth_deg", azimuth_rule);
  entry.options.dt_s = table.number("dt_s", above_zero);
  entry.options.units = read_units(table);
  entry.options.counts_per_unit = table.number("counts_per_unit", above_zero);
  entry.sha256 = read_sha256(table);
  return entry;
}

MotionProcessing read_processing(const TomlTable& above) {
  constexpr int highest_degree = 5;
  const TomlTable table = above.table("processing");
  MotionProcessing processing;
  if (const auto degree = table.whole("baseline_degree", 0, highest_degree))
    processing.baseline_degree = static_cast<int>(*degree);
  processing.band_pass = read_band(table.table("band_pass"));
  processing.rotate_to_deg = table.number("rotate_to_deg", azimuth_rule);
  processing.rotate_to = table.choice<FaultAxis>("rotate_to", fault_axes);
  table.refuse_both("rotate_to", "rotate_to_deg", "leave one out");
  processing.arias_percent = read_arias(table);
  processing.step_s = table.number("step_s", above_zero);
  return processing;
}

RecordEntry read_record_entry(const TomlTable& record) {
  RecordEntry entry;
  Motion& motion = entry.metadata;
  motion.id = record.required_text("id");
  motion.event = record.text("event").value_or("");
  motion.station = record.text("station").value_or("");
  constexpr NumberRule magnitude_rule{"above 0, up to 10",
                                      [](double x) { return x > 0.0 && x <= 10.0; }};
  motion.magnitude = record.number("magnitude", magnitude_rule).value_or(0.0);
  motion.distance_km = record.number("distance_km", not_negative).value_or(0.0);
  motion.vs30_mps = record.number("vs30_mps", above_zero).value_or(0.0);
  motion.scale = record.number("scale", above_zero).value_or(1.0);
  entry.step_s = record.number("step_s", above_zero);
  entry.end_s = record.number("end_s", above_zero);
  entry.strike_deg = record.number("strike_deg", azimuth_rule);
  entry.processing = read_processing(record);
  entry.magnitude_kind = record.text("magnitude_kind").value_or("");
  if (motion.magnitude > 0.0 && !entry.magnitude_kind.empty() && entry.magnitude_kind != "Mw")
    motion.notes.push_back(fmt::format("its magnitude, {:g}, is {}, no moment magnitude",
                                       motion.magnitude, entry.magnitude_kind));
  entry.distance_kind = record
                            .choice<const char*>("distance_kind", {{"rupture", ""},
                                                                   {"joyner_boore", "joyner_boore"},
                                                                   {"epicentral", "epicentral"}})
                            .value_or("");
  if (motion.distance_km > 0.0 && !entry.distance_kind.empty())
    motion.notes.push_back(fmt::format(
        "its distance, {:g} km, is {}, not that to the rupture", motion.distance_km,
        entry.distance_kind == "epicentral" ? "epicentral" : "that of Joyner and Boore"));
  return entry;
}

std::string record_toml(const RecordEntry& entry) {
  const Motion& m = entry.metadata;
  std::string text =
      "\n[[record]]\n" + line("id", m.id) + line("event", m.event) + line("station", m.station) +
      line("magnitude", m.magnitude) + line("magnitude_kind", entry.magnitude_kind) +
      line("distance_km", m.distance_km) + line("distance_kind", entry.distance_kind) +
      line("vs30_mps", m.vs30_mps) + line("scale", m.scale) +
      line("step_s", entry.step_s.value_or(0.0)) + line("end_s", entry.end_s.value_or(0.0));
  if (entry.strike_deg) text += fmt::format("strike_deg = {}\n", *entry.strike_deg);
  text += processing_toml(entry.processing);
  for (const auto& [key, component] : entry.components)  // first, second, vertical
    text += fmt::format("{} = {}\n", key, component_toml(component));
  return text;
}

}  // namespace glissade
