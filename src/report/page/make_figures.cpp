// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/chart/report.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/figures.hpp"

namespace glissade {
namespace {

std::vector<Figure> fragility_figures(const Results& results) {
  std::vector<Figure> figures;
  if (results.runs.empty()) return figures;
  for (const RunResults& run : results.runs) figures.push_back(fragility_figure(results, run));
  const RunResults& run = results.runs.front();
  if (results.measure == IntensityMeasure::sds_g)
    figures.push_back(slip_vs_sds_figure(results, run));
  figures.push_back(ida_figure(results, run));
  if (!run.impact.empty()) figures.push_back(impact_figure(results, run));
  return figures;
}

void append(std::vector<Figure>& all, std::vector<Figure> more) {
  for (Figure& figure : more) {
    const auto same = [&](const Figure& f) { return f.name == figure.name; };
    if (!std::any_of(all.begin(), all.end(), same)) all.push_back(std::move(figure));
  }
}

}  // namespace

std::vector<Figure> make_figures(const Results& results) {
  std::vector<Figure> figures;
  if (results.clearance) append(figures, clearance_figures(clearance_results(results)));
  append(figures, fragility_figures(results));
  if (results.chart) append(figures, chart_figures(results));
  if (!results.suites.empty() && !results.suites.front().spectra.periods_s.empty())
    append(figures, {spectra_figure(results)});
  std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
  return figures;
}

}  // namespace glissade
