// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

namespace glissade {

/// A vector in plan, in the axes of the slope.
struct PlanVector {
  double along_m = 0.0;   ///< positive in the direction in which the surface falls, or of the
                          ///< azimuth on a flat roof
  double across_m = 0.0;  ///< positive at 90 degrees from that, from the first axis to the second
};

/// What every scheme gives of a history: displacement of the block relative to the roof, in plan
/// (slip along the slope times cos(slope)). Of one axis all that is across is zero.
struct SlipPeak {
  double peak_displacement_m = 0.0;  ///< largest length of the displacement vector
  PlanVector peak_by_axis;           ///< largest |displacement| along each axis, at any time
  double peak_downslope_m = 0.0;     ///< >= 0
  double peak_upslope_m = 0.0;       ///< >= 0
  PlanVector residual;               ///< signed, when the block has come to rest
  double slip_duration_s = 0.0;      ///< time spent sliding
  std::size_t slip_phases = 0;       ///< intervals of sliding from rest to rest; of one axis in one
                                     ///< direction
  bool uplift = false;  ///< the normal force was negative: outside the model; friction is then
                        ///< taken as zero
  bool free_sliding = false;  ///< friction cannot stop it: tan(slope) > mu, or equal and moving;
                              ///< displacements are those at the last sample
};

/// And what requires a step through every sample.
struct SlipResult : SlipPeak {
  double path_length_m = 0.0;
  double peak_velocity_mps = 0.0;  ///< largest length of the velocity vector
};

/// The SRSS of the separate maxima of the two axes: the displacement of a history by Walters et al.
/// (2012). Not less than the peak of the vector, and at most sqrt(2) times that.
inline double srss_of_maxima_m(const SlipPeak& slip) {
  return std::hypot(slip.peak_by_axis.along_m, slip.peak_by_axis.across_m);
}

}  // namespace glissade
