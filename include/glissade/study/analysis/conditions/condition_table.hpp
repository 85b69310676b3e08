// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glissade/study/analysis/conditions/condition_grid.hpp"

// The histories of a study by condition, as required clearance and base shear are read from them.
namespace glissade {

struct Results;

/// One history, in plan and by the roof's axes: along the slope (positive where it falls) and
/// across it. Of a study with samples the mean over them. NaN where a study does not keep a number.
struct ConditionHistory {
  double displacement_m = 0.0;                     ///< by the study's measure
  double peak_m = 0.0;                             ///< largest length of the displacement
  double peak_along_m = 0.0, peak_across_m = 0.0;  ///< largest |displacement| by axis, whenever
  double residual_along_m = 0.0, residual_across_m = 0.0;
  double shear_along = 0.0,
         shear_across = 0.0;  ///< peak base shear over the building's weight without the array
  std::uint8_t uplift = 0;    ///< 1: the array lifts off, outside the model
};

/// SRSS of the peaks along both axes, as displacements are taken.
double base_shear(const ConditionHistory& history);

struct ConditionTable {
  ConditionGrid grid;
  std::vector<Orientation> orientations;
  std::vector<std::uint64_t> same_as;  ///< by orientation: the first whose histories are the same
  std::vector<double> friction;        ///< design values by (ConditionAxis::listed, SlopeAxis)
  std::vector<std::uint64_t> first_case;    ///< by condition: of its cases, which are in a row
  std::vector<ConditionHistory> histories;  ///< by (record, orientation, condition)

  const ConditionHistory& at(std::size_t record, std::size_t orientation,
                             std::size_t condition) const {
    return histories[(record * orientations.size() + orientation) * grid.count() + condition];
  }
};

/// From cases and histories. Of friction that is drawn the design value counts (mean - 2 std) where
/// the study has it, of anything else that is drawn the mean over the samples.
ConditionTable condition_table(const Results& results);
/// Makes those of the results, where no other analysis has.
void need_conditions(Results& results);

}  // namespace glissade
