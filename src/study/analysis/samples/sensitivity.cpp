// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/samples/design_friction.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/sampling/sobol_indices.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// One number of every history of a run.
template <class Value>
CrossedResponse response_of(const Results& results, const RunResults& run, std::size_t factors,
                            Value value) {
  const std::size_t samples = run.cases / (factors + 2);
  CrossedResponse response(results.records.size(), factors, samples);
  for (std::size_t record = 0; record < response.records(); ++record) {
    for (std::size_t matrix = 0; matrix < response.matrices(); ++matrix) {
      for (std::size_t k = 0; k < samples; ++k)
        response(record, matrix, k) = value(record, run.first_case + matrix * samples + k);
    }
  }
  return response;
}

void add(const SobolIndex& index, SpreadRow& row) {
  row.first.push_back(index.first.value);
  row.first_interval.push_back({index.first.low, index.first.high});
  row.total.push_back(index.total.value);
  row.total_interval.push_back({index.total.low, index.total.high});
}

void fill(const CrossedResponse& response, SpreadRow& row) {
  const SobolIndices indices = sobol_indices(response);
  row.mean = indices.mean;
  row.std = std::sqrt(std::max(0.0, indices.variance));
  row.record_error = indices.record_error;
  row.sample_error = indices.sample_error;
  add(indices.records, row);
  add(indices.drawn, row);
  for (const SobolIndex& index : indices.factors) add(index, row);
}

class RunSpread {
 public:
  RunSpread(const Results& results, const RunResults& run, std::size_t factors)
      : results_(results), run_(run), factors_(factors) {}

  SpreadRow of_capacity(std::size_t threshold) const {
    SpreadRow row = row_of(threshold);
    const double low = results_.levels.front(), high = results_.levels.back();
    double below = 0.0, above = 0.0;
    fill(response_of(results_, run_, factors_,
                     [&](std::size_t record, std::size_t c) {
                       const double capacity = results_.histories.capacity(record, c, threshold);
                       below += capacity < low ? 1.0 : 0.0;
                       above += capacity > high ? 1.0 : 0.0;
                       return std::log(std::clamp(capacity, low, high));
                     }),
         row);
    const double histories = static_cast<double>(results_.records.size() * run_.cases);
    row.share_below = below / histories;
    row.share_above = above / histories;
    return row;
  }

  SpreadRow of_exceedance(std::size_t threshold, std::size_t level) const {
    SpreadRow row = row_of(threshold);
    row.level = results_.levels[level];
    fill(response_of(results_, run_, factors_,
                     [&](std::size_t record, std::size_t c) {
                       return results_.histories.displacement_m(record, c, level) >= row.threshold_m
                                  ? 1.0
                                  : 0.0;
                     }),
         row);
    return row;
  }

 private:
  SpreadRow row_of(std::size_t threshold) const {
    return {.first_case = run_.first_case,
            .condition = results_.cases.describe(run_.first_case / run_.cases),
            .threshold_m = results_.thresholds_m[threshold]};
  }

  const Results& results_;
  const RunResults& run_;
  std::size_t factors_;
};

}  // namespace

SensitivityResults SensitivityAnalysis::find(const StudyConfig& config, const Results& results) {
  GLISSADE_EXPECTS(config.sensitivity && !results.runs.empty());
  SensitivityResults found;
  found.factors = {"records", "all that is drawn"};
  const std::vector<DrawnFactor> factors = drawn_factors(config);
  for (const DrawnFactor& factor : factors) found.factors.push_back(factor.name);
  found.samples = config.sampling.samples;
  for (const RunResults& run : results.runs) {
    const Case& first = results.cases.cases[run.first_case];
    if (first.friction_value == FrictionValue::design && config.samples_friction()) continue;
    const RunSpread spread(results, run, factors.size());
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      found.rows.push_back(spread.of_capacity(t));
      for (std::size_t level = 0; level < results.levels.size(); ++level)
        found.rows.push_back(spread.of_exceedance(t, level));
    }
  }
  found.design_friction = design_friction_rows(config, results);
  return found;
}

}  // namespace glissade
