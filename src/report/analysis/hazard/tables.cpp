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

const ColumnOf quantity_column{
    text_column("quantity", "Slip", "which displacement of a design life"),
    [](const auto& row) -> decltype(quantity_name(row.quantity)) {
      return quantity_name(row.quantity);
    }};

/// A row of each run and one of its rows.
template <class Row>
struct RunTable : TableOf<HazardRun, Row> {
  RunTable(const Results& results, FileName file, const std::string& what)
      : TableOf<HazardRun, Row>(file, what + by_curve(results) + in_plan(results)) {
    this->put_all(run_column);
  }
  void put_rate(auto value) {
    this->rate("annual_rate", "Annual rate", "annual rate of exceedance; inf: slides freely",
               value);
  }
  Column& put_in_50_years(auto value) {
    return this->share("probability_50_years", "In 50 years",
                       "probability of one exceedance or more in 50 years", value);
  }
  void put_displacement(auto value) {
    this->length("displacement", "Displacement",
                 "displacement in plan; inf: beyond the levels, nan: below them", value);
  }
  void put_below() {
    this->share("below_share", "Below levels",
                "share of histories that exceed it at the lowest level; above 0: a lower bound",
                &Row::below_share)
        .detail = true;
  }
  void put_moving() {
    this->share("moving_share", "Moving",
                "share of histories that slide at the intensity below which none counts; above 0: "
                "a lower bound",
                &HazardRun::moving_share)
        .detail = true;
  }
};

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
  using R = ThresholdRate;
  RunTable<R> t(results, "hazard", "How often each clearance is exceeded.");
  t.put_all(threshold_column);
  t.put_rate([](const R& row) { return NumberCell{row.annual_rate, sign_of(row)}; });
  t.number(
      "return_period", "Return period", "1 over the annual rate",
      [](const R& row) {
        const auto& [rate, interval] = row.annual_rate;
        return NumberCell{{1.0 / rate, {1.0 / interval.high, 1.0 / interval.low}},
                          row.is_mostly_assumed() ? "> " : ""};
      },
      "years");
  t.share("life_probability", "In " + life_text(hazard),
          "probability of one exceedance or more in the design life", [](const R& row) {
            return NumberCell{row.life_probability, sign_of(row)};
          });
  t.put_in_50_years([](const R& row) -> Cell {
     return NumberCell{{probability_in(50.0, row.annual_rate.value), {}}, sign_of(row)};
   }).detail = true;
  t.number("effective_records", "Effective number of records",
           "number of records, or events, that carry the rate", &R::effective_records);
  t.share("beyond_share", "Beyond levels",
          "part of the rate from histories that do not reach it at the highest level",
          &R::beyond_share);
  t.put_all(
      intensity_column(results, "half_intensity", "Half of it above",
                       "half of the rate is of stronger shaking: median of its deaggregation; "
                       "inf: above the levels; nan: an infinite rate",
                       &R::half_intensity));
  t.rate("fit_rate", "Annual rate by the lognormal fit",
         "annual rate by the lognormal fit; nan: no fit", &R::fit_rate)
      .detail = true;
  for (const HazardRun& run : hazard.runs)
    for (const R& row : run.thresholds)
      if (row.threshold_m == threshold_m.value_or(row.threshold_m)) t.add(run, row);
  t.notes = {
      "Beyond levels: the share of the rate from histories that do not reach the clearance at the "
      "highest level. Any shaking above that level counts as exceeding it. Above a half the rate "
      "is an upper bound (<), without an interval.",
      "Half of it above: half of the annual rate is of shaking stronger than this (the median of "
      "its deaggregation by intensity).",
      "Effective number of records: (sum r)^2 / sum r^2 of the rates r by " +
          (units_name(results) == "events" ? std::string("event") : "record") +
          ". Where few carry the rate, the upper end may be too low. The hazard curve and the "
          "friction tests are "
          "outside the interval."};
  return with_listed(results, t);
}

Table hazard_ground_table(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  TableOf<std::size_t> t(
      "hazard_ground",
      fmt::format("Points of the hazard curve {}; shaking above the highest level: {:.3g} a year.",
                  curve_name(hazard), hazard.beyond_rate));
  t.put_all(intensity_column(results, "intensity", "Intensity", "intensity",
                             [&](std::size_t i) { return hazard.intensity[i]; }));
  t.rate("annual_rate", "Annual rate", "annual rate of shaking above the intensity",
         [&](std::size_t i) { return hazard.intensity_rate[i]; });
  for (std::size_t i = 0; i < hazard.intensity.size(); ++i) t.add(i);
  return t;
}

Table hazard_curve_table(const Results& results) {
  using R = DisplacementRate;
  RunTable<R> t(results, "hazard_curve", "Annual rate of exceeding a displacement.");
  t.put_displacement(&R::displacement_m);
  t.put_rate([](const R& row) { return at_least(row.annual_rate, row.below_share); });
  t.put_below();
  t.add_each(results.hazard->runs, &HazardRun::curve);
  return with_bounds(results, t);
}

