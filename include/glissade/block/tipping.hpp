// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_table.hpp"

namespace glissade {

/// The base of a rigid body that could tip instead of sliding.
struct RigidBase {
  double centre_of_mass_height_m = 0.0;  ///< above the roof, > 0; midway between the edges
  double width_m = 0.0;                  ///< of the base along the slope, > 0
};

// When a block at rest first moves. Both of its drives (slide.hpp) are linear in the roof's
// acceleration, c_0 + c_a a + c_w w with c_0 < 0, so the factor on the motion that brings one to
// zero is closed:
//   factor = -c_0 / max over t of (c_a a + c_w w), the least over the directions it may go;
// infinity where nothing pushes; 0 where gravity alone moves it (c_0 > 0), or friction just holds
// it (c_0 = 0) and something pushes.

/// Multiply `per_unit` by more than this and the block leaves its rest. As far as the tables are
/// followed, between nodes too, to 1e-12 relative. A block free both ways slides before it lifts.
double slip_onset_factor(const RoofTable& roof, const Block& block,
                         const MotionFactors& per_unit = {});
/// The same on top of the roof's own factors, sample by sample: the readable reference. Exact but
/// for rounding: a line peaks at an end.
double slip_onset_factor(const RoofAcceleration& roof, const Block& block);

/// The block that begins to slide when the body, held by enough friction, begins to rock: of
/// friction b / (2 h) and free both ways. The roof of a tipping check is to be followed for it.
Block rocking_block(const Block& block, const RigidBase& base);

/// Multiply `per_unit` by more than this and the body begins to rock on its base; infinity where it
/// never does. Of onset only: rocking is not overturning, and the slip of a body that rocks is
/// outside the model.
///
/// With d = (g + w) sin(slope) - a cos(slope), a body of centre-of-mass height h and base width b
/// rests on all of its base while |d| h <= (N/m) b / 2, that is |d| <= mu_t N/m with mu_t = b / (2
/// h). Sliding, friction is mu N whatever d: it can rock only if mu > mu_t, and then begins when a
/// block of friction mu_t would begin to slide. (Shenton 1996, "Criteria for initiation of slide,
/// rock, and slide-rock rigid-body modes": static friction above B/H; whether it also slides as it
/// rocks, which he tells apart by a higher friction, is left open here.) Both edges are looked at,
/// whatever block.directions.
double tipping_onset_factor(const RoofTable& roof, const Block& block, const RigidBase& base,
                            const MotionFactors& per_unit = {});
/// The same on top of the roof's own factors.
double tipping_onset_factor(const RoofAcceleration& roof, const Block& block,
                            const RigidBase& base);

}  // namespace glissade
