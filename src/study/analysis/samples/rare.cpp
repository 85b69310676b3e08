// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/rare.hpp"

#include <algorithm>

#include "glissade/core/contract.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/sampling/importance.hpp"
#include "glissade/study/analysis/fragility.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// Of one combination at a threshold and level.
class RareEvent {
 public:
  RareEvent(const Results& results, const std::vector<double>& weights, std::size_t combination)
      : results_(results), weights_(weights), combination_(combination) {}

  RareRow row(double threshold_m, std::size_t level, const StudyConfig& config) const {
    const CaseSet& set = results_.cases;
    RareRow row{.first_case = set.index(combination_, 0, 0),
                .condition = set.describe(combination_),
                .threshold_m = threshold_m,
                .level = results_.levels[level]};
    std::vector<double> of_record(results_.records.size()), of_sample(set.samples);
    const double records = static_cast<double>(of_record.size()),
                 orientations = static_cast<double>(set.orientations),
                 samples = static_cast<double>(set.samples);
    for (std::size_t record = 0; record < of_record.size(); ++record) {
      for (std::size_t k = 0; k < set.samples; ++k) {
        double reached = 0.0;
        for (std::size_t o = 0; o < set.orientations; ++o) {
          const std::size_t c = set.index(combination_, k, o);
          if (results_.histories.displacement_m(record, c, level) >= threshold_m) reached += 1.0;
        }
        of_sample[k] += reached / (orientations * records);
        of_record[record] += weights_[k] * reached / (orientations * samples);
      }
    }
    const WeightedProbability found =
        weighted_probability(of_sample, weights_, config.sampling.scrambles);
    row.probability = found.probability;
    row.plain_samples = found.plain_samples;
    row.effective_samples = found.effective_samples;
    if (found.standard_error > 0.0) row.sampling_interval = {found.low, found.high};
    add_records(results_.histories.by_unit(of_record), row);
    return row;
  }

 private:
  static void add_records(const UnitValues& of_record, RareRow& row) {
    row.effective_records = effective_number(of_record);
    if (row.probability == 0.0) return;
    row.record_interval = positive_mean_interval(of_record);
    row.record_interval.high = std::min(row.record_interval.high, 1.0);
  }

  const Results& results_;
  const std::vector<double>& weights_;
  std::size_t combination_;
};

}  // namespace

RareResults RareAnalysis::find(const StudyConfig& config, const Results& results) {
  GLISSADE_EXPECTS(config.rare.has_value());
  RareResults found{.widening = config.rare->widening};
  const SamplePoints points(config);
  const CaseSet& set = results.cases;
  for (std::size_t k = 0; k < set.samples; ++k) found.weights.push_back(points.weight(k));
  for (std::size_t c = 0; c < set.combinations(); ++c) {
    const Case& first = set.cases[set.index(c, 0, 0)];
    if (first.support != ArraySupport::isolated || first.friction_value == FrictionValue::design)
      continue;
    if (found.rows.empty()) found.friction = friction_text(config, first);
    const RareEvent event(results, found.weights, c);
    for (const double threshold_m : config.rare->thresholds_m) {
      for (std::size_t level = 0; level < results.levels.size(); ++level)
        found.rows.push_back(event.row(threshold_m, level, config));
    }
  }
  return found;
}

}  // namespace glissade
