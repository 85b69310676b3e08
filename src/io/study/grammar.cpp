// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/grammar.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "enum_names.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/study_grammar.hpp"
#include "glissade/study/config.hpp"
#include "project/project_keys.hpp"
#include "toml/written_units.hpp"

namespace glissade {
namespace {

constexpr const char* quantity_value =
    "number, list, { from, to, count }, { mean, std } or a distribution";

template <class E>
std::string one_of(EnumNames<E> names) {
  std::string text;
  for (const auto& [name, value] : names)
    text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\"";
  return text;
}

/// As it stands in a study file.
template <class E>
std::string quoted(EnumNames<E> names, E value) {
  const auto found = std::ranges::find(names, value, &std::pair<const char*, E>::second);
  return std::string("\"") + found->first + "\"";
}

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
        "of the samples and of the bootstrap"},
       {"study", "units", one_of(unit_names()), quoted(unit_names(), usual.units),
        "of the report: metres or inches first; CSV and HDF5 files are in metres"},
       {"suite", "file", "path", "required (or files)", "suite file, relative to the study file"},
       {"suite", "files", "list of paths", "none", "several suites in one study"},
       {"suite", "records", "list of ids", "all", "the records to run"},
       {"intensity", "measure", "name", "required", measures()},
       {"intensity", "levels", "list or { from, to, count, spacing }", "required",
        "the levels, increasing, in the measure's unit; spacing \"linear\" or \"log\""},
       {"intensity", "scaled_to_s", "number", fmt::format("{:g}", usual.intensity.scaled_to_s),
        "sds_g: the suite's average is 0.9 of the design spectrum or more from 2 s to here too, s"},
       {"intensity", "sa_period_s", "number", "required with sa_g",
        "period of the spectral "
        "acceleration, s"},
       {"intensity", "avg_sa_periods_s", "list or { from, to, count }", "required with avg_sa_g",
        "periods of the average spectral acceleration, s"},
       {"intensity", "target",
        "{ edition, ss_g, s1_g, site_class or site_classes, tl_s }, { edition, sds_g, sd1_g, tl_s "
        "} or "
        "{ edition, spectrum }",
        "that of the suite",
        "the design spectrum: shape for sds_g, demand for building.response_modification; "
        "site_class is a letter or \"default\"; spectrum is a CSV file with the columns period_s "
        "and "
        "design_sa_g or mce_sa_g"},
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
  keys.push_back({"roof", "rise_in_12", quantity_value, "slope_deg", "the slope as a rise in 12"});
}

void add_cases(std::vector<GrammarKey>& keys) {
  const StudyConfig usual;
  keys.insert(
      keys.end(),
      {{"friction", "value", one_of(friction_value_names()) + ", or a list",
        "what the analyses need: [fragility] both, [chart] \"sampled\", [clearance] \"design\"",
        "of friction that is drawn: the samples, or mean - 2 std (Walters et al. 2012)"},
       {"friction", "file", "path", "none", "pull tests that give mu (CSV; see Pull tests)"},
       {"friction", "direction", "name", "the only one", "direction of the pull tests for mu"},
       {"friction", "across_direction", "name", "none",
        "direction of the pull tests for across_mu"},
       {"friction", "slip_m", "number", "see Pull tests", "slip from which a pull slides, m"},
       {"friction", "sliding_from_m", "number", "see Pull tests",
        "slip from which sliding friction is averaged, m"},
       {"array", "support", one_of(support_names()) + ", or a list",
        quoted(support_names(), usual.support.front()),
        "how the array stands on its building: by friction, fixed, or not at all"},
       {"vertical", "use", one_of(vertical_names()) + ", or a list",
        quoted(vertical_names(), usual.vertical.front()),
        "whether the vertical ground motion acts"},
       {"orientation", "choice", one_of(orientation_names()),
        "\"all_permutations\" with [chart] or [clearance]; else \"random\" where the study draws "
        "samples or has [fragility]",
        "directions of the horizontal components relative to the building: drawn for each sample; "
        "either "
        "component along the first axis with either sign, the other with either sign; every 22.5 "
        "degrees; as recorded"},
       {"orientation", "slope_axis", one_of(slope_axis_names()) + ", or a list",
        quoted(slope_axis_names(), usual.orientation.slope_axis.front()),
        "the array's axis along the slope; friction.mu is along E-W, across_mu along "
        "N-S"},
       {"orientation", "component", "\"first\", \"second\", \"random\"", "\"random\"",
        "the component along the first axis"},
       {"orientation", "sign", "\"positive\", \"negative\", \"random\"", "\"random\"", "its sign"},
       {"orientation", "second_sign", "\"positive\", \"negative\", \"random\"", "\"random\"",
        "sign of the other component"},
       {"sampling", "method", "\"sobol\", \"monte_carlo\"", "\"sobol\"",
        "scrambled Sobol points, or independent ones"},
       {"sampling", "samples", "whole number", fmt::format("{}", usual.sampling.samples),
        "samples of what is drawn; for Sobol a power of two"},
       {"sampling", "scrambles", "whole number", "1",
        "independent parts of the samples; two or more give the sampling error beside that of the "
        "records"},
       {"sampling", "target_error", "number", "none: all scrambles are run",
        "ends the run after the scramble with which half of the 95 % interval of every median, of "
        "the "
        "samples alone, is this share of it or less: 0.01 is 1 %"},
       {"sampling", "bootstrap_replicates", "whole number",
        fmt::format("{}", usual.sampling.bootstrap_replicates),
        "resamples of whole records for the intervals"}});
}

