// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/core/in_parallel.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string fit_text(const Results& results, const FitSummary& fit) {
  if (fit.status == FitStatus::always_exceeds) return "every history slides freely";
  if (fit.converged()) {
    const std::string free =
        fit.curve.floor > 0 ? format_share(fit.curve.floor) + " slide freely; the others: " : "";
    const char* beyond = fit.status == FitStatus::extrapolated ? ", beyond the levels" : "";
    return fmt::format(
        "{}median {} [{}]{}, log std {}", free, with_unit(results, format_number(fit.curve.median)),
        format_interval(fit.median_interval), beyond, format_number(fit.curve.log_std));
  }
  if (fit.status == FitStatus::upper_bound) {
    return fmt::format("median below {} (95 % bound; all exceed)",
                       with_unit(results, format_number(fit.curve.median)));
  }
  if (fit.status == FitStatus::lower_bound) {
    return fmt::format("median above {} (95 % bound; no exceedance)",
                       with_unit(results, format_number(fit.curve.median)));
  }
  if (fit.status == FitStatus::one_capacity) {
    return fmt::format("one capacity: {}", with_unit(results, format_number(fit.curve.median)));
  }
  return "no curve could be fitted";
}

bool has_curve(const ThresholdFragility& fragility) {
  return fragility.curve_fit().converged() ||
         fragility.curve_fit().status == FitStatus::always_exceeds;
}

bool are_a_few(const RunResults& run) {
  return run.fragilities.size() > 1 && run.fragilities.size() <= 5;
}

/// The clearances at the ends of their curves, where these are a few.
void add_direct_labels(Panel& panel, const RunResults& run) {
  const std::size_t count = run.fragilities.size();
  std::vector<Note> labels;
  for (std::size_t t = 0; t < count; ++t) {
    const ThresholdFragility& fragility = run.fragilities[t];
    if (fragility.curve_fit().converged())
      labels.push_back({0.0, fragility.curve_fit().curve.probability(panel.x.high),
                        short_length(fragility.threshold_m), family_look(t, count).colour});
  }
  if (are_a_few(run)) add_side_labels(panel, std::move(labels), {Side::right, 0.15, 0.1});
}

/// "0.300 m (11.8 in): median 1.66 g [1.46 to 1.89], log std 0.311"
std::string threshold_text(const Results& results, const ThresholdFragility& fragility) {
  return format_length(fragility.threshold_m) + ": " + fit_text(results, fragility.curve_fit()) +
         (departs_from_lognormal(fragility.lognormal) ? ", not lognormal" : "");
}

/// Bands, curves and observed shares, with a key entry where a clearance has no label.
void add_thresholds(Panel& panel, const Results& results, const RunResults& run) {
  View curves{fragility_band_table(results, {&run, 1}), "intensity", {}},
      observed{stripes_table(results, {&run, 1}), "level", {}};
  curves.in_key = observed.in_key = false;
  std::vector<DataSeries> key;
  for (std::size_t t = 0; t < run.fragilities.size(); ++t) {
    const ThresholdFragility& fragility = run.fragilities[t];
    const Look colour = family_look(t, run.fragilities.size());
    const std::string name = "slip above " + format_length(fragility.threshold_m);
    const Where where{{"threshold", fragility.threshold_m}};
    if (has_curve(fragility))
      curves.lines.push_back({name + ", lognormal", colour, as_line, "probability", where,
                              "probability_low95", "probability_high95"});
    observed.lines.push_back({name + ", observed", colour, as_points, "share", where});
    if (!are_a_few(run) || !fragility.curve_fit().converged())
      key.push_back(
          {has_curve(fragility) ? DataSeries::Kind::line_and_points : DataSeries::Kind::points,
           colour, "", threshold_text(results, fragility)});
  }
  add_lines(panel, curves);
  add_lines(panel, observed);
  panel.series.insert(panel.series.end(), key.begin(), key.end());
}

}  // namespace

