// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "analysis/in_files.hpp"
#include "enum_names.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/study_grammar.hpp"
#include "glissade/study/config.hpp"
#include "product/product_keys.hpp"
#include "project/project_keys.hpp"
#include "study/quantity_table.hpp"
#include "toml/written_units.hpp"

namespace glissade {
namespace {

std::string measures() {
  std::string text;
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure m = IntensityMeasure::number(i);
    text += fmt::format("{}{} ({}): {}", i > 0 ? "; " : "", m.key(), m.unit(), m.meaning());
  }
  return text;
}

void add_head(std::vector<GrammarKey>& keys) {
  const StudyConfig usual;
  keys.insert(
      keys.end(),
      {{"study", "name", "text", "required", "name of the study"},
       {"study", "description", "text", "\"\"", "what it is, in a sentence"},
       {"study", "seed", "whole number", fmt::format("{}", usual.seed),
        "seed of the samples and of the bootstrap"},
       {"study", "units", one_of(unit_names()), quoted(unit_names(), usual.units),
        "units of the report, metres or inches first; CSV and HDF5 files are in metres"},
       {"suite", "file", "path", "required (or files)", "suite file, relative to the study file"},
       {"suite", "files", "list of paths", "none", "several suites in one study"},
       {"suite", "stripes", "list of paths", "none",
        "multiple stripes: the suite of each of intensity.levels, in their order; its records are "
        "run at that level only"},
       {"suite", "records", "list of ids", "all", "the records to run"},
       {"suite", "normalise", "name", "none",
        "pgv: each record is scaled to the suite's median PGV first (FEMA P-695, A.8, recalled): "
        "what "
        "remains between records is not how strong their earthquakes were"},
       {"intensity", "measure", "name", "required", measures()},
       {"intensity", "levels", list_value, "required",
        "the levels, increasing, in the measure's unit"},
       {"intensity", "scaling_rule", one_of(scaling_rule_names()),
        quoted(scaling_rule_names(), usual.intensity.scaling_rule),
        "how a suite is scaled to its design spectrum: by Walters et al. (2012), or by a clause of "
        "ASCE 7 (suites/README.md), at DBE and MCE. With sds_g the study scales the suite as a "
        "whole; with mce_fraction its file must"},
       {"intensity", "to_1_5_t", "true or false", "false",
        "asce7_16, asce7_22: up to 1.5 times the longest period in place of 2, where a dynamic "
        "analysis justifies it (16.2.3.1)"},
       {"intensity", "scaled_to_s", "number", fmt::format("{:g}", usual.intensity.scaled_to_s),
        "sds_g: the suite's average is 0.9 of the design spectrum or more from 2 s to here too, s"},
       {"intensity", "sa_period_s", "number", "required with sa_g and sa_rotd50_g",
        "period of the spectral acceleration, s"},
       {"intensity", "avg_sa_periods_s", list_value, "required with avg_sa_g",
        "periods of the average spectral acceleration, s"},
       {"intensity", "target",
        "{ edition, ss_g, s1_g, site_class or site_classes, tl_s, hazard_analysis }, { edition, "
        "sds_g, sd1_g, tl_s } or { edition, spectrum }",
        "that of the suite",
        "the design spectrum: shape for sds_g, demand for building.response_modification; "
        "site_class is a letter or \"default\"; spectrum is a CSV file with the columns period_s "
        "and design_sa_g or mce_sa_g; hazard_analysis states the exception of ASCE 7-16, 11.4.8, "
        "that is taken, or the report of the analysis"},
       {"model", "axes", "1 or 2", usual.two_axes() ? "2" : "1",
        "along how many horizontal axes the array may slide; along one it slides less than under "
        "both components"},
       {"model", "displacement", one_of(displacement_names()),
        quoted(displacement_names(), usual.model.displacement),
        "SRSS of the separate maxima (Walters et al. 2012), or the longest vector"}});
}

void add_quantities(std::vector<GrammarKey>& keys) {
  const Quantities usual;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const bool mu = p.table == std::string("friction") && p.key == std::string("mu");
    const bool across = p.key == std::string("across_mu");
    keys.push_back({p.table, p.key, quantity_value,
                    mu       ? "required (or file)"
                    : across ? "friction.mu"
                             : describe(usual[i]),
                    fmt::format("{}{}; range: {}", p.meaning,
                                p.unit == std::string("-") || p.unit == std::string("deg")
                                    ? ""
                                    : std::string(", ") + p.unit,
                                p.range.text)});
  }
  keys.insert(
      keys.end(),
      {{"building", "storeys", "whole number", "one mass",
        "the building is a shear building of so many storeys, with the first period period_s"},
       {"building", "storey_masses", list_value, "equal",
        "masses of its floors from the ground up; only their ratios count"},
       {"building", "storey_stiffnesses", list_value, "equal",
        "stiffnesses of its storeys, likewise"},
       {"building", "modes", "list of { period_s, participation, mass_share, damping }", "one mass",
        "the building's modes along its first axis, the longest period first, six at most: "
        "participation is that at the array (gamma in theory.md, 2.5), mass_share the effective "
        "modal mass over the building's mass; damping only if it is not building.damping for all. "
        "period_s and period_ratio then scale the listed periods"},
       {"building", "modes_across", "list of { period_s, participation, mass_share, damping }",
        "modes", "the same along the second axis"}});
  keys.push_back({"roof", "rise_in_12", quantity_value, "slope_deg", "the slope as a rise in 12"});
  keys.push_back({"roof", "neighbour_slope", one_of(neighbour_slope_names()),
                  quoted(neighbour_slope_names(), StudyConfig().neighbour_slope),
                  "where the second array stands: on the same slope, or on one "
                  "that falls toward the first array, across a valley"});
}

