// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analysis/conditions/columns.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Suite means by (suite, place), and the columns that name a place.
struct MeansByCondition {
  const Results& results;
  ConditionColumns conditions;
  const Column* period;  ///< after these, where it is not one of them
  std::vector<SuiteMean> means;
  ColumnKind kind = ColumnKind::length;
};

/// A row for each mean: over the orientations the lowest, median and highest; the bounds with the
/// orientation of each record by itself; the largest history.
Table means_table(const MeansByCondition& of, FileName name, std::string title);
/// A row for each mean and orientation of all records.
Table means_by_orientation_table(const MeansByCondition& of, FileName name, std::string title);

/// Suite means over those at another condition, by orientation.
struct RatiosByCondition {
  const Results& results;
  MeanQuestion question;
  ConditionColumns conditions;
  std::vector<Condition> places;
  std::function<Condition(const Condition&)> reference;
};
/// A row for each place: the lowest, the median and the highest ratio.
Table ratios_table(const RatiosByCondition& of, FileName name, std::string title);

}  // namespace glissade
