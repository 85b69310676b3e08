// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "analysis/in_files.hpp"
#include "keys/quantity_table.hpp"

namespace glissade {
namespace {

bool is_always(const StudyConfig& study, const char* table, const char* key, double value) {
  return study.quantities.at(table, key).is_always(value);
}

const StudyNeed needs_two_axes{"[model] axes = 2", [](auto&, auto& s) { return s.two_axes(); }};
const StudyNeed needs_pull_tests{
    "friction.file", [](auto& root, auto&) { return root.table("friction").has("file"); }};
const StudyNeed needs_random{"choice = \"random\"", [](auto&, auto& s) {
                               return s.orientation.choice == OrientationChoice::random;
                             }};
const StudyNeed needs_vertical{"a use other than \"none\"", [](auto&, auto& s) {
                                 return s.vertical != std::vector{VerticalChoice::none};
                               }};
const StudyNeed needs_draws{"a quantity or an orientation that is drawn",
                            [](auto&, auto& s) { return s.draws(); }};
const StudyNeed needs_all_levels{"a study without suite.stripes",
                                 [](auto&, auto& s) { return !s.by_stripes; }};

std::string measures() {
  std::string text = "what levels are of (each: glissade explain NAME): ";
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i)
    text += (i > 0 ? ", " : "") + std::string(IntensityMeasure::number(i).key());
  return text;
}

std::vector<StudyNeed> needs_of(const Parameter& p) {
  std::vector<StudyNeed> needs;
  if (p.axes == Parameter::Axes::two) needs.push_back(needs_two_axes);
  if (p.table == std::string("vertical")) needs.push_back(needs_vertical);
  if (p.key == std::string("hardening_ratio"))
    needs.push_back({"response_modification or yield_coefficient", [](auto&, auto& s) {
                       return !is_always(s, "building", "response_modification", 0.0) ||
                              !is_always(s, "building", "yield_coefficient", 0.0);
                     }});
  if (p.needs == nullptr) return needs;
  const std::size_t other = parameter_index(p.table, p.needs);
  const double usual = value_of(parameters()[other], Case());
  needs.push_back({fmt::format("{} other than {:g}", p.needs, usual),
                   [=](const TomlTable&, const StudyConfig& study) {
                     return !study.quantities[other].is_always(usual);
                   }});
  return needs;
}

/// A row for each parameter of the table; that of mu, which is required, comes first.
std::vector<StudyKey> quantities_of(const std::string& table, std::vector<StudyKey> others) {
  std::vector<StudyKey> rows;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    if (p.table != table) continue;
    const std::string key = p.key, unit = p.unit;
    const auto read = [&p, i](const TomlTable& of, const char* name, StudyConfig& study) {
      if (auto quantity = read_quantity(of, name, p.range)) study.quantities[i] = *quantity;
      study.quantities[i].is_stated = of.has(name);
    };
    const bool is_warned_of = p.name() == "building.period_s" || p.name() == "roof.slope_deg";
    const std::string usual = describe(Quantities()[i]) + (is_warned_of ? ", with a warning" : "");
    rows.push_back({p.key,
                    Reading{quantity_value,
                            key == "mu"           ? "required (or file)"
                            : key == "across_mu"  ? "friction.mu"
                            : p.absent != nullptr ? p.absent
                                                  : usual,
                            read},
                    fmt::format("{}{}; range: {}", p.meaning,
                                unit == "-" || unit == "deg" ? "" : ", " + unit, p.range.text),
                    needs_of(p)});
  }
  const auto rank = [](const StudyKey& row) {
    return row.key == "mu" ? 0 : row.key == "across_mu" ? 1 : 2;
  };
  std::ranges::stable_sort(rows, {}, rank);
  std::ranges::move(others, std::back_inserter(rows));
  return rows;
}

