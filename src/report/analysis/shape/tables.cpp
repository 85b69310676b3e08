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

/// A row of what the results and the analysis of the shape have of each run and threshold, and of
/// one of its levels or models.
using ShapeTable = TableOf<RunResults, ThresholdFragility, ThresholdShape, std::size_t>;

void add_each(ShapeTable& t, const Results& results, std::size_t count) {
  for (std::size_t r = 0; r < results.runs.size(); ++r)
    for (std::size_t k = 0; k < results.thresholds_m.size(); ++k)
      for (std::size_t i = 0; i < count; ++i)
        t.add(results.runs[r], results.runs[r].fragilities[k], results.shape->runs[r].thresholds[k],
              i);
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
  using F = ThresholdFragility;
  ShapeTable t("shape", "Is a lognormal the right fragility? " + in_plan(results));
  t.put_all(run_column, threshold_column);
  t.number("p_value", "Goodness of fit, p", "goodness of fit of the lognormal; nan: no test",
           [](const F& of) { return Cell(p_cell(of.lognormal.p_value)); })
      .decimals = 3;
  t.number("largest_gap", "Observed - curve", "largest difference of observed share and curve",
           [](const F& of) { return of.lognormal.largest_gap; })
      .decimals = 3;
  t.put_all(intensity_column(results, "gap_at", "there", "intensity at which the gap is largest",
                             [](const F& of) { return of.lognormal.gap_intensity; }));
  t.text("best", "Best model", "best model, or why none was compared", models_text);
  t.share("recrossed", "Recross",
          "share of histories that reached the threshold at a lower level and do not here",
          [](const ThresholdShape& shape) { return std::ranges::max(shape.recrossed); });
  t.number("distance", "Distance", "Cramer-von Mises distance of capacities and curve",
           [](const F& of) { return of.lognormal.distance; })
      .detail = true;
  t.number("correlation", "Correlation in a record",
           "correlation of the normal scores of a record's capacities",
           [](const F& of) { return of.lognormal.correlation; })
      .detail = true;
  add_each(t, results, 1);
  t.notes = {
      "Not lognormal: p below 0.05 (Cramer-von Mises distance, parametric bootstrap over " +
      units_name(results) + ") and a gap of 0.05 or more. Best model: by cross-validation over " +
      units_name(results) +
      ". Recross: the largest share, over the levels, that reached the clearance at a lower level "
      "and does not there. Of lognormal curves one in twenty has p below 0.05 by chance."};
  return with_listed(results, t);
}

Table shape_models_table(const Results& results) {
  using S = ThresholdShape;
  TableOf<ShapeRun, S, ShapeModel> t(
      "shape_models",
      "Models compared by cross-validation: ln of the probability that a model fitted on "
      "the other records gives to a record, per history and level. Higher is better.");
  t.put_all(run_column, threshold_column);
  t.text("model", "Model", "model", model_name);
  const auto number = [&](const char* stem, const char* heading, const char* description,
                          std::vector<double> S::*values) {
    t.number(stem, heading, description, [=](const ShapeRun&, const S& shape, ShapeModel model) {
       return (shape.*values)[static_cast<std::size_t>(model)];
     }).decimals = 4;
  };
  number("score", "Score",
         "ln probability of a record by the model fitted on the others, per history and level",
         &S::score);
  number("difference", "To lognormal", "score less that of the lognormal", &S::difference);
  number("standard_error", "Standard error",
         "standard error of the difference, over records or events", &S::standard_error);
  t.text("against", "Against lognormal", "verdict against the lognormal",
         [](const ShapeRun&, const S& shape, ShapeModel model) {
           return against_lognormal(shape, model);
         });
  for (const ShapeRun& run : results.shape->runs)
    for (const S& shape : run.thresholds)
      for (std::size_t m = 0; m < shape.score.size(); ++m)
        t.add(run, shape, static_cast<ShapeModel>(m));
  t.notes = {"Better, worse: by more than two standard errors over " + units_name(results) + "."};
  return with_listed(results, t);
}

Table shape_levels_table(const Results& results) {
  using R = RunResults;
  using F = ThresholdFragility;
  using S = ThresholdShape;
  ShapeTable t("shape_levels",
               "Observed share, fitted probability of each model and recrossings, by level. "
               "Histories that slide freely are in the observed share only.");
  t.put_all(run_column, threshold_column);
  t.put_all(intensity_column(results, "level", "Level", "intensity level",
                             [&](std::size_t level) { return results.levels[level]; }));
  t.share("observed", "Observed", "observed share",
          [](const R&, const F& of, const S&, std::size_t level) { return of.probability[level]; });
  constexpr const char* stems[] = {"lognormal", "logit",    "complementary_log_log",
                                   "two_part",  "monotone", "one_surface"};
  static_assert(std::size(stems) == shape_model_count);
  for (std::size_t m = 0; m < shape_model_count; ++m) {
    const auto model = static_cast<ShapeModel>(m);
    t.share(stems[m], model_name(model),
            "probability by the model " + model_name(model) + ", fitted on all records",
            [=](const R&, const F&, const S& shape, std::size_t level) {
              return shape.probability_at(model, level);
            });
  }
  t.share(
      "recrossed", "Recross",
      "share of histories that reached the threshold at a lower level and do not here",
      [](const R&, const F&, const S& shape, std::size_t level) { return shape.recrossed[level]; });
  add_each(t, results, results.levels.size());
  return with_listed(results, t);
}

Table shape_crossings_table(const Results& results) {
  using C = ShapeCrossing;
  TableOf<ShapeRun, C> t(
      "shape_crossings",
      "Where the lognormals of neighbouring clearances cross: on one side of it the larger "
      "clearance would be exceeded with the higher probability.");
  t.put_all(run_column, threshold_column);
  t.length("next_threshold", "Next", "the next larger threshold", &C::next_threshold_m);
  t.put_all(intensity_column(results, "intensity", "Cross at", "where their lognormals cross",
                             &C::intensity));
  t.share("probability", "Probability there", "probability of both where they cross",
          &C::probability);
  t.text("within", "Between the levels",
         "whether they cross between the lowest and the highest level", &C::within_levels);
  t.add_each(results.shape->runs, &ShapeRun::crossings);
  return with_listed(results, t);
}

Table shape_surface_table(const Results& results) {
  TableOf<ShapeRun, SurfaceMedian, FragilityCurve> t(
      "shape_surface",
      "Fitted jointly: lognormals of all clearances with one log std, which never cross, beside "
      "the separate fits.");
  t.put_all(run_column, threshold_column);
  t.put_all(intensity_column(results, "median", "Joint median",
                             "median with one log_std for all thresholds", &SurfaceMedian::median));
  t.number("log_std", "Joint log std", "the one logarithmic standard deviation of all thresholds",
           &ShapeRun::surface_log_std);
  t.put_all(intensity_column(results, "separate_median", "Separate median",
                             "median of the separate fit", &FragilityCurve::median));
  t.number("separate_log_std", "Separate log std",
           "logarithmic standard deviation of the separate fit", &FragilityCurve::log_std);
  for (std::size_t r = 0; r < results.runs.size(); ++r)
    for (const SurfaceMedian& row : results.shape->runs[r].surface)
      for (const ThresholdFragility& of : results.runs[r].fragilities)
        if (of.threshold_m == row.threshold_m)
          t.add(results.shape->runs[r], row, of.capacities.curve);
  return with_listed(results, t);
}

}  // namespace glissade
