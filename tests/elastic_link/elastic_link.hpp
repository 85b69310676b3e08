// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/slide.hpp"

namespace glissade::test {

/// How the link's shear force comes to the friction mu N.
enum class FrictionLaw {
  elastic_plastic,  ///< a spring and a slider in series
  wen,              ///< the rounded knee of CSI's friction isolator: Wen (1976), exponent 2
};

/// A friction isolator of a structural program in place of the rigid block: a mass of weight 1 N on
/// two springs, along the roof and normal to it. The defaults are those with which Rodriguez-Nikl
/// et al. (2019), section "SAP 2000", modelled the block.
struct ElasticLink {
  double stiffness_npmm = 100.0;     ///< of either spring, N/mm, > 0
  double longest_substep_s = 0.001;  ///< a sample interval is cut into equal parts at most as long
  FrictionLaw law = FrictionLaw::elastic_plastic;
};

/// Where the link's slider went, in plan, downslope positive as in SlipResult; without the
/// deflection of the springs, which ring on for ever: the link has no damping.
struct LinkSlip {
  double peak_displacement_m = 0.0;  ///< max |displacement|
  PlanVector residual;               ///< once the slider stays where it is
};

/// omega dt of the link's springs at its longest substep; the stepping is stable below 2.
double explicit_step(const ElasticLink& link, const Block& block);

/// The block on an elastic link, stepped as the paper has SAP 2000 step it. Displacement s along
/// the slope and compression d of the normal spring, per mass:
///   s'' = g sin(slope) - a cos(slope) - f      f: a spring omega^2 that slips at |f| = mu N
///   d'' = g cos(slope) + a sin(slope) - N      N = omega^2 d, zero where the link is open
/// From static equilibrium; Newmark's method with gamma = 1/2 and beta = 0, the link's force taken
/// once a step. After the last sample the roof's acceleration goes to zero as in slide(), and the
/// link is followed until its slider has rested for a second, or for 100 s (where the stepping is
/// not stable, it may never rest).
///
/// Horizontal motion only, slip both ways, and friction above |tan(slope)|: without it there is no
/// static equilibrium to begin at.
LinkSlip slide_on_elastic_link(const RoofAcceleration& roof, const Block& block,
                               const ElasticLink& link);

}  // namespace glissade::test