void add_analyses(std::vector<GrammarKey>& keys) {
  const StudyConfig usual;
  keys.insert(
      keys.end(),
      {{"fragility", "thresholds_m", "list or { from, to, count }", "required",
        "clearances, m: probability that displacement exceeds each"},
       {"fragility", "stop_at_largest", "true or false", "false",
        "levels above the one that reaches the largest threshold are not run"},
       {"impact", "", "an empty table", "absent",
        "when and how fast each threshold is first reached; needs [fragility]"},
       {"hazard", "curve", "path", "none",
        "how often the site has shaking, CSV: the study's intensity measure (its key is the "
        "header), annual_rate of exceeding it; needs [fragility]"},
       {"hazard", "k0", "number", "none",
        "in place of a curve: annual rate of exceeding x = k0 x^-k"},
       {"hazard", "k", "number", "none", "the exponent of that"},
       {"hazard", "sds_g", "number", "none",
        "S_DS of the site, g: rates of the prescribed displacements; with k and without k0 the "
        "curve is assumed from it, by the risk target of ASCE 7"},
       {"hazard", "design_life_years", "number", "required",
        "slip is accumulated, and probabilities are given, over so many years"},
       {"hazard", "target_rates_per_year", "list or { from, to, count }",
        "1/700, 1/2475 and 1 % in 50 years",
        "the displacement that is exceeded at each of these annual rates is found"},
       {"standards", "compare", "list of \"seaoc_pv1_2012\", \"asce7_16\"", "required",
        "prescriptive displacements to compare with; needs measure = \"sds_g\""},
       {"standards", "importance", "number", fmt::format("{:g}", usual.standards.importance),
        "importance factor, 1 to 1.5"},
       {"standards", "seismic_design_category", "\"A\" to \"F\"", "\"D\"",
        "seismic design category"},
       {"verdict", "exceedance", "list", "[0.1, 0.05, 0.01]",
        "prescribed displacements are judged: the first probability of exceedance is accepted at "
        "S_DS; the displacement of each is found; needs [standards], and levels of which 1.5 times "
        "are listed too (MCE)"},
       {"sensitivity", "", "an empty table", "absent",
        "where the spread comes from: Sobol indices of the records and of each drawn quantity; "
        "runs "
        "samples x (2 + drawn quantities) samples; needs [fragility]"},
       {"rare", "thresholds_m", "list or { from, to, count }", "required",
        "clearances, m: small probabilities that displacement reaches each, at each level; drawn "
        "quantities without bounds are drawn from wider distributions, with weights; stands alone"},
       {"rare", "widening", "number", fmt::format("{:g}", RareConfig{}.widening),
        "factor on the standard normal numbers of these quantities, 1 to 10"},
       {"intensity_measures", "sa_periods_s", "list or { from, to, count }", "0.2, 0.5, 1, 2",
        "intensity measures are ranked, spectral accelerations at these periods (0.02 to 4 s) "
        "among "
        "them; needs [fragility], and another measure than ppa_g"},
       {"chart", "shown", "{ slope_deg or rise_in_12, mu, level }", "the middle; the highest level",
        "where the figures cut through the chart"},
       {"chart", "read",
        "[[chart.read]] with level, slope_deg or rise_in_12, and mu or displacement_m", "none",
        "a displacement, or the friction required for one, read off the chart"},
       {"chart", "without_target", "true or false", "false",
        "chart clearances also of a suite that does not meet its design spectrum: not for design"},
       {"clearance", "without_target", "true or false", "false",
        "a clearance also of a suite that does not meet a design spectrum: not for design"},
       {"clearance", "orientation", one_of(orientation_rule_names()),
        quoted(orientation_rule_names(), ClearanceConfig{}.orientation),
        "of the suite's means, each with all records in one orientation, the one that is the "
        "recommended clearance; Walters et al. (2012) take the median"},
       {"clearance", "factor", "number", fmt::format("{:g}", ClearanceConfig{}.factor),
        "required clearance: this factor on the suite's mean displacement, the largest over the "
        "periods (Walters et al. 2012); also of a [chart]"},
       {"shape", "", "an empty table", "absent",
        "whether the fragilities are lognormal and what else they could be; needs [fragility]"},
       {"base_shear", "", "an empty table", "absent", "peak base shear; needs [model] axes = 2"},
       {"tipping", "centre_of_mass_height_m", "number", "required",
        "of the array above the roof, m: where the body begins to tip is checked"},
       {"tipping", "base_width_m", "number", "required", "of the array along the slope, m"}});
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

/// Keys of a project file.
std::string project_text(const std::string& wanted) {
  std::string text, table;
  for (const ProjectKey& key : project_keys()) {
    if (wanted != key.table && wanted != key.key &&
        wanted != fmt::format("{}.{}", key.table, key.key))
      continue;
    if (table != key.table)
      text += fmt::format("{}[{}] of a project (glissade clearance)\n", text.empty() ? "" : "\n",
                          key.table);
    table = key.table;
    text += explained(key.key, fmt::format("for example {}", key.example), {key.meaning});
  }
  return text;
}

}  // namespace

