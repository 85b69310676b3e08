// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analysis/shape/shape.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr ShapeModel first_model = ShapeModel::lognormal;

std::string models_text(const ThresholdShape& shape) {
  const auto best = best_model(shape);
  if (!best) return to_string(shape.status);
  if (*best == first_model) return "lognormal";
  return differs_clearly(shape, *best) ? model_name(*best) : "none clearly";
}

const char* against_lognormal(const ThresholdShape& shape, ShapeModel model) {
  const double difference = shape.difference[static_cast<std::size_t>(model)];
  if (model == first_model) return "";
  if (std::isnan(difference)) return "not fitted";
  if (!differs_clearly(shape, model)) return "no clear difference";
  return difference > 0.0 ? "better" : "worse";
}

}  // namespace

std::string model_name(ShapeModel model) {
  switch (model) {
    case ShapeModel::lognormal:
      return "lognormal";
    case ShapeModel::logit:
      return "logit";
    case ShapeModel::complementary_log_log:
      return "complementary log-log";
    case ShapeModel::two_part:
      return "two-part";
    case ShapeModel::monotone:
      return "monotone shares";
    case ShapeModel::one_surface:
      return "one surface";
  }
  return "";
}

std::optional<ShapeModel> best_model(const ThresholdShape& shape) {
  if (shape.score.empty()) return std::nullopt;
  std::size_t best = 0;
  for (std::size_t m = 1; m < shape.score.size(); ++m) {
    if (shape.score[m] > shape.score[best]) best = m;
  }
  return static_cast<ShapeModel>(best);
}

bool differs_clearly(const ThresholdShape& shape, ShapeModel model) {
  const auto m = static_cast<std::size_t>(model);
  return std::abs(shape.difference[m]) > 2.0 * shape.standard_error[m];
}

Table shape_table(const Results& results) {
  Table table{
      "shape",
      "Is a lognormal the right fragility? " + in_plan(results),
      {run_column,
       threshold_column,
       {"p_value", "", "Goodness of fit, p", ColumnKind::number,
        "goodness of fit of the lognormal; nan: no test", false, 3},
       {"largest_gap", "", "Observed - curve", ColumnKind::number,
        "largest difference of observed share and curve", false, 3},
       intensity_column(results, "gap_at", "there", "intensity at which the gap is largest"),
       text_column("best", "Best model", "best model, or why none was compared"),
       {"recrossed", "", "Recross", ColumnKind::share,
        "share of histories that reached the threshold at a lower level and do not here"},
       detail({"distance", "", "Distance", ColumnKind::number,
               "Cramer-von Mises distance of capacities and curve"}),
       detail({"correlation", "", "Correlation in a record", ColumnKind::number,
               "correlation of the normal scores of a record's capacities"})},
      {}};
  for (std::size_t r = 0; r < results.runs.size(); ++r) {
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      const GoodnessOfFit& fit = results.runs[r].fragilities[t].lognormal;
      const ThresholdShape& shape = results.shape->runs[r].thresholds[t];
      table.add({results.runs[r].label, shape.threshold_m, p_cell(fit.p_value), fit.largest_gap,
                 fit.gap_intensity, models_text(shape), std::ranges::max(shape.recrossed),
                 fit.distance, fit.correlation});
    }
  }
  table.notes = {
      "Not lognormal: p below 0.05 (Cramer-von Mises distance, parametric bootstrap, records as "
      "the unit) and a gap of 0.05 or more. Best model: by cross-validation over records. Recross: "
      "the largest share, over the levels, that reached the clearance at a lower level and does "
      "not there."};
  return with_listed(results, table);
}

Table shape_models_table(const Results& results) {
  Table table{
      "shape_models",
      "Models compared by cross-validation: ln of the probability that a model fitted on "
      "the other records gives to a record, per history and level. Higher is better.",
      {run_column,
       threshold_column,
       text_column("model", "Model", "model"),
       {"score", "", "Score", ColumnKind::number,
        "ln probability of a record by the model fitted on the others, per history and level",
        false, 4},
       {"difference", "", "To lognormal", ColumnKind::number, "score less that of the lognormal",
        false, 4},
       {"standard_error", "", "Standard error", ColumnKind::number,
        "standard error of the difference, over records", false, 4},
       text_column("against", "Against lognormal", "verdict against the lognormal")},
      {}};
  for (const ShapeRun& run : results.shape->runs) {
    for (const ThresholdShape& shape : run.thresholds) {
      for (std::size_t m = 0; m < shape.score.size(); ++m) {
        const auto model = static_cast<ShapeModel>(m);
        table.add({run.label, shape.threshold_m, model_name(model), shape.score[m],
                   shape.difference[m], shape.standard_error[m],
                   std::string(against_lognormal(shape, model))});
      }
    }
  }
  table.notes = {"Better, worse: by more than two standard errors over records."};
  return with_listed(results, table);
}

