// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/hazard/hazard.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string by_curve(const Results& results) {
  return " Hazard curve: " + curve_name(*results.hazard) + ", intensity measure " +
         results.intensity_label + ". ";
}

Estimate period_of(const Estimate& rate) {
  return {1.0 / rate.value, {1.0 / rate.interval.high, 1.0 / rate.interval.low}};
}

const Column rate_column = {"annual_rate",
                            "per_year",
                            "Annual rate [95 %]",
                            ColumnKind::rate,
                            "annual rate of exceedance; inf: slides freely",
                            true},
             in_50_years_column = {"probability_50_years", "", "In 50 years", ColumnKind::share,
                                   "probability of one exceedance or more in 50 years"},
             displacement_column = {
                 "displacement", "m", "Displacement, m (in)", ColumnKind::length,
                 "displacement in plan; inf: beyond the levels, nan: below them"};
const Column below_column = detail(
                 {"below_share", "", "Below levels", ColumnKind::share,
                  "share of histories that exceed it at the lowest level; above 0: a lower bound"}),
             moving_column =
                 detail({"moving_share", "", "Moving", ColumnKind::share,
                         "share of histories that slide at the intensity below which none counts; "
                         "above 0: a lower bound"});

/// with_listed, and what the sign of a lower bound says where there is one.
Table with_bounds(const Results& results, Table table) {
  const auto slides = [](const HazardRun& run) {
    return run.moving_share > 0.0 || run.curve.front().below_share > 0.0;
  };
  if (std::ranges::any_of(results.hazard->runs, slides))
    table.notes.push_back(
        "> is a lower bound, without an interval: at the lowest level some histories slide farther "
        "already (below_share; over a life: at all, moving_share), and what weaker shaking adds is "
        "not known. Begin the levels lower.");
  return with_listed(results, table);
}

/// A lower bound where histories slide below the levels.
NumberCell at_least(const Estimate& estimate, double below_share) {
  return {estimate, below_share > 0.0 ? "> " : ""};
}

NumberCell target_of(const HazardRun& run, const TargetDisplacement& row) {
  const double lowest = run.curve.front().displacement_m;
  if (row.displacement_m.value == lowest) return {row.displacement_m, "< "};
  return at_least(row.displacement_m, row.below_share);
}

}  // namespace

std::string quantity_name(LifeQuantity quantity) {
  switch (quantity) {
    case LifeQuantity::single:
      return "largest peak of one earthquake";
    case LifeQuantity::accumulated:
      return "accumulated at the end";
    case LifeQuantity::farthest:
      return "largest distance from the initial position";
  }
  return "";
}

const char* sign_of(const ThresholdRate& row) { return row.is_mostly_assumed() ? "< " : ""; }

std::string curve_name(const HazardResults& hazard) {
  return std::filesystem::path(hazard.source).filename().string();
}

std::string life_text(const HazardResults& hazard) {
  return fmt::format("{:g} years", hazard.design_life_years);
}

std::string rate_text(double annual_rate) {
  if (std::abs(annual_rate / rate_of(0.01, 50.0) - 1.0) < 1e-3) return "1 % in 50 years";
  return fmt::format("1/{:.4g} a year", 1.0 / annual_rate);
}

