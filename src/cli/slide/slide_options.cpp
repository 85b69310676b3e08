// SPDX-License-Identifier: GPL-3.0-or-later
#include "slide/slide_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "glissade/building/mode_rules.hpp"
#include "glissade/core/error.hpp"
#include "glissade/io/mode_file.hpp"
#include "glissade/io/record_file.hpp"
#include "glissade/study/cases/case_scene.hpp"
#include "shared/output_rule.hpp"

namespace glissade::cli {
namespace {

bool is(const Parameter& p, const char* table, const char* key) {
  return p.table == std::string_view(table) && p.key == std::string_view(key);
}

/// "--period-s", "--vertical-damping"
std::string option_of(const Parameter& p) {
  std::string name = p.key;
  std::ranges::replace(name, '_', '-');
  return (p.table == std::string_view("vertical") ? "--vertical-" : "--") + name;
}

/// One array on one record: no neighbour, and no design spectrum that R would divide.
bool is_option(const Parameter& p) {
  return !is(p, "friction", "neighbour_mu") && !is(p, "friction", "neighbour_over_mu") &&
         !is(p, "building", "response_modification");
}

std::string meaning_of(const Parameter& p) {
  const bool is_required = is(p, "friction", "mu") || is(p, "roof", "slope_deg");
  std::string text = (p.axes == Parameter::Axes::two ? "with --second: " : "") +
                     std::string(p.meaning) +
                     (p.unit == std::string_view("-") ? "" : fmt::format(", {}", p.unit));
  if (is(p, "friction", "across_mu")) return text + " [as --mu]";
  if (p.absent != nullptr) return fmt::format("{} [{}]", text, p.absent);
  return is_required ? text : fmt::format("{} [{:g}]", text, value_of(p, Case()));
}

void take_case(SlideOptions& o, ProblemList& problems) {
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    if (!o.given[i]) continue;
    if (!(*o.given[i] >= p.range.min && *o.given[i] <= p.range.max && std::isfinite(*o.given[i])))
      problems.add(
          {option_of(p),
           fmt::format("{:g} is outside its range: it must be {}", *o.given[i], p.range.text), "",
           ""});
    p.of(o.c) = *o.given[i];
  }
  if (!o.given[parameter_index("friction", "across_mu")]) o.c.friction_across = o.c.friction;
}

/// The modes of a file, of more than six those that govern, their periods over the first, which
/// goes to `first_s`.
std::vector<Mode> modes_of(const std::string& name, std::optional<ModeAxis> axis, double& first_s,
                           bool& have_damping) {
  const ModeFile file = read_modes(name, {.axis = axis});
  const std::vector<Mode> modes =
      file.modes.size() > most_modes ? governing_modes(file.modes) : file.modes;
  first_s = modes.front().period_s;
  have_damping = file.has_damping;
  return with_first_period(modes, 1.0);
}

void take_modes(SlideOptions& o, ProblemList& problems) {
  const auto given = [&](const char* key) {
    return o.given[parameter_index("building", key)].has_value();
  };
  std::optional<ModeAxis> axis, other;
  if (!o.axis.empty()) {
    axis = o.axis == "x" ? ModeAxis::x : ModeAxis::y;
    other = o.axis == "x" ? ModeAxis::y : ModeAxis::x;
  }
  double first_s = 0.0, across_s = 0.0;
  bool across_have_damping = false;
  o.building.modes[0] = modes_of(o.modes, axis, first_s, o.building.has_own_damping);
  o.building.modes[1] = o.building.modes[0];
  if (!given("period_s")) o.c.period_s = first_s;
  if (!o.modes_across.empty()) {
    o.building.modes[1] = modes_of(o.modes_across, other, across_s, across_have_damping);
    if (!given("period_ratio")) o.c.period_ratio = across_s / first_s;
    if (across_have_damping != o.building.has_own_damping)
      problems.add({"--modes-across", "only one of the files of modes has damping",
                    "give it in both, or in none", ""});
  }
  if (o.building.has_own_damping && given("damping"))
    problems.add({"--damping", o.modes + " has the damping of each mode", "leave it out", ""});
}

void take_storeys(SlideOptions& o, ProblemList& problems) {
  const std::size_t count =
      o.storeys.value_or(std::max(o.storey_masses.size(), o.storey_stiffnesses.size()));
  for (std::vector<double>* values : {&o.storey_masses, &o.storey_stiffnesses}) {
    if (values->empty()) values->assign(count, 1.0);
    if (values->size() == count) continue;
    problems.add({"--storeys", "masses or stiffnesses are not as many as the storeys",
                  "give one for each storey, from the ground up", ""});
    return;
  }
  o.building.modes[0] = o.building.modes[1] =
      with_first_period(shear_building_modes(o.storey_masses, o.storey_stiffnesses), 1.0);
  if (!(o.c.period_s > 0.0))
    problems.add({"--storeys", "the building has no period",
                  "give --period-s, its first period, above 0", ""});
}

/// The building of several modes that is stated, if one is.
void take_building(SlideOptions& o, ProblemList& problems) {
  using Kind = BuildingModel::Kind;
  std::vector<Kind> stated;
  if (o.given[parameter_index("building", "alpha")]) stated.push_back(Kind::cantilever);
  if (o.storeys || !o.storey_masses.empty() || !o.storey_stiffnesses.empty())
    stated.push_back(Kind::storeys);
  if (!o.modes.empty()) stated.push_back(Kind::modes);
  if (!o.modes_across.empty() && !(o.two_axes() && !o.modes.empty()))
    problems.add(
        {"--modes-across", "needs --modes and --second", "leave it out, or give them", ""});
  if (stated.size() > 1)
    problems.add({o.modes.empty() ? "--storeys" : "--modes", "the building is stated in two ways",
                  "give one of --alpha, --storeys and --modes", ""});
  if (stated.size() != 1) return;
  o.building.kind = stated.front();
  try {
    if (o.building.kind == Kind::storeys) take_storeys(o, problems);
    if (o.building.kind == Kind::modes) take_modes(o, problems);
  } catch (const InputError& error) {
    problems.add(error);
  }
}

/// No oscillator is between ground and array, and friction is Coulomb's.
bool has_rigid_roof(const Case& c) {
  return c.period_s == 0.0 && c.vertical_period_s == 0.0 && c.law.is_coulomb();
}

/// A motion of a suite has its components, their steps and units; one of a roof has no building.
void check_motion(const SlideOptions& o, ProblemList& problems) {
  const auto refuse = [&](bool given, const std::string& option, const char* why) {
    if (given) problems.add({option, o.record + why, "leave it out", ""});
  };
  constexpr const char *of_suite = " has its components, steps and units from its suite",
                       *of_roof = " is the motion of a roof: nothing is computed below the array";
  if (names_motion(o)) {
    refuse(o.dt_s.has_value(), "--dt-s", of_suite);
    refuse(!o.units.empty(), "--units", of_suite);
    refuse(o.counts_per_unit.has_value(), "--counts-per-unit", of_suite);
  }
  for (std::size_t i = 0; o.of_roof && i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const std::string_view table = p.table;
    if (table == "building" || table == "vertical")
      refuse(o.given[i].has_value() && *o.given[i] != 0.0, option_of(p), of_roof);
  }
}

/// Conditions on the model's extensions, each and together.
void check_model(const SlideOptions& o, ProblemList& problems) {
  const auto given = [&](const char* table, const char* key) {
    return o.given[parameter_index(table, key)].has_value();
  };
  if (o.two_axes() && !(o.c.friction > 0.0 && o.c.friction_across > 0.0))
    problems.add({o.c.friction > 0.0 ? "--across-mu" : "--mu",
                  "0 leaves the friction ellipse without an axis",
                  "on two axes give friction above 0", ""});
  if (given("building", "yield_coefficient") && o.c.yield_coefficient == 0.0)
    problems.add({"--yield-coefficient", "must be > 0", "", ""});
  const auto needs = [&](bool is_given, const std::string& option, bool met,
                         const std::string& what) {
    if (is_given && !met) problems.add({option, what, "leave it out, or give the other", ""});
  };
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    if (p.axes == Parameter::Axes::two)
      needs(o.given[i].has_value(), option_of(p), o.two_axes(), "needs --second");
    if (p.needs == nullptr) continue;
    const Parameter& other = parameters()[parameter_index(p.table, p.needs)];
    needs(o.given[i].has_value(), option_of(p), value_of(other, o.c) != value_of(other, Case()),
          fmt::format("needs {} other than {:g}", option_of(other), value_of(other, Case())));
  }
  for (const char* key : {"damping", "period_ratio", "mass_ratio", "yield_coefficient"})
    needs(given("building", key), option_of(parameters()[parameter_index("building", key)]),
          o.c.period_s > 0.0, "has no effect without a building: --period-s above 0");
  needs(given("building", "hardening_ratio"), "--hardening-ratio", o.c.yields(),
        "needs --yield-coefficient");
  needs(given("vertical", "period_s"), "--vertical-period-s", !o.vertical.empty(),
        "needs --vertical");
  needs(given("vertical", "damping"), "--vertical-damping", o.c.vertical_period_s != 0.0,
        "needs --vertical-period-s above 0");
  needs(o.given_substeps.has_value(), "--substeps", o.method != "event",
        "needs --method rodriguez-nikl");

