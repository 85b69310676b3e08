// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// Median and largest spectral acceleration over all horizontal directions (Boore 2010, BSSA
/// 100(4):1830-1835). RotD100 is the maximum-direction spectrum of ASCE 7-16, 16.2.3.2.
struct RotatedSpectrum {
  std::vector<double> rotd50_mps2, rotd100_mps2;  ///< by period
};

/// Of the motion's horizontals, scale not applied. Exact over the directions: the largest value
/// along each is the support of the convex hull of the path of the oscillator in plan. Along the
/// path 314 points a period or more, so that values are too small by 5e-5 at most; period 0 is the
/// ground acceleration itself. Throws InputError where the motion has one horizontal.
RotatedSpectrum rotated_spectrum(const Motion& motion, std::span<const double> periods_s,
                                 double damping_ratio = 0.05);

}  // namespace glissade
