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

NumberCell p50_of(const FitSummary& fit) {
  return {{fit.curve.intensity_at(0.5), fit.p50_interval}, median_of(fit).sign};
}

/// A row of each run, threshold and fit.
struct FitTable : TableOf<RunResults, ThresholdFragility, FitSummary> {
  using TableOf::TableOf;

  Column& put_method() {
    return text("method", "Fitted on", "which of the two fits: on stripes or on capacities",
                [](const RunResults&, const ThresholdFragility& of, const FitSummary& fit) {
                  return &fit == &of.stripes ? "stripes" : "capacities";
                });
  }
  void put_median(const Results& results) {
    put_all(
        intensity_column(results, "median", "Median",
                         "median of the lognormal fragility of the histories that need shaking; "
                         "with status lower or upper bound, the bound",
                         median_of));
    number("log_std", "Log std", "logarithmic standard deviation; of a bound: as assumed",
           [](const FitSummary& fit) -> NumberCell {  // that of a bound is no result
             return {{fit.curve.log_std, fit.log_std_interval}, fit.is_bound() ? "assumed " : ""};
           });
  }
  void put_p50(const Results& results, const char* heading) {
    put_all(
        intensity_column(results, "p50", heading, "intensity at which half of all exceed", p50_of));
  }
  void put_censored() {
    share("censored_share", "Never reached", "share of histories that never reach the threshold",
          &ThresholdFragility::censored_share);
  }
};

/// Share of records of which any sample falls below the threshold again at a higher level.
double record_recross_share(const ThresholdFragility& fragility) {
  const std::vector<double>& recross = fragility.record_recross;
  return recross.empty() ? nan
                         : std::accumulate(recross.begin(), recross.end(), 0.0) /
                               static_cast<double>(recross.size());
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
  using F = ThresholdFragility;
  FitTable t("fragility",
             "Fragilities by clearance threshold: P = p0 + (1 - p0) Phi(ln(x / median) / log_std), "
             "p0 the share that slides freely, without shaking; half of all exceed at p50." +
                 measured_by(results) + "log_std and shares are dimensionless. " +
                 in_plan(results));
  t.put_all(run_column, threshold_column);
  t.put_method();
  t.put_median(results);
  t.text("status", "Fit", "how the fit came out", &FitSummary::status);
  t.number("lognormal_p", "Lognormal, p", "goodness of fit of the lognormal, p; nan: no test",
           [](const F& of) { return Cell(p_cell(of.lognormal.p_value)); });
  t.share("recross_share", "Histories that recross",
          "share of histories that reach the threshold and fall below it again at a higher level",
          &F::recross_share);
  t.share("record_recross_share", "Records that recross",
          "share of records of which any history recrosses", record_recross_share);
  t.put_censored();
  t.share("free_sliding_share", "Slides freely, p0", "p0, the share that slides without shaking",
          [](const FitSummary& fit) {
            return Estimate{fit.curve.floor, fit.floor_interval};
          });
  t.put_p50(results, "p50");
  t.text("interval_method", "Intervals by", "how the intervals were found",
         &FitSummary::interval_method);
  t.text("note", "Note", "remarks on the fit", &FitSummary::note);
  t.text("fit_method", "Method", "how it was fitted", &FitSummary::method);
  t.number("log_likelihood", "Log likelihood", "logarithm of the likelihood",
           &FitSummary::log_likelihood);
  for (const RunResults& run : results.runs) {
    for (const F& fragility : run.fragilities) {
      t.add(run, fragility, fragility.stripes);
      if (!fragility.on_stripes) t.add(run, fragility, fragility.capacities);
    }
  }
  return without_capacities(results, with_listed(results, t));
}

Table combinations_table(const Results& results) {
  using R = RunResults;
  TableOf<R> t("combinations", "The combinations of what the study lists, with what friction is.");
  t.put_all(run_column);
  t.text("friction_is", "Friction", "what friction is",
         [&](const R& run) { return friction_and_listed(results, run); });
  t.count("first_case", "First case", "position of its first in `cases` and in `histories`",
          &R::first_case);
  t.count("cases", "Cases", "number of its cases: samples x orientations", &R::cases);
  t.add_each(results.runs);
  return with_listed(results, t);
}