Table shape_levels_table(const Results& results) {
  Table table{"shape_levels",
              "Observed share, fitted probability of each model and recrossings, by level. "
              "Histories that slide freely are in the observed share only.",
              {run_column,
               threshold_column,
               level_column(results),
               {"observed", "", "Observed", ColumnKind::share, "observed share"}},
              {}};
  constexpr const char* stems[] = {"lognormal", "logit",    "complementary_log_log",
                                   "two_part",  "monotone", "one_surface"};
  static_assert(std::size(stems) == shape_model_count);
  for (std::size_t m = 0; m < shape_model_count; ++m)
    table.columns.push_back({stems[m], "", model_name(static_cast<ShapeModel>(m)),
                             ColumnKind::share,
                             "probability by the model " + model_name(static_cast<ShapeModel>(m)) +
                                 ", fitted on all records"});
  table.columns.push_back(
      {"recrossed", "", "Recross", ColumnKind::share,
       "share of histories that reached the threshold at a lower level and do not here"});
  for (std::size_t r = 0; r < results.runs.size(); ++r) {
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      const ThresholdShape& shape = results.shape->runs[r].thresholds[t];
      for (std::size_t level = 0; level < results.levels.size(); ++level) {
        std::vector<Cell> row{results.runs[r].label, shape.threshold_m, results.levels[level],
                              results.runs[r].fragilities[t].probability[level]};
        for (std::size_t m = 0; m < shape_model_count; ++m)
          row.emplace_back(shape.probability_at(static_cast<ShapeModel>(m), level));
        row.emplace_back(shape.recrossed[level]);
        table.add(std::move(row));
      }
    }
  }
  return with_listed(results, table);
}

Table shape_crossings_table(const Results& results) {
  Table table{
      "shape_crossings",
      "Where the lognormals of neighbouring clearances cross: on one side of it the larger "
      "clearance would be exceeded with the higher probability.",
      {run_column,
       threshold_column,
       {"next_threshold", "m", "Next, m (in)", ColumnKind::length, "the next larger threshold"},
       intensity_column(results, "intensity", "Cross at", "where their lognormals cross"),
       {"probability", "", "Probability there", ColumnKind::share,
        "probability of both where they cross"},
       text_column("within", "Between the levels",
                   "whether they cross between the lowest and the highest level")},
      {}};
  for (const ShapeRun& run : results.shape->runs) {
    for (const ShapeCrossing& c : run.crossings)
      table.add({run.label, c.threshold_m, c.next_threshold_m, c.intensity, c.probability,
                 std::string(c.within_levels ? "yes" : "no")});
  }
  return with_listed(results, table);
}

Table shape_surface_table(const Results& results) {
  Table table{"shape_surface",
              "Fitted jointly: lognormals of all clearances with one log std, which never cross, "
              "beside the separate fits.",
              {run_column,
               threshold_column,
               intensity_column(results, "median", "Joint median",
                                "median with one log_std for all thresholds", true),
               {"log_std", "", "Joint log std [95 %]", ColumnKind::number,
                "the one logarithmic standard deviation of all thresholds", true},
               intensity_column(results, "separate_median", "Separate median",
                                "median of the separate fit"),
               {"separate_log_std", "", "Separate log std", ColumnKind::number,
                "logarithmic standard deviation of the separate fit"}},
              {}};
  for (std::size_t r = 0; r < results.runs.size(); ++r) {
    const ShapeRun& run = results.shape->runs[r];
    for (const SurfaceMedian& row : run.surface) {
      const auto of = std::ranges::find(results.runs[r].fragilities, row.threshold_m,
                                        &ThresholdFragility::threshold_m);
      if (of == results.runs[r].fragilities.end()) continue;
      table.add({run.label, row.threshold_m, row.median, run.surface_log_std,
                 of->capacities.curve.median, of->capacities.curve.log_std});
    }
  }
  return with_listed(results, table);
}

}  // namespace glissade
