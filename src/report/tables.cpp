// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "chart/report.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr auto in_plan = "Displacements are in plan (horizontal).";

Column text_column(std::string stem, std::string heading) {
  return {std::move(stem), "", std::move(heading), ColumnKind::text, false};
}

/// The title's opening: what the levels are.
std::string measured_by(const Results& results) {
  return " Intensity measure: " + results.intensity_label + ". ";
}

Estimate median_of(const FitSummary& fit) {
  const char* sign = fit.status == FitStatus::lower_bound   ? "> "
                     : fit.status == FitStatus::upper_bound ? "< "
                                                            : "";
  return {fit.curve.median, fit.median_interval, sign};
}

Estimate log_std_of(const FitSummary& fit) { return {fit.curve.log_std, fit.log_std_interval, ""}; }

Estimate p50_of(const FitSummary& fit) {
  return {fit.curve.intensity_at(0.5), fit.p50_interval, median_of(fit).sign};
}

Estimate floor_of(const FitSummary& fit) { return {fit.curve.floor, fit.floor_interval, ""}; }

/// Share of records of which any sample falls below the threshold again at a higher level.
double record_recross_share(const ThresholdFragility& fragility) {
  const std::vector<double>& recross = fragility.record_recross;
  return recross.empty() ? nan
                         : std::accumulate(recross.begin(), recross.end(), 0.0) /
                               static_cast<double>(recross.size());
}

void add_fragility_row(Table& table, const RunResults& run, const ThresholdFragility& fragility,
                       const std::string& method, const FitSummary& fit) {
  table.add({run.label, fragility.threshold_m, method, median_of(fit), log_std_of(fit),
             to_string(fit.status), fragility.recross_share, record_recross_share(fragility),
             fragility.censored_share, floor_of(fit), p50_of(fit), fit.interval_method, fit.note});
}

/// How the median came about, for people.
std::string fit_label(const FitSummary& fit, double highest_level) {
  const bool beyond = fit.converged() && fit.curve.median > highest_level;
  return to_string(fit.status) + (beyond ? ", extrapolated beyond the levels" : "");
}

double histories_per_level(const Results& results, const RunResults& run) {
  return static_cast<double>(results.records.size() * run.cases);
}

const SlipStatistics* slip_at(const RunResults& run, double level) {
  for (const SlipStatistics& slip : run.slip) {
    if (slip.level == level) return &slip;
  }
  return nullptr;
}

}  // namespace

const FitSummary& preferred_fit(const ThresholdFragility& fragility) {
  return !fragility.capacities.converged() && fragility.stripes.converged() ? fragility.stripes
                                                                            : fragility.capacities;
}

Table fragility_table(const Results& results) {
  Table table{
      "fragility",
      "Fragilities by clearance threshold: P = p0 + (1 - p0) Phi(ln(x / median) / log_std), "
      "p0 the share that slides freely, without shaking; half of all exceed at p50." +
          measured_by(results) + "log_std and shares are dimensionless. " + in_plan,
      {text_column("run", "Friction run"),
       {"threshold", "m", "Clearance, m (in)", ColumnKind::length},
       text_column("method", "Fitted on"),
       {"median", "g", "Median, g [95 %]", ColumnKind::number, true},
       {"log_std", "", "Log std [95 %]", ColumnKind::number, true},
       text_column("status", "Fit"),
       {"recross_share", "", "Histories that recross", ColumnKind::share},
       {"record_recross_share", "", "Records that recross", ColumnKind::share},
       {"censored_share", "", "Never reached", ColumnKind::share},
       {"free_sliding_share", "", "Slides freely, p0 [95 %]", ColumnKind::share, true},
       {"p50", "g", "p50, g [95 %]", ColumnKind::number, true},
       text_column("interval_method", "Intervals by"),
       text_column("note", "Note")},
      {}};
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      add_fragility_row(table, run, fragility, "stripes", fragility.stripes);
      add_fragility_row(table, run, fragility, "capacities", fragility.capacities);
    }
  }
  return table;
}

