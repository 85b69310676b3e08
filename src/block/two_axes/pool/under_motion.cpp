// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/pool/under_motion.hpp"

#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail::two_axes {

void UnderMotion::by_reference(const Batch& batch, std::size_t k) const {
  const TwoAxisScene& scene = batch.scenes[k];
  try {
    const BuildingSlip on_building =
        slide_on_building(ground, scene.factors, scene.building, scene.block, batch.thresholds_m,
                          batch.crossings_of(k), tolerance);
    const TwoAxisResult& r = on_building.slip;
    batch.peaks[k] = {r.peak_displacement_m,
                      r.peak_by_axis,
                      r.peak_downslope_m,
                      r.peak_upslope_m,
                      r.residual,
                      r.slip_phases,
                      r.uplift,
                      r.free_sliding,
                      scene.base_shear ? on_building.peak_base_shear : std::array{0.0, 0.0},
                      false};
  } catch (const NotConverged&) {
    batch.peaks[k] = {.failed = true};
  }
}

}  // namespace glissade::block_detail::two_axes
