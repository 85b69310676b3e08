// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/shared_list.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/record.hpp"

namespace glissade {

/// A ground motion of up to three components on a common clock: equal dt_s and equal lengths.
/// A missing component has no samples; the first horizontal is required.
struct Motion {
  std::string id;  ///< unique in its suite
  std::string event, station;
  double magnitude = 0.0;    ///< moment magnitude; 0: not given
  double distance_km = 0.0;  ///< rupture distance; 0: not given
  double vs30_mps = 0.0;     ///< 0: not given
  double scale = 1.0;        ///< the suite's factor on all three components, not yet applied
  double dt_s = 0.0;
  std::array<Samples, 2> horizontal_mps2;
  Samples vertical_mps2;  ///< up positive
  /// What its files contradict: stations and directions of their headers, their ends.
  std::vector<std::string> contradictions;
  /// What reading its files found or changed.
  std::vector<std::string> notes;
  /// What its suite asked for and was done with it, in order (motion_processing.hpp).
  std::vector<std::string> processing;
  /// Its components differ in step or length, and nothing states how they lie in time.
  bool starts_are_assumed = false;
};

/// A component and its start on the time axis of the motion.
struct TimedRecord {
  Record record;
  double start_s = 0.0;  ///< a whole number of samples of the motion, >= 0
};

/// Puts components on a common time axis: each is shifted to its start and padded with zeros to the
/// longest. Components with a coarser step whose dt_s is a whole multiple of the finest are
/// interpolated linearly, with their last interval to zero, which changes nothing (the motion is
/// piecewise linear). A component that starts later rises to its first sample over one interval.
/// Where components end more than a second apart, a contradiction says so.
/// `metadata` gives all other values of the motion; its samples are replaced. Throws InputError,
/// with the faults of all components, if a record is empty, has a sample that is not finite or a
/// dt_s that is not positive, and if steps or starts differ from whole samples by more than 1e-6 of
/// a sample.
Motion assemble_motion(Motion metadata, const TimedRecord& first,
                       const std::optional<TimedRecord>& second,
                       const std::optional<TimedRecord>& vertical);

/// A set of motions used together.
struct Suite {
  std::string name;
  std::string description;
  std::vector<Motion> motions;
  std::optional<DesignTarget> target;  ///< design spectrum of the suite
  /// The file states that its records were selected as the nearest to a target spectrum: they
  /// scatter less than recorded motions.
  bool nearest_to_target = false;
  /// Motions of a roof or floor, not of the ground: nothing stands between them and the array.
  bool of_roof = false;
};

}  // namespace glissade