  if (o.c.yields() && !o.building.is_one_mass())
    problems.add({"--yield-coefficient", "a building of several modes stays elastic here",
                  "leave it out: only one mass yields", ""});

  const KernelChoice chosen = kernel_for(o);
  if (chosen.kernel == Kernel::tables) return;
  const auto refuse = [&](bool given, const char* option, const char* what) {
    if (given) problems.add({option, what + ("; here " + chosen.reason), "leave it out", ""});
  };
  constexpr auto uncoupled =
      "needs one axis, Coulomb friction and a linear building that is not coupled with the array";
  refuse(o.method != "event", "--method", uncoupled);
  refuse(o.cm_height_m.has_value(), "--centre-of-mass-height-m", uncoupled);
  if (chosen.kernel == Kernel::full) {
    refuse(!o.history.empty() && !(o.two_axes() && has_rigid_roof(o.c)), "--history",
           "needs one axis, or two on a rigid roof, and Coulomb friction");
    refuse(o.one_way, "--one-way", uncoupled);
  }
}

}  // namespace

bool names_motion(const SlideOptions& o) {
  return std::filesystem::path(split_address(o.record).file).extension() == ".toml";
}

KernelChoice kernel_for(const SlideOptions& o) {
  StudyConfig config;
  config.model.axes = o.two_axes() ? SlidingAxes::two : SlidingAxes::one;
  for (std::size_t i = 0; i < parameters().size(); ++i)
    config.quantities[i] = {{value_of(parameters()[i], o.c)}, {}};
  config.vertical = {o.vertical.empty() ? VerticalChoice::none : VerticalChoice::required};
  const KernelChoice chosen = cheapest_exact_kernel(config);
  if (chosen.kernel == Kernel::coupled && !o.building.is_one_mass())
    return {Kernel::full, "the building has several modes and is coupled with the array"};
  return chosen;
}

