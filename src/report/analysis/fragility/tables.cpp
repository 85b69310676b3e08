// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// The title's opening: what the levels are.
std::string measured_by(const Results& results) {
  return " Intensity measure: " + results.intensity_label + ". ";
}

SignedEstimate median_of(const FitSummary& fit) {
  const char* sign = fit.status == FitStatus::lower_bound   ? "> "
                     : fit.status == FitStatus::upper_bound ? "< "
                                                            : "";
  return {{fit.curve.median, fit.median_interval}, sign};
}

/// That of a bound is no result.
SignedEstimate log_std_of(const FitSummary& fit) {
  return {{fit.curve.log_std, fit.log_std_interval}, fit.is_bound() ? "assumed " : ""};
}

SignedEstimate p50_of(const FitSummary& fit) {
  return {{fit.curve.intensity_at(0.5), fit.p50_interval}, median_of(fit).sign};
}

Estimate floor_of(const FitSummary& fit) { return {fit.curve.floor, fit.floor_interval}; }

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
             to_string(fit.status), p_cell(fragility.lognormal.p_value), fragility.recross_share,
             record_recross_share(fragility), fragility.censored_share, floor_of(fit), p50_of(fit),
             fit.interval_method, fit.note});
}

/// How the median came about, for people.
std::string fit_label(const ThresholdFragility& fragility) {
  return to_string(preferred_fit(fragility).status) +
         (departs_from_lognormal(fragility.lognormal)
              ? fmt::format(", not lognormal ({})", format_p(fragility.lognormal.p_value))
              : "");
}

/// Neighbouring clearances of which the larger one has the lower median.
std::string crossing_note(const Results& results) {
  std::vector<std::string> crossings;
  for (const RunResults& run : results.runs) {
    const ThresholdFragility* before = nullptr;
    for (const ThresholdFragility& fragility : run.fragilities) {
      if (!preferred_fit(fragility).converged()) continue;
      const double median = preferred_fit(fragility).curve.intensity_at(0.5);
      if (before != nullptr && median < preferred_fit(*before).curve.intensity_at(0.5))
        crossings.push_back(fmt::format(
            "{} at {}, {} at {}", format_length(before->threshold_m),
            with_unit(results, format_number(preferred_fit(*before).curve.intensity_at(0.5))),
            format_length(fragility.threshold_m), with_unit(results, format_number(median))));
      before = &fragility;
    }
  }
  if (crossings.empty()) return "";
  return fmt::format(
      "Fitted medians that cross, though a larger clearance is never exceeded sooner: {}{}. Where "
      "curves are extrapolated or not lognormal the order of the histories holds, not theirs.",
      crossings.front(),
      crossings.size() > 1 ? fmt::format(" and {} more", crossings.size() - 1) : "");
}

double histories_per_level(const Results& results, const RunResults& run) {
  return static_cast<double>(results.records.size() * run.cases);
}

}  // namespace

const FitSummary& preferred_fit(const ThresholdFragility& fragility) {
  const FitSummary& capacities = fragility.capacities;
  const bool known = capacities.converged() || capacities.status == FitStatus::one_capacity;
  return !known && fragility.stripes.converged() ? fragility.stripes : capacities;
}

Table fragility_table(const Results& results) {
  Table table{
      "fragility",
      "Fragilities by clearance threshold: P = p0 + (1 - p0) Phi(ln(x / median) / log_std), "
      "p0 the share that slides freely, without shaking; half of all exceed at p50." +
          measured_by(results) + "log_std and shares are dimensionless. " + in_plan(results),
      {run_column,
       threshold_column,
       text_column("method", "Fitted on"),
       intensity_column(results, "median", "Median", true),
       {"log_std", "", "Log std [95 %]", ColumnKind::number, true},
       text_column("status", "Fit"),
       {"lognormal_p", "", "Lognormal, p"},
       {"recross_share", "", "Histories that recross", ColumnKind::share},
       {"record_recross_share", "", "Records that recross", ColumnKind::share},
       {"censored_share", "", "Never reached", ColumnKind::share},
       {"free_sliding_share", "", "Slides freely, p0 [95 %]", ColumnKind::share, true},
       intensity_column(results, "p50", "p50", true),
       text_column("interval_method", "Intervals by"),
       text_column("note", "Note")},
      {}};
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      add_fragility_row(table, run, fragility, "stripes", fragility.stripes);
      add_fragility_row(table, run, fragility, "capacities", fragility.capacities);
    }
  }
  return with_listed(results, table);
}