void add_cases(std::vector<GrammarKey>& keys) {
  const StudyConfig usual;
  keys.insert(
      keys.end(),
      {{"friction", "value", one_of(friction_value_names()) + ", or a list",
        "what the analyses need: [fragility] both, [chart] \"sampled\", [clearance] \"design\"",
        "which values of drawn friction are run: the samples, or mean - 2 std (Walters et al. "
        "2012)"},
       {"friction", "file", "path", "none", "pull tests that give mu (CSV; see Pull tests)"},
       {"friction", "direction", "name", "the only one", "direction of the pull tests for mu"},
       {"friction", "across_direction", "name", "none",
        "direction of the pull tests for across_mu"},
       {"friction", "slip_m", "number", "see Pull tests", "slip from which a pull slides, m"},
       {"friction", "sliding_from_m", "number", "see Pull tests",
        "slip from which sliding friction is averaged, m"},
       {"array", "support", one_of(support_names()) + ", or a list",
        quoted(support_names(), usual.support.front()),
        "support of the array: by friction, fixed, or no array"},
       {"vertical", "use", one_of(vertical_names()) + ", or a list",
        quoted(vertical_names(), usual.vertical.front()),
        "whether the vertical ground motion acts"},
       {"orientation", "choice", one_of(orientation_names()),
        "\"all_permutations\" with [chart] or [clearance]; else, where the study draws samples or "
        "has [fragility], \"as_recorded\" with measure = \"factor\" and \"random\" with others",
        "directions of the horizontal components relative to the building: drawn for each sample; "
        "either component along the first axis with either sign, the other with either sign; every "
        "22.5 degrees; as recorded"},
       {"orientation", "slope_axis", one_of(slope_axis_names()) + ", or a list",
        quoted(slope_axis_names(), usual.orientation.slope_axis.front()),
        "the array's axis along the slope; friction.mu is along E-W, across_mu along N-S"},
       {"orientation", "component", "\"first\", \"second\", \"random\"", "\"random\"",
        "which component acts along the first axis"},
       {"orientation", "sign", "\"positive\", \"negative\", \"random\"", "\"random\"", "its sign"},
       {"orientation", "second_sign", "\"positive\", \"negative\", \"random\"", "\"random\"",
        "sign of the other component"},
       {"sampling", "method", "\"sobol\", \"monte_carlo\"", "\"sobol\"",
        "scrambled Sobol points, or independent ones"},
       {"sampling", "samples", "whole number", fmt::format("{}", usual.sampling.samples),
        "samples of what is drawn; for Sobol a power of two"},
       {"sampling", "scrambles", "whole number", "1",
        "independent parts of the samples; with two or more the sampling error is given too"},
       {"sampling", "target_error", "number", "none: all scrambles are run",
        "the run ends when half of the 95 % interval of every median, of the samples alone, is at "
        "most this share of the median (0.01 is 1 %); checked after each scramble"},
       {"sampling", "bootstrap_replicates", "whole number",
        fmt::format("{}", usual.sampling.bootstrap_replicates),
        "resamples of whole records for the intervals"}});
}

