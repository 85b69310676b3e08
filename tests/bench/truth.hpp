// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "schemes.hpp"
#include "standard_scenes.hpp"

namespace glissade::bench {

/// What a scene's peak is, by problem; NaN where it is not known.
struct Truth {
  double samples_m = 0.0, one_way_m = 0.0, oscillator_m = std::nan("");
  bool uplift = false;

  double peak_m(Problem problem) const {
    return problem == Problem::one_way_samples ? one_way_m
           : problem == Problem::oscillator    ? oscillator_m
                                               : samples_m;
  }
};

/// Of the chosen scenes; two threads. Samples: in 50 digits. One way: slide(), which
/// tests/unit/block holds to 1e-12. Oscillator: the closed form at all times, without the vertical,
/// and not for free sliders (it does not stop where the record does).
std::vector<Truth> truths_of(const test::StandardScenes& all, const std::vector<bool>& chosen);

}  // namespace glissade::bench
