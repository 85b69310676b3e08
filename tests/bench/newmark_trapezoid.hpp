// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/slide.hpp"

namespace glissade::bench {

/// Newmark's (1965) sliding block as it is commonly coded, after Jibson (1993, "Predicting
/// earthquake-induced landslide displacements using Newmark's sliding block analysis"), here with
/// the equations of slide(): the relative velocity is the trapezoidal sum of the relative
/// acceleration over the samples, the displacement that of the velocity; the block sticks at the
/// first sample where the velocity would have changed its sign. Where a phase begins and ends
/// between samples is not looked for. One way (block.directions) or both.
///
/// After the last sample it goes on by slide()'s rule, so that the two converge to one limit.
///
/// @param substeps >= 1: each sample interval is cut into so many by linear interpolation
/// @return largest |displacement|, in plan, m
double newmark_trapezoid_peak_m(const RoofAcceleration& roof, const Block& block, int substeps);

}  // namespace glissade::bench