std::vector<GrammarKey> grammar() {
  std::vector<GrammarKey> keys;
  add_head(keys);
  add_quantities(keys);
  add_cases(keys);
  add_analyses(keys);
  for (const KeyNeeds& n : key_needs()) {
    const auto key = std::ranges::find(keys, std::string(n.table) + "." + n.key, &GrammarKey::name);
    const bool is_first = key->meaning.find("; needs ") == std::string::npos;
    key->meaning += std::string(is_first ? "; needs " : " and ") + n.needs;
  }
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

std::string grammar_text(const std::string& wanted) {
  if (std::string measure = measure_text(wanted); !measure.empty()) return measure;
  std::string text, table;
  for (const GrammarKey& key : grammar()) {
    if (!is_meant(key, wanted)) continue;
    if (key.table != table) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.table);
    table = key.table;
    std::vector<std::string> lines{"usual: " + key.usual, key.meaning};
    if (const KeyUnits* units = units_of_key(key.key))
      lines.push_back("units, in quotes: " + units->names());
    text += explained(key.key.empty() ? "(no keys)" : key.key, key.value, lines);
  }
  const std::string of_project = project_text(wanted);
  return text + (text.empty() || of_project.empty() ? "" : "\n") + of_project;
}

std::string nearest_grammar_key(const std::string& wanted) {
  std::vector<std::string> names;
  for (const GrammarKey& key : grammar()) names.insert(names.end(), {key.table, key.key});
  for (const ProjectKey& key : project_keys()) names.emplace_back(key.key);
  return nearest_word(wanted.substr(wanted.find('.') + 1), names);  // of table.key the key
}

std::string grammar_page() {
  std::string page =
      "# The keys of a study file\n\n"
      "Made by `glissade explain --markdown`; do not edit. A quantity is a number, a list (every "
      "value is run, in all combinations), or a distribution (a value is drawn for each "
      "sample).\n\n"
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
                        key.value, key.usual, key.meaning);
  }
  return page;
}

}  // namespace glissade
