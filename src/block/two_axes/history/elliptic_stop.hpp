// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/full_model/stop.hpp"

namespace glissade::block_detail::two_axes {

/// Stop of a block under constant load on a friction ellipse, as stop_under_constant_load() gives
/// it on a circle.
struct EllipticStop {
  Stop stop;
  Vector last;  ///< the direction of the velocity at the end, not of unit length
};

/// With M = diag(1, aspect), e = M v / |M v| and u = |M v|:
///   u' = d . M e - n |M e|^2,   u e' = its part across e
/// so that e depends on u alone: RK4 for e in log u, Simpson's rule in u for time and displacement,
/// until what is left is straight; with steps half as long until that changes nothing.
/// @param n friction along the slope
/// @param enough_m error of the displacement that does not matter
EllipticStop stop_on_an_ellipse(Vector v, Vector d, double n, double aspect, double enough_m);

}  // namespace glissade::block_detail::two_axes
