// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/chart/report.hpp"

#include "analysis/analyses.hpp"
#include "analysis/standards/section.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

Html section(const Results& results) {
  constexpr std::size_t most = 16;
  Html html = heading("Design chart");
  if (!results.chart->readings.empty()) html += wide_table(chart_answers_table(results));
  return html + standards_html(results, chart_standards_table(results)) +
         heading("The chart in numbers") + wide_table(chart_matrix_table(results, most)) +
         paragraph(
             "Every level, slope and coefficient of friction, to interpolate in: "
             "tables/chart.csv.");
}

}  // namespace

AnalysisReport ChartAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.chart.has_value(); },
          .summary = chart_summary,
          .sentences = chart_sentences,
          .figures = chart_figures,
          .tables = chart_csv_tables,
          .section = section};
}

}  // namespace glissade
