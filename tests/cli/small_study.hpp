// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::test {

/// The text with `from`, which must be there, replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A study of a second: seven built-in motions, eight samples, three levels. On few levels and
/// records, so that it says little.
inline std::string small_study() {
  return R"([study]
name = "small"
seed = 7

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level0.toml"

[intensity]
measure = "sds_g"
levels = [0.5, 1.0, 2.0]

[building]
period_s = { distribution = "uniform", min = 0.2, max = 1.0 }

[friction]
mu = { mean = 0.3, std = 0.03 }
value = ["sampled", "design"]

[sampling]
samples = 8
bootstrap_replicates = 100

[fragility]
thresholds_m = [0.05, 0.2]

[standards]
compare = ["seaoc_pv1_2012"]
)";
}

/// As small_study on one axis, two samples: a tenth of a second.
inline std::string short_study() {
  return replaced(replaced(small_study(), "samples = 8", "samples = 2"), "[building]",
                  "[model]\naxes = 1\n\n[building]");
}

/// As small_study by multiple stripes: other motions at each of two levels.
inline std::string stripes_study() {
  std::string text = small_study();
  text = replaced(text, "file = \"" GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml\"",
                  "stripes = [\"" GLISSADE_SOURCE_DIR
                  "/suites/synthetic_level0.toml\", \"" GLISSADE_SOURCE_DIR
                  "/suites/synthetic_level1.toml\"]");
  text = replaced(text, "measure = \"sds_g\"\nlevels = [0.5, 1.0, 2.0]",
                  "measure = \"sa_rotd50_g\"\nsa_period_s = 0.5\nlevels = [0.4, 1.5]");
  return replaced(text, "\n[standards]\ncompare = [\"seaoc_pv1_2012\"]\n", "");
}

/// As small_study on one axis, ended where its samples are precise enough.
inline std::string target_study() {
  return replaced(
      replaced(small_study(), "samples = 8", "samples = 512\nscrambles = 64\ntarget_error = 0.01"),
      "[building]", "[model]\naxes = 1\n\n[building]");
}

/// A chart of a second on the same motions: slopes to one on which the array slides freely, and a
/// tall body.
inline std::string small_chart() {
  return R"([study]
name = "small chart"

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level0.toml"

[intensity]
measure = "sds_g"
levels = [0, 1.5]

[model]
axes = 1

[building]
period_s = [0, 0.5]

[roof]
slope_deg = [0, 2, 6]

[friction]
mu = [0.1, 0.2, 0.3, 0.5]

[[chart.read]]
slope_deg = 1
mu = 0.4

[[chart.read]]
slope_deg = 1
displacement_m = 0.1

[standards]
compare = ["seaoc_pv1_2012"]

[tipping]
centre_of_mass_height_m = 1.0
base_width_m = 0.8
)";
}

/// A suite of one motion of one component: record.txt beside it, in g at 0.02 s.
inline std::string suite_of_one_record() {
  return R"([suite]
name = "one"

[[record]]
id = "a"
first = { file = "record.txt", dt_s = 0.02, units = "g" }
)";
}

}  // namespace glissade::test
