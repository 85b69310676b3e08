// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
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

DataSeries of_model(const Results& results, const ThresholdFragility& fragility,
                    const ThresholdShape& shape, ShapeModel model, std::size_t look_index) {
  DataSeries series{DataSeries::Kind::line, distinct_look(look_index), model_name(model)};
  series.look.dash = static_cast<int>(look_index) + 1;
  const double floor = fragility.capacities.curve.floor;
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    const double probability = shape.probability_at(model, l);
    if (!std::isnan(probability))
      series.add(results.levels[l], floor + (1.0 - floor) * probability);
  }
  return series;
}

/// Where the observed share and the lognormal are farthest apart.
void mark_gap(Panel& panel, const ThresholdFragility& fragility) {
  const GoodnessOfFit& fit = fragility.lognormal;
  if (!departs_from_lognormal(fit) || !(fit.gap_intensity < panel.x.high)) return;
  panel.rules.push_back({Rule::Kind::vertical, fit.gap_intensity, look(Role::reference)});
  panel.notes.push_back(
      {fit.gap_intensity, 0.05, " largest gap", look(Role::reference).colour, Note::Align::left});
}

/// Below this difference from the lognormal a model is not drawn: the lines would be one.
constexpr double visible_difference = 0.03;

double difference_from_lognormal(const DataSeries& model, const ThresholdFragility& fragility) {
  double largest = fragility.capacities.converged() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < model.x.size(); ++i)
    largest = std::max(largest,
                       std::abs(model.y[i] - fragility.capacities.curve.probability(model.x[i])));
  return largest;
}

/// The three that differ most from the lognormal.
std::vector<DataSeries> shown_models(const Results& results, const ThresholdFragility& fragility,
                                     const ThresholdShape& shape) {
  constexpr std::size_t most = 3;
  std::vector<std::pair<double, DataSeries>> lines;
  std::size_t look_index = 1;
  for (const ShapeModel model : {ShapeModel::logit, ShapeModel::complementary_log_log,
                                 ShapeModel::two_part, ShapeModel::one_surface}) {
    DataSeries line = of_model(results, fragility, shape, model, look_index++);
    if (const double by = difference_from_lognormal(line, fragility); by > visible_difference)
      lines.emplace_back(by, std::move(line));
  }
  if (lines.size() > most)
    lines.erase(std::ranges::min_element(lines, {}, &std::pair<double, DataSeries>::first));
  std::vector<DataSeries> shown;
  for (auto& [by, line] : lines) shown.push_back(std::move(line));
  return shown;
}

Panel panel_of(const Results& results, std::size_t threshold) {
  const ThresholdFragility& fragility = results.runs.front().fragilities[threshold];
  const ThresholdShape& shape = results.shape->runs.front().thresholds[threshold];
  const double p = fragility.lognormal.p_value;
  Panel panel{
      format_length(fragility.threshold_m) +
          (std::isnan(p)
               ? ""
               : fmt::format(": {}largest gap {:.2f} ({})",
                             departs_from_lognormal(fragility.lognormal) ? "not lognormal, " : "",
                             std::abs(fragility.lognormal.largest_gap), format_p(p))),
      {results.intensity_label, 0.0, results.levels.back()},
      {"Probability of exceedance", 0.0, 1.0}};
  panel.series = {interval_bars(results, fragility), lognormal(panel, fragility)};
  for (DataSeries& line : shown_models(results, fragility, shape))
    panel.series.push_back(std::move(line));
  panel.series.push_back(observed(results, fragility));
  mark_gap(panel, fragility);
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
      "from the lognormal, and by 0.03 or more. p: goodness of fit; dotted: where the gap is "
      "largest. All clearances: tables/shape.csv and tables/shape_levels.csv."};
  for (const auto shown : {worst, best}) {
    if (shown == best && best == worst && !figure.panels.empty()) break;
    figure.panels.push_back(
        panel_of(results, static_cast<std::size_t>(shown - fragilities.begin())));
  }
  return figure;
}

}  // namespace glissade
