// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/in_files.hpp"
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

bool runs_all_levels(const TomlTable&, const StudyConfig& study) { return !study.by_stripes; }

bool uses_target(const TomlTable&, const StudyConfig& study) {
  return study.intensity.measure.is_of_design_spectrum() ||
         !is_always(study, "building", "response_modification", 0.0);
}

/// Keys of analyses, and keys of others that only some of them use.
void add_needs_of_analyses(std::vector<KeyNeeds>& needs) {
  std::set<std::string> used;
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    needs.insert(needs.end(), analysis.key_needs.begin(), analysis.key_needs.end());
    used.insert(analysis.uses.begin(), analysis.uses.end());
  }
  for (const std::string& key : used) {
    const auto tables = tables_where([&](const AnalysisInFiles& analysis) {
      return std::ranges::find(analysis.uses, key) != analysis.uses.end();
    });
    const std::size_t dot = key.find('.');
    needs.push_back({key.substr(0, dot), key.substr(dot + 1), listed(tables, " or "),
                     [tables](const TomlTable& root, const StudyConfig&) {
                       return std::ranges::any_of(
                           tables, [&](const std::string& table) { return root.has(table); });
                     }});
  }
}

}  // namespace

std::vector<KeyNeeds> key_needs() {
  constexpr auto axes = "[model] axes = 2", file = "friction.file", random = "choice = \"random\"",
                 drawn = "a quantity or an orientation that is drawn",
                 vertical = "a use other than \"none\"",
                 all_levels = "a study without suite.stripes";
  std::vector<KeyNeeds> needs = {
      {"intensity", "scaled_to_s", "measure = \"sds_g\"",
       [](const TomlTable&, const StudyConfig& study) {
         return study.intensity.measure == IntensityMeasure::sds_g;
       }},
      {"intensity", "target",
       "measure = \"sds_g\" or \"mce_fraction\", or building.response_modification", uses_target},
      {"model", "displacement", axes, two_axes},
      {"building", "hardening_ratio", "response_modification or yield_coefficient", yields},
      {"roof", "neighbour_slope", "friction.neighbour_mu or friction.neighbour_over_mu above 0",
       [](const TomlTable&, const StudyConfig& s) { return s.has_neighbours(); }},
      {"roof", "neighbour_slope", "a slope other than 0",
       [](const TomlTable&, const StudyConfig& s) {
         return !is_always(s, "roof", "slope_deg", 0.0);
       }},
      {"friction", "value", "friction that is drawn", draws_friction},
      {"friction", "direction", file, has_pull_tests},
      {"friction", "across_direction", file, has_pull_tests},
      {"friction", "across_direction", axes, two_axes},
      {"friction", "slip_m", file, has_pull_tests},
      {"friction", "sliding_from_m", file, has_pull_tests},
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
      {"sampling", "target_error", "a study without [sensitivity]",
       [](const TomlTable&, const StudyConfig& s) { return !s.sensitivity; }},
      {"sampling", "target_error", "sampling.scrambles of 8 or more",
       [](const TomlTable&, const StudyConfig& s) {
         return s.sampling.scrambles >= least_scrambles;
       }},
      {"sampling", "scrambles", drawn, draws},
      {"sampling", "target_error", all_levels, runs_all_levels},
      {"sampling", "scrambles", all_levels, runs_all_levels},
      {"fragility", "stop_at_largest", all_levels, runs_all_levels}};
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two) needs.push_back({p.table, p.key, axes, two_axes});
    if (p.needs == nullptr) continue;
    const std::size_t other = parameter_index(p.table, p.needs);
    const double usual = value_of(parameters()[other], Case());
    needs.push_back({p.table, p.key, fmt::format("{} other than {:g}", p.needs, usual),
                     [=](const TomlTable&, const StudyConfig& study) {
                       return !study.quantities[other].is_always(usual);
                     }});
  }
  add_needs_of_analyses(needs);
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
