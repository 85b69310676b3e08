// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "clearance_names.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/clearance_file.hpp"
#include "glissade/io/csv.hpp"
#include "number_list.hpp"
#include "suite_choice.hpp"
#include "toml_table.hpp"

namespace glissade {
namespace {

constexpr double most_conditions = 100000;
constexpr std::uint64_t largest_seed = std::uint64_t{1} << 62;

constexpr NumberRule mass_rule{"from 0 to 1", [](double x) { return x >= 0.0 && x <= 1.0; },
                               "it is the array's mass over the building's"};
constexpr NumberRule r_rule{"1 or more", [](double x) { return x >= 1.0; },
                            "1 is a building that stays elastic"};
constexpr NumberRule slope_rule{"in degrees, 0 to 45",
                                [](double x) { return x >= 0.0 && x <= 45.0; },
                                "the roof falls along its slope axis"};
constexpr NumberRule rise_rule{"from 0 to 12", [](double x) { return x >= 0.0 && x <= 12.0; },
                               "a rise of 12 in 12 is 45 degrees"};
constexpr NumberRule mu_rule{"above 0 and up to 2", [](double x) { return x > 0.0 && x <= 2.0; },
                             "without friction nothing holds the array"};
constexpr NumberRule damping_rule{"0 or more and below 1",
                                  [](double x) { return x >= 0.0 && x < 1.0; }};
constexpr NumberRule factor_rule{"1 or more", [](double x) { return x >= 1.0; }};

std::vector<double> increasing_or(const TomlTable& table, const char* key, const NumberRule& rule,
                                  std::vector<double> otherwise) {
  return table.has(key) ? read_increasing(table, key, rule) : otherwise;
}

/// Names, each once.
template <class E>
std::vector<E> choices_or(const TomlTable& table, const char* key, EnumNames<E> names,
                          std::vector<E> otherwise) {
  const auto given = table.choices<E>(key, names);
  if (!given) return otherwise;
  if (given->empty()) table.report(key, table.name_of(key) + " is empty", "name at least one");
  for (std::size_t i = 0; i < given->size(); ++i) {
    if (std::find(given->begin(), given->begin() + static_cast<std::ptrdiff_t>(i), (*given)[i]) !=
        given->begin() + static_cast<std::ptrdiff_t>(i))
      table.report(key, table.name_of(key) + " names one twice", "name each once");
  }
  return given->empty() ? otherwise : *given;
}

std::vector<double> read_slopes(const TomlTable& table) {
  if (!table.has("rise_in_12")) return read_increasing(table, "slope_deg", slope_rule);
  std::vector<double> slopes = read_increasing(table, "rise_in_12", rise_rule);
  for (double& slope : slopes) slope = std::atan(slope / 12.0) / rad_per_deg;
  if (table.has("slope_deg")) {
    table.numbers("slope_deg");
    table.report("slope_deg", "clearance_study.slope_deg and rise_in_12 are both given",
                 "give the slopes one way");
  }
  return slopes;
}

std::vector<VerticalCondition> read_verticals(const TomlTable& table) {
  const auto uses = choices_or<VerticalChoice>(table, "vertical", vertical_names(),
                                               {VerticalChoice::if_available});
  const auto periods = increasing_or(table, "vertical_period_s", not_negative, {0.0});
  std::vector<VerticalCondition> conditions;
  for (const VerticalChoice use : uses) {
    if (use == VerticalChoice::none)
      conditions.push_back({use, 0.0});
    else
      for (const double period : periods) conditions.push_back({use, period});
  }
  return conditions;
}

/// The isolated array first, as what is shown where nothing else is said.
std::vector<ArraySupport> read_supports(const TomlTable& table) {
  auto supports =
      choices_or<ArraySupport>(table, "support", support_names(), {ArraySupport::isolated});
  const auto isolated = std::ranges::find(supports, ArraySupport::isolated);
  if (isolated == supports.end()) {
    table.report("support", table.name_of("support") + " leaves out \"isolated\"",
                 "an array that does not slide needs no clearance: name isolated too");
  } else {
    std::rotate(supports.begin(), isolated, isolated + 1);
  }
  return supports;
}

ClearanceGrid read_grid(const TomlTable& table) {
  ClearanceGrid grid;
  grid.support = read_supports(table);
  grid.vertical = read_verticals(table);
  grid.response_modification = increasing_or(table, "response_modification", r_rule, {1.0});
  grid.mass_ratio = increasing_or(table, "mass_ratio", mass_rule, {0.05});
  grid.slope_deg = read_slopes(table);
  grid.fraction_of_mce = increasing_or(table, "fraction_of_mce", above_zero, {2.0 / 3});
  grid.period_s = read_increasing(table, "period_s", not_negative);
  if (!grid.response_modification.empty() && grid.response_modification.back() > 1.0 &&
      !grid.period_s.empty() && grid.period_s.front() == 0.0) {
    table.report("period_s", "a rigid building (period 0) cannot yield",
                 "leave period 0 out, or ask for response_modification = [1]");
  }
  double conditions = 1.0;  // the product may exceed any integer
  for (const ClearanceAxis axis : clearance_axes)
    conditions *= static_cast<double>(grid.size(axis));
  if (conditions > most_conditions) {
    table.report("", "clearance_study asks for " + shortest_decimal(conditions) + " conditions",
                 "at most 100000 in one study: divide it");
  }
  return grid;
}

/// A number, or { mean, std } of pull tests: then mean - 2 std.
TestedFriction read_one_friction(const TomlTable& table, const char* key) {
  if (!table.is_table(key)) return {table.required_number(key, mu_rule), 0.0};
  const TomlTable tests = table.table(key);
  const std::size_t problems = tests.problem_count();
  const TestedFriction friction{tests.required_number("mean", mu_rule),
                                tests.required_number("std", not_negative)};
  if (tests.problem_count() == problems && friction.design() <= 0.0) {
    table.report(key,
                 table.name_of(key) + ": mean - 2 std = " + shortest_decimal(friction.design()) +
                     " leaves no friction to design with",
                 "test more, or give the design value as a number");
  }
  return friction;
}

std::array<TestedFriction, 2> read_friction(const TomlTable& table) {
  if (table.has("mu")) {
    for (const char* key : {"mu_e_w", "mu_n_s"}) {
      if (table.has(key))
        table.report(key, table.name_of(key) + " and mu are both given",
                     "give mu for both directions, or mu_e_w and mu_n_s");
    }
    const TestedFriction both = read_one_friction(table, "mu");
    return {both, both};
  }
  if (!table.has("mu_e_w") && !table.has("mu_n_s")) {
    table.report_missing("mu", "give mu for both directions, or mu_e_w and mu_n_s");
    return {};
  }
  return {read_one_friction(table, "mu_e_w"), read_one_friction(table, "mu_n_s")};
}

/// An array that slides without any shaking has no clearance.
void check_at_rest(const TomlTable& table, const ClearanceConfig& study) {
  if (study.grid.slope_deg.empty()) return;
  const double steepest = study.grid.slope_deg.back();
  for (const SlopeAxis axis : study.slope_axes) {
    const double mu = study.friction[static_cast<std::size_t>(axis)].design();
    if (!(mu > 0.0) || std::tan(steepest * rad_per_deg) < mu) continue;
    table.report(table.has("rise_in_12") ? "rise_in_12" : "slope_deg",
                 "on a slope of " + shortest_decimal(steepest) + " degrees a friction of " +
                     shortest_decimal(mu) + " does not hold the array at rest",
                 "give slopes below atan(mu), or more friction");
    return;
  }
}

void read_conditions(const TomlTable& table, ClearanceConfig& study) {
  const std::size_t problems = table.problem_count();
  study.grid = read_grid(table);
  study.friction = read_friction(table);
  study.slope_axes = choices_or<SlopeAxis>(table, "slope_axis", slope_axis_names(),
                                           {SlopeAxis::e_w, SlopeAxis::n_s});
  study.orientation = table.choice<OrientationChoice>("orientations", orientation_names())
                          .value_or(study.orientation);
  study.damping = table.number("damping", damping_rule).value_or(study.damping);
  study.vertical_damping =
      table.number("vertical_damping", damping_rule).value_or(study.vertical_damping);
  study.hardening_ratio =
      table.number("hardening_ratio", damping_rule).value_or(study.hardening_ratio);
  study.displacement = table.choice<DisplacementMeasure>("displacement", displacement_names())
                           .value_or(study.displacement);
  study.clearance_factor =
      table.number("clearance_factor", factor_rule).value_or(study.clearance_factor);
  if (table.problem_count() == problems) check_at_rest(table, study);
}

void read_suites(const TomlTable& suite, const std::filesystem::path& file,
                 ClearanceConfig& study) {
  if (!suite.has("files")) {
    const SuiteChoice chosen = read_suite_choice(suite, file);
    study.suite_files = {chosen.file};
    study.records = chosen.records;
    return;
  }
  if (suite.has("file") || suite.has("records"))
    suite.report("files", "suite.files goes with neither file nor records",
                 "give one suite by file, or several by files");
  suite.text("file");
  suite.texts("records");
  const std::vector<std::string> names = suite.texts("files").value_or(std::vector<std::string>{});
  if (names.empty()) suite.report("files", "suite.files is empty", "name at least one suite");
  for (const std::string& name : names) {
    study.suite_files.push_back(file.parent_path() / name);
    std::error_code ignored;
    if (!std::filesystem::exists(study.suite_files.back(), ignored)) {
      suite.report("files", "there is no suite " + study.suite_files.back().string(),
                   "give its path relative to the study file");
    }
  }
}

PaperStatement read_statement(const TomlTable& table) {
  PaperStatement statement;
  if (!table.has("about"))
    table.report_missing("about", "tell which figure answers it: period, slope, yielding ...");
  statement.about = table.choice<ClearanceTopic>("about", topic_names()).value_or(statement.about);
  statement.where = table.required_text("where");
  statement.says = table.required_text("says");
  if (const auto inches = table.number("displacement_in", above_zero))
    statement.displacement_m = *inches * inch_m;
  statement.period_s = table.number("period_s", not_negative).value_or(statement.period_s);
  return statement;
}

}  // namespace

bool is_clearance_study(const std::filesystem::path& file) {
  return TomlDocument(file).root().has("clearance_study");
}

ClearanceConfig read_clearance_study(const std::filesystem::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  const TomlTable head = root.required_table("study"), suite = root.required_table("suite");
  ClearanceConfig study;
  study.file = file;
  study.source_text = document.text();
  study.name = head.required_text("name");
  study.description = head.text("description").value_or("");
  study.seed = head.whole("seed", 0, largest_seed).value_or(0);
  read_suites(suite, file, study);
  const TomlTable table = root.required_table("clearance_study");
  if (table.exists()) read_conditions(table, study);
  for (const TomlTable& statement : root.tables("paper"))
    study.statements.push_back(read_statement(statement));
  for (const PaperStatement& s : study.statements) {
    const std::vector<double>& periods = study.grid.period_s;
    if (!std::isnan(s.period_s) && std::ranges::find(periods, s.period_s) == periods.end())
      document.add({file.string(),
                    "a [[paper]] statement is about a period of " + shortest_decimal(s.period_s) +
                        " s, which is not among clearance_study.period_s",
                    "add the period, or leave period_s out", ""});
  }
  document.finish();
  return study;
}

}  // namespace glissade
