// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/analyses.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Below it a measure is called insufficient.
constexpr double significant_p = 0.05;

/// The rows of one run and threshold, the best first.
using Ranking = std::span<const RankedMeasure>;

std::vector<Ranking> rankings_of(const Results& results) {
  return groups_of(*results.intensity_measures, [](const RankedMeasure& a, const RankedMeasure& b) {
    return a.run == b.run && a.threshold_m == b.threshold_m;
  });
}

/// The one that the figure shows: of the first run the middle threshold of those that are ranked.
Ranking shown_ranking(const Results& results) {
  std::vector<Ranking> of_first = rankings_of(results);
  std::erase_if(of_first, [&](const Ranking& ranking) {
    return ranking.front().run != results.intensity_measures->front().run;
  });
  return of_first[of_first.size() / 2];
}

/// Whether it is known that ln capacity in it depends on magnitude or distance.
bool is_insufficient(const RankedMeasure& row) {
  return row.magnitude_p < significant_p || row.distance_p < significant_p;
}

Table intensity_measures_table(const Results& results) {
  using M = RankedMeasure;
  TableOf<RunResults, M> t(
      "intensity_measures",
      "Intensity measures by the dispersion of ln capacity between records, the best first. " +
          in_plan(results));
  t.put_all(run_column, threshold_column);
  t.text("measure", "Intensity measure", "intensity measure, or two", &M::name);
  t.number("dispersion", "Dispersion", "standard deviation of the records' ln capacity in it",
           &M::dispersion);
  t.share("smallest_share", "Ranks first in",
          "share of the resamples of the records in which it ranks first", &M::smallest_share);
  t.number("magnitude_slope", "Slope on M", "slope of ln capacity on magnitude; nan: not known",
           &M::magnitude_slope)
      .detail = true;
  t.number("magnitude_p", "p", "p-value of the slope on magnitude", &M::magnitude_p);
  t.number("distance_slope", "Slope on ln R", "slope of ln capacity on ln distance; nan: not known",
           &M::distance_slope)
      .detail = true;
  t.number("distance_p", "p", "p-value of the slope on ln distance", &M::distance_p);
  t.count("censored_records", "Records not reached",
          "records of which half do not reach the threshold", &M::censored_records)
      .detail = true;
  t.count("is_pair", "Two measures", "1: of two measures", &M::pair).detail = true;
  for (const M& row : *results.intensity_measures) t.add(results.runs[row.run], row);
  t.notes = {
      "Ranks first in: that share of the resamples of the records; equal measures do so together. "
      "Ties: where intervals overlap and none ranks first in nearly all resamples, these records "
      "do not show which measure is better.",
      "A and B: the dispersion in A that is left when the ratio of B to A (or the duration) is "
      "known too.",
      "p: that the slope of ln capacity on magnitude or ln distance is 0; below 0.05 the measure "
      "is not sufficient."};
  return with_listed(results, t);
}

DataSeries points(std::size_t look, const std::string& label) {
  DataSeries series{DataSeries::Kind::points, distinct_look(look), label, label};
  series.look.symbol = 7;  // disc
  series.look.symbol_size = 1.1;
  return series;
}

