// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "glissade/study/analysis/clearance_grid.hpp"
#include "glissade/study/results.hpp"

// Required clearance after Walters et al. (2012): the mean of the suite for each building period,
// the largest over the periods, and a factor on that.
namespace glissade {

/// One history, in plan and by the roof's axes: along the slope (positive where it falls) and
/// across it. Of a study with samples the mean over them.
struct ClearanceHistory {
  double displacement_m = 0.0;                     ///< by the study's measure
  double peak_m = 0.0;                             ///< largest length of the displacement
  double peak_along_m = 0.0, peak_across_m = 0.0;  ///< largest |displacement| by axis, whenever
  double residual_along_m = 0.0, residual_across_m = 0.0;
  double shear_along = 0.0,
         shear_across = 0.0;  ///< peak base shear over the bare building's weight; 0: not kept
  std::uint8_t uplift = 0;    ///< 1: the array lifts off, outside the model
};

/// SRSS of the peaks along both axes, as displacements are taken.
double base_shear(const ClearanceHistory& history);

/// What of a study a figure or table shows.
enum class ClearanceTopic {
  spectra,
  period,
  level,
  yielding,
  base_shear,
  slope,
  mce,
  vertical,
  mass,
  orientation,
};

/// The histories of a study as the clearance is read from them.
struct ClearanceResults {
  std::string study_name, study_description, program_version, plan_hash, study_text;
  std::uint64_t seed = 0;
  ClearanceGrid grid;
  std::vector<Orientation> orientations;
  std::vector<std::uint64_t> same_as;  ///< by orientation: the first whose histories are the same
  std::vector<SuiteSummary> suites;
  std::vector<RecordSummary> records;  ///< those of one suite together
  std::vector<double> friction;        ///< design values by (ClearanceAxis::listed, SlopeAxis)
  DisplacementMeasure displacement = DisplacementMeasure::srss;
  double clearance_factor = 1.1;
  std::vector<ClearanceHistory> histories;  ///< by (record, orientation, condition)

  const ClearanceHistory& at(std::size_t record, std::size_t orientation,
                             std::size_t condition) const {
    return histories[(record * orientations.size() + orientation) * grid.count() + condition];
  }
};

/// Of friction that is drawn the design value counts (mean - 2 std), of anything else that is drawn
/// the mean over the samples. Precondition: results.clearance.
ClearanceResults clearance_results(const Results& results);

}  // namespace glissade
