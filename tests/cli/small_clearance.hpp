// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::test {

/// A required clearance of a second: three built-in motions, two periods.
inline std::string small_clearance() {
  return R"([study]
name = "small clearance"

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level2.toml"
records = ["level2_1", "level2_2", "level2_3"]

[intensity]
measure = "mce_fraction"
levels = [0.6666666666666666]

[model]
axes = 2

[building]
period_s = [0.2, 0.7]
mass_ratio = 0.05

[roof]
rise_in_12 = 0.25

[friction]
mu = 0.47

[vertical]
use = "none"

[orientation]
slope_axis = ["e_w", "n_s"]

[clearance]
without_target = true   # three records of the suite
)";
}

}  // namespace glissade::test
