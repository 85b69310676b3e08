// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/chart/report.hpp"
#include "glissade/report/figures.hpp"

namespace glissade {
namespace {

std::vector<Figure> study_figures(const Results& results) {
  std::vector<Figure> figures;
  if (results.runs.empty() || results.levels.empty()) return figures;
  for (const RunResults& run : results.runs) {
    if (!run.fragilities.empty()) figures.push_back(fragility_figure(results, run));
  }
  const RunResults& run = results.runs.front();
  if (!run.slip.empty() && results.measure == IntensityMeasure::sds_g)
    figures.push_back(slip_vs_sds_figure(results, run));
  if (!run.peak_displacement_m.data.empty()) figures.push_back(ida_figure(results, run));
  if (!run.impact.empty()) figures.push_back(impact_figure(results, run));
  return figures;
}

}  // namespace

std::vector<Figure> make_figures(const Results& results) {
  std::vector<Figure> figures = results.chart ? chart_figures(results) : study_figures(results);
  if (!results.spectra.periods_s.empty()) figures.push_back(spectra_figure(results));
  std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
  return figures;
}

}  // namespace glissade
