// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/grammar.hpp"

namespace glissade {
namespace {

/// The keys of [clearance_study], which had a study of its own.
void add_clearance_study(std::vector<RenamedKey>& keys) {
  keys.push_back({"clearance_study",
                  "give [clearance] orientation = \"median\" and factor, and move its keys as "
                  "stated at each; [base_shear] gives the base shears"});
  const auto moved = [&](const char* old, const std::string& now, const char* but = "") {
    keys.push_back({std::string("clearance_study.") + old, "it is " + now + " now" + but});
  };
  for (const char* key : {"period_s", "mass_ratio", "damping", "hardening_ratio"})
    moved(key, std::string("building.") + key);
  moved("response_modification", "building.response_modification",
        ": an elastic building, which was 1, is 0");
  moved("slope_deg", "roof.slope_deg");
  moved("rise_in_12", "roof.rise_in_12");
  moved("mu", "friction.mu");
  moved("mu_e_w", "friction.mu");
  moved("mu_n_s", "friction.across_mu");
  moved("support", "array.support");
  moved("vertical", "vertical.use");
  moved("vertical_period_s", "vertical.period_s");
  moved("vertical_damping", "vertical.damping");
  moved("displacement", "model.displacement");
  moved("slope_axis", "orientation.slope_axis");
  moved("orientations", "orientation.choice",
        ": \"sixteen\" is \"all_permutations\", \"stated\" is \"as_recorded\"");
  moved("fraction_of_mce", "intensity.levels", " with intensity.measure = \"mce_fraction\"");
  moved("clearance_factor", "clearance.factor");
}

constexpr const char* recorded_only =
    "a chart takes all orientations where [orientation] is absent. For the first component alone "
    "give orientation.choice = \"as_recorded\" in its place; with roof.slope_deg of both signs, "
    "for example { from = -7, to = 7, count = 29 }, both signs of the component are run";

}  // namespace

std::vector<RenamedKey> renamed_keys() {
  const char* moments = "write friction.mu = { mean = ..., std = ... }";
  const char* across = "write friction.across_mu = { mean = ..., std = ... }";
  const char* thresholds = "it is in [fragility] now";
  const char* both =
      "leave it out: a [chart] takes every orientation, orientation.choice = \"all_permutations\"";
  const char* tipping = "[array] is [tipping] for this key now";
  std::vector<RenamedKey> keys = {
      {"friction.mean", moments},
      {"friction.std", moments},
      {"friction.across_mean", across},
      {"friction.across_std", across},
      {"friction.static_ratio", "it is friction.static_over_sliding now"},
      {"friction.fast_ratio", "it is friction.fast_over_slow now"},
      {"friction.rate_spm", "it is friction.rate_s_per_m now"},
      {"friction.design_run", "false is friction.value = \"sampled\" now; for true leave it out"},
      {"clearance.thresholds_m", thresholds},
      {"clearance.stop_at_largest", thresholds},
      {"clearance.impact", "true is an empty table [impact] now; for false leave it out"},
      {"array.centre_of_mass_height_m", tipping},
      {"array.base_width_m", tipping},
      {"chart.slope_deg", "it is roof.slope_deg now, a list"},
      {"chart.mu", "it is friction.mu now, a list"},
      {"chart.period_s", "it is building.period_s now, a list"},
      {"orientation.component = \"both\"", both},
      {"orientation.sign = \"both\"", both},
      {"paper", "published statements are compared in tests/verification now: leave it out"},
      {"convergence", "the convergence of the published scheme is a program under tests now"}};
  add_clearance_study(keys);
  return keys;
}

std::vector<ChangedKey> changed_keys() {
  using Where = ChangedKey::Where;
  return {{"model.axes", Where::absent, "", "clearance_study", "was 1 where absent, and is 2 now",
           "give [model] axes = 1 for the same numbers as before"},
          {"clearance_study.mass_ratio", Where::absent, "clearance_study", "",
           "was 0.05 where absent", "give building.mass_ratio = 0.05: absent is 0 now"},
          {"clearance_study.slope_axis", Where::absent, "clearance_study", "",
           "was both axes where absent",
           "give orientation.slope_axis = [\"e_w\", \"n_s\"]: absent is \"e_w\" now"},
          {"clearance_study.fraction_of_mce", Where::absent, "clearance_study", "",
           "was 2/3 where absent",
           "give intensity.levels = [0.6666666666666666] and intensity.measure = \"mce_fraction\""},
          {"orientation.component", Where::given, "chart", "", "has no effect in a chart now",
           recorded_only},
          {"orientation.sign", Where::given, "chart", "", "has no effect in a chart now",
           recorded_only}};
}

}  // namespace glissade
