// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::test {

/// A convergence study of a second: three built-in motions, eight scenes, four values of P.
inline std::string small_convergence() {
  return R"([study]
name = "small convergence"

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level0.toml"
records = ["level0_1", "level0_2", "level0_3"]

[convergence]
slope_deg = [0, 7]
mu = [0.1, 0.5]
ppa_g = [0, 1.44]
substeps = [1, 16, 64, 256]
)";
}

}  // namespace glissade::test
