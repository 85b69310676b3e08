// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"

namespace glissade::test {

/// What every solver of the sliding block gives; as in SlipResult.
struct Outcome {
  double peak_displacement_m, residual_displacement_m, peak_downslope_m, peak_upslope_m;
  double slip_duration_s;
  std::size_t slip_phases;
  bool uplift, free_sliding;
};

struct Solver {
  const char* name;
  std::function<Outcome(const RoofAcceleration&, const Block&)> solve;
};

/// Of a SlipResult or a PeakSlip.
template <class Result>
Outcome outcome_of(const Result& r) {
  return {r.peak_displacement_m,
          r.residual_displacement_m,
          r.peak_downslope_m,
          r.peak_upslope_m,
          r.slip_duration_s,
          r.slip_phases,
          r.uplift,
          r.free_sliding};
}

inline Outcome by_kernel(const RoofAcceleration& roof, const Block& block, EventSearch search) {
  const RoofTable table(roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2);
  return outcome_of(
      peak_slip(table, block, {roof.horizontal_factor, roof.vertical_factor}, search));
}

/// All that solve the block exactly, so that each test of one is a test of all.
inline const std::vector<Solver>& solvers() {
  static const std::vector<Solver> all = {
      {"scalar", [](const RoofAcceleration& roof,
                    const Block& block) { return outcome_of(slide(roof, block)); }},
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
