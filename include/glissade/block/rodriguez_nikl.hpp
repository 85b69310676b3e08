// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/slide.hpp"

namespace glissade {

/// The time-stepping scheme of Rodriguez-Nikl, Cedano, Martinez & Ojeda (2019), "Predicted slip of
/// ballasted solar arrays on angled roofs due to seismic motion", as published, for comparison:
/// each sample interval is cut into `substeps` by linear interpolation; acceleration is constant
/// over a substep; the block sticks where its relative velocity is zero or has changed sign and |a
/// cos - g sin| < mu |g cos + a sin|. First order in the substep. The vertical, which the paper
/// names as future work, enters as g + w.
///
/// After the last sample it goes on by slide()'s rule for the end of the record, so that the two
/// converge to one limit. slip_phases counts runs of substeps with one sign of velocity.
///
/// @param substeps P >= 1; the paper chose 64
SlipResult slide_rodriguez_nikl(const RoofAcceleration& roof, const Block& block, int substeps);

}  // namespace glissade
