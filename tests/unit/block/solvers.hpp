// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"

namespace glissade::test {

struct Solver {
  const char* name;
  std::function<SlipPeak(const RoofAcceleration&, const Block&)> solve;
};

inline SlipPeak by_kernel(const RoofAcceleration& roof, const Block& block, EventSearch search) {
  const RoofTable table(roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2);
  return peak_slip(table, block, {roof.horizontal_factor, roof.vertical_factor}, search);
}

/// All that solve the block exactly, so that each test of one is a test of all.
inline const std::vector<Solver>& solvers() {
  static const std::vector<Solver> all = {
      {"scalar",
       [](const RoofAcceleration& roof, const Block& block) { return slide(roof, block); }},
      {"kernel", [](const RoofAcceleration& roof,
                    const Block& block) { return by_kernel(roof, block, EventSearch::bounds); }},
      {"kernel, looking into every interval",
       [](const RoofAcceleration& roof, const Block& block) {
         return by_kernel(roof, block, EventSearch::every_interval);
       }},
  };
  return all;
}

}  // namespace glissade::test
