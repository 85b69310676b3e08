// SPDX-License-Identifier: GPL-3.0-or-later
// A project of its own that uses an installed glissade: does a block on a still plane of 7 degrees,
// friction 0.1, slide freely?
#include <glissade/block/slide.hpp>
#include <vector>

int main() {
  const std::vector<double> still(101, 0.0);
  const glissade::SlipResult slip =
      glissade::slide({.dt_s = 0.01, .horizontal_mps2 = still},
                      {.friction = 0.1, .slope_rad = 7.0 * glissade::rad_per_deg});
  return slip.free_sliding && slip.peak_displacement_m > 0.1 ? 0 : 1;
}
