// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/intensity_measures/ranking.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

DataSeries points(std::size_t look, const std::string& label) {
  DataSeries series{DataSeries::Kind::points, distinct_look(look), label, label};
  series.look.symbol = 7;  // disc
  series.look.symbol_size = 1.1;
  return series;
}

}  // namespace

Figure intensity_measures_figure(const Results& results) {
  const Ranking ranking = shown_ranking(results);
  const RunResults& run = results.runs[ranking.front().run];
  Panel panel{"", {"Dispersion of ln capacity between records: smaller is better"}, {""}};
  DataSeries sufficient = points(0, "no dependence on magnitude or distance found"),
             insufficient = points(
                 1, fmt::format("depends on magnitude or distance (p < {:g})", significant_p)),
             bars{DataSeries::Kind::line, look(Role::record), "95 % interval over records",
                  "95 % interval over records"};
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

}  // namespace glissade
