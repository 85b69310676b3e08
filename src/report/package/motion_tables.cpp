// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"

namespace glissade {
namespace {

/// Of a record in tables and figures.
const Column number_column = {"number", "", "No.", ColumnKind::count};
double number_after(const Table& table) { return static_cast<double>(table.rows.size() + 1); }

/// "-" of none.
NumberCell given(double value, int decimals) { return fixed(value > 0.0 ? value : nan, decimals); }

/// "730" of a component "walters/gukasian_RSN730/RSN730_SPITAK_GUK000.AT2": the record sequence
/// number of NGA-West2; else that of the id "rsn730", else "-".
std::string rsn_of(const std::vector<ComponentFile>& files, const std::string& record) {
  for (const ComponentFile& f : files) {
    const std::string name = std::filesystem::path(f.file).filename().string();
    if (f.record != record || !name.starts_with("RSN")) continue;
    return name.substr(3, name.find_first_not_of("0123456789", 3) - 3);
  }
  if (record.starts_with("rsn") && record.find_first_not_of("0123456789", 3) == std::string::npos)
    return record.substr(3);
  return "-";
}

/// "Nos. 1, 2: processed: ...", of records that were processed in one way.
std::vector<std::string> processing_notes(const std::vector<RecordSummary>& records) {
  std::vector<std::string> notes;
  for (auto first = records.begin(); first != records.end(); ++first) {
    const auto is_same = [&](const RecordSummary& r) { return r.processing == first->processing; };
    if (first->processing.empty() || std::any_of(records.begin(), first, is_same)) continue;
    std::vector<std::ptrdiff_t> numbers;
    for (auto r = first; r != records.end(); ++r)
      if (is_same(*r)) numbers.push_back(r - records.begin() + 1);
    notes.push_back(fmt::format("Not as recorded but processed, No. {}: {}.",
                                fmt::join(numbers, ", "), first->processing));
  }
  return notes;
}

}  // namespace

Table motions_table(const std::vector<RecordSummary>& records,
                    const std::vector<ComponentFile>& files, bool of_roof) {
  Table table{"motions",
              of_roof ? "Motions of the roof" : "Ground motions",
              {number_column, text_column("id", "Record"), text_column("rsn", "RSN"),
               text_column("event", "Event"), text_column("station", "Station"),
               text_column("magnitude", "M"), text_column("distance", "R, km"),
               text_column("vs30", "V_S30, m/s")},
              {}};
  bool has_rsn = false;
  for (const RecordSummary& r : records) {
    const std::string rsn = rsn_of(files, r.id);
    has_rsn = has_rsn || rsn != "-";
    table.add({number_after(table), r.id, rsn, r.event, r.station, given(r.magnitude, 1),
               given(r.distance_km, 1), given(r.vs30_mps, 0)});
  }
  for (std::string& note : processing_notes(records)) table.notes.push_back(std::move(note));
  return has_rsn ? table : table.without("rsn");
}

Table scaled_motions_table(const CalculationPackage& package) {
  const bool of_roof = package.project.of_roof;
  const char *acceleration = of_roof ? "Peak roof acceleration, g" : "PGA, g",
             *velocity = of_roof ? "velocity" : "PGV",
             *displacement = of_roof ? "displacement" : "PGD";
  Table table{
      "scaled_motions",
      std::string(of_roof ? "Motions of the roof as in the suite"
                          : "Ground motions before scaling") +
          ", and factor to DBE",
      {number_column, text_column("id", "Record"), text_column("pga", acceleration),
       text_column("pgv", velocity + std::string(in_inches() ? ", in/s" : ", m/s")),
       text_column("pgd", displacement + std::string(in_inches() ? ", in" : ", m")),
       text_column("step", "Step, s"), text_column("length", "Length, s"),
       text_column("duration", "D5-95, s"), text_column("suite_scale", "Scale of the suite"),
       text_column("factor", "Factor to DBE")},
      {}};
  const auto of_motion = [](double metric) {
    return in_inches() ? fixed(metric / inch_m, 1) : fixed(metric, 3);
  };
  for (std::size_t i = 0; i < package.demand.records.size(); ++i) {
    const RecordSummary& r = package.demand.records[i];
    table.add({number_after(table), r.id, fixed(r.pga_g, 3), of_motion(r.pgv_mps),
               of_motion(r.pgd_m), significant(r.dt_s, 3),
               fixed(r.dt_s * static_cast<double>(r.samples - 1), 0), fixed(r.duration_s, 1),
               significant(r.suite_scale, 3),
               fixed(r.factor_at_unit_level * dbe_level(package.project), 3)});
  }
  const std::vector<RecordSummary>& records = package.demand.records;
  const bool same_scale = std::ranges::all_of(records, [&](const RecordSummary& r) {
    return r.suite_scale == records.front().suite_scale;
  });
  table.notes.push_back(
      (of_roof ? "Peaks: geometric mean of both horizontal components. D5-95: from 5 "
               : "PGA, PGV and PGD: geometric mean of both horizontal components. "
                 "D5-95: from 5 ") +
      std::string("% to 95 % of the Arias intensity of both together. The factor to DBE "
                  "contains the scale of the suite") +
      (same_scale ? fmt::format(", {:.3g} for every record,", records.front().suite_scale) : "") +
      " and is on all components.");
  return same_scale ? table.without("suite_scale") : table;
}

Table record_spectra_table(const CalculationPackage& package) {
  const SuiteSpectra& spectra = package.demand.suites.front().spectra;
  const std::vector<double>& grid_s = spectra.periods_s;
  Table table{"record_spectra",
              "Spectra of the records at the building periods, scaled to DBE: S_a, g",
              {number_column, text_column("id", "Record")},
              {}};
  table.notes = {
      fmt::format("{} of both horizontal components, 5 % damping; at all periods: Fig. 1. Spectra "
                  "are computed to {:g} s.",
                  spectra.combination(), grid_s.back())};
  for (const double period_s : package.project.building.period_s)
    table.columns.push_back(
        text_column(fmt::format("sa_{:g}_s", period_s), fmt::format("{:.3g}\u00a0s", period_s)));
  const auto add = [&](const Cell& number, const std::string& name,
                       const std::vector<double>& sa_g) {
    std::vector<Cell> row{number, name};
    for (const double period_s : package.project.building.period_s) {
      if (period_s > grid_s.back()) {
        row.emplace_back(std::string("-"));
        continue;
      }
      const auto right =
          std::max<std::ptrdiff_t>(1, std::ranges::lower_bound(grid_s, period_s) - grid_s.begin());
      const double part = (period_s - grid_s[right - 1]) / (grid_s[right] - grid_s[right - 1]);
      row.emplace_back(fixed(std::lerp(sa_g[right - 1], sa_g[right], part) *
                                 package.design.site.sds_g / spectra.reference_level,
                             3));
    }
    table.add(row);
  };
  for (std::size_t i = 0; i < package.demand.records.size(); ++i)
    add(number_after(table), package.demand.records[i].id, spectra.records_g[i]);
  add(std::string(), "average", spectra.average_g);
  if (!spectra.target_g.empty()) add(std::string(), "design spectrum", spectra.target_g);
  return table;
}

Table files_table(const CalculationPackage& package) {
  Table table{"files",
              package.project.of_roof ? "Files of the motions" : "Files of the ground motions",
              {text_column("record", "Record"), text_column("component", "Component"),
               text_column("file", "File"), text_column("sha256", "SHA-256")},
              {}};
  for (const ComponentFile& f : package.files) table.add({f.record, f.component, f.file, f.sha256});
  return table;
}

}  // namespace glissade
