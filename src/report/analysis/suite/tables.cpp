// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/motion/peak_names.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {

namespace {

/// "suite a", "the suites a, b".
std::string suites_text(const Results& results) {
  std::string names;
  for (const SuiteSummary& suite : results.suites)
    names += (names.empty() ? "" : ", ") + suite.name;
  return (results.suites.size() > 1 ? "the suites " : "suite ") + names;
}

}  // namespace

Table records_table(const Results& results) {
  const bool of_roof = results.suites.front().of_roof;
  const PeakNames peak = peak_names(of_roof);
  Table table{
      "records",
      fmt::format("{} motions of {}. {}, {} and {} are geometric means of the horizontals as "
                  "recorded, D5-95 the time from 5 to 95 % of the integral of their a^2; factor at "
                  "unit level is what the record is multiplied by at level 1 (0: depends on the "
                  "roof); 0 in magnitude, distance and vs30 means not given.",
                  of_roof ? "Roof" : "Ground", suites_text(results), capitalised(peak.acceleration),
                  peak.velocity, peak.displacement),
      {{"number", "", "No.", ColumnKind::count},
       text_column("suite", "Suite"),
       text_column("id", "Record"),
       text_column("event", "Event"),
       text_column("station", "Station"),
       {"magnitude", "", "M"},
       {"distance", "km", "R, km"},
       {"vs30", "mps", "Vs30, m/s"},
       {"suite_scale", "", "Suite factor"},
       {"factor_at_unit_level", "", "Factor at level 1"},
       {"pga", "g", capitalised(peak.acceleration) + std::string(", g")},
       {"pgv", "mps", capitalised(peak.velocity) + ", m/s", ColumnKind::metric},
       {"pgd", "m", capitalised(peak.displacement) + ", m", ColumnKind::metric},
       {"duration", "s", "D5-95, s"},
       {"dt", "s", "Step, s"},
       {"samples", "", "Samples", ColumnKind::count},
       text_column("has_second", "2nd axis"),
       text_column("has_vertical", "Vertical"),
       text_column("processing", "Processing")},
      {}};
  table.is_of_inputs = true;
  const auto yes_no = [](bool value) -> std::string { return value ? "yes" : "no"; };
  for (const RecordSummary& r : results.records) {
    table.add({static_cast<double>(table.rows.size() + 1), results.suites.at(r.suite).name, r.id,
               r.event, r.station, r.magnitude, r.distance_km, r.vs30_mps, r.suite_scale,
               r.factor_at_unit_level, r.pga_g, r.pgv_mps, r.pgd_m, r.duration_s, r.dt_s,
               static_cast<double>(r.samples), yes_no(r.has_second), yes_no(r.has_vertical),
               r.processing});
  }
  if (results.suites.size() == 1) table = table.without("suite");
  if (std::ranges::all_of(results.records,
                          [](const RecordSummary& r) { return r.processing.empty(); }))
    table = table.without("processing");
  return table;
}

Table spectra_table(const Results& results) {
  const SuiteSpectra& spectra = results.suites.front().spectra;
  const std::string combination = is_of_16_2(spectra.rule) ? "rotd100" : "srss";
  Table table{"spectra",
              std::string("5 % damped ") + spectra.combination() +
                  " spectra of the horizontals of suite " + results.suites.front().name + ", " +
                  (spectra.reference_level > 0.0 ? "scaled to " + results.intensity_label + " = " +
                                                       level_number(spectra.reference_level)
                                                 : std::string("by the suite's own factors")) +
                  ".",
              {{"period", "s", "Period, s"}, {"average_" + combination, "g", "Average, g"}},
              {}};
  table.is_of_inputs = true;
  table.suite = 0;
  if (!spectra.target_g.empty()) table.columns.push_back({"target", "g", "Target, g"});
  for (std::size_t r = 0; r < spectra.records_g.size(); ++r) {
    const std::string id = r < results.records.size() ? results.records[r].id : std::to_string(r);
    table.columns.push_back({combination + "_" + id, "g", id + ", g"});
  }
  for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
    std::vector<Cell> row = {spectra.periods_s[p], spectra.average_g.at(p)};
    if (!spectra.target_g.empty()) row.emplace_back(spectra.target_g.at(p));
    for (const std::vector<double>& record : spectra.records_g) row.emplace_back(record.at(p));
    table.add(std::move(row));
  }
  return table;
}

Table samples_table(const Results& results) {
  // A row takes ten times the memory of the sample's histories.
  constexpr std::size_t most = 4096;
  const std::size_t samples = results.cases.samples;
  Table table{"samples",
              samples <= most ? "The samples of the first combination."
                              : fmt::format("The first {} of {} samples of the first combination; "
                                            "all are in results.h5, group cases.",
                                            most, samples),
              {{"sample", "", "Sample", ColumnKind::count}},
              {}};
  table.is_of_inputs = true;
  std::vector<const Parameter*> shown;
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two && !slides_on_two_axes(results)) continue;
    shown.push_back(&p);
    const std::string unit = p.unit == std::string("-") ? "" : p.unit;
    table.columns.push_back({std::string(p.table) + "_" + p.key, "",
                             std::string(p.key) + (unit.empty() ? "" : ", " + unit),
                             ColumnKind::number});
  }
  table.columns.push_back({"ground_azimuth_deg", "", "Ground azimuth, deg"});
  table.columns.push_back({"across_sign", "", "Sign across", ColumnKind::count});
  for (std::size_t j = 0; j < std::min(samples, most); ++j) {
    const Case& c = results.cases.cases[results.cases.index(0, j, 0)];
    std::vector<Cell> row{static_cast<double>(j)};
    for (const Parameter* p : shown) row.emplace_back(value_of(*p, c));
    row.emplace_back(c.orientation.ground_azimuth_deg);
    row.emplace_back(static_cast<double>(c.orientation.across_sign));
    table.add(std::move(row));
  }
  return table;
}

}  // namespace glissade
