// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/record.hpp"

namespace glissade {

/// A ground motion of up to three components on a common clock: equal dt_s and equal lengths.
/// A missing component is an empty vector; the first horizontal is always there.
struct Motion {
  std::string id;  ///< unique in its suite
  std::string event, station;
  double magnitude = 0.0;    ///< moment magnitude; 0 where not told
  double distance_km = 0.0;  ///< rupture distance; 0 where not told
  double vs30_mps = 0.0;     ///< 0 where not told
  double scale = 1.0;        ///< the suite's factor on all three components, not yet applied
  double dt_s = 0.0;
  std::array<std::vector<double>, 2> horizontal_mps2;
  std::vector<double> vertical_mps2;  ///< up positive
};

/// A component and when it starts on the motion's clock.
struct TimedRecord {
  Record record;
  double start_s = 0.0;  ///< a whole number of the motion's samples, >= 0
};

/// Puts components on a common clock: each is shifted to its start and padded with zeros to the
/// longest. Components with a coarser step whose dt_s is a whole multiple of the finest are
/// interpolated linearly, with their last interval to zero, which changes nothing (the motion is
/// piecewise linear). A component that starts later rises to its first sample over one interval.
/// `metadata` brings what is told of the motion; its samples are replaced. Throws InputError, with
/// the problems of all components, where a record is empty, has a sample that is not finite or a
/// dt_s that is not positive, and where steps or starts are further than 1e-6 of a sample from
/// fitting.
Motion assemble_motion(Motion metadata, const TimedRecord& first,
                       const std::optional<TimedRecord>& second,
                       const std::optional<TimedRecord>& vertical);

/// A set of motions used together.
struct Suite {
  std::string name;
  std::string description;
  std::vector<Motion> motions;
  std::optional<DesignTarget> target;  ///< the design spectrum the suite was made or scaled for
};

}  // namespace glissade