void add_analyses(std::vector<GrammarKey>& keys) {
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    for (const AnalysisKey& key : analysis.keys)
      keys.push_back({analysis.table, key.key, key.value, key.usual, key.meaning});
  }
}

/// "; needs A and B" behind what a key means.
void add_need(GrammarKey& key, const std::string& what) {
  const bool is_first = key.meaning.find("; needs ") == std::string::npos;
  key.meaning += (is_first ? "; needs " : " and ") + what;
}

std::vector<GrammarKey> make_grammar() {
  std::vector<GrammarKey> keys;
  add_head(keys);
  add_quantities(keys);
  add_cases(keys);
  add_analyses(keys);
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    for (const AnalysisNeeds& need : analysis.needs)
      add_need(*std::ranges::find(keys, analysis.table, &GrammarKey::table), need.what);
  }
  for (const KeyNeeds& n : key_needs())
    add_need(*std::ranges::find(keys, n.table + "." + n.key, &GrammarKey::name), n.needs);
  // A table's keys together, the tables in the order in which they first come; those that are
  // required first.
  std::vector<std::string> tables;
  for (const GrammarKey& key : keys) {
    if (std::ranges::find(tables, key.table) == tables.end()) tables.push_back(key.table);
  }
  std::ranges::stable_sort(keys, {}, [&](const GrammarKey& key) {
    const int rank = key.usual.starts_with("required") ? 0 : key.key == "across_mu" ? 1 : 2;
    return std::pair(std::ranges::find(tables, key.table) - tables.begin(), rank);
  });
  return keys;
}

std::string text_of(const DistributionForm& form) {
  return fmt::format("{{ distribution = \"{}\", {} }}", form.name, form.keys);
}

std::string distributions_text() {
  std::string text;
  for (const DistributionForm& form : distribution_forms())
    text += (text.empty() ? "" : ", ") + text_of(form);
  return text;
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_of_word = [](char c) { return std::isalnum(c) || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (end == text.size() || !is_of_word(text[end])))
      return true;
  }
  return false;
}

/// A table, a key with or without its table, or one of its values.
bool is_meant(const GrammarKey& key, const std::string& wanted) {
  return wanted.empty() || key.table == wanted || key.name() == wanted || key.key == wanted ||
         key.value.find('"' + wanted + '"') != std::string::npos;
}

std::string explained(const std::string& name, const std::string& value,
                      const std::vector<std::string>& lines) {
  std::string text = fmt::format("  {:<24} {}\n", name, wrapped(value, terminal_width, 27));
  for (const std::string& line : lines)
    text += fmt::format("{:27}{}\n", "", wrapped(line, terminal_width, 27));
  return text;
}

/// Of "sa_g" or "sa"; else empty.
std::string measure_text(const std::string& wanted) {
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure m = IntensityMeasure::number(i);
    const std::string key = m.key();
    if (key != wanted && (wanted.empty() || !key.starts_with(wanted + "_"))) continue;
    std::vector<std::string> lines{m.meaning()};
    if (m.own_key() != nullptr)
      lines.push_back(fmt::format("with the key intensity.{}", m.own_key()));
    return "[intensity]\n" +
           explained("measure",
                     fmt::format("\"{}\", levels in {}", key,
                                 m.unit() == std::string("-") ? "parts" : m.unit()),
                     lines);
  }
  return "";
}

