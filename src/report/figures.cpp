// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart/report.hpp"
#include "glissade/report/clearance_report.hpp"
#include "figure_text.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

std::string symbol_of_fit(const FitSummary& fit) {
  if (fit.status == FitStatus::always_exceeds) return "every history slides freely";
  if (fit.converged()) {
    const std::string free =
        fit.curve.floor > 0 ? format_share(fit.curve.floor) + " slide freely; the others: " : "";
    return fmt::format("{}median {} g [{}], log std {}", free, format_number(fit.curve.median),
                       format_interval(fit.median_interval), format_number(fit.curve.log_std));
  }
  if (fit.status == FitStatus::upper_bound) {
    return fmt::format("median below {} g (95 % bound; all exceed)",
                       format_number(fit.curve.median));
  }
  if (fit.status == FitStatus::lower_bound) {
    return fmt::format("median above {} g (95 % bound; no exceedance)",
                       format_number(fit.curve.median));
  }
  return "no curve could be fitted";
}

bool has_curve(const ThresholdFragility& fragility) {
  return fragility.capacities.converged() ||
         fragility.capacities.status == FitStatus::always_exceeds;
}

void add_fragility_data(gnuplot::DataBlocks& data, const Results& results, const RunResults& run,
                        std::size_t threshold, double largest_intensity) {
  const ThresholdFragility& fragility = run.fragilities[threshold];
  data.begin(fmt::format("observed {}", threshold), "intensity_g share share_low95 share_high95");
  for (std::size_t l = 0; l < fragility.probability.size(); ++l) {
    const Interval interval =
        l < fragility.probability_interval.size() ? fragility.probability_interval[l] : Interval{};
    data.row({results.levels.at(l), fragility.probability[l], interval.low, interval.high});
  }
  if (!has_curve(fragility)) return;
  data.begin(fmt::format("curve {}", threshold), "intensity_g probability");
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double x = largest_intensity * i / points;
    data.row({x, fragility.capacities.curve.probability(x)});
  }
  if (fragility.band.empty()) return;
  data.begin(fmt::format("band {}", threshold), "intensity_g low95 high95");
  for (std::size_t i = 0; i < fragility.band.size(); ++i) {
    data.row({run.band_intensities.at(i), fragility.band[i].low, fragility.band[i].high});
  }
}

}  // namespace

Figure fragility_figure(const Results& results, const RunResults& run) {
  const bool main_run = run.label == results.runs.front().label;
  Figure figure;
  figure.name = main_run ? "fragility" : "fragility_" + run.label;
  figure.title = "Chance that the array slips more than a clearance (" + run.label + " friction)";
  figure.caption =
      "Probability that the peak slip in plan exceeds each clearance at a given intensity, with "
      "friction " +
      run.friction_description +
      ". Lines: lognormal curves fitted to the lowest intensity at which each history reaches the "
      "clearance (histories that never reach "
      "it are treated as censored; the share that slides freely, without shaking, is in the curve "
      "at "
      "every intensity). Points: share of histories that exceed it at each level. "
      "Shaded: 95 % interval from "
      "resampling whole records, because histories of one record are not independent.";
  const double largest = results.levels.back();
  gnuplot::DataBlocks data;
  std::string bands, curves, points, key;
  const std::string file = quoted_file(figure.name);
  for (std::size_t t = 0; t < run.fragilities.size(); ++t) {
    const ThresholdFragility& fragility = run.fragilities[t];
    add_fragility_data(data, results, run, t, largest);
    const std::string colour = gnuplot::ramp_colour(t, run.fragilities.size());
    const int symbol = point_symbol(t);
    const bool drawn = has_curve(fragility);
    if (drawn && !fragility.band.empty()) {
      bands += fmt::format("  {} index 'band {}' using 1:2:3 with filledcurves fc rgb '{}', \\\n",
                           file, t, colour);
    }
    if (drawn) {
      curves += fmt::format("  {} index 'curve {}' using 1:2 with lines lw 2.5 lc rgb '{}', \\\n",
                            file, t, colour);
    }
    points +=
        fmt::format("  {} index 'observed {}' using 1:2 with points pt {} ps 0.8 lc rgb '{}', \\\n",
                    file, t, symbol, colour);
    key += fmt::format("  keyentry with {} lw 2.5 pt {} ps 0.8 lc rgb '{}' title {}, \\\n",
                       drawn ? "linespoints" : "points", symbol, colour,
                       gnuplot::quoted(format_length(fragility.threshold_m) + ": " +
                                       symbol_of_fit(fragility.capacities)));
  }
  figure.body =
      title_of(figure, counts_of(results) + "; " + friction_of(run)) +
      axis("x", results.intensity_label) +
      axis("y", "Probability that slip in plan exceeds the clearance") +
      fmt::format("set xrange [0:{}]\nset yrange [0:1]\nset ytics 0.1\n", largest) + "plot \\\n" +
      bands + curves + points + key +
      "  keyentry with filledcurves fc rgb '#777777' title "
      "'shaded and [ ]: 95 % interval from resampling whole records; points: observed shares'\n";
  figure.key_rows = static_cast<int>(run.fragilities.size()) + 1;
  figure.data = data.text();
  return figure;
}