std::vector<StudyTable> tables_of_cases() {
  constexpr auto intensity = &StudyConfig::intensity;
  constexpr NumberRule longest_rule{
      "from 2 to 30",
      [](double x) { return x >= longest_scaled_period_s && x <= longest_possible_scaled_s; },
      "from 0 to 2 s the suite is scaled in any case"};
  constexpr auto model = &StudyConfig::model;
  constexpr const char* modes = "list of { period_s, participation, mass_share, damping }";
  constexpr auto orientation = &StudyConfig::orientation;
  constexpr auto sampling = &StudyConfig::sampling;
  return {
      {"study",
       {{"name", requires_text<&StudyConfig::name>(), "name of the study"},
        {"description", reads<&StudyConfig::description>(), "what it is, in a sentence"},
        {"seed", reads<&StudyConfig::seed>(0, std::numeric_limits<std::int64_t>::max()),
         "seed of the samples and of the bootstrap"},
        {"units", reads<&StudyConfig::units>(unit_names),
         "units of the report, metres or inches first; CSV and HDF5 files are in metres"}}},
      {"suite",
       {{"file", "path", "required (or files)", "suite file, relative to the study file"},
        {"files", "list of paths", "none", "several suites in one study"},
        {"stripes", "list of paths", "none",
         "multiple stripes: the suite of each of intensity.levels, in their order; its records "
         "are run at that level only"},
        {"records", "list of ids", "all", "the records to run"},
        {"normalise", "name", "none",
         "pgv: each record is scaled to the suite's median PGV first (FEMA P-695, A.8, "
         "recalled), which removes the scatter that comes from the strength of shaking"}}},
      {"intensity",
       {{"measure", "name", "required", measures()},
        {"levels", list_value, "required", "the levels, increasing, in the measure's unit"},
        {"scaling_rule",
         reads<intensity, &IntensityConfig::scaling_rule>(scaling_rule_names),
         "how a suite is scaled to its design spectrum (suites/README.md). With sds_g the study "
         "scales the suite as a whole; with mce_fraction its file must",
         {{"measure = \"sds_g\" or \"mce_fraction\"",
           [](auto&, auto& s) { return s.intensity.measure.is_of_design_spectrum(); }}}},
        {"to_1_5_t", reads<intensity, &IntensityConfig::to_one_and_a_half>(),
         "asce7_16, asce7_22: up to 1.5 times the longest period in place of 2, where a dynamic "
         "analysis justifies it (16.2.3.1)"},
        {"scaled_to_s",
         reads<intensity, &IntensityConfig::scaled_to_s>(longest_rule),
         "sds_g: the suite's average is 0.9 of the design spectrum or more from 2 s to here too, s",
         {{"measure = \"sds_g\"",
           [](auto&, auto& s) { return s.intensity.measure == IntensityMeasure::sds_g; }},
          {"scaling_rule = \"walters_2012\"",
           [](auto&, auto& s) { return s.intensity.scaling_rule == ScalingRule::walters_2012; }}}},
        {"sa_period_s", "number", "required with sa_g and sa_rotd50_g",
         "period of the spectral acceleration, s"},
        {"avg_sa_periods_s", list_value, "required with avg_sa_g",
         "periods of the average spectral acceleration, s"},
        {"target",
         "{ edition, ss_g, s1_g, site_class or site_classes, tl_s, hazard_analysis }, { edition, "
         "sds_g, sd1_g, tl_s } or { edition, spectrum }",
         "that of the suite",
         "the design spectrum: shape for sds_g, demand for building.response_modification. "
         "site_class: a letter or \"default\"; spectrum: a CSV file (period_s, design_sa_g or "
         "mce_sa_g); hazard_analysis: \"exception 2 of 11.4.8\", that is taken",
         {{"measure = \"sds_g\" or \"mce_fraction\", or building.response_modification",
           [](auto&, auto& s) {
             return s.intensity.measure.is_of_design_spectrum() ||
                    !is_always(s, "building", "response_modification", 0.0);
           }}}}}},
      {"model",
       {{"axes",
         Reading{"1 or 2", usual_at<model, &ModelConfig::axes>() == SlidingAxes::two ? "2" : "1",
                 [](auto& table, auto key, auto& study) {
                   if (const auto axes = table.whole(key, 1, 2))
                     study.model.axes = *axes == 1 ? SlidingAxes::one : SlidingAxes::two;
                 }},
         "along how many horizontal axes the array may slide; along one it slides less than "
         "under both components"},
        {"displacement",
         reads<model, &ModelConfig::displacement>(displacement_names),
         "SRSS of the separate maxima (Walters et al. 2012), or the longest vector",
         {needs_two_axes}}}},
      {"building",
       quantities_of(
           "building",
           {{"storeys", "whole number", "one mass",
             "the building is a shear building of so many storeys, with the first period period_s; "
             "1: "
             "one mass, without the warning above 0.3 s"},
            {"storey_masses", list_value, "equal",
             "masses of its floors from the ground up; only their ratios count"},
            {"storey_stiffnesses", list_value, "equal", "stiffnesses of its storeys, likewise"},
            {"modes", modes, "one mass",
             "the building's modes along its first axis, the longest period first, six at most "
             "(theory.md, 2.5): participation at the array, effective modal mass over the "
             "building's, damping if not building.damping. period_s and period_ratio scale the "
             "periods"},
            {"modes_across",
             modes,
             "modes",
             "the same along the second axis",
             {{"building.modes",
               [](auto& root, auto&) { return root.table("building").has("modes"); }},
              needs_two_axes}}})},
      {"vertical", quantities_of("vertical", {{"use", reads<&StudyConfig::vertical>(vertical_names),
                                               "whether the vertical ground motion acts"}})},
      {"friction",
       quantities_of(
           "friction",
           {{"value",
             one_of(friction_value_names) + ", or a list",
             "what the analyses need: [fragility] both, [chart] \"sampled\", [clearance] "
             "\"design\"",
             "which values of drawn friction are run: the samples, or mean - 2 std (Walters et al. "
             "2012)",
             {{"friction that is drawn",
               [](auto&, auto& s) {
                 return s.quantities.at("friction", "mu").is_drawn() ||
                        s.quantities.at("friction", "across_mu").is_drawn();
               }}}},
            {"file", "path", "none", "pull tests that give mu (CSV; see Pull tests)"},
            {"direction",
             "name",
             "the only one",
             "direction of the pull tests for mu",
             {needs_pull_tests}},
            {"across_direction",
             "name",
             "none",
             "direction of the pull tests for across_mu",
             {needs_pull_tests, needs_two_axes}},
            {"slip_m",
             "number",
             "see Pull tests",
             "slip from which a pull slides, m",
             {needs_pull_tests}},
            {"sliding_from_m",
             "number",
             "see Pull tests",
             "slip from which sliding friction is averaged, m",
             {needs_pull_tests}}})},
      {"roof",
       quantities_of(
           "roof",
           {{"rise_in_12", quantity_value, "slope_deg", "the slope as a rise in 12"},
            {"neighbour_slope",
             reads<&StudyConfig::neighbour_slope>(neighbour_slope_names),
             "where the second array stands: on the same slope, or on one that falls toward the "
             "first array, across a valley",
             {{"friction.neighbour_mu or friction.neighbour_over_mu above 0",
               [](auto&, auto& s) { return s.has_neighbours(); }},
              {"a slope other than 0",
               [](auto&, auto& s) { return !is_always(s, "roof", "slope_deg", 0.0); }}}}})},
      {"array",
       {{"support",
         reads<&StudyConfig::support>(support_names),
         "support of the array: by friction, fixed, or no array",
         {{"[base_shear], where it is a list",
           [](auto&, auto& s) { return s.support.size() == 1 || s.base_shear; }}}}}},
      {"orientation",
       {{"choice", one_of(orientation_names),
         "\"all_permutations\" with [chart] or [clearance]; else, where the study draws samples or "
         "has [fragility], \"as_recorded\" with measure = \"factor\" and \"random\" with others",
         "directions of the horizontal components relative to the building: drawn for each sample; "
         "either component along the first axis with either sign, the other with either sign; "
         "every "
         "22.5 degrees; as recorded"},
        {"slope_axis",
         reads<orientation, &OrientationConfig::slope_axis>(slope_axis_names),
         "the array's axis along the slope; friction.mu is along E-W, across_mu along N-S",
         {needs_two_axes}},
        {"component",
         reads<orientation, &OrientationConfig::component>(component_names),
         "which component acts along the first axis",
         {needs_random}},
        {"sign",
         reads<orientation, &OrientationConfig::sign>(sign_names),
         "its sign",
         {needs_random}},
        {"second_sign",
         reads<orientation, &OrientationConfig::second_sign>(sign_names),
         "sign of the other component",
         {needs_random, needs_two_axes}}}},
      {"sampling",
       {{"method",
         reads<sampling, &SamplingConfig::method>(sampling_method_names),
         "scrambled Sobol points, or independent ones",
         {needs_draws}},
        {"samples",
         reads<sampling, &SamplingConfig::samples>(1, std::numeric_limits<std::uint32_t>::max()),
         "samples of what is drawn; for Sobol a power of two",
         {needs_draws}},
        {"scrambles",
         reads<sampling, &SamplingConfig::scrambles>(1, 1024),
         "independent parts of the samples; with two or more the sampling error is given too",
         {needs_draws, needs_all_levels}},
        {"target_error",
         "number",
         "none: all scrambles are run",
         "the run ends when half of the 95 % interval of every median, of the samples alone, is "
         "at most this share of the median (0.01 is 1 %); checked after each scramble from "
         "least_scrambles on",
         {needs_draws,
          {"a study without [sensitivity]", [](auto&, auto& s) { return !s.sensitivity; }},
          {"sampling.scrambles of 8 or more",
           [](auto&, auto& s) { return s.sampling.scrambles >= least_scrambles; }},
          needs_all_levels}},
        {"least_scrambles",
         reads<sampling, &SamplingConfig::scrambles_to_target>(least_scrambles, 1024),
         "scrambles that are run before target_error can end the run: the error of few is more "
         "often too small by chance",
         {{"sampling.target_error", [](auto&, auto& s) { return s.sampling.target.has_value(); }},
          {"sampling.scrambles of as many or more",
           [](auto&, auto& s) { return s.sampling.scrambles >= s.sampling.scrambles_to_target; }}}},
        {"bootstrap_replicates",
         reads<sampling, &SamplingConfig::bootstrap_replicates>(100, 1000000),
         "resamples of whole records for the intervals"}}}};
}

