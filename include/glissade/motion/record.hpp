// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "glissade/core/shared_list.hpp"

namespace glissade {

/// Of a record, and of a motion: 28 h at 0.005 s. More is an error of units.
inline constexpr std::size_t most_samples = 20'000'000;

/// One component of a digitised accelerogram: piecewise linear between equally spaced samples, zero
/// before the first; after the last it goes linearly to zero over one more interval and remains
/// zero.
struct Record {
  std::string name;           ///< of its file, or of a simulation
  double dt_s = 0.0;          ///< > 0
  Samples acceleration_mps2;  ///< finite, at least one
  /// "EVENT, DATE, STATION, DIRECTION" where the file states them; else empty.
  std::string source;
  /// What reading found or changed: a step by the last time, a mean that is subtracted.
  std::vector<std::string> notes = {};
};

}  // namespace glissade
