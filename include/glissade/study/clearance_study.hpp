// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/study/clearance_grid.hpp"
#include "glissade/study/results.hpp"

// The clearance study of Walters et al. (2012): suites of motions scaled to MCE, a building that
// feels the array, both horizontal axes and the vertical; the mean of the suite for each building
// period, the largest over the periods, and 1.1 times that.
namespace glissade {

/// From pull tests.
struct TestedFriction {
  double mean = 0.0, std = 0.0;
  double design() const { return mean - 2.0 * std; }  ///< > 0
};

/// What of the study a statement of the paper is about, and which figure of ours answers it.
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

/// A statement to be told beside what comes out.
struct PaperStatement {
  ClearanceTopic about = ClearanceTopic::period;
  std::string where, says;
  /// A displacement stated, m; NaN: none.
  double displacement_m = std::numeric_limits<double>::quiet_NaN();
  /// The building's period it is for; NaN: the largest over the periods.
  double period_s = std::numeric_limits<double>::quiet_NaN();
};

/// A clearance study as its file tells it: checked, nothing read or run yet.
struct ClearanceConfig {
  std::string name, description;
  std::uint64_t seed = 0;                          ///< of the bootstrap
  std::filesystem::path file;                      ///< the study file
  std::string source_text;                         ///< the study file, verbatim
  std::vector<std::filesystem::path> suite_files;  ///< one at least, resolved
  std::vector<std::string> records;  ///< ids of the suite's records to run; empty: all
  ClearanceGrid grid;
  std::array<TestedFriction, 2> friction;  ///< by SlopeAxis: of the array pulled along E-W, N-S
  std::vector<SlopeAxis> slope_axes;
  OrientationChoice orientation = OrientationChoice::sixteen;
  double damping = 0.05, vertical_damping = 0.05;
  double hardening_ratio = 0.0;  ///< of yielding buildings, [0, 1)
  DisplacementMeasure displacement = DisplacementMeasure::srss;
  double clearance_factor = 1.1;  ///< on the largest mean
  std::vector<PaperStatement> statements;
};

/// A record of a plan.
struct PlannedRecord {
  std::size_t suite = 0, motion = 0;
};

/// What would be run. Immutable once made.
struct ClearancePlan {
  ClearanceConfig config;
  std::vector<Suite> suites;           ///< with the records asked for
  std::vector<PlannedRecord> records;  ///< of all suites, in their order
  std::vector<GroundOrientation> orientations;
  /// By orientation: the first whose histories are the same. The mirror image of what acts across
  /// the slope only mirrors what moves across it, and where friction is one in both directions it
  /// does not matter which axis the slope has.
  std::vector<std::size_t> same_as;
  std::vector<std::size_t> run;  ///< orientations that are their own `same_as`
  std::string hash;              ///< of everything that decides the results

  std::size_t units() const { return records.size() * run.size(); }
  std::uint64_t histories() const { return units() * config.grid.count(); }
};

/// Throws InputError where study and suites do not fit: unknown record ids, a record without a
/// second component or (where it is required) a vertical, R above 1 and a suite without a target.
ClearancePlan make_plan(const ClearanceConfig& config, std::vector<Suite> suites);

/// A page of text: what the plan would run (for --dry-run).
std::string to_string(const ClearancePlan& plan);

/// One history, in plan and by the roof's axes: along the slope (positive where it falls) and
/// across it.
struct ClearanceHistory {
  double peak_m = 0.0;                             ///< largest length of the displacement
  double peak_along_m = 0.0, peak_across_m = 0.0;  ///< largest |displacement| by axis, whenever
  double residual_along_m = 0.0, residual_across_m = 0.0;
  double shear_along = 0.0,
         shear_across = 0.0;  ///< peak base shear over the bare building's weight
  std::uint8_t uplift = 0;    ///< 1: the array lifts off, outside the model
};

/// In plan; 0 where the array is anchored or there is none.
double displacement_m(const ClearanceHistory& history, DisplacementMeasure measure);
/// SRSS of the peaks along both axes, as displacements are taken.
double base_shear(const ClearanceHistory& history);

/// What one record gave in one orientation.
struct ClearanceUnit {
  std::size_t unit = 0;
  std::vector<ClearanceHistory> histories;  ///< by condition
};

/// Runs one record in one orientation: a free function of the plan.
ClearanceUnit execute(const ClearancePlan& plan, std::size_t unit);

struct ClearanceRecord {
  std::uint64_t suite = 0;
  std::string id, event, station;
  double magnitude = 0.0, distance_km = 0.0;  ///< 0 where not told
  double scale = 1.0;                         ///< of the suite file, to MCE
  double dt_s = 0.0;
  bool has_vertical = false;
  std::uint64_t stronger = 0;  ///< the component with the larger integral of a^2: 0 or 1
};

struct ClearanceSuite {
  std::string name, description;
  SuiteSpectra spectra;  ///< 0 to 2 s, as scaled to MCE
};

/// Everything a clearance study found, and nothing about when, where or how fast.
struct ClearanceResults {
  std::string study_name, study_description, program_version, plan_hash, study_text;
  std::uint64_t seed = 0;
  ClearanceGrid grid;
  std::vector<GroundOrientation> orientations;
  std::vector<std::uint64_t> same_as;
  std::vector<ClearanceSuite> suites;
  std::vector<ClearanceRecord> records;  ///< those of one suite together
  std::vector<double> friction;          ///< design values by SlopeAxis
  DisplacementMeasure displacement = DisplacementMeasure::srss;
  double clearance_factor = 1.1;
  std::vector<PaperStatement> statements;
  std::vector<ClearanceHistory> histories;  ///< by (record, orientation, condition)

  const ClearanceHistory& at(std::size_t record, std::size_t orientation,
                             std::size_t condition) const {
    return histories[(record * orientations.size() + orientation) * grid.count() + condition];
  }
};

/// Puts the units together in plan order. They may come in any order; each must be there once.
ClearanceResults reduce(const ClearancePlan& plan, const std::vector<ClearanceUnit>& units);

// Messages between the ranks of one run.
std::vector<char> pack(const std::vector<ClearanceUnit>& units);
std::vector<ClearanceUnit> unpack_clearance_units(const std::vector<char>& bytes);

}  // namespace glissade
