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

NumberCell median_of(const FitSummary& fit) {
  const char* sign = fit.status == FitStatus::lower_bound   ? "> "
                     : fit.status == FitStatus::upper_bound ? "< "
                                                            : "";
  return {{fit.curve.median, fit.median_interval}, sign};
}

/// That of a bound is no result.
NumberCell log_std_of(const FitSummary& fit) {
  return {{fit.curve.log_std, fit.log_std_interval}, fit.is_bound() ? "assumed " : ""};
}

NumberCell p50_of(const FitSummary& fit) {
  return {{fit.curve.intensity_at(0.5), fit.p50_interval}, median_of(fit).sign};
}

Estimate floor_of(const FitSummary& fit) { return {fit.curve.floor, fit.floor_interval}; }

Column median_column(const Results& results) {
  return intensity_column(results, "median", "Median",
                          "median of the lognormal fragility of the histories that need shaking; "
                          "with status lower or upper bound, the bound",
                          true);
}
Column p50_column(const Results& results, const char* heading) {
  return intensity_column(results, "p50", heading, "intensity at which half of all exceed", true);
}
const Column log_std_column{"log_std",
                            "",
                            "Log std [95 %]",
                            ColumnKind::number,
                            "logarithmic standard deviation; of a bound: as assumed",
                            true},
    censored_column{"censored_share", "", "Never reached", ColumnKind::share,
                    "share of histories that never reach the threshold"},
    method_column =
        text_column("method", "Fitted on", "which of the two fits: on stripes or on capacities"),
    status_column = text_column("status", "Fit", "how the fit came out");

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
             fit.interval_method, fit.note, fit.method, fit.log_likelihood});
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

/// Of every run and threshold.
void for_each_fragility(std::span<const RunResults> runs, const auto& put) {
  for (const RunResults& run : runs)
    for (const ThresholdFragility& fragility : run.fragilities) put(run, fragility);
}

double histories_at(const Results& results, const RunResults& run, std::size_t level) {
  return static_cast<double>(results.histories.records_at(level) * run.cases);
}

/// Of multiple stripes, whose records are run at one level, without what only the others have.
Table without_capacities(const Results& results, Table table) {
  if (!results.by_stripes) return table;
  for (const char* stem :
       {"lognormal_p", "recross_share", "record_recross_share", "censored_share"})
    if (std::ranges::find(table.columns, stem, &Column::stem) != table.columns.end())
      table = table.without(stem);
  return table;
}

}  // namespace

const FitSummary& preferred_fit(const ThresholdFragility& fragility) {
  if (fragility.on_stripes) return fragility.stripes;
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
       method_column,
       median_column(results),
       log_std_column,
       status_column,
       {"lognormal_p", "", "Lognormal, p", ColumnKind::number,
        "goodness of fit of the lognormal, p; nan: no test"},
       {"recross_share", "", "Histories that recross", ColumnKind::share,
        "share of histories that reach the threshold and fall below it again at a higher level"},
       {"record_recross_share", "", "Records that recross", ColumnKind::share,
        "share of records of which any history recrosses"},
       censored_column,
       {"free_sliding_share", "", "Slides freely, p0 [95 %]", ColumnKind::share,
        "p0, the share that slides without shaking", true},
       p50_column(results, "p50"),
       text_column("interval_method", "Intervals by", "how the intervals were found"),
       text_column("note", "Note", "remarks on the fit"),
       text_column("fit_method", "Method", "how it was fitted"),
       {"log_likelihood", "", "Log likelihood", ColumnKind::number, "logarithm of the likelihood"}},
      {}};
  for_each_fragility(results.runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    add_fragility_row(table, run, fragility, "stripes", fragility.stripes);
    if (!fragility.on_stripes)
      add_fragility_row(table, run, fragility, "capacities", fragility.capacities);
  });
  return without_capacities(results, with_listed(results, table));
}

Table combinations_table(const Results& results) {
  Table table{
      "combinations",
      "The combinations of what the study lists, with what friction is.",
      {run_column,
       text_column("friction_is", "Friction", "what friction is"),
       {"first_case", "", "First case", ColumnKind::count,
        "position of its first in `cases` and in `histories`"},
       {"cases", "", "Cases", ColumnKind::count, "number of its cases: samples x orientations"}},
      {}};
  for (const RunResults& run : results.runs)
    table.add({run.label, friction_and_listed(results, run), static_cast<double>(run.first_case),
               static_cast<double>(run.cases)});
  return with_listed(results, table);
}

Table goodness_of_fit_table(const Results& results) {
  Table table{
      "goodness_of_fit",
      "The lognormal beside the capacities. " + in_plan(results),
      {run_column,
       threshold_column,
       {"p_value", "", "Goodness of fit, p", ColumnKind::number,
        "goodness of fit of the lognormal; nan: no test"},
       {"distance", "", "Distance", ColumnKind::number,
        "Cramer-von Mises distance of capacities and curve"},
       {"correlation", "", "Correlation in a record", ColumnKind::number,
        "correlation of the normal scores of a record's capacities"},
       {"largest_gap", "", "Observed - curve", ColumnKind::number,
        "largest difference of observed share and curve"},
       intensity_column(results, "gap_at", "there", "intensity at which the gap is largest")},
      {}};
  for_each_fragility(results.runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    const GoodnessOfFit& fit = fragility.lognormal;
    table.add({run.label, fragility.threshold_m, p_cell(fit.p_value), fit.distance, fit.correlation,
               fit.largest_gap, fit.gap_intensity});
  });
  return with_listed(results, table);
}