Figure ida_figure(const Results& results, const RunResults& run) {
  const HistoryTable& slip = results.histories;
  Figure figure;
  figure.name = "ida";
  figure.title = "Incremental dynamic analysis: slip as the shaking grows";
  figure.caption =
      "Intensity (vertical) over peak slip in plan (horizontal), as is the convention of "
      "incremental dynamic analysis. Grey: each "
      "record's median over the samples. Coloured: 16th, 50th and 84th percentile over all "
      "histories (records and samples "
      "together) at each level. Dotted: the clearances. Friction " +
      run.friction_description + ".";
  gnuplot::DataBlocks data;
  data.begin("fractiles", "intensity_g p16_m p50_m p84_m");
  double widest_m = results.thresholds_m.empty() ? 0.0 : results.thresholds_m.front();
  for (std::size_t l = 0; l < slip.levels; ++l) {
    const std::vector<double> all = histories_at(slip, slice_of(run), 0, slip.records, l);
    data.row({results.levels.at(l), quantile_of(all, 0.16), quantile_of(all, 0.50),
              quantile_of(all, 0.84)});
    for (const double share : {0.50, 0.84}) {
      const double slip_m = quantile_of(all, share);
      if (std::isfinite(slip_m)) widest_m = std::max(widest_m, slip_m);  // infinite: not run
    }
  }
  data.begin("records", "record_median_m intensity_g");
  for (std::size_t i = 0; i < slip.records; ++i) {
    for (std::size_t l = 0; l < slip.levels; ++l) {
      data.row({quantile_of(histories_at(slip, slice_of(run), i, i + 1, l), 0.5), results.levels.at(l)});
    }
    data.break_line();
  }
  const double right_m = 1.25 * (widest_m > 0.0 ? widest_m : 1.0);
  const std::string file = quoted_file(figure.name);
  std::string lines;
  for (const double threshold_m : results.thresholds_m) {
    if (threshold_m > right_m) continue;
    lines += fmt::format(
        "set arrow from {0},graph 0 to {0},graph 1 nohead dt 3 lw 1.2 lc rgb '#555555' back\n",
        threshold_m);
  }
  figure.body =
      title_of(figure, counts_of(results) + "; " + friction_of(run)) + lines +
      axis("x", "Peak slip in plan (m)") + axis("y", results.intensity_label) +
      inches_beside("x", right_m) +
      fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", right_m, results.levels.back()) +
      fmt::format(
          "plot \\\n"
          "  {0} index 'records' using 1:2 with lines lw 1 lc rgb '#b0b0b0' title 'grey: each "
          "record, median over its "
          "samples', \\\n"
          "  {0} index 'fractiles' using 2:1 with linespoints pt 9 ps 0.6 lw 2.5 dt 2 lc rgb "
          "'#0072b2' title '16th "
          "percentile of all histories', \\\n"
          "  {0} index 'fractiles' using 3:1 with linespoints pt 7 ps 0.6 lw 3 lc rgb '#000000' "
          "title '50th percentile "
          "(median)', \\\n"
          "  {0} index 'fractiles' using 4:1 with linespoints pt 5 ps 0.6 lw 2.5 dt 4 lc rgb "
          "'#d55e00' title '84th "
          "percentile', \\\n"
          "  keyentry with lines dt 3 lw 1.2 lc rgb '#555555' title {1}\n",
          file, gnuplot::quoted("clearances: " + list_of_lengths(results.thresholds_m)));
  figure.key_rows = 5;
  figure.data = data.text();
  return figure;
}

