// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/record_units.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
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

enum class HeaderUnits { none, g, mps2, cmps2, velocity, displacement, unknown };

HeaderUnits header_units(const std::string& text) {
  if (text.empty()) return HeaderUnits::none;
  std::string unit = text;  // cm/sec**2, cm/sec^2, cm/sec/sec -> cm/s2
  for (const auto& [from, to] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{
           {"sec", "s"}, {"**", ""}, {"^", ""}, {"/s/s", "/s2"}}) {
    for (std::size_t at; (at = unit.find(from)) != std::string::npos;)
      unit.replace(at, from.size(), to);
  }
  constexpr std::array<std::pair<std::string_view, HeaderUnits>, 13> known = {
      {{"g", HeaderUnits::g},
       {"g's", HeaderUnits::g},
       {"gs", HeaderUnits::g},
       {"m/s2", HeaderUnits::mps2},
       {"cm/s2", HeaderUnits::cmps2},
       {"gal", HeaderUnits::cmps2},
       {"gals", HeaderUnits::cmps2},
       {"cm/s", HeaderUnits::velocity},
       {"m/s", HeaderUnits::velocity},
       {"in/s", HeaderUnits::velocity},
       {"cm", HeaderUnits::displacement},
       {"m", HeaderUnits::displacement},
       {"in", HeaderUnits::displacement}}};
  for (const auto& [name, units] : known) {
    if (unit == name) return units;
  }
  return HeaderUnits::unknown;
}

}  // namespace

double mps2_per_unit(AccelerationUnits units) { return unit_of(units).mps2; }

AccelerationUnits units_of(const std::filesystem::path& file, const At2Header& header,
                           const RecordFileOptions& options) {
  const auto refuse = [&](const std::string& what, const char* suggestion) {
    throw InputError({header.units_line > 0 ? place(file, header.units_line) : file.string(), what,
                      suggestion, ""});
  };
  const auto agreed = [&](AccelerationUnits stated) {
    if (options.units && *options.units != stated) {
      refuse("the header says the units are " + in_quotes(header.units) + ", units says " +
                 to_string(*options.units),
             "leave the units out, or correct the file");
    }
    return stated;
  };
  switch (header_units(header.units)) {
    case HeaderUnits::none:
      break;
    case HeaderUnits::g:
      return agreed(AccelerationUnits::g);
    case HeaderUnits::mps2:
      return agreed(AccelerationUnits::mps2);
    case HeaderUnits::cmps2:
      return agreed(AccelerationUnits::cmps2);
    case HeaderUnits::velocity:
      refuse("units " + in_quotes(header.units) + ": this is a velocity file",
             "give the acceleration file (.AT2)");
      break;
    case HeaderUnits::displacement:
      refuse("units " + in_quotes(header.units) + ": this is a displacement file",
             "give the acceleration file (.AT2)");
      break;
    case HeaderUnits::unknown:
      if (!options.units)
        refuse("the units " + in_quotes(header.units) + " are not known",
               "give units as g, m/s2 or cm/s2");
      break;
  }
  if (!options.units && !options.units_if_not_stated) {
    refuse("does not state the units of its accelerations",
           "give units as g, m/s2 or cm/s2, or a first line \"# units: g\"");
  }
  return options.units ? *options.units : *options.units_if_not_stated;
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
