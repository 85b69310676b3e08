// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "clearance/family_figures.hpp"
#include "clearance/view.hpp"
#include "figure_text.hpp"
#include "glissade/report/clearance_report.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

/// Walters et al. (2012), Fig. 8.
Figure spectra_figure(const ClearanceResults& results) {
  const SuiteSummary& suite = results.suites.front();
  const SuiteSpectra& spectra = suite.spectra;
  const bool has_target = !spectra.target_g.empty();
  Figure figure;
  figure.name = "spectra";
  figure.title = "Response spectra of the suite, scaled to MCE";
  figure.caption =
      "Pseudo-acceleration spectra at 5 % damping: square root of the sum of squares (SRSS) of the "
      "two horizontal components of each record times its factor (grey), and their average";
  figure.caption += has_target ? ", beside the target MCE spectrum." : ".";
  gnuplot::DataBlocks data;
  data.begin("suite", has_target ? "period_s average_g target_g" : "period_s average_g");
  double top_g = 0.0;
  for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
    std::vector<double> row{spectra.periods_s[p], spectra.average_srss_g[p]};
    if (has_target) row.push_back(spectra.target_g[p]);
    top_g = std::max(top_g, row[1]);
    data.row(row);
  }
  data.begin("records", "period_s srss_g");
  for (const std::vector<double>& record : spectra.srss_g) {
    for (std::size_t p = 0; p < record.size(); ++p) data.row({spectra.periods_s[p], record[p]});
    data.break_line();
  }
  const std::string file = quoted_file(figure.name);
  figure.body =
      title_of(figure, fmt::format("suite {}; {} records", suite.name, spectra.srss_g.size())) +
      axis("x", "Period (s)") + axis("y", "Spectral acceleration, 5 % damped, SRSS (g)") +
      fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", spectra.periods_s.back(), 2.2 * top_g) +
      fmt::format(
          "plot \\\n  {0} index 'records' using 1:2 with lines lw 1 lc rgb '#b0b0b0' title 'grey: "
          "each record, SRSS of its horizontal components', \\\n  {0} index 'suite' using 1:2 with "
          "lines lw 3 lc rgb '#0072b2' title 'average of the records'",
          file);
  figure.key_rows = 2;
  if (has_target) {
    figure.body += fmt::format(
        ", \\\n  {} index 'suite' using 1:3 with lines lw 2.5 dt 2 lc rgb '#d55e00' title 'target "
        "MCE spectrum, envelope over the site classes'",
        file);
    ++figure.key_rows;
  }
  figure.body += "\n";
  figure.data = data.text();
  return figure;
}

}  // namespace

std::vector<Figure> clearance_figures(const ClearanceResults& results) {
  std::vector<Figure> figures;
  const auto add = [&](ClearanceTopic topic, Figure (*draw)(const ClearanceResults&)) {
    if (can_tell(results, topic)) figures.push_back(draw(results));
  };
  add(ClearanceTopic::spectra, spectra_figure);
  add(ClearanceTopic::period, period_figure);
  if (can_tell(results, ClearanceTopic::orientation)) {
    if (const auto figure = orientation_figure(results)) figures.push_back(*figure);
  }
  add(ClearanceTopic::level, level_figure);
  add(ClearanceTopic::yielding, yielding_figure);
  add(ClearanceTopic::base_shear, base_shear_figure);
  if (place_of(results.grid, ArraySupport::no_array))
    add(ClearanceTopic::base_shear, base_shear_ratio_figure);
  add(ClearanceTopic::slope, slope_figure);
  add(ClearanceTopic::mce, mce_figure);
  add(ClearanceTopic::vertical, vertical_figure);
  return figures;
}

}  // namespace glissade
