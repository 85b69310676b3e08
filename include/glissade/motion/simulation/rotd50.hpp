// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace glissade {

/// RotD50 (Boore 2010, BSSA 100(4):1830-1835): the median over all orientations of the 5 % damped
/// spectral acceleration of two horizontal components, here over six orientations 30 degrees apart.
/// Units of the input, one per period.
std::vector<double> rotd50_spectrum(double dt_s, std::span<const double> first,
                                    std::span<const double> second,
                                    std::span<const double> periods_s);

}  // namespace glissade
