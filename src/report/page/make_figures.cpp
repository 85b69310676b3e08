// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/analyses.hpp"
#include "glissade/report/figures.hpp"
#include "text/study_text.hpp"

namespace glissade {

std::vector<Figure> make_figures(const Results& results) {
  std::vector<Figure> figures = collected(results, &AnalysisReport::figures);
  const bool has_spectra =
      !results.suites.empty() && !results.suites.front().spectra.periods_s.empty();
  const auto is_spectra = [](const Figure& figure) { return figure.name == FileName("spectra"); };
  if (has_spectra && std::ranges::none_of(figures, is_spectra))
    figures.push_back(spectra_figure(results));
  std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
  const auto add_below = [](Figure& figure, const std::string& text) {
    if (!text.empty()) figure.below += (figure.below.empty() ? "" : "; ") + text;
  };
  for (Figure& figure : figures) {
    if (!is_spectra(figure)) add_below(figure, one_axis_text(results));
    const std::string target = target_text(results, figure.title + figure.below);
    if (!target.empty()) add_below(figure, "target " + target);
  }
  return figures;
}

}  // namespace glissade