Figure intensity_measures_figure(const Results& results) {
  const Ranking ranking = shown_ranking(results);
  const RunResults& run = results.runs[ranking.front().run];
  Panel panel{"", {"Dispersion of ln capacity between records: smaller is better"}, {""}};
  DataSeries sufficient = points(0, "no dependence on magnitude or distance found"),
             insufficient = points(
                 1, fmt::format("depends on magnitude or distance (p < {:g})", significant_p)),
             bars{DataSeries::Kind::line, look(Role::record),
                  "95 % interval over " + units_name(results),
                  "95 % interval over " + units_name(results)};
  bars.look.width = 4.0;
  double right = 0.0;
  for (std::size_t i = 0; i < ranking.size(); ++i) {
    const RankedMeasure& row = ranking[i];
    const double y = -static_cast<double>(i);
    DataSeries& at = is_insufficient(row) ? insufficient : sufficient;
    at.add(row.dispersion.value, y);
    bars.add(row.dispersion.interval.low, y);
    bars.add(row.dispersion.interval.high, y);
    bars.end_line();
    panel.y.ticks.push_back({y, row.name});
    right = std::max({right, row.dispersion.value, row.dispersion.interval.high});
  }
  panel.x.high = 1.05 * std::min(right, 3.0 * ranking.back().dispersion.value);
  panel.y.low = -static_cast<double>(ranking.size());
  panel.y.high = 1.0;
  panel.y.values = Axis::Values::names;
  panel.series = {std::move(bars), std::move(sufficient), std::move(insufficient)};
  Figure figure{
      "intensity_measures",
      "Intensity measures ranked by dispersion, for slip of " +
          format_length(ranking.front().threshold_m),
      run_below(results, run),
      "Capacity: the intensity at which half the samples of a record reach that displacement. A "
      "small dispersion means that a few records suffice. Of Arias intensity the square root "
      "counts, so that all measures grow with the motion alike. Of two measures: the first, given "
      "the second. Other clearances: tables/intensity_measures.csv."};
  figure.panels = {std::move(panel)};
  figure.plot_height_px = 200 + 26 * static_cast<int>(figure.panels[0].y.ticks.size());
  return figure;
}

/// With the names of all that are equal to it.
std::string with_dispersion(const Ranking& ranking, const RankedMeasure& row) {
  std::vector<std::string> names;
  for (const RankedMeasure& other : ranking)
    if (other.dispersion.value == row.dispersion.value) names.push_back(other.name);
  return fmt::format("{} ({:.3g} [{}])", fmt::join(names, " = "), row.dispersion.value,
                     format_interval(row.dispersion.interval));
}

std::vector<std::string> sentences(const Results& results) {
  std::vector<std::string> all;
  for (const Ranking& ranking : rankings_of(results)) {
    const RankedMeasure& first = ranking.front();
    if (first.run != 0) continue;
    all.push_back(fmt::format(
        "Intensity measures, slip of {}: the dispersion of ln capacity between records is smallest "
        "in {}, which ranks first in {} of the resamples of the records, and largest in {}. {} "
        "of {} measures depend on magnitude or distance (p < {:g}).",
        format_length(first.threshold_m), with_dispersion(ranking, first),
        format_share(first.smallest_share), with_dispersion(ranking, ranking.back()),
        std::count_if(ranking.begin(), ranking.end(), is_insufficient), ranking.size(),
        significant_p));
  }
  return all;
}

/// Of the figure alone.
Table shown_table(const Results& results) {
  const Ranking ranking = shown_ranking(results);
  Table table = intensity_measures_table(results);
  const auto first =
      static_cast<std::ptrdiff_t>(ranking.data() - results.intensity_measures->data());
  table.rows = {table.rows.begin() + first,
                table.rows.begin() + first + static_cast<std::ptrdiff_t>(ranking.size())};
  return table.without("run").without("threshold");
}

std::string summary(const Results& results) {
  return paragraphs(sentences(results)) + "\n" + to_text(shown_table(results));
}

Html section(const Results& results) {
  return heading("Intensity measures") +
         paragraph(
             "How well each intensity measure predicts the slip, from the same histories: a "
             "capacity in one measure is one in any other of the same scaled record. The "
             "dispersion between records decides how many records a fragility needs. A measure "
             "is sufficient where the capacity in it does not depend on magnitude and distance: "
             "only then does it not matter from which earthquakes the records are. The tests of "
             "that "
             "(p) take each record as independent.") +
         wide_table(intensity_measures_table(results));
}

}  // namespace

AnalysisReport IntensityMeasuresAnalysis::in_report() {
  return {.is_in =
              [](const Results& results) {
                return results.intensity_measures && !results.intensity_measures->empty();
              },
          .summary = summary,
          .sentences = sentences,
          .figures = each<intensity_measures_figure>,
          .tables = each<intensity_measures_table>,
          .section = section};
}
}  // namespace glissade
