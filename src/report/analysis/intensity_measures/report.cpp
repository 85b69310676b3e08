// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/analyses.hpp"
#include "analysis/intensity_measures/ranking.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

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
             "only then does it not matter from which earthquakes the records are.") +
         wide_table(intensity_measures_table(results));
}

}  // namespace

AnalysisReport IntensityMeasuresAnalysis::in_report() {
  return {
      .is_in =
          [](const Results& results) {
            return results.intensity_measures && !results.intensity_measures->empty();
          },
      .summary = summary,
      .sentences = sentences,
      .figures =
          [](const Results& results) { return std::vector{intensity_measures_figure(results)}; },
      .tables =
          [](const Results& results) { return std::vector{intensity_measures_table(results)}; },
      .section = section};
}

}  // namespace glissade
