// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/tables.hpp"

#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {

Table records_table(const Results& results) {
  Table table{"records",
              "Ground motions of suite " + results.suite_name +
                  ". pga and pgv are geometric means of the horizontals as recorded; factor at "
                  "unit level is what "
                  "the record is multiplied by at intensity 1 g (0: depends on the sample); 0 in "
                  "magnitude, distance "
                  "and vs30 means not told. " +
                  in_plan,
              {text_column("id", "Record"),
               text_column("event", "Event"),
               text_column("station", "Station"),
               {"magnitude", "", "M", ColumnKind::number},
               {"distance", "km", "Distance, km", ColumnKind::number},
               {"vs30", "mps", "Vs30, m/s", ColumnKind::number},
               {"suite_scale", "", "Suite factor", ColumnKind::number},
               {"factor_at_unit_level", "per_g", "Factor at 1 g", ColumnKind::number},
               {"pga", "g", "PGA, g", ColumnKind::number},
               {"pgv", "mps", "PGV, m/s", ColumnKind::number},
               {"dt", "s", "Step, s", ColumnKind::number},
               {"samples", "", "Samples", ColumnKind::count},
               text_column("has_second", "2nd horizontal"),
               text_column("has_vertical", "Vertical")},
              {}};
  const auto yes_no = [](bool value) -> std::string { return value ? "yes" : "no"; };
  for (const RecordSummary& r : results.records) {
    table.add({r.id, r.event, r.station, r.magnitude, r.distance_km, r.vs30_mps, r.suite_scale,
               r.factor_at_unit_level, r.pga_g, r.pgv_mps, r.dt_s, static_cast<double>(r.samples),
               yes_no(r.has_second), yes_no(r.has_vertical)});
  }
  return table;
}

Table spectra_table(const Results& results) {
  const SuiteSpectra& spectra = results.spectra;
  Table table{"spectra",
              "5 % damped SRSS spectra of the horizontals, " +
                  (spectra.reference_level > 0.0 ? "scaled to " + results.intensity_label + " = " +
                                                       format_number(spectra.reference_level)
                                                 : std::string("by the suite's own factors")) +
                  ". " + in_plan,
              {{"period", "s", "Period, s", ColumnKind::number},
               {"average_srss", "g", "Average, g", ColumnKind::number}},
              {}};
  if (!spectra.target_g.empty())
    table.columns.push_back({"target", "g", "Target, g", ColumnKind::number});
  for (std::size_t r = 0; r < spectra.srss_g.size(); ++r) {
    const std::string id = r < results.records.size() ? results.records[r].id : std::to_string(r);
    table.columns.push_back({"srss_" + id, "g", id + ", g", ColumnKind::number});
  }
  for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
    std::vector<Cell> row = {spectra.periods_s[p], spectra.average_srss_g.at(p)};
    if (!spectra.target_g.empty()) row.emplace_back(spectra.target_g.at(p));
    for (const std::vector<double>& record : spectra.srss_g) row.emplace_back(record.at(p));
    table.add(std::move(row));
  }
  return table;
}

Table samples_table(const Results& results) {
  Table table{"samples",
              std::string("Sampled parameters. Friction is that of the sampled run; component 0 or "
                          "1 is the horizontal "
                          "that acts along the slope (of two axes: along the building's first), "
                          "with the given sign. ") +
                  in_plan,
              {{"sample", "", "Sample", ColumnKind::count},
               {"friction", "", "Friction", ColumnKind::number},
               {"slope", "deg", "Slope, deg", ColumnKind::number},
               {"period", "s", "Period, s", ColumnKind::number},
               {"damping_ratio", "", "Damping ratio", ColumnKind::number},
               {"component", "", "Component", ColumnKind::count},
               {"sign", "", "Sign", ColumnKind::count},
               {"mass_ratio", "", "Mass ratio", ColumnKind::number},
               {"friction_across", "", "Friction across", ColumnKind::number},
               {"azimuth", "deg", "Azimuth, deg", ColumnKind::number},
               {"second_sign", "", "Sign of the other component", ColumnKind::count}},
              {}};
  for (std::size_t j = 0; j < results.samples.size(); ++j) {
    const SamplePoint& s = results.samples[j];
    table.add({static_cast<double>(j), s.friction, s.slope_deg, s.period_s, s.damping,
               static_cast<double>(s.component), static_cast<double>(s.sign), s.mass_ratio,
               s.friction_across, s.azimuth_deg, static_cast<double>(s.second_sign)});
  }
  if (slides_on_two_axes(results)) return table;
  return table.without("friction_across").without("azimuth").without("second_sign");
}

}  // namespace glissade
