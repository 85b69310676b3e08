// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "check.hpp"
#include "unit/block/solvers.hpp"

namespace glissade::fuzz {

/// How far two exact solvers may be apart by rounding. Coulomb friction only ever brings two
/// histories closer, so an error of the acceleration's rounding, held for the whole time, is the
/// worst that can be: v = eps A t in velocity, v t in slip, however ill-conditioned an event is. A
/// block that has stopped at the record's end may coast v^2 / (2 mu g) with that velocity.
struct Rounding {
  double acceleration_mps2 = 0.0;  ///< the largest there is, gravity and friction included
  double time_s = 0.0;             ///< the record's, and what the block coasts after it
  double deceleration_mps2 = 0.0;  ///< after the record; <= 0: it does not stop
  double slip_m(double peak_m) const {
    const double velocity_mps =
        64 * std::numeric_limits<double>::epsilon() * acceleration_mps2 * time_s;
    const double coast_m =
        deceleration_mps2 > 0.0 ? 0.5 * velocity_mps * velocity_mps / deceleration_mps2 : 0.0;
    return 1e-10 * peak_m + velocity_mps * time_s + coast_m;
  }
};

/// slide() against itself with a history.
inline void check_history(const RoofAcceleration& roof, const Block& block,
                          const SlipResult& expected) {
  std::vector<SlipPoint> history;
  const SlipResult recorded = slide(roof, block, history);
  check(recorded.peak_displacement_m == expected.peak_displacement_m &&
            recorded.residual.along_m == expected.residual.along_m &&
            recorded.slip_phases == expected.slip_phases,
        "recording a history changes nothing");
  check(history.back().displacement_m == expected.residual.along_m,
        "a history ends at the residual");
  for (std::size_t i = 1; i < history.size(); ++i) {
    check(history[i].time_s >= history[i - 1].time_s, "time does not run backwards");
  }
}

/// Every solver of tests/unit/block/solvers.hpp, the one list of them, against slide().
inline void check_other_solvers(const RoofAcceleration& roof, const Block& block,
                                const SlipResult& expected, const Rounding& rounding) {
  for (const test::Solver& solver : test::solvers()) {
    const SlipPeak r = solver.solve(roof, block);
    const double tolerance_m = rounding.slip_m(expected.peak_displacement_m);
    const auto is_near = [&](double a, double b) { return std::abs(a - b) <= tolerance_m; };
    check(r.peak_displacement_m == std::max(r.peak_downslope_m, r.peak_upslope_m) &&
              -r.peak_upslope_m <= r.residual.along_m && r.residual.along_m <= r.peak_downslope_m,
          "peaks bound the residual, whatever the solver");
    check(is_near(r.peak_downslope_m, expected.peak_downslope_m) &&
              is_near(r.peak_upslope_m, expected.peak_upslope_m) &&
              is_near(r.residual.along_m, expected.residual.along_m),
          "solvers agree");
    check(
        std::isfinite(r.slip_duration_s) && r.slip_phases <= 4 * (roof.horizontal_mps2.size() + 1),
        "work per sample is bounded, whatever the solver");
    // At critical friction whether it stops is a matter of the last digit.
    const double pull = std::tan(std::abs(block.slope_rad)) - block.friction.along;
    check(std::abs(pull) < 1e-12 || r.free_sliding == expected.free_sliding,
          "solvers agree on what never stops");
  }
}

}  // namespace glissade::fuzz
