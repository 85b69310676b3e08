// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "glissade/study/analysis/sampling_error.hpp"
#include "study/grammar.hpp"

namespace glissade {
namespace {

bool two_axes(const TomlTable&, const StudyConfig& study) { return study.two_axes(); }

bool has_pull_tests(const TomlTable& root, const StudyConfig&) {
  return root.table("friction").has("file");
}

bool draws_friction(const TomlTable&, const StudyConfig& study) {
  return study.quantities.at("friction", "mu").is_drawn() ||
         study.quantities.at("friction", "across_mu").is_drawn();
}

bool is_always(const StudyConfig& study, const char* table, const char* key, double value) {
  return study.quantities.at(table, key).is_always(value);
}

bool yields(const TomlTable&, const StudyConfig& study) {
  return !is_always(study, "building", "response_modification", 0.0) ||
         !is_always(study, "building", "yield_coefficient", 0.0);
}

bool has_vertical(const TomlTable&, const StudyConfig& study) {
  return study.vertical != std::vector{VerticalChoice::none};
}

bool draws_orientation(const TomlTable&, const StudyConfig& study) {
  return study.orientation.choice == OrientationChoice::random;
}

bool draws(const TomlTable&, const StudyConfig& study) { return study.draws(); }

bool uses_target(const TomlTable&, const StudyConfig& study) {
  return study.intensity.measure.is_of_design_spectrum() ||
         !is_always(study, "building", "response_modification", 0.0);
}

bool has_one_of(const TomlTable& root, std::initializer_list<const char*> tables) {
  return std::ranges::any_of(tables, [&](const char* table) { return root.has(table); });
}

template <Standard standard>
bool compares(const TomlTable&, const StudyConfig& study) {
  return std::ranges::find(study.standards.compare, standard) != study.standards.compare.end();
}

/// The suite: it is not scaled by the study at all, or not to the study's longest period.
bool may_miss_target(const StudyConfig& study) {
  return study.intensity.measure != IntensityMeasure::sds_g ||
         study.quantities.at("building", "period_s").largest() *
                 study.quantities.at("building", "period_ratio").largest() >
             longest_scaled_period_s;
}

}  // namespace

std::vector<KeyNeeds> key_needs() {
  constexpr auto axes = "[model] axes = 2", file = "friction.file", random = "choice = \"random\"",
                 drawn = "a quantity or an orientation that is drawn",
                 vertical = "a use other than \"none\"";
  std::vector<KeyNeeds> needs = {
      {"intensity", "scaled_to_s", "measure = \"sds_g\"",
       [](const TomlTable&, const StudyConfig& study) {
         return study.intensity.measure == IntensityMeasure::sds_g;
       }},
      {"intensity", "target",
       "measure = \"sds_g\" or \"mce_fraction\", or building.response_modification", uses_target},
      {"model", "displacement", axes, two_axes},
      {"model", "displacement", "[fragility], [chart], [clearance], [verdict] or [rare]",
       [](const TomlTable& root, const StudyConfig&) {
         return has_one_of(root, {"fragility", "chart", "clearance", "verdict", "rare"});
       }},
      {"building", "hardening_ratio", "response_modification or yield_coefficient", yields},
      {"friction", "value", "friction that is drawn", draws_friction},
      {"hazard", "sds_g", "measure = \"sds_g\"",
       [](const TomlTable&, const StudyConfig& study) {
         return study.intensity.measure == IntensityMeasure::sds_g;
       }},
      {"friction", "neighbour_mu", "[verdict]",
       [](const TomlTable& root, const StudyConfig&) { return root.has("verdict"); }},
      {"friction", "direction", file, has_pull_tests},
      {"friction", "across_direction", file, has_pull_tests},
      {"friction", "across_direction", axes, two_axes},
      {"friction", "slip_m", file, has_pull_tests},
      {"friction", "sliding_from_m", file, has_pull_tests},
      {"friction", "fast_over_slow", "rate_s_per_m above 0",
       [](const TomlTable&, const StudyConfig& s) {
         return !is_always(s, "friction", "rate_s_per_m", 0.0);
       }},
      {"friction", "rate_s_per_m", "fast_over_slow other than 1",
       [](const TomlTable&, const StudyConfig& s) {
         return !is_always(s, "friction", "fast_over_slow", 1.0);
       }},
      {"array", "support", "[base_shear], where it is a list",
       [](const TomlTable& root, const StudyConfig& s) {
         return s.support.size() == 1 || root.has("base_shear");
       }},
      {"vertical", "period_s", vertical, has_vertical},
      {"vertical", "damping", vertical, has_vertical},
      {"orientation", "slope_axis", axes, two_axes},
      {"orientation", "component", random, draws_orientation},
      {"orientation", "sign", random, draws_orientation},
      {"orientation", "second_sign", random, draws_orientation},
      {"orientation", "second_sign", axes, two_axes},
      {"sampling", "method", drawn, draws},
      {"sampling", "samples", drawn, draws},
      {"sampling", "target_error", drawn, draws},
      {"sampling", "target_error", "[fragility]",
       [](const TomlTable& root, const StudyConfig&) { return root.has("fragility"); }},
      {"sampling", "target_error", "a study without [sensitivity]",
       [](const TomlTable&, const StudyConfig& s) { return !s.sensitivity; }},
      {"sampling", "target_error", "sampling.scrambles of 8 or more",
       [](const TomlTable&, const StudyConfig& s) {
         return s.sampling.scrambles >= least_scrambles;
       }},
      {"sampling", "scrambles", drawn, draws},
      {"sampling", "scrambles", "[fragility] or [rare]",
       [](const TomlTable& root, const StudyConfig&) {
         return has_one_of(root, {"fragility", "rare"});
       }},
      {"sampling", "bootstrap_replicates", "[fragility] or [chart]",
       [](const TomlTable& root, const StudyConfig&) {
         return has_one_of(root, {"fragility", "chart"});
       }},
      {"standards", "importance", "\"asce7_16\" in compare", compares<Standard::asce7_16>},
      {"standards", "seismic_design_category", "\"seaoc_pv1_2012\" in compare",
       compares<Standard::seaoc_pv1_2012>},
      {"clearance", "orientation", "several orientations",
       [](const TomlTable&, const StudyConfig& s) {
         return s.orientation.choice == OrientationChoice::all_permutations ||
                s.orientation.choice == OrientationChoice::azimuths ||
                s.orientation.slope_axis.size() > 1;
       }},
      {"chart", "without_target", "measure = \"mce_fraction\", or a building period above 2 s",
       [](const TomlTable&, const StudyConfig& s) {
         return s.intensity.measure.is_of_design_spectrum() && may_miss_target(s);
       }},
      {"clearance", "without_target",
       "a measure other than \"sds_g\", which scales to the target, or a building period above 2 s",
       [](const TomlTable&, const StudyConfig& s) { return may_miss_target(s); }}};
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two) needs.push_back({p.table, p.key, axes, two_axes});
  }
  return needs;
}

void refuse_idle_keys(const TomlTable& root, const StudyConfig& study) {
  std::set<std::string> reported;
  for (const KeyNeeds& key : key_needs()) {
    if (!root.has(key.table) || !root.is_table(key.table)) continue;
    const TomlTable table = root.table(key.table);
    if (!table.has(key.key) || key.are_met(root, study) ||
        !reported.insert(table.name_of(key.key)).second)
      continue;
    table.report_idle(key.key, table.name_of(key.key) + " needs " + key.needs);
  }
}

}  // namespace glissade