Figure fragility_figure(const Results& results, const RunResults& run) {
  const bool main_run = run.label == results.runs.front().label;
  Figure figure{
      main_run ? "fragility" : "fragility_" + run.label,
      "Probability that the array slips more than a clearance (" + run_name(results, run) + ")",
      run_below(results, run),
      "Probability that the peak slip in plan exceeds each clearance at a given intensity, with "
      "friction " +
          friction_and_listed(results, run) +
          (results.by_stripes
               ? ". Lines: lognormal curves fitted to the counts at the levels, of which each has "
                 "records of its own (multiple stripes, Baker 2015)"
               : ". Lines: lognormal curves fitted to the lowest intensity at which each history "
                 "reaches the clearance (those that never do are censored; the share that slides "
                 "freely is in the curve)") +
          ". Points: share of histories that exceed it at a level. Shaded: 95 % interval "
          "from the variance between " +
          units_name(results) + "."};
  Panel panel{"",
              {results.intensity_label, 0.0, results.levels.back()},
              {"Probability that slip in plan exceeds the clearance", 0.0, 1.0}};
  add_thresholds(panel, results, run);
  add_direct_labels(panel, run);
  panel.series.push_back({DataSeries::Kind::band, look(Role::largest), "",
                          std::string(are_a_few(run) ? "shaded" : "shaded and [ ]") +
                              ": 95 % interval over " + units_name(results) +
                              "; points: observed shares"});
  if (are_a_few(run))
    for (const ThresholdFragility& fragility : run.fragilities)
      figure.caption += " " + threshold_text(results, fragility) + ".";
  figure.panels = {std::move(panel)};
  figure.plot_height_px = 430;  // its caption is long
  return figure;
}

/// The coloured lines of the IDA figure.
struct Percentile {
  double share;
  Role role;
  const char* label;
};
constexpr std::array percentiles{Percentile{0.16, Role::p16, "16th percentile"},
                                 Percentile{0.50, Role::median, "median"},
                                 Percentile{0.84, Role::p84, "84th percentile"}};

/// Slips in plan at a level.
struct LevelSlips {
  std::vector<double> record_medians_m;                    // over the samples
  std::array<double, percentiles.size()> percentiles_m{};  // of all histories
};

LevelSlips slips_at(const HistoryTable& histories, CaseSlice cases, std::size_t level) {
  LevelSlips found;
  std::vector<double> all;
  for (std::size_t record = 0; record < histories.records; ++record) {
    std::vector<double> slips;
    for (std::size_t i = 0; i < cases.count; ++i) {
      const double slip_m = histories.displacement_m(record, cases.first + i, level);
      if (!std::isnan(slip_m)) slips.push_back(slip_m);
    }
    all.insert(all.end(), slips.begin(), slips.end());
    found.record_medians_m.push_back(quantile_of(std::move(slips), 0.5));
  }
  for (std::size_t k = 0; k < found.percentiles_m.size(); ++k)
    found.percentiles_m[k] = quantile_of(all, percentiles[k].share);
  return found;
}

Figure ida_figure(const Results& results, const RunResults& run) {
  const HistoryTable& slip = results.histories;
  Figure figure{"ida", "Incremental dynamic analysis: slip at increasing intensity",
                run_below(results, run),
                "Intensity (vertical) over peak slip in plan (horizontal), as is the convention of "
                "incremental dynamic analysis. Grey: each record's median over the samples. "
                "Coloured: 16th, 50th and 84th percentile over all histories (records and samples "
                "together) at each level. Dotted: the clearances. Friction " +
                    friction_and_listed(results, run) + "."};
  DataSeries records{DataSeries::Kind::line, look(Role::record), "records",
                     "each record, median over its samples"};
  std::vector<LevelSlips> slips(slip.levels);
  in_parallel(slip.levels,
              [&](std::size_t level) { slips[level] = slips_at(slip, slice_of(run), level); });
  for (std::size_t i = 0; i < slip.records; ++i) {
    for (std::size_t l = 0; l < slip.levels; ++l)
      records.add(slips[l].record_medians_m[i], results.levels.at(l));
    records.end_line();
  }
  Panel panel{"", {}, {results.intensity_label, 0.0, results.levels.back()}, {records}};
  double widest_m = results.thresholds_m.empty() ? 0.0 : results.thresholds_m.front();
  for (std::size_t k = 0; k < percentiles.size(); ++k) {
    const Percentile& p = percentiles[k];
    DataSeries series{DataSeries::Kind::line_and_points, look(p.role), p.label, p.label};
    series.y = results.levels;
    for (const LevelSlips& level : slips) {
      series.x.push_back(level.percentiles_m[k]);
      // Infinite: not run.
      if (std::isfinite(series.x.back()) && p.share >= 0.5)
        widest_m = std::max(widest_m, series.x.back());
    }
    panel.series.push_back(std::move(series));
  }
  panel.x = length_axis("Peak slip in plan", 1.3 * (widest_m > 0.0 ? widest_m : 1.0));
  for (const double threshold_m : results.thresholds_m) {
    panel.rules.push_back({Rule::Kind::vertical, threshold_m, look(Role::reference)});
    if (threshold_m >= panel.x.high) continue;
    const double height = 0.06 + 0.1 * static_cast<double>(panel.notes.size() % 3);  // side by side
    panel.notes.push_back({threshold_m, height * panel.y.high, short_length(threshold_m),
                           look(Role::reference).colour});
  }
  figure.labels_at_lines = true;
  figure.panels = {std::move(panel)};
  return figure;
}

}  // namespace glissade
