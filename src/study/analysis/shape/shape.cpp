// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/shape.hpp"

#include "analysis/shape/threshold_data.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

ThresholdShape shape_of(const ShapeComparison& comparison) {
  ThresholdShape shape{.status = comparison.status};
  for (const ModelScore& model : comparison.models) {
    shape.score.push_back(model.score);
    shape.difference.push_back(model.difference);
    shape.standard_error.push_back(model.standard_error);
    shape.probability.insert(shape.probability.end(), model.probability.begin(),
                             model.probability.end());
  }
  return shape;
}

std::vector<double> recrossed_by_level(const HistoryTable& table, CaseSlice cases,
                                       double threshold_m) {
  std::vector<double> shares(table.levels, 0.0);
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
      bool reached = false;
      for (std::size_t level = 0; level < table.levels; ++level) {
        const bool exceeds = table.displacement_m(record, i, level) >= threshold_m;
        if (reached && !exceeds) shares[level] += 1.0;
        reached |= exceeds;
      }
    }
  }
  for (double& share : shares) share /= static_cast<double>(table.records * cases.count);
  return shares;
}

void add_crossings(const Results& results, const RunResults& of, ShapeRun& run) {
  for (std::size_t t = 1; t < of.fragilities.size(); ++t) {
    const FitSummary &low = of.fragilities[t - 1].capacities, &high = of.fragilities[t].capacities;
    if (!low.converged() || !high.converged()) continue;
    const auto crossing = crossing_of(low.curve, high.curve);
    if (!crossing) continue;
    run.crossings.push_back({of.fragilities[t - 1].threshold_m, of.fragilities[t].threshold_m,
                             crossing->intensity, crossing->probability,
                             crossing->intensity >= results.levels.front() &&
                                 crossing->intensity <= results.levels.back()});
  }
}

void add_surface(const FragilitySurface& surface, ShapeRun& run) {
  for (std::size_t t = 0; t < surface.medians.size(); ++t)
    run.surface.push_back(
        {surface.thresholds_m[t], {surface.medians[t], surface.median_intervals[t]}});
  run.surface_log_std = {surface.log_std, surface.log_std_interval};
}

}  // namespace

ShapeResults ShapeAnalysis::find(const StudyConfig&, const Results& results) {
  ShapeResults shape;
  for (const RunResults& of : results.runs) {
    ShapeRun& run = shape.runs.emplace_back();
    run.label = of.label;
    const ShapeData data = shape_data(results, slice_of(of));
    for (const ShapeComparison& comparison : compare_shapes(data))
      run.thresholds.push_back(shape_of(comparison));
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      run.thresholds[t].threshold_m = results.thresholds_m[t];
      run.thresholds[t].recrossed =
          recrossed_by_level(results.histories, slice_of(of), results.thresholds_m[t]);
    }
    add_crossings(results, of, run);
    if (const auto surface = fit_surface(data)) add_surface(*surface, run);
  }
  return shape;
}

}  // namespace glissade