Table fragility_summary_table(const Results& results) {
  Table table{"fragility_summary",
              "Fragility by clearance: intensity with a 50 % chance of exceedance." +
                  measured_by(results) + in_plan,
              {text_column("run", "Friction run"),
               {"threshold", "m", "Clearance, m (in)", ColumnKind::length},
               {"median", "g", "Median, g [95 %]", ColumnKind::number, true},
               {"log_std", "", "Log std [95 %]", ColumnKind::number, true},
               {"free_sliding_share", "", "Slides freely, p0", ColumnKind::share},
               {"p50", "g", "50 % of all at, g [95 %]", ColumnKind::number, true},
               {"censored_share", "", "Never reached", ColumnKind::share},
               text_column("method", "Fitted on"),
               text_column("status", "Fit")},
              {}};
  double least_floor = 1.0, largest_floor = 0.0;
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      const FitSummary& fit = preferred_fit(fragility);
      least_floor = std::min(least_floor, fit.curve.floor);
      largest_floor = std::max(largest_floor, fit.curve.floor);
      table.add({run.label, fragility.threshold_m, median_of(fit), log_std_of(fit), fit.curve.floor,
                 p50_of(fit), fragility.censored_share,
                 &fit == &fragility.stripes ? "stripes" : "capacities",
                 fit_label(fit, results.levels.back())});
    }
  }
  if (largest_floor == 0.0) return table.without("free_sliding_share").without("p50");
  table.notes.push_back(
      least_floor == 1.0
          ? "Every history slides freely: it exceeds at any intensity, without shaking."
          : "Some histories slide freely: they exceed at any intensity. Median and log std are "
            "those of "
            "the others: P = p0 + (1 - p0) Phi(ln(x / median) / log std).");
  return table;
}

Table slip_table(const Results& results) {
  Table table{"slip",
              "Peak slip over records and samples, by level." + measured_by(results) + in_plan,
              {text_column("run", "Friction run"),
               {"level", "g", "Level, g", ColumnKind::number},
               {"median_slip", "m", "Median, m (in) [95 %, m]", ColumnKind::length, true},
               {"p84_slip", "m", "84th percentile, m (in) [95 %, m]", ColumnKind::length, true},
               {"p95_slip", "m", "95th percentile, m (in)", ColumnKind::length},
               {"mean_slip", "m", "Mean, m (in) [95 %, m]", ColumnKind::length, true},
               {"mean_vector", "m", "Mean longest vector, m (in)", ColumnKind::length},
               {"uplift_share", "", "Uplift", ColumnKind::share},
               {"tip_share", "", "Begins to tip", ColumnKind::share}},
              {}};
  bool tipping = false, two_axes = false;  // asked for
  for (const RunResults& run : results.runs) {
    for (const SlipStatistics& slip : run.slip) {
      tipping = tipping || !std::isnan(slip.tip_share);
      two_axes = two_axes || !std::isnan(slip.mean_vector_m);
      table.add({run.label, slip.level, Estimate{slip.median_m, slip.median_interval},
                 Estimate{slip.p84_m, slip.p84_interval}, slip.p95_m,
                 Estimate{slip.mean_m, slip.mean_interval}, slip.mean_vector_m, slip.uplift_share,
                 slip.tip_share});
    }
  }
  if (!tipping) table = table.without("tip_share");
  return two_axes ? table : table.without("mean_vector");
}

Table standards_table(const Results& results) {
  Table table{"standards",
              std::string("Displacements prescribed by standards beside the slip that came out. ") +
                  in_plan,
              {text_column("run", "Friction run"),
               text_column("standard", "Standard"),
               {"sds", "g", "S_DS, g", ColumnKind::number},
               {"prescribed", "m", "Prescribed, m (in)", ColumnKind::length},
               {"median_slip", "m", "Median, m (in)", ColumnKind::length},
               {"p84_slip", "m", "84th, m (in)", ColumnKind::length},
               {"p95_slip", "m", "95th, m (in)", ColumnKind::length},
               {"mean_slip", "m", "Mean, m (in)", ColumnKind::length},
               {"exceedance_share", "", "Slip > prescribed [95 %]", ColumnKind::share, true},
               text_column("provenance", "Provision"),
               text_column("basis", "Basis")},
              {}};
  for (const RunResults& run : results.runs) {
    for (const StandardComparison& comparison : run.standards) {
      const SlipStatistics* found = slip_at(run, comparison.sds_g);
      const SlipStatistics slip =
          found ? *found : SlipStatistics{0.0, nan, nan, nan, nan, {}, {}, {}, nan};
      table.add({run.label, standard_name(comparison.standard), comparison.sds_g,
                 comparison.prescribed.value_m, slip.median_m, slip.p84_m, slip.p95_m, slip.mean_m,
                 Estimate{comparison.exceedance_probability, comparison.exceedance_interval},
                 provenance_label(comparison.prescribed.provenance), comparison.prescribed.basis});
    }
  }
  return table;
}

