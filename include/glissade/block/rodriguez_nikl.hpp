// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/slide.hpp"

namespace glissade {

/// The time-stepping scheme of Rodriguez-Nikl, Cedano, Martinez & Ojeda (2019), "Predicted slip of
/// ballasted solar arrays on angled roofs due to seismic motion", as published, for comparison:
/// each sample interval is divided into `substeps` by linear interpolation; acceleration is
/// constant over a substep; the block sticks if its relative velocity is zero or has changed sign
/// and |a cos - g sin| < mu |g cos + a sin|. First order in the substep. The vertical, future work
/// in the paper, enters as g + w.
///
/// The end of the record is that of slide() (theory.md, 1.6), so that the two converge to one
/// limit. slip_phases counts runs of substeps with one sign of velocity.
///
/// @param substeps P >= 1; the paper chose 64
SlipResult slide_rodriguez_nikl(const RoofAcceleration& roof, const Block& block, int substeps);

}  // namespace glissade
