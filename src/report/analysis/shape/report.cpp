// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/shape/shape.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string threshold_sentence(const Results& results, const ThresholdFragility& fragility,
                               const ThresholdShape& shape) {
  const GoodnessOfFit& fit = fragility.lognormal;
  std::string text = format_length(fragility.threshold_m) + ": ";
  if (std::isnan(fit.p_value)) {
    text += "no test of the lognormal";
  } else if (departs_from_lognormal(fit)) {
    text += fmt::format("not lognormal ({}): the observed share is {:.2f} {} the curve at {}",
                        format_p(fit.p_value), std::abs(fit.largest_gap),
                        fit.largest_gap > 0.0 ? "above" : "below",
                        at_intensity(results, fit.gap_intensity));
  } else {
    text += fmt::format("lognormal within {:.2f} ({})", std::abs(fit.largest_gap),
                        format_p(fit.p_value));
  }
  const auto best = best_model(shape);
  if (!best) return text + "; models not compared: " + to_string(shape.status) + ".";
  if (*best == ShapeModel::lognormal) return text + "; no other model predicts better.";
  return text + fmt::format(
                    "; best predicted by {}{}.", model_name(*best),
                    differs_clearly(shape, *best) ? "" : ", not clearly better than the lognormal");
}

/// In the tails, below 0.1 % and above 99.9 %, crossings change nothing.
std::string crossing_sentence(const Results& results, const ShapeRun& run) {
  std::string text;
  for (const ShapeCrossing& c : run.crossings) {
    if (!c.within_levels || std::min(c.probability, 1.0 - c.probability) < 1e-3) continue;
    text += fmt::format("{}{} and {} at {} (probability {})", text.empty() ? "" : "; ",
                        format_length(c.threshold_m), format_length(c.next_threshold_m),
                        at_intensity(results, c.intensity), format_share(c.probability));
  }
  if (text.empty())
    return "Between the levels no lognormals of neighbouring clearances cross, from 0.1 to 99.9 %.";
  return "Lognormals of neighbouring clearances cross: " + text +
         ". Fitted jointly they do not: tables/shape_surface.csv.";
}

std::vector<std::string> sentences(const Results& results) {
  std::vector<std::string> all;
  const ShapeRun& run = results.shape->runs.front();
  for (std::size_t t = 0; t < run.thresholds.size(); ++t)
    all.push_back(
        threshold_sentence(results, results.runs.front().fragilities[t], run.thresholds[t]));
  all.push_back(crossing_sentence(results, run));
  return all;
}

std::string summary(const Results& results) {
  return to_text(without_run_key(results, shape_table(results)).first_rows(12, "shape")) + "\n" +
         wrapped(crossing_sentence(results, results.shape->runs.front()));
}

Html section(const Results& results) {
  const Table crossings = shape_crossings_table(results);
  return heading("Shape of the fragilities") +
         wide_table(without_run_key(results, shape_table(results))) +
         wide_table(without_run_key(results, shape_models_table(results))) +
         (crossings.rows.empty() ? Html() : wide_table(without_run_key(results, crossings))) +
         wide_table(without_run_key(results, shape_surface_table(results))) +
         paragraph("Every level, with the share of recrossings: tables/shape_levels.csv.");
}

}  // namespace

AnalysisReport ShapeAnalysis::in_report() {
  return {
      .is_in = [](const Results& results) { return results.shape && !results.shape->runs.empty(); },
      .summary = summary,
      .sentences = sentences,
      .figures = each<shape_figure>,
      .tables = each<shape_table, shape_models_table, shape_levels_table, shape_crossings_table,
                     shape_surface_table>,
      .section = section};
}

}  // namespace glissade
