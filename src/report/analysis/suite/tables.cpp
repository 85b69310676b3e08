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
  using R = RecordSummary;
  const bool of_roof = results.suites.front().of_roof;
  const PeakNames peak = peak_names(of_roof);
  TableOf<R> t(
      "records",
      fmt::format("{} motions of {}. {}, {} and {} are geometric means of the horizontals as "
                  "recorded, D5-95 the time from 5 to 95 % of the integral of their a^2; factor at "
                  "unit level is what the record is multiplied by at level 1 (0: depends on the "
                  "roof); 0 in magnitude, distance and vs30 means not given.",
                  of_roof ? "Roof" : "Ground", suites_text(results), capitalised(peak.acceleration),
                  peak.velocity, peak.displacement));
  t.count("number", "No.", "", [&](const R& r) { return &r - results.records.data() + 1; });
  t.text("suite", "Suite", "", [&](const R& r) { return results.suites.at(r.suite).name; });
  t.text("id", "Record", "", &R::id);
  t.text("event", "Event", "", &R::event);
  t.text("station", "Station", "", &R::station);
  t.number("magnitude", "M", "", &R::magnitude);
  t.number("distance", "R", "", &R::distance_km, "km");
  t.number("vs30", "Vs30", "", &R::vs30_mps, "mps");
  t.number("suite_scale", "Suite factor", "", &R::suite_scale);
  t.number("factor_at_unit_level", "Factor at level 1", "", &R::factor_at_unit_level);
  t.number("pga", capitalised(peak.acceleration), "", &R::pga_g, "g");
  t.put({"pgv", "mps", capitalised(peak.velocity) + ", m/s", ColumnKind::metric}, &R::pgv_mps);
  t.put({"pgd", "m", capitalised(peak.displacement) + ", m", ColumnKind::metric}, &R::pgd_m);
  t.number("duration", "D5-95", "", &R::duration_s, "s");
  t.number("dt", "Step", "", &R::dt_s, "s");
  t.count("samples", "Samples", "", &R::samples);
  t.text("has_second", "2nd axis", "", &R::has_second);
  t.text("has_vertical", "Vertical", "", &R::has_vertical);
  t.text("processing", "Processing", "", &R::processing);
  t.add_each(results.records);
  Table table = t;
  table.is_of_inputs = true;
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
  TableOf<std::size_t, Case> t(
      "samples", samples <= most
                     ? "The samples of the first combination."
                     : fmt::format("The first {} of {} samples of the first combination; "
                                   "all are in results.h5, group cases.",
                                   most, samples));
  t.is_of_inputs = true;
  t.count("sample", "Sample", "", [](std::size_t sample) { return sample; });
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two && !slides_on_two_axes(results)) continue;
    const std::string unit = p.unit == std::string("-") ? "" : std::string(", ") + p.unit;
    t.number(std::string(p.table) + "_" + p.key, std::string(p.key) + unit, p.description() + unit,
             [&](const Case& c) { return value_of(p, c, results.building); });
  }
  t.number("ground_azimuth_deg", "Ground azimuth, deg", "",
           [](const Case& c) { return c.orientation.ground_azimuth_deg; });
  t.count("across_sign", "Sign across", "",
          [](const Case& c) { return c.orientation.across_sign; });
  for (std::size_t j = 0; j < std::min(samples, most); ++j)
    t.add(j, results.cases.cases[results.cases.index(0, j, 0)]);
  return t;
}

}  // namespace glissade
