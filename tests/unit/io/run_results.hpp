// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/report/tables.hpp"
#include "temporary_folder.hpp"
#include "unit/study/small_study.hpp"

// Results of studies that were run: between them every analysis, and every field of a history.
namespace glissade::test {

inline const std::string head_of_study =
    "[study]\nname = \"σχέδιο\"\ndescription = \"UTF-8\"\nseed = 7\n[suite]\nfile = "
    "\"suite.toml\"\n";

/// Two axes, sampled and design friction, samples in one orientation each.
inline const std::string study_of_everything = head_of_study + R"(
[intensity]
measure = "sds_g"
levels = [0.5, 1.0, 1.5]
[building]
period_s = { distribution = "uniform", min = 0.2, max = 0.4 }
mass_ratio = 0.05
[roof]
slope_deg = 1
[friction]
mu = { mean = 0.3, std = 0.04 }
[orientation]
choice = "as_recorded"
[sampling]
samples = 8
method = "monte_carlo"
bootstrap_replicates = 100
[fragility]
thresholds_m = [0.02, 0.1]
[impact]
[shape]
[hazard]
curve = "curve.csv"
design_life_years = 25
[standards]
compare = ["seaoc_pv1_2012", "asce7_16"]
[intensity_measures]
[sensitivity]
)";

/// Every combination in every orientation.
inline const std::string study_of_means = head_of_study + R"(
[intensity]
measure = "sds_g"
levels = [1.0, 1.5]
[building]
period_s = [0.3, 0.6]
mass_ratio = 0.05
[roof]
slope_deg = [0, 2]
[friction]
mu = 0.3
neighbour_mu = 0.25
[array]
support = ["isolated", "anchored"]
[clearance]
[base_shear]
[standards]
compare = "seaoc_pv1_2012"
[verdict]
)";

inline const std::string study_of_a_chart = head_of_study + R"(
[intensity]
measure = "sds_g"
levels = [1.0, 1.5]
[model]
axes = 1
[building]
period_s = [0, 0.5]
[roof]
slope_deg = [0, 2, 20]
[friction]
mu = [0.2, 0.3]
[standards]
compare = ["seaoc_pv1_2012", "asce7_16"]
[chart]
[[chart.read]]
level = 1.0
slope_deg = 1
mu = 0.25
[[chart.read]]
level = 1.0
slope_deg = 1
displacement_m = 0.05
)";

inline const std::string study_of_rare_slip = head_of_study + R"(
[intensity]
measure = "sds_g"
levels = [0.5, 1.0]
[model]
axes = 1
[friction]
mu = { mean = 0.4, std = 0.04 }
[sampling]
samples = 64
scrambles = 8
[rare]
thresholds_m = [0.05, 0.1]
)";

/// Ends after the first eight scrambles.
inline const std::string study_with_a_target_error = head_of_study + R"(
[intensity]
measure = "sds_g"
levels = [0.5, 1.0, 2.0]
[model]
axes = 1
[friction]
mu = { mean = 0.3, std = 0.04 }
[sampling]
samples = 64
scrambles = 16
target_error = 0.5
bootstrap_replicates = 100
[fragility]
thresholds_m = [0.02]
[tipping]
centre_of_mass_height_m = 0.5
base_width_m = 0.3
)";

inline StudyConfig study_of(const std::string& text) {
  TextFiles files({{"study.toml", text},
                   {"curve.csv", "sds_g,annual_rate\n0.1,0.05\n0.5,0.005\n1.5,0.0004\n"}});
  return read_study("study.toml", files);
}

/// As many records as a ranking of intensity measures requires.
inline Suite suite_of_five() {
  Suite suite = small_suite();
  for (unsigned i = 3; i < 5; ++i) {
    Motion m = suite.motions[i - 3];
    m.id = "motion" + std::to_string(i);
    m.horizontal_mps2 = {made_up_record(600, 10 * i + 1, 3.0),
                         made_up_record(600, 10 * i + 2, 2.0)};
    suite.motions.push_back(m);
  }
  return suite;
}

inline Results results_of(const std::string& text) {
  const StudyConfig study = study_of(text);
  Plan plan = make_plan(study, {suite_of_five()});
  if (study.sampling.target) plan = first_blocks(plan, plan.units.size() / 2);
  return run(plan);
}

/// Run once.
inline const Results& with_everything() {
  static const Results results = results_of(study_of_everything);
  return results;
}
inline const std::vector<Results>& whole_results() {
  static const std::vector<Results> all = {
      with_everything(), results_of(study_of_means), results_of(study_of_a_chart),
      results_of(study_of_rare_slip), results_of(study_with_a_target_error)};
  return all;
}

/// The writer's bytes are a function of the content: every double the same bits, nan included.
inline std::string bytes_of(const Results& results, const TemporaryFolder& folder,
                            const std::string& name) {
  write_results(folder.path() / name, results);
  return read_text_file(folder.path() / name);
}

}  // namespace glissade::test
