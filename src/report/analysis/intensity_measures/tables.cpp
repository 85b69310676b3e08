// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/intensity_measures/ranking.hpp"
#include "text/study_text.hpp"

namespace glissade {

std::vector<Ranking> rankings_of(const Results& results) {
  const std::vector<RankedMeasure>& rows = *results.intensity_measures;
  std::vector<Ranking> rankings;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t end = i + 1;
    while (end < rows.size() && rows[end].run == rows[i].run &&
           rows[end].threshold_m == rows[i].threshold_m)
      ++end;
    rankings.emplace_back(rows.data() + i, end - i);
    i = end;
  }
  return rankings;
}

Ranking shown_ranking(const Results& results) {
  std::vector<Ranking> of_first = rankings_of(results);
  std::erase_if(of_first, [&](const Ranking& ranking) {
    return ranking.front().run != results.intensity_measures->front().run;
  });
  return of_first[of_first.size() / 2];
}

bool is_insufficient(const RankedMeasure& row) {
  return row.magnitude_p < significant_p || row.distance_p < significant_p;
}

Table intensity_measures_table(const Results& results) {
  Table table{
      "intensity_measures",
      "Intensity measures by the dispersion of ln capacity between records, the best first. " +
          in_plan(results),
      {run_column,
       threshold_column,
       text_column("measure", "Intensity measure", "intensity measure, or two"),
       {"dispersion", "", "Dispersion [95 %]", ColumnKind::number,
        "standard deviation of the records' ln capacity in it", true},
       {"smallest_share", "", "Ranks first in", ColumnKind::share,
        "share of the resamples of the records in which it ranks first"},
       {"magnitude_slope", "", "Slope on M", ColumnKind::number,
        "slope of ln capacity on magnitude; nan: not known"},
       {"magnitude_p", "", "p", ColumnKind::number, "p-value of the slope on magnitude"},
       {"distance_slope", "", "Slope on ln R", ColumnKind::number,
        "slope of ln capacity on ln distance; nan: not known"},
       {"distance_p", "", "p", ColumnKind::number, "p-value of the slope on ln distance"},
       {"censored_records", "", "Records not reached", ColumnKind::count,
        "records of which half do not reach the threshold"},
       {"is_pair", "", "Two measures", ColumnKind::count, "1: of two measures"}},
      {}};
  for (Column& column : table.columns)
    column.detail = column.stem == "magnitude_slope" || column.stem == "distance_slope" ||
                    column.stem == "censored_records" || column.stem == "is_pair";
  for (const RankedMeasure& row : *results.intensity_measures)
    table.add({results.runs[row.run].label, row.threshold_m, row.name, row.dispersion,
               row.smallest_share, row.magnitude_slope, row.magnitude_p, row.distance_slope,
               row.distance_p, static_cast<double>(row.censored_records), row.pair ? 1.0 : 0.0});
  table.notes = {
      "Ranks first in: that share of the resamples of the records; equal measures do so together. "
      "Ties: where intervals overlap and none ranks first in nearly all resamples, these records "
      "do not show which measure is better.",
      "A and B: the dispersion in A that is left when the ratio of B to A (or the duration) is "
      "known too.",
      "p: that the slope of ln capacity on magnitude or ln distance is 0; below 0.05 the measure "
      "is not sufficient."};
  return with_listed(results, table);
}

}  // namespace glissade
