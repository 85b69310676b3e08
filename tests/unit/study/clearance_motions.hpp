// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade::test {

/// A few incommensurate sines below a window; no symmetry to hide behind.
inline std::vector<double> wobble(std::size_t samples, double dt_s, double peak_mps2,
                                  double phase) {
  std::vector<double> a(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = dt_s * static_cast<double>(i);
    const double share = static_cast<double>(i) / static_cast<double>(samples);
    const double window = share * (1.0 - share) * 4.0;
    a[i] = peak_mps2 * window *
           (0.6 * std::sin(7.3 * t + phase) + 0.4 * std::sin(17.9 * t + 2.0 * phase));
  }
  return a;
}

/// Three components, 6 s.
inline Motion shaking(const std::string& id, double peak_mps2, double phase) {
  Motion motion;
  motion.id = id;
  motion.dt_s = 0.01;
  motion.horizontal_mps2 = {wobble(600, 0.01, peak_mps2, phase),
                            wobble(600, 0.01, 0.7 * peak_mps2, phase + 1.1)};
  motion.vertical_mps2 = wobble(600, 0.01, 0.3 * peak_mps2, phase + 2.3);
  return motion;
}

inline Suite suite_of(std::vector<Motion> motions) {
  Suite suite;
  suite.name = "made up";
  suite.motions = std::move(motions);
  suite.target = DesignTarget{.ss_g = 1.95, .s1_g = 0.8};
  return suite;
}

}  // namespace glissade::test