Table goodness_of_fit_table(const Results& results) {
  using G = GoodnessOfFit;
  TableOf<RunResults, ThresholdFragility, G> t(
      "goodness_of_fit", "The lognormal beside the capacities. " + in_plan(results));
  t.put_all(run_column, threshold_column);
  t.number("p_value", "Goodness of fit, p", "goodness of fit of the lognormal; nan: no test",
           [](const G& fit) { return Cell(p_cell(fit.p_value)); });
  t.number("distance", "Distance", "Cramer-von Mises distance of capacities and curve",
           &G::distance);
  t.number("correlation", "Correlation in a record",
           "correlation of the normal scores of a record's capacities", &G::correlation);
  t.number("largest_gap", "Observed - curve", "largest difference of observed share and curve",
           &G::largest_gap);
  t.put_all(intensity_column(results, "gap_at", "there", "intensity at which the gap is largest",
                             &G::gap_intensity));
  for (const RunResults& run : results.runs)
    for (const ThresholdFragility& of : run.fragilities) t.add(run, of, of.lognormal);
  return with_listed(results, t);
}

Table fragility_band_table(const Results& results, std::span<const RunResults> runs) {
  using F = ThresholdFragility;
  const std::string fit = results.by_stripes ? "fit on stripes" : "fit on capacities";
  TableOf<RunResults, F, std::size_t> t(
      "fragility_band", "The " + fit + " by intensity, with its 95 % band." + measured_by(results) +
                            in_plan(results));
  t.put_all(run_column, threshold_column);
  t.put_all(intensity_column(
      results, "intensity", "Intensity", "intensity",
      [](const RunResults& run, const F&, std::size_t i) { return run.band_intensities[i]; }));
  t.share("probability", "Probability", "of exceeding the threshold, by the " + fit,
          [](const RunResults& run, const F& of, std::size_t i) {
            return Estimate{of.curve_fit().curve.probability(run.band_intensities[i]),
                            of.curve_fit().band[i]};
          });
  for (const RunResults& run : runs)
    for (const F& of : run.fragilities)
      for (std::size_t i = 0; i < of.curve_fit().band.size(); ++i) t.add(run, of, i);
  return with_listed(results, t);
}

Table recrossing_table(const Results& results) {
  TableOf<RunResults, ThresholdFragility, RecordSummary> t(
      "recrossing",
      "Records of which any history reaches the threshold and falls below it again "
      "at a higher level." +
          measured_by(results) + in_plan(results));
  t.put_all(run_column, threshold_column);
  t.text("record", "Record", "id of the record", &RecordSummary::id);
  for (const RunResults& run : results.runs)
    for (const ThresholdFragility& of : run.fragilities)
      for (std::size_t r = 0; r < of.record_recross.size(); ++r)
        if (of.record_recross[r] > 0.0) t.add(run, of, results.records[r]);
  return with_listed(results, t);
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
  using F = ThresholdFragility;
  FitTable t("fragility_summary",
             "Fragility by clearance: intensity with a 50 % chance of exceedance." +
                 measured_by(results) + in_plan(results));
  t.put_all(run_column, threshold_column);
  t.put_median(results);
  t.share("free_sliding_share", "Slides freely, p0", "p0, the share that slides without shaking",
          [](const FitSummary& fit) { return fit.curve.floor; });
  t.put_p50(results, "50 % of all at");
  t.put_censored();
  t.put_method().detail = true;
  t.text("status", "Fit", "how the fit came out", fit_label).detail = true;
  double least_floor = 1.0, largest_floor = 0.0;
  for (const RunResults& run : results.runs) {
    for (const F& fragility : run.fragilities) {
      const FitSummary& fit = preferred_fit(fragility);
      least_floor = std::min(least_floor, fit.curve.floor);
      largest_floor = std::max(largest_floor, fit.curve.floor);
      t.add(run, fragility, fit);
    }
  }
  Table table = without_run_key(results, without_capacities(results, with_listed(results, t)));
  table.notes = friction_names(results);
  table.add_note(crossing_note(results));
  if (largest_floor == 0.0) return table.without("free_sliding_share").without("p50");
  table.notes.push_back(
      least_floor == 1.0
          ? "Every history slides freely: it exceeds at any intensity, without shaking."
          : "Some histories slide freely: they exceed at any intensity. Median and log std are "
            "those of the others: P = p0 + (1 - p0) Phi(ln(x / median) / log std).");
  return table;
}

