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

// Onset of sliding (theory.md, 4.1). Both drives of a block at rest are linear in the roof
// acceleration, c_0 + c_a a + c_w w with c_0 < 0, so the factor on the motion at which one becomes
// zero has a closed form:
//   factor = -c_0 / max over t of (c_a a + c_w w), the least over the permitted directions;
// infinity if the maximum is not positive; 0 if gravity alone moves the block (c_0 > 0), or if
// c_0 = 0 and the maximum is positive.

/// The block slides if `per_unit` is multiplied by more than this. Up to the end of the tables,
/// between nodes too, to 1e-12 relative. A block free in both directions slides before uplift.
double slip_onset_factor(const RoofTable& roof, const Block& block,
                         const MotionFactors& per_unit = {});
/// The same relative to the factors of the roof, sample by sample: the scalar reference. Exact to
/// rounding: a line has its maximum at an end.
double slip_onset_factor(const RoofAcceleration& roof, const Block& block);

/// The block that begins to slide when the body, with sufficient friction, begins to rock: friction
/// b / (2 h), free in both directions. The roof motion of a tipping check must be followed for it.
Block rocking_block(const Block& block, const RigidBase& base);

/// The body begins to rock on its base if `per_unit` is multiplied by more than this; infinity if
/// it never does. Onset only: rocking is not overturning, and the slip of a rocking body is outside
/// the model.
///
/// With d = (g + w) sin(slope) - a cos(slope), a body of centre-of-mass height h and base width b
/// rests on all of its base while |d| h <= (N/m) b / 2, that is |d| <= mu_t N/m with mu_t = b / (2
/// h). Sliding, friction is mu N whatever d: it can rock only if mu > mu_t, and then begins when a
/// block of friction mu_t would begin to slide. (Shenton 1996, "Criteria for initiation of slide,
/// rock, and slide-rock rigid-body modes": static friction above B/H; whether it also slides while
/// it rocks, for which he gives a higher friction, is not determined here.) Both edges are checked,
/// for any block.directions.
double tipping_onset_factor(const RoofTable& roof, const Block& block, const RigidBase& base,
                            const MotionFactors& per_unit = {});
/// The same relative to the factors of the roof.
double tipping_onset_factor(const RoofAcceleration& roof, const Block& block,
                            const RigidBase& base);

}  // namespace glissade
