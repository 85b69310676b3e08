// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glissade {

/// One component of a digitised accelerogram: piecewise linear between equally spaced samples, zero
/// before the first; after the last it goes linearly to zero over one more interval and remains
/// zero.
struct Record {
  std::string name;                       ///< of its file, or of a simulation
  double dt_s = 0.0;                      ///< > 0
  std::vector<double> acceleration_mps2;  ///< finite, at least one sample
  std::string source;  ///< "EVENT, DATE, STATION, DIRECTION" of a PEER NGA file; else empty
};

}  // namespace glissade
