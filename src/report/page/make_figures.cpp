// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "analysis/analyses.hpp"
#include "glissade/report/figures.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Those of a figure in its first panel, each with its source in the key. The axes reach to them.
void add_published(const std::vector<PublishedPoint>& points, Figure& figure) {
  constexpr int open_symbols[] = {12, 4, 6, 8, 10};  // of gnuplot
  std::size_t count = 0;
  for (const PublishedPoint& point : points) {
    if (figure.name != FileName(point.figure)) continue;
    Panel& panel = figure.panels.front();
    Look of_point = look(Role::published);
    of_point.symbol = open_symbols[count++ % std::size(open_symbols)];
    DataSeries series{DataSeries::Kind::points, of_point, point.source, point.source};
    series.add(point.x, point.y);
    series.end_line();
    panel.series.push_back(std::move(series));
    panel.x.low = std::min(panel.x.low, point.x);
    panel.x.high = std::max(panel.x.high, point.x);
    constexpr double room = 1.08;
    if (room * point.y <= panel.y.high) continue;
    if (panel.y.length.empty())
      panel.y.high = point.y;
    else
      panel.y = length_axis(panel.y.length, room * point.y);
  }
}

}  // namespace

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
    add_published(results.published, figure);
    if (!is_spectra(figure)) add_below(figure, one_axis_text(results));
    const std::string target = target_text(results, figure.suite);
    if (!target.empty()) add_below(figure, "target " + target);
  }
  return figures;
}

}  // namespace glissade
