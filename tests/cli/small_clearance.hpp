// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::test {

/// A clearance study of a second: three built-in motions, two periods.
inline std::string small_clearance() {
  return R"([study]
name = "small clearance"

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level2.toml"
records = ["level2_1", "level2_2", "level2_3"]

[clearance_study]
period_s = [0.2, 0.7]
mass_ratio = [0.05]
rise_in_12 = [0.25]
mu = 0.47
vertical = ["none"]

[[paper]]
about = "period"
where = "Fig. 13"
says = "10.21 inches"
displacement_in = 10.21
)";
}

}  // namespace glissade::test