/// Keys that only some analyses use.
void add_uses(std::vector<StudyTable>& tables) {
  for (StudyTable& table : tables) {
    for (StudyKey& key : table.keys) {
      const std::string name = table.name + "." + key.key;
      const auto users = tables_where([&](const AnalysisInFiles& analysis) {
        return std::ranges::find(analysis.uses, name) != analysis.uses.end();
      });
      if (users.empty()) continue;
      key.needs.push_back(
          {listed(users, " or "), [users](const TomlTable& root, const StudyConfig&) {
             return std::ranges::any_of(users,
                                        [&](const std::string& user) { return root.has(user); });
           }});
    }
  }
}

std::vector<StudyTable> make_tables() {
  std::vector<StudyTable> tables = tables_of_cases();
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (analysis.table == nullptr) continue;
    tables.push_back({analysis.table, analysis.keys, {}});
    for (const StudyNeed& need : analysis.needs) tables.back().needs.push_back(need.what);
  }
  add_uses(tables);
  return tables;
}

}  // namespace

const std::vector<StudyTable>& study_tables() {
  static const std::vector<StudyTable> tables = make_tables();
  return tables;
}

namespace {

/// Whether its usual value holds, and another one could be stated beside what the study states.
bool holds_as_usual(std::size_t i, const StudyConfig& study) {
  constexpr std::array instead{std::array{"response_modification", "yield_coefficient"},
                               std::array{"neighbour_mu", "neighbour_over_mu"}};
  const Parameter& p = parameters()[i];
  const BuildingModel& building = study.building;
  const std::string key = p.key;
  const auto is_usual = [&](std::size_t of) {
    return study.quantities[of].is_always(value_of(parameters()[of], Case()));
  };
  if (key == "across_mu") return !study.friction.across_is_given;
  if (study.quantities[i].is_stated || !is_usual(i)) return false;  // another key gives it
  if (p.moves_roof() && key != "period_s" && is_always(study, p.table, "period_s", 0.0))
    return false;
  if (p.is_of != nullptr && !p.is_of(building) && !building.is_one_mass()) return false;
  if (key == "alpha" && building.is_one_storey) return false;
  for (const auto& pair : instead) {
    if (std::ranges::find(pair, key) == pair.end()) continue;
    if (p.moves_roof() && !building.is_one_mass()) return false;  // only one mass yields
    for (const char* other : pair)
      if (!is_usual(parameter_index(p.table, other))) return false;
  }
  return true;
}

}  // namespace

