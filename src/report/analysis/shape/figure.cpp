// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/shape/shape.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr int curve_points = 200;

double gap_of(const ThresholdFragility& fragility) {
  const double gap = std::abs(fragility.lognormal.largest_gap);
  return std::isnan(gap) ? -1.0 : gap;
}

DataSeries observed(const Results& results, const ThresholdFragility& fragility) {
  Look points = look(Role::record);
  points = {{0x000000}, 1.5, 1, 7, 0.7};
  DataSeries series{DataSeries::Kind::points, points, "observed"};
  series.x = results.levels;
  series.y = fragility.probability;
  return series;
}

DataSeries interval_bars(const Results& results, const ThresholdFragility& fragility) {
  DataSeries series{DataSeries::Kind::bars, {{0xbbbbbb}, 1.0}, "observed, 95 % interval"};
  for (std::size_t l = 0; l < results.levels.size(); ++l)
    series.add(results.levels[l], fragility.probability_interval[l]);
  return series;
}

DataSeries lognormal(const Panel& panel, const ThresholdFragility& fragility) {
  DataSeries series{DataSeries::Kind::line, distinct_look(0), "lognormal"};
  series.look.width = 3.0;
  const FitSummary& fit = fragility.capacities;
  for (int i = 1; i <= curve_points && fit.converged(); ++i) {
    const double intensity = panel.x.high * i / curve_points;
    series.add(intensity, fit.curve.probability(intensity));
  }
  return series;
}

constexpr std::array other_models = {ShapeModel::logit, ShapeModel::complementary_log_log,
                                     ShapeModel::two_part, ShapeModel::one_surface};

DataSeries of_model(const Results& results, std::size_t threshold, ShapeModel model) {
  const auto place = std::ranges::find(other_models, model) - other_models.begin();
  DataSeries series{DataSeries::Kind::line, distinct_look(static_cast<std::size_t>(place) + 1),
                    model_name(model)};
  const double floor = results.runs.front().fragilities[threshold].capacities.curve.floor;
  const ThresholdShape& shape = results.shape->runs.front().thresholds[threshold];
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    const double probability = shape.probability_at(model, l);
    if (!std::isnan(probability))
      series.add(results.levels[l], floor + (1.0 - floor) * probability);
  }
  return series;
}

double difference_from_lognormal(const DataSeries& model, const ThresholdFragility& fragility) {
  double largest = fragility.capacities.converged() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < model.x.size(); ++i)
    largest = std::max(largest,
                       std::abs(model.y[i] - fragility.capacities.curve.probability(model.x[i])));
  return largest;
}

/// Those that differ from the lognormal of any of some clearances by 0.03 or more (else the lines
/// would be one); at most three, those that differ most.
std::vector<ShapeModel> shown_models(const Results& results,
                                     const std::vector<std::size_t>& thresholds) {
  constexpr std::size_t most = 3;
  constexpr double visible_difference = 0.03;
  std::vector<std::pair<double, ShapeModel>> models;
  for (const ShapeModel model : other_models) {
    double by = 0.0;
    for (const std::size_t t : thresholds) {
      const ThresholdFragility& fragility = results.runs.front().fragilities[t];
      by = std::max(by, difference_from_lognormal(of_model(results, t, model), fragility));
    }
    if (by > visible_difference) models.emplace_back(by, model);
  }
  if (models.size() > most) models.erase(std::ranges::min_element(models));
  std::vector<ShapeModel> shown;
  for (const auto& [by, model] : models) shown.push_back(model);
  return shown;
}

Panel panel_of(const Results& results, std::size_t threshold,
               const std::vector<ShapeModel>& models) {
  const ThresholdFragility& fragility = results.runs.front().fragilities[threshold];
  const GoodnessOfFit& fit = fragility.lognormal;
  const bool is_tested = !std::isnan(fit.p_value);
  Panel panel{format_length(fragility.threshold_m) +
                  (is_tested ? fmt::format(": {}largest gap {:.2f} ({})",
                                           departs_from_lognormal(fit) ? "not lognormal, " : "",
                                           std::abs(fit.largest_gap), format_p(fit.p_value))
                             : ""),
              {results.intensity_label, 0.0, results.levels.back()},
              {"Probability of exceedance", 0.0, 1.0}};
  panel.series = {interval_bars(results, fragility), lognormal(panel, fragility)};
  for (const ShapeModel model : models) panel.series.push_back(of_model(results, threshold, model));
  panel.series.push_back(observed(results, fragility));
  if (is_tested)
    panel.rules.push_back({Rule::Kind::vertical, fit.gap_intensity, look(Role::reference),
                           "largest gap to the lognormal"});
  for (DataSeries& series : panel.series) {
    if (series.kind != DataSeries::Kind::bars)
      series.label = series.name == "observed" ? "observed, 95 % interval" : series.name;
  }
  return panel;
}

}  // namespace

Figure shape_figure(const Results& results) {
  const std::vector<ThresholdFragility>& fragilities = results.runs.front().fragilities;
  const auto [best, worst] = std::ranges::minmax_element(fragilities, {}, gap_of);
  Figure figure{
      "shape", "Exceedance of a clearance: observed share, lognormal and other models",
      run_below(results, results.runs.front()),
      "Points: observed share of histories that exceed the clearance. Lines: the lognormal fitted "
      "to capacities, and other models fitted to the shares at the levels. Two-part: probability "
      "of any slip times that of its size. One surface: lognormals of all clearances with one log "
      "std. Shown are the clearance where the observed share departs most from the lognormal, and "
      "that where it departs least. Of the models at most three are drawn, those that differ most "
      "from the lognormal of either, and by 0.03 or more. p: goodness of fit. All clearances: "
      "tables/shape.csv and tables/shape_levels.csv."};
  std::vector<std::size_t> shown;
  for (const auto one : {worst, best})
    shown.push_back(static_cast<std::size_t>(one - fragilities.begin()));
  if (best == worst) shown.pop_back();
  const std::vector<ShapeModel> models = shown_models(results, shown);
  for (const std::size_t threshold : shown)
    figure.panels.push_back(panel_of(results, threshold, models));
  return figure;
}

}  // namespace glissade