Table hazard_table(const Results& results, std::optional<double> threshold_m) {
  const HazardResults& hazard = *results.hazard;
  Table table{"hazard",
              "How often each clearance is exceeded." + by_curve(results) + in_plan(results),
              {run_column,
               threshold_column,
               rate_column,
               {"return_period", "years", "Return period, years [95 %]", ColumnKind::number,
                "1 over the annual rate", true},
               {"life_probability", "", "In " + life_text(hazard) + " [95 %]", ColumnKind::share,
                "probability of one exceedance or more in the design life", true},
               detail(in_50_years_column),
               {"beyond_share", "", "Beyond levels", ColumnKind::share,
                "part of the rate from histories that do not reach it at the highest level"},
               intensity_column(results, "half_intensity", "Half of it above",
                                "half of the rate is of stronger shaking: median of its "
                                "deaggregation; inf: above the levels; nan: an infinite rate"),
               detail({"fit_rate", "per_year", "Annual rate by the lognormal fit", ColumnKind::rate,
                       "annual rate by the lognormal fit; nan: no fit"})},
              {}};
  for (const HazardRun& run : hazard.runs) {
    for (const ThresholdRate& row : run.thresholds) {
      if (row.threshold_m != threshold_m.value_or(row.threshold_m)) continue;
      const char* sign = sign_of(row);
      const Estimate in_50_years{probability_in(50.0, row.annual_rate.value), {}};
      table.add({run.label, row.threshold_m, NumberCell{row.annual_rate, sign},
                 NumberCell{period_of(row.annual_rate), row.is_mostly_assumed() ? "> " : ""},
                 NumberCell{row.life_probability, sign}, NumberCell{in_50_years, sign},
                 row.beyond_share, row.half_intensity, row.fit_rate});
    }
  }
  table.notes = {
      "Beyond levels: the share of the rate from histories that do not reach the clearance at the "
      "highest level. Any shaking above that level counts as exceeding it. Above a half the rate "
      "is an upper bound (<), without an interval.",
      "Half of it above: half of the annual rate is of shaking stronger than this (the median of "
      "its deaggregation by intensity)."};
  return with_listed(results, table);
}

Table hazard_ground_table(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  Table table{
      "hazard_ground",
      fmt::format("Points of the hazard curve {}; shaking above the highest level: {:.3g} a year.",
                  curve_name(hazard), hazard.beyond_rate),
      {intensity_column(results, "intensity", "Intensity", "intensity"),
       {"annual_rate", "per_year", "Annual rate", ColumnKind::rate,
        "annual rate of shaking above the intensity"}},
      {},
      {}};
  for (std::size_t i = 0; i < hazard.intensity.size(); ++i)
    table.add({hazard.intensity[i], hazard.intensity_rate[i]});
  return table;
}

Table hazard_curve_table(const Results& results) {
  Table table{"hazard_curve",
              "Annual rate of exceeding a displacement." + by_curve(results) + in_plan(results),
              {run_column, displacement_column, rate_column, below_column},
              {}};
  for (const HazardRun& run : results.hazard->runs) {
    for (const DisplacementRate& row : run.curve)
      table.add({run.label, row.displacement_m, at_least(row.annual_rate, row.below_share),
                 row.below_share});
  }
  return with_bounds(results, std::move(table));
}

Table hazard_targets_table(const Results& results) {
  Table table{"hazard_targets",
              "Displacement that is exceeded at a given annual rate." + by_curve(results) +
                  in_plan(results),
              {run_column,
               text_column("target", "Rate", "the annual rate in words"),
               {"annual_rate", "per_year", "Annual rate", ColumnKind::rate,
                "annual rate of exceedance; inf: slides freely"},
               in_50_years_column,
               {"displacement", "m", "Displacement, m (in) [95 %, m]", ColumnKind::length,
                "displacement in plan; inf: beyond the levels, nan: below them", true},
               intensity_column(results, "intensity", "Shaking of that rate",
                                "intensity that shaking exceeds at that rate"),
               below_column},
              {}};
  for (const HazardRun& run : results.hazard->runs) {
    for (const TargetDisplacement& row : run.targets)
      table.add({run.label, rate_text(row.annual_rate), row.annual_rate,
                 probability_in(50.0, row.annual_rate), target_of(run, row), row.intensity,
                 row.below_share});
  }
  return with_bounds(results, std::move(table));
}

Table hazard_standards_table(const Results& results) {
  Table table{"hazard_standards",
              "How often the displacements that standards prescribe at the S_DS of the site are "
              "exceeded, beside the displacement that is exceeded with 1 % in 50 years." +
                  by_curve(results) + in_plan(results),
              {run_column,
               standard_column,
               provision_column,
               sds_column,
               prescribed_column,
               rate_column,
               in_50_years_column,
               {"risk_targeted", "m", "1 % in 50 years, m (in)", ColumnKind::length,
                "displacement that is exceeded with 1 % in 50 years"},
               {"ratio", "", "That over prescribed", ColumnKind::number,
                "displacement exceeded with 1 % in 50 years over the prescribed one"},
               below_column},
              {}};
  for (const HazardRun& run : results.hazard->runs) {
    const TargetDisplacement target = target_displacement(rate_of(0.01, 50.0), run);
    const double target_m = target.displacement_m.value;
    for (const PrescribedRate& row : run.prescribed)
      table.add(
          {run.label, standard_name(row.standard),
           std::string(row.prescribed.provenance == Provenance::checked ? "checked" : "recalled"),
           row.sds_g, row.prescribed.value_m, at_least(row.annual_rate, row.below_share),
           at_least({probability_in(50.0, row.annual_rate.value), {}}, row.below_share),
           target_of(run, target), target_m / row.prescribed.value_m, row.below_share});
  }
  return with_bounds(results, std::move(table));
}