Table earthquakes_table(const Results& results) {
  using F = ThresholdFragility;
  TableOf<RunResults, F> t("earthquakes", "");
  t.put_all(run_column, threshold_column);
  std::vector<std::string> earthquakes;
  const double dbe_level = results.model.dbe_level;
  for (const auto& [name, of_name] :
       {std::pair{"DBE", dbe_level}, {"MCE", mce_over_dbe * dbe_level}}) {
    const auto nearest = std::ranges::min_element(
        results.levels, {}, [&](double level) { return std::abs(level - of_name); });
    const auto level = static_cast<std::size_t>(nearest - results.levels.begin());
    if (nearest == results.levels.end() || earthquake_name(*nearest, dbe_level) != name) continue;
    const bool is_dbe = name == std::string_view("DBE");
    earthquakes.push_back(is_dbe ? "the design earthquake (DBE)"
                                 : "the maximum considered earthquake (MCE)");
    t.share(
        is_dbe ? "dbe_probability" : "mce_probability",
        fmt::format("At the {}, {}", name, with_unit(results, level_number(results.levels[level]))),
        fmt::format("share of the histories that exceed the threshold at the {}", name),
        [=](const F& of) {
          return Estimate{of.probability.at(level), of.probability_interval.at(level)};
        });
  }
  if (earthquakes.empty()) return t;
  t.title =
      fmt::format("Probability that the clearance is exceeded in {}: share of the histories.{}{}",
                  fmt::join(earthquakes, " and in "), measured_by(results), in_plan(results));
  t.add_each(results.runs, &RunResults::fragilities);
  return with_listed(results, t);
}

Table slip_table(const Results& results) {
  using S = SlipStatistics;
  TableOf<RunResults, S> t("slip", "Peak slip over records and samples, by level." +
                                       measured_by(results) + in_plan(results));
  t.put_all(run_column, level_column(results));
  const std::string peak = " peak displacement in plan", of_peak = " of the" + peak;
  t.length("median_slip", "Median", "median" + peak,
           with_interval(&S::median_m, &S::median_interval));
  t.length("p84_slip", "84th percentile", "84th percentile" + of_peak,
           with_interval(&S::p84_m, &S::p84_interval));
  t.length("p95_slip", "95th percentile", "95th percentile" + of_peak, &S::p95_m);
  t.length("mean_slip", "Mean", "mean" + peak, with_interval(&S::mean_m, &S::mean_interval));
  t.length("mean_vector", "Mean longest vector", "mean of the longest displacement vectors",
           &S::mean_vector_m);
  t.share("uplift_share", "Uplift", "share of histories with uplift", &S::uplift_share);
  t.add_each(results.runs, &RunResults::slip);
  const bool two_axes = std::ranges::any_of(results.runs, [](const RunResults& run) {
    return std::ranges::any_of(run.slip,
                               [](const S& slip) { return !std::isnan(slip.mean_vector_m); });
  });
  Table table = with_listed(results, t);
  table.add_note(open_percentile(results));
  table.add_note(
      "The interval of a mean covers less than 95 % where the displacements of 7 records have a "
      "log "
      "standard deviation above 2: 91 % at 2.5 (verification manual, 5.2).");
  return two_axes ? table : table.without("mean_vector");
}

Table stripes_table(const Results& results, std::span<const RunResults> runs) {
  using R = RunResults;
  using F = ThresholdFragility;
  TableOf<R, F, std::size_t> t(
      "stripes",
      "Histories whose slip exceeds the threshold, by level: what the fit on stripes rests on." +
          measured_by(results) + in_plan(results));
  t.put_all(run_column, threshold_column);
  t.put_all(intensity_column(results, "level", "Level", "intensity level",
                             [&](std::size_t level) { return results.levels[level]; }));
  const auto histories = [&](const R& run, const F&, std::size_t level) {
    return static_cast<double>(results.histories.records_at(level) * run.cases);
  };
  t.count("histories", "Histories", "number of histories", histories);
  t.count("exceedances", "Exceedances", "number of histories that exceed the threshold",
          [=](const R& run, const F& of, std::size_t level) {
            return std::round(of.probability[level] * histories(run, of, level));
          });
  t.share(
      "share", "Share", "share of histories that exceed the threshold",
      [](const R&, const F& of, std::size_t level) {
        const bool known = level < of.probability_interval.size();
        return Estimate{of.probability[level], known ? of.probability_interval[level] : Interval{}};
      });
  for (const R& run : runs)
    for (const F& of : run.fragilities)
      for (std::size_t level = 0; level < of.probability.size(); ++level) t.add(run, of, level);
  return with_listed(results, t);
}

}  // namespace glissade
