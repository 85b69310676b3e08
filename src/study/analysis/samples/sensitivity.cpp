// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/samples/design_friction.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/sampling/sobol_indices.hpp"
#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr std::size_t least_units = 3;
constexpr const char* least_units_text =
    "three records or more, of three events where they are stated";

/// The samples of a run, as they were drawn.
class SampleDesign {
 public:
  SampleDesign(const StudyConfig& config, const Results& results)
      : results_(results), factors_(drawn_factors(config)) {
    is_given_data_ = results.cases.per_combination() == config.sampling.samples;
    if (!is_given_data_) return;
    check(config);
    if (config.sampling.method == SamplingMethod::sobol) blocks_ = config.sampling.scrambles;
  }
  const std::vector<DrawnFactor>& factors() const { return factors_; }
  std::uint64_t matrices() const { return is_given_data_ ? 1 : factors_.size() + 2; }

  /// One number of every history of a run.
  template <class Value>
  CrossedResponse response(const RunResults& run, Value value) const {
    const std::size_t samples = run.cases / matrices();
    CrossedResponse response =
        is_given_data_ ? CrossedResponse(results_.records.size(), groups(run), blocks_)
                       : CrossedResponse(results_.records.size(), factors_.size(), samples);
    response.set_units(results_.histories.unit_of);
    for (std::size_t record = 0; record < response.records(); ++record) {
      for (std::size_t matrix = 0; matrix < response.matrices(); ++matrix) {
        for (std::size_t k = 0; k < samples; ++k)
          response(record, matrix, k) = value(record, run.first_case + matrix * samples + k);
      }
    }
    return response;
  }

 private:
  void check(const StudyConfig& config) const {
    constexpr std::size_t least_samples = 32;
    const auto refuse = [&](const std::string& what) {
      throw InputError({config.file.string(), "[sensitivity] of finished results needs " + what,
                        "run the study with [sensitivity]", ""});
    };
    if (results_.histories.units() < least_units) refuse(least_units_text);
    if (config.sampling.samples < least_samples)
      refuse(std::to_string(least_samples) + " samples or more");
    // Sobol points of one scramble depend on each other, so that their scatter says nothing.
    if (config.sampling.method == SamplingMethod::sobol &&
        config.sampling.scrambles < least_scrambles)
      refuse("sampling.scrambles of " + std::to_string(least_scrambles) +
             " or more, or sampling.method = \"monte_carlo\"");
  }

  std::vector<FactorGroups> groups(const RunResults& run) const {
    std::vector<FactorGroups> groups;
    for (const DrawnFactor& factor : factors_) {
      std::vector<double> values;
      for (std::size_t k = 0; k < run.cases; ++k)
        values.push_back(factor.value(results_.cases.cases[run.first_case + k]));
      groups.push_back(groups_of(values));
    }
    return groups;
  }

  const Results& results_;
  std::vector<DrawnFactor> factors_;
  bool is_given_data_ = false;
  std::size_t blocks_ = 1;  ///< of given data that are not independent
};

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
  RunSpread(const Results& results, const RunResults& run, const SampleDesign& design)
      : results_(results), run_(run), design_(design) {}

  SpreadRow of_capacity(std::size_t threshold) const {
    SpreadRow row = row_of(threshold);
    const double low = results_.levels.front(), high = results_.levels.back();
    double below = 0.0, above = 0.0;
    fill(design_.response(run_,
                          [&](std::size_t record, std::size_t c) {
                            const double capacity =
                                results_.histories.capacity(record, c, threshold);
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
    fill(design_.response(run_,
                          [&](std::size_t record, std::size_t c) {
                            return results_.histories.displacement_m(record, c, level) >=
                                           row.threshold_m
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
  const SampleDesign& design_;
};

}  // namespace

SensitivityResults SensitivityAnalysis::find(const StudyConfig& config, const Results& results) {
  GLISSADE_EXPECTS(config.sensitivity && !results.runs.empty());
  SensitivityResults found;
  found.factors = {"records", "all that is drawn"};
  const SampleDesign design(config, results);
  for (const DrawnFactor& factor : design.factors()) found.factors.push_back(factor.name);
  found.samples = config.sampling.samples;
  found.matrices = design.matrices();
  for (const RunResults& run : results.runs) {
    const Case& first = results.cases.cases[run.first_case];
    if (first.friction_value == FrictionValue::design && config.samples_friction()) continue;
    const RunSpread spread(results, run, design);
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      found.rows.push_back(spread.of_capacity(t));
      for (std::size_t level = 0; level < results.levels.size(); ++level)
        found.rows.push_back(spread.of_exceedance(t, level));
    }
  }
  found.design_friction = design_friction_rows(config, results);
  return found;
}

void SensitivityAnalysis::check(const StudyConfig& study, std::size_t units,
                                ProblemList& problems) {
  if (study.sensitivity && units < least_units)
    problems.add({study.file.string(), std::string("[sensitivity] needs ") + least_units_text,
                  "give more records, or leave out [sensitivity]", ""});
}

}  // namespace glissade