Figure spectra_figure(const Results& results) {
  const SuiteSpectra& spectra = results.suites.front().spectra;
  const std::string scaled =
      spectra.reference_level > 0.0
          ? "scaled to S_DS = " + format_number(spectra.reference_level) + " g"
          : "scaled by the suite's own factors";
  Figure figure;
  figure.name = "spectra";
  figure.title = "Response spectra of the ground motions, " + scaled;
  figure.caption =
      "Pseudo-acceleration spectra at 5 % damping: square root of the sum of squares (SRSS) of the "
      "two horizontal components of each "
      "record (grey), their average" +
      std::string(spectra.target_g.empty() ? "" : ", and the target spectrum") +
      ". Suite: " + results.suites.front().name + ", " + scaled + ".";
  gnuplot::DataBlocks data;
  data.begin("suite",
             spectra.target_g.empty() ? "period_s average_g" : "period_s average_g target_g");
  double top_g = 0.0;
  for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
    std::vector<double> row = {spectra.periods_s[p], spectra.average_srss_g.at(p)};
    if (!spectra.target_g.empty()) row.push_back(spectra.target_g.at(p));
    top_g = std::max({top_g, row[1], row.back()});
    data.row(row);
  }
  data.begin("records", "period_s srss_g");
  for (const std::vector<double>& record : spectra.srss_g) {
    for (std::size_t p = 0; p < record.size(); ++p) data.row({spectra.periods_s.at(p), record[p]});
    data.break_line();
  }
  const std::string file = quoted_file(figure.name);
  figure.body =
      title_of(figure,
               fmt::format("suite {}; {} records", results.suites.front().name, results.records.size())) +
      axis("x", "Period (s)") + axis("y", "Spectral acceleration, 5 % damped, SRSS (g)") +
      fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", spectra.periods_s.back(), 2.0 * top_g) +
      fmt::format(
          "plot \\\n"
          "  {0} index 'records' using 1:2 with lines lw 1 lc rgb '#b0b0b0' title 'grey: each "
          "record, SRSS of its horizontal components', \\\n"
          "  {0} index 'suite' using 1:2 with lines lw 3 lc rgb '#0072b2' title 'average of the "
          "records'{1}\n",
          file,
          spectra.target_g.empty() ? ""
                                   : fmt::format(", \\\n  {} index 'suite' using 1:3 with lines lw "
                                                 "2.5 dt 2 lc rgb '#d55e00' title "
                                                 "'target (design spectrum)'",
                                                 file));
  figure.key_rows = spectra.target_g.empty() ? 2 : 3;
  figure.data = data.text();
  return figure;
}

std::vector<Figure> make_figures(const Results& results) {
  std::vector<Figure> figures;
  if (results.chart) figures = chart_figures(results);
  if (results.clearance) {
    for (Figure& figure : clearance_figures(clearance_results(results)))
      figures.push_back(std::move(figure));
  }
  if (!results.runs.empty() && !results.levels.empty()) {
    for (const RunResults& run : results.runs) {
      if (!run.fragilities.empty()) figures.push_back(fragility_figure(results, run));
    }
    const RunResults& main_run = results.runs.front();
    if (!main_run.slip.empty() && results.measure == IntensityMeasure::sds_g) {
      figures.push_back(slip_vs_sds_figure(results, main_run));
    }
    figures.push_back(ida_figure(results, main_run));
    if (!main_run.impact.empty()) {
      Figure impact = impact_figure(results, main_run);
      if (!impact.data.empty()) figures.push_back(std::move(impact));
    }
  }
  const bool has_spectra = std::ranges::any_of(
      figures, [](const Figure& figure) { return figure.name == FileName("spectra"); });
  if (!has_spectra) figures.push_back(spectra_figure(results));
  return figures;
}

}  // namespace glissade
