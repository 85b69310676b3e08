// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/peak_slip.hpp"

#include "block/tables/table_kernel.hpp"

namespace glissade {

SlipPeak peak_slip(const RoofTable& roof, const Block& block, const MotionFactors& factors,
                   EventSearch search) {
  return block_detail::walk_events(roof, block, factors, search, block_detail::NoHistory{});
}

}  // namespace glissade