/// What the names of the values of friction mean, where they are shown.
std::vector<std::string> friction_names(const Results& results) {
  const std::string label = results.runs.empty() ? "" : results.runs.front().label;
  const bool shown = results.cases.axis("friction.value") < results.cases.axes.size() ||
                     label == "sampled" || label == "design";
  if (!shown) return {};
  return {"sampled: friction is drawn for each sample; design: friction is mean - 2 std."};
}

Table fragility_summary_table(const Results& results) {
  Table table{"fragility_summary",
              "Fragility by clearance: intensity with a 50 % chance of exceedance." +
                  measured_by(results) + in_plan(results),
              {run_column,
               threshold_column,
               intensity_column(results, "median", "Median", true),
               {"log_std", "", "Log std [95 %]", ColumnKind::number, true},
               {"free_sliding_share", "", "Slides freely, p0", ColumnKind::share},
               intensity_column(results, "p50", "50 % of all at", true),
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
                 &fit == &fragility.stripes ? "stripes" : "capacities", fit_label(fragility)});
    }
  }
  table = with_listed(results, table);
  if (lists_more_than_friction_value(results)) table = table.without("run");
  for (Column& column : table.columns)
    column.detail = column.stem == "method" || column.stem == "status";
  table.notes = friction_names(results);
  if (const std::string note = crossing_note(results); !note.empty()) table.notes.push_back(note);
  if (largest_floor == 0.0) return table.without("free_sliding_share").without("p50");
  table.notes.push_back(
      least_floor == 1.0
          ? "Every history slides freely: it exceeds at any intensity, without shaking."
          : "Some histories slide freely: they exceed at any intensity. Median and log std are "
            "those of the others: P = p0 + (1 - p0) Phi(ln(x / median) / log std).");
  return table;
}

Table earthquakes_table(const Results& results) {
  Table table{"earthquakes", "", {run_column, threshold_column}, {}};
  std::vector<std::string> earthquakes;
  std::vector<std::size_t> named;
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    const std::string name = earthquake_name(results.levels[level], results.model.dbe_level);
    if (name.empty()) continue;
    named.push_back(level);
    earthquakes.push_back(name == "DBE" ? "the design earthquake (DBE)"
                                        : "the maximum considered earthquake (MCE)");
    table.columns.push_back({name == "DBE" ? "dbe_probability" : "mce_probability", "",
                             fmt::format("At the {}, {} [95 %]", name,
                                         with_unit(results, level_number(results.levels[level]))),
                             ColumnKind::share, true});
  }
  if (named.empty()) return table;
  table.title =
      fmt::format("Probability that the clearance is exceeded in {}: share of the histories.{}{}",
                  fmt::join(earthquakes, " and in "), measured_by(results), in_plan(results));
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      std::vector<Cell> cells{run.label, fragility.threshold_m};
      for (const std::size_t level : named)
        cells.emplace_back(
            Estimate{fragility.probability.at(level), fragility.probability_interval.at(level)});
      table.add(std::move(cells));
    }
  }
  return with_listed(results, table);
}

Table slip_table(const Results& results) {
  Table table{
      "slip",
      "Peak slip over records and samples, by level." + measured_by(results) + in_plan(results),
      {run_column,
       intensity_column(results, "level", "Level"),
       {"median_slip", "m", "Median, m (in) [95 %, m]", ColumnKind::length, true},
       {"p84_slip", "m", "84th percentile, m (in) [95 %, m]", ColumnKind::length, true},
       {"p95_slip", "m", "95th percentile, m (in)", ColumnKind::length},
       {"mean_slip", "m", "Mean, m (in) [95 %, m]", ColumnKind::length, true},
       {"mean_vector", "m", "Mean longest vector, m (in)", ColumnKind::length},
       {"uplift_share", "", "Uplift", ColumnKind::share}},
      {}};
  bool two_axes = false;
  for (const RunResults& run : results.runs) {
    for (const SlipStatistics& slip : run.slip) {
      two_axes = two_axes || !std::isnan(slip.mean_vector_m);
      table.add({run.label, slip.level, Estimate{slip.median_m, slip.median_interval},
                 Estimate{slip.p84_m, slip.p84_interval}, slip.p95_m,
                 Estimate{slip.mean_m, slip.mean_interval}, slip.mean_vector_m, slip.uplift_share});
    }
  }
  table = with_listed(results, table);
  return two_axes ? table : table.without("mean_vector");
}

Table stripes_table(const Results& results) {
  Table table{
      "stripes",
      "Histories whose slip exceeds the threshold, by level: what the fit on stripes rests on." +
          measured_by(results) + in_plan(results),
      {run_column,
       threshold_column,
       intensity_column(results, "level", "Level"),
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
  return with_listed(results, table);
}

}  // namespace glissade
