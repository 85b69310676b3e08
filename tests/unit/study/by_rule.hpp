// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "glissade/study/results.hpp"
#include "glissade/study/run/reduce.hpp"

namespace glissade::test {

inline Quantity fixed(double value) { return {{value}, {}}; }
inline Quantity listed(std::vector<double> values) { return {std::move(values), {}}; }
inline Quantity drawn(Distribution distribution) { return {{}, std::move(distribution)}; }

/// A history of made-up results, and what a rule makes of it.
struct HistoryPlace {
  std::size_t record, orientation, level;
  const Case& c;
};
struct MadeUpHistory {
  double displacement_m = 0.0, vector_m = 0.0;  ///< by the study's measure; the vector's peak
  double shear_along = 0.0, shear_across = 0.0;
};
using HistoryRule = std::function<MadeUpHistory(const HistoryPlace&)>;

/// A table of zeros for the results' records, cases, levels and thresholds; no capacity is reached.
inline void size_histories(Results& results) {
  HistoryTable& table = results.histories;
  table = {results.records.size(),
           results.cases.size(),
           results.levels.size(),
           results.thresholds_m.size(),
           {}};
  const std::size_t size = table.records * table.cases;
  table.fields.peak_displacement_m.assign(size * table.levels, 0.0);
  table.fields.uplift.assign(size * table.levels, 0);
  table.fields.failed.assign(size * table.levels, 0);
  table.fields.capacity.assign(size * table.thresholds, std::numeric_limits<double>::infinity());
}

/// The cases of a study under these records, with histories by a rule; no analysis.
inline Results results_by_rule(const StudyConfig& study, std::vector<RecordSummary> records,
                               const HistoryRule& rule) {
  Results results;
  put_study(study, results);
  results.cases = PlannedCases(study).stored();
  results.records = std::move(records);
  results.suites.resize(results.records.back().suite + 1);
  size_histories(results);
  HistoryFields& fields = results.histories.fields;
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    for (std::size_t i = 0; i < results.cases.size(); ++i) {
      for (std::size_t level = 0; level < results.levels.size(); ++level) {
        const MadeUpHistory history =
            rule({record, i % results.cases.orientations, level, results.cases.cases[i]});
        fields.peak_displacement_m[results.histories.at(record, i, level)] = history.displacement_m;
        fields.peak_vector_m.push_back(history.vector_m);
        fields.shear_along.push_back(history.shear_along);
        fields.shear_across.push_back(history.shear_across);
      }
    }
  }
  return results;
}

}  // namespace glissade::test
