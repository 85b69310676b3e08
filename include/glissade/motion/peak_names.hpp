// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// How the peaks of a motion are called.
struct PeakNames {
  const char *acceleration, *velocity, *displacement;
};

/// Of the ground, or of a roof.
constexpr PeakNames peak_names(bool of_roof) {
  if (of_roof) return {"peak roof acceleration", "peak roof velocity", "peak roof displacement"};
  return {"PGA", "PGV", "PGD"};
}

}  // namespace glissade