Table life_distribution_table(const Results& results) {
  Table table{
      "design_life_distribution",
      "Slip over " + life_text(*results.hazard) + ", " + not_returned +
          ": what it stays below in a share of the design lives." + by_curve(results) +
          in_plan(results),
      {run_column,
       text_column("quantity", "Slip", "which displacement of a design life"),
       {"probability", "", "Share of the lives", ColumnKind::share, "share of the design lives"},
       displacement_column,
       moving_column},
      {},
      {kept_over_life}};
  for (const HazardRun& run : results.hazard->runs)
    for (const LifeQuantile& row : run.life_distribution)
      table.add({run.label, quantity_name(row.quantity), row.probability,
                 at_least({row.displacement_m, {}}, run.moving_share), run.moving_share});
  return with_bounds(results, std::move(table));
}

Table shown_design_life_table(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  Table table{"design_life",
              "Slip over " + life_text(hazard) + ", " + not_returned + ": 95th percentiles." +
                  by_curve(results) + in_plan(results),
              {run_column},
              {}};
  double median_m = 0.0;
  for (const LifeDisplacement& row : hazard.runs.front().life) {
    table.columns.push_back({"p95_" + std::to_string(table.columns.size()), "m",
                             capitalised(quantity_name(row.quantity)) + ", m (in) [95 %, m]",
                             ColumnKind::length, "", true});
  }
  for (const HazardRun& run : hazard.runs) {
    std::vector<Cell> row{run.label};
    for (const LifeDisplacement& life : run.life) {
      row.emplace_back(at_least(life.p95_m, run.moving_share));
      median_m = std::max(median_m, life.median_m.value);
    }
    table.add(std::move(row));
  }
  const bool bound =
      std::ranges::any_of(hazard.runs, [](const HazardRun& run) { return run.moving_share > 0.0; });
  table.notes = {std::string(bound ? "The medians, lower bounds, are " : "The medians are ") +
                     (median_m == 0.0        ? "all 0"
                      : std::isinf(median_m) ? "in part beyond the levels"
                                             : "at most " + format_length(median_m)) +
                     "; they and the 84th percentiles: tables/design_life.csv.",
                 kept_over_life};
  return with_bounds(results, std::move(table));
}

Table design_life_table(const Results& results) {
  Table table{"design_life",
              "Slip over " + life_text(*results.hazard) + ", " + not_returned + "." +
                  by_curve(results) + in_plan(results),
              {run_column,
               text_column("quantity", "Slip", "which displacement of a design life"),
               {"median", "m", "Median, m (in) [95 %, m]", ColumnKind::length,
                "median over design lives", true},
               {"p84", "m", "84th percentile, m (in) [95 %, m]", ColumnKind::length,
                "84th percentile over design lives", true},
               {"p95", "m", "95th percentile, m (in) [95 %, m]", ColumnKind::length,
                "95th percentile over design lives", true},
               moving_column,
               detail({"events", "", "Earthquakes", ColumnKind::number,
                       "expected earthquakes of a design life above from_intensity"}),
               intensity_column(results, "from_intensity", "above",
                                "intensity below which no earthquake is counted")},
              {},
              {kept_over_life}};
  for (const HazardRun& run : results.hazard->runs) {
    const double below = run.moving_share;
    for (const LifeDisplacement& row : run.life)
      table.add({run.label, quantity_name(row.quantity), at_least(row.median_m, below),
                 at_least(row.p84_m, below), at_least(row.p95_m, below), below, run.events,
                 run.from_intensity});
  }
  return with_bounds(results, std::move(table));
}

}  // namespace glissade