std::vector<StudyConfig::NotStated> keys_not_stated(const TomlTable& root,
                                                    const StudyConfig& study) {
  std::vector<StudyConfig::NotStated> all;
  for (const StudyTable& of : study_tables()) {
    const bool is_analysis = std::ranges::any_of(analyses_in_files(), [&](const auto& analysis) {
      return analysis.table != nullptr && of.name == analysis.table;
    });
    if (of.name == "study" || (is_analysis && !root.has(of.name))) continue;
    const TomlTable table = root.table(of.name);
    for (const StudyKey& row : of.keys) {
      const std::string name = of.name + "." + row.key;
      const bool has_value = row.read && !row.usual.starts_with("required") &&
                             row.usual != "none" && row.usual != "absent" && row.usual != "false";
      const auto p = std::ranges::find(parameters(), name, &Parameter::name);
      const bool is_parameter = p != parameters().end();
      if (!has_value || table.has(row.key) ||
          (is_parameter &&
           !holds_as_usual(static_cast<std::size_t>(p - parameters().begin()), study)))
        continue;
      if (std::ranges::all_of(row.needs,
                              [&](const StudyNeed& need) { return need.is_met(root, study); }))
        all.push_back({name + ": " + row.usual, is_parameter ? &*p : nullptr});
    }
  }
  return all;
}

void refuse_idle_keys(const TomlTable& root, const StudyConfig& study) {
  for (const StudyTable& of : study_tables()) {
    if (!root.has(of.name) || !root.is_table(of.name)) continue;
    const TomlTable table = root.table(of.name);
    for (const StudyKey& row : of.keys) {
      if (row.needs.empty() || !table.has(row.key)) continue;
      const auto unmet = std::ranges::find_if(
          row.needs, [&](const StudyNeed& need) { return !need.is_met(root, study); });
      if (unmet != row.needs.end())
        table.report_idle(row.key, table.name_of(row.key) + " needs " + unmet->what);
    }
  }
}

}  // namespace glissade
