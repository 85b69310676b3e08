// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figure_text.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

/// The comparisons of one standard, in order of level.
std::vector<StandardComparison> comparisons_of(const RunResults& run, Standard standard) {
  std::vector<StandardComparison> found;
  for (const StandardComparison& comparison : run.standards) {
    if (comparison.standard == standard) found.push_back(comparison);
  }
  return found;
}

bool any_with(const std::vector<StandardComparison>& comparisons, Provenance provenance) {
  return std::any_of(comparisons.begin(), comparisons.end(),
                     [&](const auto& c) { return c.prescribed.provenance == provenance; });
}

struct StandardStyle {
  Standard standard;
  const char* colour;
  int filled, hollow;  ///< point types
  double size;
  const char* line;
};

/// Adds one standard's block and its plot lines: a line through all, filled points where checked,
/// hollow where recalled.
int add_standard(const RunResults& run, const StandardStyle& style, const std::string& file,
                 gnuplot::DataBlocks& data, std::string& plot) {
  const auto comparisons = comparisons_of(run, style.standard);
  if (comparisons.empty()) return 0;
  const std::string name = standard_name(style.standard);
  data.begin(name, "sds_g prescribed_m recalled(0|1)");
  for (const StandardComparison& c : comparisons) {
    data.row({c.sds_g, c.prescribed.value_m,
              c.prescribed.provenance == Provenance::recalled ? 1.0 : 0.0});
  }
  plot += fmt::format(", \\\n  {} index '{}' using 1:2 with lines {} lc rgb '{}'", file, name,
                      style.line, style.colour);
  int rows = 0;
  const auto points = [&](Provenance provenance, int flag, int symbol, const char* what) {
    if (!any_with(comparisons, provenance)) return;
    plot += fmt::format(
        ", \\\n  {0} index '{1}' using 1:($3=={2} ? $2 : NaN) with points pt {3} ps {6} lc rgb "
        "'{4}', \\\n"
        "  keyentry with linespoints {7} pt {3} ps {6} lc rgb '{4}' title '{1}, prescribed{5}'",
        file, name, flag, symbol, style.colour, what, style.size, style.line);
    ++rows;
  };
  points(Provenance::checked, 0, style.filled, "");
  points(Provenance::recalled, 1, style.hollow, " (hollow: recalled, verify against the standard)");
  return rows;
}

}  // namespace

Figure slip_vs_sds_figure(const Results& results, const RunResults& run) {
  Figure figure;
  figure.name = "slip_vs_sds";
  figure.title = run.standards.empty()
                     ? "Slip as the design shaking grows"
                     : "Slip as the design shaking grows, and what the standards prescribe";
  figure.caption =
      "Peak slip in plan over all histories at each S_DS: median, 84th and 95th percentile and "
      "mean; shaded: 95 % intervals of the "
      "median and of the 84th percentile from resampling whole records. Friction " +
      run.friction_description + ".";
  if (!run.standards.empty()) {
    figure.caption +=
        " Grey and black with points: displacements prescribed by the standards; hollow points "
        "rest on provisions recalled from memory and must be "
        "verified against the standard. Where they leave the figure at the top, "
        "tables/standards.csv has them.";
  }
  gnuplot::DataBlocks data;
  data.begin("slip",
             "sds_g median_m median_low95 median_high95 p84_m p84_low95 p84_high95 p95_m mean_m");
  double top_m = 0.0;
  for (const SlipStatistics& s : run.slip) {
    for (const double slip : {s.median_m, s.p84_m, s.p95_m, s.mean_m})
      if (std::isfinite(slip)) top_m = std::max(top_m, slip);  // infinite: beyond, and not run
  }
  // A band whose upper end is infinite leaves the figure at the top.
  const auto shown = [&](double limit_m) { return std::isinf(limit_m) ? 10.0 * top_m : limit_m; };
  for (const SlipStatistics& s : run.slip) {
    data.row({s.level, s.median_m, shown(s.median_interval.low), shown(s.median_interval.high),
              s.p84_m, shown(s.p84_interval.low), shown(s.p84_interval.high), s.p95_m, s.mean_m});
  }
  // The prescribed values may leave the figure at the top: slip must stay readable.
  double prescribed_m = 0.0;
  for (const StandardComparison& c : run.standards)
    prescribed_m = std::max(prescribed_m, c.prescribed.value_m);
  top_m = std::max(top_m, std::min(prescribed_m, 1.8 * top_m));
  const std::string file = quoted_file(figure.name);
  std::string plot = fmt::format(
      "plot \\\n"
      "  {0} index 'slip' using 1:6:7 with filledcurves fc rgb '#d55e00', \\\n"
      "  {0} index 'slip' using 1:3:4 with filledcurves fc rgb '#0072b2', \\\n"
      "  {0} index 'slip' using 1:8 with lines lw 2 dt 2 lc rgb '#cc79a7' title '95th percentile "
      "of slip', \\\n"
      "  {0} index 'slip' using 1:5 with lines lw 2.5 lc rgb '#d55e00' title '84th percentile "
      "(shaded: 95 % interval, "
      "records resampled)', \\\n"
      "  {0} index 'slip' using 1:9 with lines lw 2 dt 3 lc rgb '#009e73' title 'mean', \\\n"
      "  {0} index 'slip' using 1:2 with lines lw 2.5 lc rgb '#0072b2' title 'median (shaded: 95 % "
      "interval)'",
      file);
  const double shown_m = top_m > 0.0 ? 1.05 * top_m : 1.0;
  // The two standards agree over a wide range: the wide grey one lies below the narrow black one.
  figure.key_rows = 4;
  figure.key_rows +=
      add_standard(run, {Standard::asce7_16, "#999999", 5, 4, 1.5, "lw 5 dt 1"}, file, data, plot);
  figure.key_rows += add_standard(
      run, {Standard::seaoc_pv1_2012, "#000000", 7, 6, 0.8, "lw 1.5 dt 5"}, file, data, plot);
  figure.body =
      title_of(figure, counts_of(results) + "; " + friction_of(run)) +
      axis("x", results.intensity_label) + axis("y", "Peak slip in plan (m)") +
      inches_beside("y", shown_m) +
      fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", results.levels.back(), shown_m) + plot +
      "\n";
  figure.data = data.text();
  return figure;
}

}  // namespace glissade
