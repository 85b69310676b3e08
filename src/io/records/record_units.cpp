// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/record_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

struct AccelerationUnit {
  AccelerationUnits units;
  std::string name;
  double mps2;
};
const AccelerationUnit acceleration_units[] = {{AccelerationUnits::g, "g", standard_gravity_mps2},
                                               {AccelerationUnits::mps2, "m/s2", 1.0},
                                               {AccelerationUnits::cmps2, "cm/s2", 0.01}};

const AccelerationUnit& unit_of(AccelerationUnits units) {
  return *std::ranges::find(acceleration_units, units, &AccelerationUnit::units);
}

struct KnownUnit {
  std::string_view name;
  UnitKind kind;
  double si;
};
constexpr double g_mps2 = standard_gravity_mps2;
constexpr std::array known_units = {KnownUnit{"g", UnitKind::acceleration, g_mps2},
                                    KnownUnit{"g's", UnitKind::acceleration, g_mps2},
                                    KnownUnit{"gs", UnitKind::acceleration, g_mps2},
                                    KnownUnit{"g/10", UnitKind::acceleration, 0.1 * g_mps2},
                                    KnownUnit{"%g", UnitKind::acceleration, 0.01 * g_mps2},
                                    KnownUnit{"mg", UnitKind::acceleration, 0.001 * g_mps2},
                                    KnownUnit{"gal", UnitKind::acceleration, 0.01},
                                    KnownUnit{"gals", UnitKind::acceleration, 0.01},
                                    KnownUnit{"s", UnitKind::time, 1.0},
                                    KnownUnit{"ms", UnitKind::time, 0.001},
                                    KnownUnit{"hz", UnitKind::frequency, 1.0},
                                    KnownUnit{"counts", UnitKind::counts, 1.0},
                                    KnownUnit{"count", UnitKind::counts, 1.0},
                                    KnownUnit{"volts", UnitKind::counts, 1.0},
                                    KnownUnit{"text", UnitKind::label, 1.0},
                                    KnownUnit{"unitless", UnitKind::label, 1.0},
                                    KnownUnit{"rad", UnitKind::label, 1.0},
                                    KnownUnit{"rad/s", UnitKind::label, 1.0},
                                    KnownUnit{"rad/s2", UnitKind::label, 1.0}};
constexpr std::array lengths = {std::pair{"nm", 1e-9},   std::pair{"mm", 0.001},
                                std::pair{"cm", 0.01},   std::pair{"m", 1.0},
                                std::pair{"in", inch_m}, std::pair{"ft", foot_m}};
constexpr std::array of_length = {
    std::pair{"", UnitKind::displacement}, std::pair{"/s", UnitKind::velocity},
    std::pair{"s-1", UnitKind::velocity}, std::pair{"/s2", UnitKind::acceleration},
    std::pair{"s-2", UnitKind::acceleration}};

/// cm/sec**2, cm/sec^2, cm/sec/sec -> cm/s2
std::string plain_unit(std::string_view text) {
  std::string unit = lower_case(trimmed(text));
  for (const auto& [from, to] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{{"seconds", "s"},
                                                                            {"second", "s"},
                                                                            {"secs", "s"},
                                                                            {"sec", "s"},
                                                                            {"**", ""},
                                                                            {"^", ""},
                                                                            {"\xc2\xb2", "2"},
                                                                            {"\xb2", "2"},
                                                                            {"/s/s", "/s2"},
                                                                            {" ", ""},
                                                                            {"milli", "m"}}) {
    for (std::size_t at; (at = unit.find(from)) != std::string::npos;)
      unit.replace(at, from.size(), to);
  }
  while (unit.ends_with('.')) unit.pop_back();
  return unit;
}

[[noreturn]] void refuse_unit(const std::filesystem::path& file, const StatedUnit& stated,
                              const std::string& what, const char* suggestion) {
  throw InputError(
      {stated.line > 0 ? place(file, stated.line) : file.string(), what, suggestion, ""});
}

/// Of the options, for a file that states none.
double unit_of_options_mps2(const std::filesystem::path& file, const StatedUnit& stated,
                            const RecordFileOptions& options) {
  if (!options.units && !options.units_if_not_stated)
    refuse_unit(file, stated, "does not state the units of its accelerations",
                "give units as g, m/s2 or cm/s2, or a first line \"# units: g\"");
  const auto units = options.units ? *options.units : *options.units_if_not_stated;
  return unit_of(units).mps2 / options.counts_per_unit.value_or(1.0);
}

void check_agrees(const std::filesystem::path& file, const StatedUnit& stated, double mps2,
                  const RecordFileOptions& options) {
  if (options.units && std::abs(unit_of(*options.units).mps2 - mps2) > 1e-12)
    refuse_unit(file, stated,
                "the header says the units are " + in_quotes(stated.text) + ", units says " +
                    to_string(*options.units),
                "leave the units out, or correct the file");
  if (options.counts_per_unit)
    refuse_unit(file, stated, "the header says the units are " + in_quotes(stated.text),
                "leave counts_per_unit out: the file holds no counts");
}

}  // namespace

HeaderUnit header_unit(std::string_view text) {
  const std::string unit = plain_unit(text);
  if (unit.empty()) return {};
  for (const KnownUnit& known : known_units)
    if (unit == known.name) return {known.kind, known.si};
  for (const auto& [length, si] : lengths)
    for (const auto& [rest, kind] : of_length)
      if (unit == std::string(length) + rest) return {kind, si};
  return {UnitKind::unknown, 1.0};
}

double unit_of_record_mps2(const std::filesystem::path& file, const StatedUnit& stated,
                           const RecordFileOptions& options) {
  const HeaderUnit unit = header_unit(stated.text);
  switch (unit.kind) {
    case UnitKind::acceleration:
      check_agrees(file, stated, unit.si, options);
      return unit.si;
    case UnitKind::velocity:
      refuse_unit(file, stated, "units " + in_quotes(stated.text) + ": this is a velocity file",
                  "give the acceleration file (.AT2)");
    case UnitKind::displacement:
      refuse_unit(file, stated, "units " + in_quotes(stated.text) + ": this is a displacement file",
                  "give the acceleration file (.AT2)");
    case UnitKind::counts:
      if (!options.counts_per_unit || !options.units)
        refuse_unit(
            file, stated,
            "holds " + stated.text + ", and does not state how many are one unit of acceleration",
            "give units and counts_per_unit, the InstrumentSensitivity of the station's "
            "metadata; or the file in acceleration");
      break;
    case UnitKind::none:
      break;
    case UnitKind::time:
    case UnitKind::frequency:
    case UnitKind::label:
    case UnitKind::unknown:
      if (!options.units)
        refuse_unit(file, stated, "the units " + in_quotes(stated.text) + " are not known",
                    "give units as g, m/s2 or cm/s2");
  }
  return unit_of_options_mps2(file, stated, options);
}

AccelerationUnits parse_acceleration_units(const std::string& text) {
  const auto known = std::ranges::find(acceleration_units, text == "gal" ? "cm/s2" : text,
                                       &AccelerationUnit::name);
  if (known != std::end(acceleration_units)) return known->units;
  throw InputError(
      {"", "units " + in_quotes(text) + " are not known", "use g, m/s2, cm/s2 or gal", ""});
}

std::string to_string(AccelerationUnits units) { return unit_of(units).name; }

}  // namespace glissade