Table hazard_targets_table(const Results& results) {
  using R = TargetDisplacement;
  RunTable<R> t(results, "hazard_targets", "Displacement that is exceeded at a given annual rate.");
  t.text("target", "Rate", "the annual rate in words",
         [](const R& row) { return rate_text(row.annual_rate); });
  t.put_rate(&R::annual_rate);
  t.put_in_50_years([](const R& row) { return probability_in(50.0, row.annual_rate); });
  t.put_displacement(target_of);
  t.put_all(intensity_column(results, "intensity", "Shaking of that rate",
                             "intensity that shaking exceeds at that rate", &R::intensity));
  t.put_below();
  t.add_each(results.hazard->runs, &HazardRun::targets);
  return with_bounds(results, t);
}

Table hazard_standards_table(const Results& results) {
  using R = PrescribedRate;
  RunTable<R> t(results, "hazard_standards",
                "How often the displacements that standards prescribe at the S_DS of the site are "
                "exceeded, beside the displacement that is exceeded with 1 % in 50 years.");
  const auto target = [](const HazardRun& run) {
    return target_displacement(rate_of(0.01, 50.0), run);
  };
  t.put_all(standard_column, provision_column, sds_column, prescribed_column);
  t.put_rate([](const R& row) { return at_least(row.annual_rate, row.below_share); });
  t.put_in_50_years([](const R& row) -> Cell {
    return at_least({probability_in(50.0, row.annual_rate.value), {}}, row.below_share);
  });
  t.length("risk_targeted", "1 % in 50 years", "displacement that is exceeded with 1 % in 50 years",
           [=](const HazardRun& run) -> Cell { return target_of(run, target(run)); });
  t.number("ratio", "That over prescribed",
           "displacement exceeded with 1 % in 50 years over the prescribed one",
           [=](const HazardRun& run, const R& row) {
             return target(run).displacement_m.value / row.prescribed.value_m;
           });
  t.put_below();
  t.add_each(results.hazard->runs, &HazardRun::prescribed);
  return with_bounds(results, t);
}

Table life_distribution_table(const Results& results) {
  using R = LifeQuantile;
  RunTable<R> t(results, "design_life_distribution",
                "Slip over " + life_text(*results.hazard) + ", " + not_returned +
                    ": what it stays below in a share of the design lives.");
  t.put_all(quantity_column);
  t.share("probability", "Share of the lives", "share of the design lives", &R::probability);
  t.put_displacement([](const HazardRun& run, const R& row) -> Cell {
    return at_least({row.displacement_m, {}}, run.moving_share);
  });
  t.put_moving();
  t.add_each(results.hazard->runs, &HazardRun::life_distribution);
  t.notes = {kept_over_life};
  return with_bounds(results, t);
}

Table shown_design_life_table(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  TableOf<HazardRun> t("design_life", "Slip over " + life_text(hazard) + ", " + not_returned +
                                          ": 95th percentiles." + by_curve(results) +
                                          in_plan(results));
  t.put_all(run_column);
  for (std::size_t i = 0; i < hazard.runs.front().life.size(); ++i)
    t.length("p95_" + std::to_string(i + 1),
             capitalised(quantity_name(hazard.runs.front().life[i].quantity)), "",
             [=](const HazardRun& run) { return at_least(run.life[i].p95_m, run.moving_share); });
  t.add_each(hazard.runs);
  double median_m = 0.0;
  bool bound = false;
  for (const HazardRun& run : hazard.runs) {
    bound = bound || run.moving_share > 0.0;
    for (const LifeDisplacement& life : run.life)
      median_m = std::max(median_m, life.median_m.value);
  }
  t.notes = {std::string(bound ? "The medians, lower bounds, are " : "The medians are ") +
                 (median_m == 0.0        ? "all 0"
                  : std::isinf(median_m) ? "in part beyond the levels"
                                         : "at most " + format_length(median_m)) +
                 "; they and the 84th percentiles: tables/design_life.csv.",
             kept_over_life};
  return with_bounds(results, t);
}

Table design_life_table(const Results& results) {
  using R = LifeDisplacement;
  RunTable<R> t(results, "design_life",
                "Slip over " + life_text(*results.hazard) + ", " + not_returned + ".");
  t.put_all(quantity_column);
  const auto bounded = [](Estimate R::*value) {
    return
        [=](const HazardRun& run, const R& row) { return at_least(row.*value, run.moving_share); };
  };
  t.length("median", "Median", "median over design lives", bounded(&R::median_m));
  t.length("p84", "84th percentile", "84th percentile over design lives", bounded(&R::p84_m));
  t.length("p95", "95th percentile", "95th percentile over design lives", bounded(&R::p95_m));
  t.put_moving();
  t.number("events", "Earthquakes", "expected earthquakes of a design life above from_intensity",
           &HazardRun::events)
      .detail = true;
  t.put_all(intensity_column(results, "from_intensity", "above",
                             "intensity below which no earthquake is counted",
                             &HazardRun::from_intensity));
  t.add_each(results.hazard->runs, &HazardRun::life);
  t.notes = {kept_over_life};
  return with_bounds(results, t);
}

}  // namespace glissade