Table fragility_band_table(const Results& results, std::span<const RunResults> runs) {
  Table table{"fragility_band",
              (results.by_stripes ? "The fit on stripes by intensity, with its 95 % band."
                                  : "The fit on capacities by intensity, with its 95 % band.") +
                  measured_by(results) + in_plan(results),
              {run_column,
               threshold_column,
               intensity_column(results, "intensity", "Intensity", "intensity"),
               {"probability", "", "Probability [95 %]", ColumnKind::share,
                results.by_stripes ? "of exceeding the threshold, by the fit on stripes"
                                   : "of exceeding the threshold, by the fit on capacities",
                true}},
              {}};
  for_each_fragility(runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    const std::vector<Interval>& band = fragility.curve_fit().band;
    for (std::size_t i = 0; i < band.size(); ++i) {
      const double intensity = run.band_intensities[i];
      table.add({run.label, fragility.threshold_m, intensity,
                 Estimate{fragility.curve_fit().curve.probability(intensity), band[i]}});
    }
  });
  return with_listed(results, table);
}

Table recrossing_table(const Results& results) {
  Table table{"recrossing",
              "Records of which any history reaches the threshold and falls below it again at a "
              "higher level." +
                  measured_by(results) + in_plan(results),
              {run_column, threshold_column, text_column("record", "Record", "id of the record")},
              {}};
  for_each_fragility(results.runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    for (std::size_t r = 0; r < fragility.record_recross.size(); ++r) {
      if (fragility.record_recross[r] > 0.0)
        table.add({run.label, fragility.threshold_m, results.records[r].id});
    }
  });
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
               median_column(results),
               log_std_column,
               {"free_sliding_share", "", "Slides freely, p0", ColumnKind::share,
                "p0, the share that slides without shaking"},
               p50_column(results, "50 % of all at"),
               censored_column,
               detail(method_column),
               detail(status_column)},
              {}};
  double least_floor = 1.0, largest_floor = 0.0;
  for_each_fragility(results.runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    const FitSummary& fit = preferred_fit(fragility);
    least_floor = std::min(least_floor, fit.curve.floor);
    largest_floor = std::max(largest_floor, fit.curve.floor);
    table.add({run.label, fragility.threshold_m, median_of(fit), log_std_of(fit), fit.curve.floor,
               p50_of(fit), fragility.censored_share,
               &fit == &fragility.stripes ? "stripes" : "capacities", fit_label(fragility)});
  });
  table = without_run_key(results, without_capacities(results, with_listed(results, table)));
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
                             ColumnKind::share,
                             "share of the histories that exceed the threshold at the " + name,
                             true});
  }
  if (named.empty()) return table;
  table.title =
      fmt::format("Probability that the clearance is exceeded in {}: share of the histories.{}{}",
                  fmt::join(earthquakes, " and in "), measured_by(results), in_plan(results));
  for_each_fragility(results.runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    std::vector<Cell> cells{run.label, fragility.threshold_m};
    for (const std::size_t level : named)
      cells.emplace_back(
          Estimate{fragility.probability.at(level), fragility.probability_interval.at(level)});
    table.add(std::move(cells));
  });
  return with_listed(results, table);
}

Table slip_table(const Results& results) {
  Table table{
      "slip",
      "Peak slip over records and samples, by level." + measured_by(results) + in_plan(results),
      {run_column,
       level_column(results),
       {"median_slip", "m", "Median, m (in) [95 %, m]", ColumnKind::length,
        "median peak displacement in plan", true},
       {"p84_slip", "m", "84th percentile, m (in) [95 %, m]", ColumnKind::length,
        "84th percentile of the peak displacement in plan", true},
       {"p95_slip", "m", "95th percentile, m (in)", ColumnKind::length,
        "95th percentile of the peak displacement in plan"},
       {"mean_slip", "m", "Mean, m (in) [95 %, m]", ColumnKind::length,
        "mean peak displacement in plan", true},
       {"mean_vector", "m", "Mean longest vector, m (in)", ColumnKind::length,
        "mean of the longest displacement vectors"},
       {"uplift_share", "", "Uplift", ColumnKind::share, "share of histories with uplift"}},
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

Table stripes_table(const Results& results, std::span<const RunResults> runs) {
  Table table{
      "stripes",
      "Histories whose slip exceeds the threshold, by level: what the fit on stripes rests on." +
          measured_by(results) + in_plan(results),
      {run_column,
       threshold_column,
       level_column(results),
       {"histories", "", "Histories", ColumnKind::count, "number of histories"},
       {"exceedances", "", "Exceedances", ColumnKind::count,
        "number of histories that exceed the threshold"},
       {"share", "", "Share [95 %]", ColumnKind::share,
        "share of histories that exceed the threshold", true}},
      {}};
  for_each_fragility(runs, [&](const RunResults& run, const ThresholdFragility& fragility) {
    for (std::size_t l = 0; l < fragility.probability.size(); ++l) {
      const Interval interval = l < fragility.probability_interval.size()
                                    ? fragility.probability_interval[l]
                                    : Interval{};
      const double histories = histories_at(results, run, l);
      table.add({run.label, fragility.threshold_m, results.levels.at(l), histories,
                 std::round(fragility.probability[l] * histories),
                 Estimate{fragility.probability[l], interval}});
    }
  });
  return with_listed(results, table);
}

}  // namespace glissade