void check_step(const SlideOptions& o, double step_s) {
  if (o.building.is_one_mass()) return;
  const std::array<Modes, 2> axes = building_axes(o.c, o.building);
  const double shortest_s =
      std::min(shortest_period_s(axes[0]), shortest_period_s(axes[o.two_axes() ? 1 : 0]));
  if (const std::string text = unresolved_mode(shortest_s, step_s); !text.empty())
    throw InputError(
        {o.record, text, "leave that mode out, or give a record of shorter steps", ""});
}

void check(SlideOptions& o) {
  ProblemList problems;
  const auto require = [&](bool ok, const char* option, double value, const char* rule) {
    if (!ok || !std::isfinite(value))
      problems.add({option, fmt::format("{:g} {}", value, rule), "", ""});
  };
  take_case(o, problems);
  take_building(o, problems);
  for (const auto& [option, value] : {std::pair{"--scale", o.scale},
                                      {"--pga-g", o.pga_g},
                                      {"--dt-s", o.dt_s},
                                      {"--counts-per-unit", o.counts_per_unit},
                                      {"--centre-of-mass-height-m", o.cm_height_m},
                                      {"--base-width-m", o.base_width_m},
                                      {"--clearance-m", o.clearance_m}})
    if (value) require(*value > 0.0, option, *value, "must be > 0");
  if (o.cm_height_m.has_value() != o.base_width_m.has_value()) {
    problems.add({o.cm_height_m ? "--centre-of-mass-height-m" : "--base-width-m",
                  "is one half of what the tipping check needs",
                  o.cm_height_m ? "give --base-width-m too" : "give --centre-of-mass-height-m too",
                  ""});
  }
  require(o.substeps() >= 1, "--substeps", o.substeps(), "must be at least 1");
  if (o.method != "event" && o.method != "rodriguez-nikl") {
    problems.add({"--method", o.method + " is not a method", "give event or rodriguez-nikl", ""});
  }
  if (!o.history.empty() && o.method != "event") {
    problems.add({"--history", "is written by the event method only", "leave out --method", ""});
  }
  if (o.history == "/dev/stdout") {
    problems.add({"--history", "/dev/stdout is where the result is printed", "give a file", ""});
  }
  try {
    check_output_file(o.history, "--history", o.overwrite);
  } catch (const InputError& error) {
    problems.add(error);
  }
  check_motion(o, problems);
  check_model(o, problems);
  problems.throw_if_any();
}

