// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Fragilities, slip, comparison with standards and impact, for each combination of what the study
/// lists.
std::vector<RunResults> fragility_runs(const StudyConfig& config, const Results& results);

/// Over the histories of some cases at a level; NaN where the field is not kept. Of flags: the
/// share that is set.
template <class T>
double mean_at(const HistoryTable& histories, const std::vector<T>& field, CaseSlice cases,
               std::size_t level) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t record = 0; record < histories.records; ++record) {
    for (std::size_t i = 0; i < cases.count; ++i)
      sum += field[histories.at(record, cases.first + i, level)];
  }
  return sum / static_cast<double>(histories.records * cases.count);
}

}  // namespace glissade
