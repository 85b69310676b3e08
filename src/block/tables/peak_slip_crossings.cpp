// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "block/tables/table_kernel.hpp"
#include "glissade/block/peak_slip.hpp"

namespace glissade {

SlipPeak peak_slip(const RoofTable& roof, const Block& block, const MotionFactors& factors,
                   std::span<const double> thresholds_m, std::span<Crossing> crossings,
                   EventSearch search) {
  block_detail::CrossingWatch watch(thresholds_m, crossings, std::cos(block.slope_rad),
                                    block_detail::Scaled(block, factors).factor);
  return block_detail::walk_events(roof, block, factors, search,
                                   block_detail::WatchHistory{&watch});
}

}  // namespace glissade