void add_options(CLI::App& command, SlideOptions& o) {
  command
      .add_option(
          "record", o.record,
          "horizontal acceleration along the slope: a file of any format of suites/README.md, "
          "FILE#COMPONENT of several; or a motion of a suite, SUITE.toml#ID: all its components, "
          "with its factor")
      ->required();
  command.add_option("--vertical", o.vertical, "vertical acceleration, up positive");
  command.add_option(
      "--second", o.second,
      "second horizontal component, perpendicular to the first: the array slides along two axes");
  o.given.resize(parameters().size());
  for (const auto& [table, key] : {std::pair{"friction", "mu"}, {"roof", "slope_deg"}}) {
    const std::size_t i = parameter_index(table, key);
    command.add_option(option_of(parameters()[i]), o.given[i], meaning_of(parameters()[i]))
        ->required();
  }
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    if (is_option(p) && command.get_option_no_throw(option_of(p)) == nullptr)
      command.add_option(option_of(p), o.given[i], meaning_of(p));
  }
  command
      .add_option("--storeys", o.storeys,
                  "the building is a shear building of so many equal storeys, with the first "
                  "period --period-s")
      ->check(CLI::Range(std::size_t{1}, std::size_t{200}));
  command.add_option("--storey-masses", o.storey_masses,
                     "masses of its floors from the ground up; only their ratios count");
  command.add_option("--storey-stiffnesses", o.storey_stiffnesses,
                     "stiffnesses of its storeys, likewise");
  command.add_option("--modes", o.modes,
                     "the building's modes along its first axis: CSV with period_s, participation, "
                     "mass_share and, where wanted, damping, as of `glissade building`");
  command.add_option("--modes-across", o.modes_across, "with --second: along its second axis");
  command.add_option("--axis", o.axis, "of an exported table of modes: x or y is the first axis")
      ->check(CLI::IsMember({"x", "y"}));
  CLI::Option* scale = command.add_option("--scale", o.scale, "factor on all components [1]");
  command.add_option("--pga-g", o.pga_g, "scale so that the horizontal peaks at this")
      ->excludes(scale);
  command.add_option("--clearance-m", o.clearance_m,
                     "also report when and how fast the array first reaches this displacement");
  command.add_option("--centre-of-mass-height-m", o.cm_height_m,
                     "height of the centre of mass above the roof: checks for tipping");
  command.add_option("--base-width-m", o.base_width_m,
                     "width of the base along the slope, the centre of mass midway");
  command.add_option("--method", o.method,
                     "event (exact) or rodriguez-nikl (published time stepping)");
  command.add_option("--substeps", o.given_substeps, "substeps P of rodriguez-nikl [64]");
  command.add_flag("--one-way", o.one_way, "no upslope slip (classical Newmark)");
  command.add_option("--dt-s", o.dt_s,
                     "time step of files without one, or that print it with too few digits");
  command.add_option("--units", o.units, "units of files that do not state theirs: g, m/s2, cm/s2");
  command.add_option("--counts-per-unit", o.counts_per_unit,
                     "counts of the recorder for one of --units (miniSEED)");
  command.add_option("--history", o.history,
                     "write the slip history to this CSV file (one axis, or two on a rigid roof): "
                     "displacement and velocity relative to the roof, in plan, positive downslope "
                     "(flat roof: +x)");
  add_overwrite(command, o.overwrite);
  command.add_flag("--json", o.json, "print one JSON object");
}

}  // namespace glissade::cli
