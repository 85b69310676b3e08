// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "unit/block/on_building_scene.hpp"
#include "verification/case.hpp"

namespace glissade::verification {

/// Largest difference in any displacement of the block, relative to the peak and 0.1 mm.
inline double displacement_difference(const SlipResult& found, const SlipResult& expected) {
  const double size = expected.peak_displacement_m + 1e-4;
  double worst = 0.0;
  for (const double d : {found.peak_displacement_m - expected.peak_displacement_m,
                         found.peak_by_axis.along_m - expected.peak_by_axis.along_m,
                         found.peak_by_axis.across_m - expected.peak_by_axis.across_m,
                         found.residual.along_m - expected.residual.along_m,
                         found.residual.across_m - expected.residual.across_m})
    worst = worse(worst, std::abs(d) / size);
  return worst;
}

/// A made-up scene on a rigid building that does not move.
inline test::OnBuilding at_rest(std::size_t samples) {
  test::OnBuilding scene(1, samples);
  for (std::vector<double>* x : {&scene.first, &scene.second, &scene.up}) x->assign(samples, 0.0);
  scene.building = {{Oscillator{0.0}, Oscillator{0.0}}, {}, 0.0};
  scene.block = {{0.3, 0.3}, 0.0, 0.0};
  scene.tolerance = 1e-9;
  return scene;
}

/// Curved stop and steady circle.
std::vector<Case> two_axis_closed_forms();
/// The full model by other methods.
std::vector<Case> two_axis_other_methods();

/// Convergence of the two-axis integration.
std::vector<Case> two_axis_convergence(const Folders& folders);

}  // namespace glissade::verification
