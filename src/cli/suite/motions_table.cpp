// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite/motions_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/peak_names.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/table.hpp"

namespace glissade::cli {
namespace {

struct ShownComponent {
  const char *stem, *name;
  const Samples& (*of)(const Motion&);
};
constexpr std::array components{
    ShownComponent{"first", "first",
                   [](const Motion& m) -> const Samples& { return m.horizontal_mps2[0]; }},
    ShownComponent{"second", "second",
                   [](const Motion& m) -> const Samples& { return m.horizontal_mps2[1]; }},
    ShownComponent{"vertical", "vertical",
                   [](const Motion& m) -> const Samples& { return m.vertical_mps2; }}};

Column number(std::string stem, std::string unit, std::string heading, int decimals = -1) {
  return {std::move(stem), std::move(unit), std::move(heading), ColumnKind::number, "",
          false,           decimals};
}

std::vector<Column> columns(const PeakNames& peak) {
  const auto heading = [](const std::string& of, const char* name, const char* unit) {
    return capitalised(of + name) + ", " + unit;
  };
  std::vector<Column> all{text_column("id", "Record"),
                          number("pga", "g", heading("", peak.acceleration, "g")),
                          number("pgv", "mps", heading("", peak.velocity, "m/s")),
                          number("pgd", "m", heading("", peak.displacement, "m")),
                          number("duration", "s", "D5-95, s"),
                          number("dt", "s", "Step, s", 4),
                          {"samples", "", "Samples", ColumnKind::count},
                          number("scale", "", "Scale")};
  const auto detail = [&](Column column) {
    column.detail = true;
    all.push_back(std::move(column));
  };
  detail(text_column("event", "Event"));
  detail(text_column("station", "Station"));
  detail(number("magnitude", "", "M", 2));
  detail(number("distance", "km", "R, km", 1));
  detail(number("vs30", "mps", "Vs30, m/s", 0));
  for (const ShownComponent& c : components) {
    const std::string stem = std::string("_") + c.stem, name = std::string(c.name) + " ";
    detail(number("pga" + stem, "g", name + peak.acceleration + ", g"));
    detail(number("pgv" + stem, "mps", name + peak.velocity + ", m/s"));
    detail(number("pgd" + stem, "m", name + peak.displacement + ", m"));
    detail(number("duration" + stem, "s", name + "D5-95, s"));
  }
  return all;
}

}  // namespace

Table motions_table(const Suite& suite) {
  const bool is_processed =
      std::ranges::any_of(suite.motions, [](const Motion& m) { return !m.processing.empty(); });
  const PeakNames peak = peak_names(suite.of_roof);
  Table table{"motions",
              fmt::format("{}, without the suite's scale. {}, {} and {} are geometric means of the "
                          "horizontals, D5-95 is of both together.",
                          is_processed ? "Processed, as the notes say" : "As recorded",
                          capitalised(peak.acceleration), peak.velocity, peak.displacement),
              columns(peak),
              {}};
  constexpr auto mean = HorizontalCombination::geometric_mean;
  const auto given = [](double value) { return value > 0.0 ? value : std::nan(""); };
  for (const Motion& m : suite.motions) {
    const auto& [first, second] = m.horizontal_mps2;
    std::vector<Cell> row{m.id,
                          horizontal_pga_mps2(m, mean) / standard_gravity_mps2,
                          horizontal_pgv_mps(m, mean),
                          horizontal_pgd_m(m, mean),
                          significant_duration_s(m.dt_s, first, second),
                          m.dt_s,
                          static_cast<double>(first.size()),
                          m.scale,
                          m.event,
                          m.station,
                          given(m.magnitude),
                          given(m.distance_km),
                          given(m.vs30_mps)};
    for (const ShownComponent& c : components) {
      const Samples& a = c.of(m);
      const auto value = [&](double x) { row.emplace_back(a.empty() ? std::nan("") : x); };
      value(peak_ground_acceleration_mps2(a) / standard_gravity_mps2);
      value(peak_ground_velocity_mps(m.dt_s, a));
      value(peak_ground_displacement_m(m.dt_s, a));
      value(significant_duration_s(m.dt_s, a));
    }
    table.add(std::move(row));
  }
  return table;
}

}  // namespace glissade::cli