/// The keys that are meant, by table.
template <class Lines>
std::string text_of(const std::vector<GrammarKey>& keys, const std::string& wanted,
                    const char* of_table, Lines lines) {
  std::string text, table;
  for (const GrammarKey& key : keys) {
    if (!is_meant(key, wanted)) continue;
    if (key.table != table)
      text += fmt::format("{}[{}]{}\n", text.empty() ? "" : "\n", key.table, of_table);
    table = key.table;
    text += lines(key);
  }
  return text;
}

std::string study_text(const GrammarKey& key) {
  std::vector<std::string> lines{"usual: " + key.usual, key.meaning};
  if (const KeyUnits* units = units_of_key(key.key))
    lines.push_back("units, in quotes: " + units->names());
  return explained(key.key.empty() ? "(no keys)" : key.key, key.value, lines);
}

std::string project_text(const GrammarKey& key) {
  return explained(key.key, "for example " + key.value, {key.meaning});
}

}  // namespace

const std::vector<GrammarKey>& grammar() {
  static const std::vector<GrammarKey> keys = make_grammar();
  return keys;
}

bool has_key(const std::vector<GrammarKey>& keys, const std::string& name) {
  const std::size_t dot = name.find('.'), next = name.find('.', dot + 1);
  return std::ranges::any_of(keys, [&](const GrammarKey& key) {
    if (dot == std::string::npos) return key.table == name;
    if (next == std::string::npos) return key.name() == name;
    const std::string values =
        key.value == quantity_value ? key.value + distributions_text() : key.value;
    return key.name() == name.substr(0, next) && has_word(values, name.substr(name.rfind('.') + 1));
  });
}

std::string grammar_text(const std::string& wanted) {
  if (std::string measure = measure_text(wanted); !measure.empty()) return measure;
  std::string text = text_of(grammar(), wanted, "", study_text);
  for (const DistributionForm& form : distribution_forms()) {
    if (wanted == form.name || wanted == "distribution")
      text += explained(form.name, text_of(form), {});
  }
  if (wanted.empty()) return text;
  const std::string of_project =
      text_of(project_grammar(), wanted, " of a project (glissade clearance)", project_text);
  const std::string of_product =
      text_of(product_grammar(), wanted, " of a product sheet (glissade clearance)", project_text);
  for (const std::string& more : {of_project, of_product})
    text += (text.empty() || more.empty() ? "" : "\n") + more;
  return text;
}

std::string nearest_grammar_key(const std::string& wanted) {
  std::vector<std::string> names;
  for (const GrammarKey& key : grammar()) names.insert(names.end(), {key.table, key.key});
  for (const auto* keys : {&project_grammar(), &product_grammar()})
    for (const GrammarKey& key : *keys) names.push_back(key.key);
  return nearest_word(wanted.substr(wanted.find('.') + 1), names);  // of table.key the key
}

std::string grammar_page() {
  std::string page =
      "# The keys of a study file\n\n"
      "Made by `glissade explain --markdown`; do not edit. A *list* is [1, 2, 4] or { from, to, "
      "count, spacing }, with spacing \"linear\" (where absent) or \"log\". A *quantity* is a "
      "number; a list (every value is run, in all combinations); { mean, std }, a normal "
      "distribution within the range; or a distribution (a value is drawn for each sample): " +
      distributions_text() +
      ".\n\n"
      "A number is in the unit at the end of its key (a level in the unit of its measure), or is "
      "written with one of these units, in quotes: `\"18 in\"`, `\"0.25:12\"`. A list may mix "
      "them.\n\n"
      "| key | units |\n|---|---|\n";
  for (const KeyUnits& row : all_key_units())
    page += fmt::format("| `{}` | {} |\n", row.suffix, row.names());
  std::string table;
  for (const GrammarKey& key : grammar()) {
    if (key.table != table)
      page += fmt::format(
          "\n## [{}]\n\n| key | value | where absent | meaning |\n|---|---|---|---|\n", key.table);
    table = key.table;
    page += fmt::format("| {} | {} | {} | {} |\n", key.key.empty() ? "" : "`" + key.key + "`",
                        key.value == list_value       ? "list"
                        : key.value == quantity_value ? "quantity"
                                                      : key.value,
                        key.usual, key.meaning);
  }
  return page;
}

}  // namespace glissade