Table stripes_table(const Results& results) {
  Table table{
      "stripes",
      "Histories whose slip exceeds the threshold, by level: what the fit on stripes rests on." +
          measured_by(results) + in_plan,
      {text_column("run", "Friction run"),
       {"threshold", "m", "Clearance, m (in)", ColumnKind::length},
       {"level", "g", "Level, g", ColumnKind::number},
       {"histories", "", "Histories", ColumnKind::count},
       {"exceedances", "", "Exceedances", ColumnKind::count},
       {"share", "", "Share [95 %]", ColumnKind::share, true}},
      {}};
  for (const RunResults& run : results.runs) {
    const double histories = histories_per_level(results, run);
    for (const ThresholdFragility& fragility : run.fragilities) {
      for (std::size_t l = 0; l < fragility.probability.size(); ++l) {
        const Interval interval = l < fragility.probability_interval.size()
                                      ? fragility.probability_interval[l]
                                      : Interval{};
        table.add({run.label, fragility.threshold_m, results.levels.at(l), histories,
                   std::round(fragility.probability[l] * histories),
                   Estimate{fragility.probability[l], interval}});
      }
    }
  }
  return table;
}

std::string suite_names(const Results& results) {
  std::string names;
  for (const SuiteSummary& suite : results.suites) names += (names.empty() ? "" : ", ") + suite.name;
  return names;
}

Table records_table(const Results& results) {
  Table table{"records",
              "Ground motions of suite " + suite_names(results) +
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
  const SuiteSpectra& spectra = results.suites.front().spectra;
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
  Table table{"samples", std::string("The samples of the first combination. ") + in_plan,
              {{"sample", "", "Sample", ColumnKind::count}}, {}};
  std::vector<const Parameter*> shown;
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two && !slides_on_two_axes(results)) continue;
    shown.push_back(&p);
    const std::string unit = p.unit == std::string("-") ? "" : p.unit;
    table.columns.push_back({std::string(p.table) + "_" + p.key, "",
                             std::string(p.key) + (unit.empty() ? "" : ", " + unit),
                             ColumnKind::number});
  }
  table.columns.push_back({"ground_azimuth_deg", "", "Ground azimuth, deg", ColumnKind::number});
  table.columns.push_back({"across_sign", "", "Sign across", ColumnKind::count});
  for (std::size_t j = 0; j < results.cases.samples; ++j) {
    const Case& c = results.cases.cases[results.cases.index(0, j, 0)];
    std::vector<Cell> row{static_cast<double>(j)};
    for (const Parameter* p : shown) row.emplace_back(value_of(*p, c));
    row.emplace_back(c.orientation.ground_azimuth_deg);
    row.emplace_back(static_cast<double>(c.orientation.across_sign));
    table.add(std::move(row));
  }
  return table;
}

std::vector<Table> csv_tables(const Results& results) {
  std::vector<Table> tables = {records_table(results), spectra_table(results)};
  const auto add = [&](std::vector<Table> more) {
    for (Table& table : more) {
      const auto same = [&](const Table& t) { return t.name == table.name; };
      if (std::ranges::none_of(tables, same)) tables.push_back(std::move(table));
    }
  };
  if (results.chart) add(chart_csv_tables(results));
  if (results.clearance) add(clearance_file_tables(clearance_results(results)));
  if (results.runs.empty()) return tables;
  add({fragility_table(results), slip_table(results), stripes_table(results),
       samples_table(results)});
  Table standards = standards_table(results);
  if (!standards.rows.empty()) add({std::move(standards)});
  Table impact = impact_table(results);
  if (!impact.rows.empty()) tables.push_back(std::move(impact));
  return tables;
}

}  // namespace glissade
