// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "enum_names.hpp"
#include "glissade/building/mode_rules.hpp"
#include "glissade/core/wrap.hpp"
#include "keys/quantity_table.hpp"

namespace glissade {
namespace {

/// An ellipse of friction has two axes.
void refuse_zero(const TomlTable& table, const Quantity& mu, const char* key) {
  if (mu.largest() > 0.0) return;
  table.report(key, table.name_of(key) + " is zero",
               "on two axes friction is an ellipse, and both of its axes are above zero");
}

void check_strength(const TomlTable& table, const StudyConfig& study) {
  const Quantity& r = study.quantities.at("building", "response_modification");
  const Quantity& coefficient = study.quantities.at("building", "yield_coefficient");
  const bool below_one =
      r.drawn ? support(*r.drawn).min < 1.0
              : std::ranges::any_of(r.values, [](double x) { return x > 0.0 && x < 1.0; });
  if (below_one) {
    table.report(
        "response_modification", "building.response_modification has values between 0 and 1",
        "it divides the elastic demand: give 1 or more, or 0 for a building that stays elastic");
  }
  if (!r.is_always(0.0) && !coefficient.is_always(0.0)) {
    table.report("yield_coefficient",
                 "building.response_modification and building.yield_coefficient are both given",
                 "give one of them: each states the strength of the building");
  }
}

constexpr NumberRule above_zero_share{"above 0 and at most 1",
                                      [](double x) { return x > 0.0 && x <= 1.0; }},
    participation_rule{"from -100 to 100",
                       [](double x) { return std::abs(x) <= most_participation; }},
    mode_damping_rule{"from 0 to 0.999",
                      [](double x) { return x >= 0.0 && x <= most_mode_damping; }, "5 % is 0.05"};

/// The modes of the engineer's own model along an axis, their periods over the first.
/// @return the first period
double read_modes(const TomlTable& building, const char* key, std::vector<Mode>& modes,
                  bool& has_own_damping) {
  double first_s = 0.0;
  std::size_t with_damping = 0;
  for (const TomlTable& row : building.tables(key)) {
    Mode mode{row.required_number("period_s", above_zero),
              row.required_number("participation", participation_rule),
              row.required_number("mass_share", above_zero_share)};
    if (const auto damping = row.number("damping", mode_damping_rule)) {
      mode.damping_ratio = *damping;
      ++with_damping;
    }
    if (modes.empty()) first_s = mode.period_s;
    if (!modes.empty() && !(mode.period_s < modes.back().period_s))
      row.report("period_s", building.name_of(key) + ": periods must fall from mode to mode",
                 "list the modes of one axis, the longest period first");
    modes.push_back(mode);
  }
  if (building.is_empty_array(key))
    building.report(key, building.name_of(key) + " is empty", "give one mode at least");
  if (modes.size() > most_modes)
    building.report(key, building.name_of(key) + " has " + std::to_string(modes.size()) + " modes",
                    "give those with the largest mass shares, six at most: modes that are left out "
                    "move with the ground");
  constexpr double rounding = 1e-3;  // of shares with a few digits
  if (mass_of(modes) > 1.0 + rounding)
    building.report(key,
                    fmt::format("{}: the mass shares are {:.4g} together, more than 1",
                                building.name_of(key), mass_of(modes)),
                    "give those of one axis, each as a fraction of the building's mass");
  if (with_damping > 0 && with_damping < modes.size())
    building.report(key, building.name_of(key) + ": some modes have a damping and some have none",
                    "give each mode its own, or none and building.damping");
  has_own_damping = with_damping > 0;
  for (Mode& mode : modes) mode.period_s /= first_s;
  return first_s;
}

std::vector<Mode> read_storeys(const TomlTable& building) {
  const auto count = building.whole("storeys", 1, 200);
  auto masses = building.numbers("storey_masses", above_zero),
       stiffnesses = building.numbers("storey_stiffnesses", above_zero);
  const std::size_t storeys = count         ? static_cast<std::size_t>(*count)
                              : masses      ? masses->size()
                              : stiffnesses ? stiffnesses->size()
                                            : 1;
  for (const auto& [key, values] :
       {std::pair{"storey_masses", &masses}, std::pair{"storey_stiffnesses", &stiffnesses}}) {
    if (!*values) *values = std::vector<double>(storeys, 1.0);
    if ((*values)->size() == storeys) continue;
    building.report(key,
                    fmt::format("{} has {} for {}", building.name_of(key),
                                counted((*values)->size(), "number"), counted(storeys, "storey")),
                    "give one for each storey, from the ground up");
    return {{1.0}};
  }
  return with_first_period(shear_building_modes(*masses, *stiffnesses), 1.0);
}

/// What the building is: one mass, if none of these keys is given.
void read_building(const TomlTable& table, StudyConfig& study) {
  using Kind = BuildingModel::Kind;
  BuildingModel& building = study.building;
  Quantities& q = study.quantities;
  std::vector<std::string> given;
  for (const char* key : {"alpha", "storeys", "modes"})
    if (table.has(key) || (key == std::string("storeys") &&
                           (table.has("storey_masses") || table.has("storey_stiffnesses"))))
      given.emplace_back(key);
  if (given.empty()) return;
  if (given.size() > 1) {
    table.report(given[1],
                 fmt::format("building.{} and building.{} are both given", given[1], given[0]),
                 "give the building one way");
    return table.ignore_unknown();
  }
  if (given[0] == "storeys") {
    if (!q.at("building", "period_s").is_drawn() &&
        q.at("building", "period_s").values.front() <= 0.0)
      table.report(given[0], "building.storeys is given without a period",
                   "give building.period_s, the first period, above 0");
    const std::vector<Mode> modes = read_storeys(table);
    building.is_one_storey = modes.size() == 1;
    if (building.is_one_storey) return;
    building.modes[0] = building.modes[1] = modes;
  }
  building.kind = given[0] == "alpha"     ? Kind::cantilever
                  : given[0] == "storeys" ? Kind::storeys
                                          : Kind::modes;
  const Quantity& alpha = q.at("building", "alpha");
  if (building.kind == Kind::cantilever && !alpha.is_drawn() && alpha.values.size() == 1)
    building.modes[0] = building.modes[1] = cantilever_modes(1.0, alpha.values.front(), most_modes);
  if (building.kind == Kind::modes) {
    bool across_has_damping = false;
    const double first_s = read_modes(table, "modes", building.modes[0], building.has_own_damping);
    building.modes[1] = building.modes[0];
    if (!table.has("period_s")) q.at("building", "period_s") = {{first_s}, {}};
    if (table.has("modes_across")) {
      building.modes[1].clear();
      const double across_s =
          read_modes(table, "modes_across", building.modes[1], across_has_damping);
      if (!table.has("period_ratio") && first_s > 0.0 && across_s > 0.0)
        q.at("building", "period_ratio") = {{across_s / first_s}, {}};
      if (across_has_damping != building.has_own_damping)
        table.report("modes_across",
                     "only one of building.modes and building.modes_across has damping",
                     "give it in both, or in none");
    }
    if (building.has_own_damping && table.has("damping"))
      table.report("damping", "building.damping is given, and the modes have their own",
                   "give the damping one way");
  }
  for (const char* key : {"response_modification", "yield_coefficient"})
    if (!q.at("building", key).is_always(0.0))
      table.report(key,
                   fmt::format("building.{} with building.{}: a building of several modes stays "
                               "elastic here",
                               key, given[0]),
                   "leave one of them out: only one mass yields");
}

}  // namespace

void check_quantities(const TomlTable& root, StudyConfig& study) {
  const TomlTable roof = root.table("roof");
  roof.refuse_both("slope_deg", "rise_in_12", "give the slope one way");
  if (const auto slope = read_rise_in_12(roof)) study.quantities.at("roof", "slope_deg") = *slope;
  study.quantities.at("roof", "slope_deg").is_stated |= roof.has("rise_in_12");
  check_strength(root.table("building"), study);
  read_building(root.table("building"), study);
}

void read_friction(const TomlTable& table, const std::vector<FrictionValue>& usual,
                   StudyConfig& study) {
  study.friction.values =
      read_choices<FrictionValue>(table, "value", friction_value_names).value_or(usual);
  study.friction.across_is_given = table.has("across_mu");
  if (table.has("file")) {
    table.hash_without_folders("file");
    read_tested_friction(table, study);
  } else if (!table.has("mu") && table.exists()) {
    table.report_missing("mu",
                         "give mu = 0.5, mu = { mean = 0.55, std = 0.04 }, a list or a "
                         "distribution, or a file of pull tests");
  }
  table.refuse_both("neighbour_over_mu", "neighbour_mu", "give the neighbour's friction one way");
  if (!study.two_axes()) return;
  refuse_zero(table, study.quantities.at("friction", "mu"), "mu");
  if (study.friction.across_is_given)
    refuse_zero(table, study.quantities.at("friction", "across_mu"), "across_mu");
}

void check_support(const TomlTable& table, StudyConfig& study) {
  const auto isolated = std::ranges::find(study.support, ArraySupport::isolated);
  if (isolated == study.support.end()) {
    table.report("support", table.name_of("support") + " leaves out \"isolated\"",
                 "an array that does not slide has no displacement: name isolated too");
  } else {
    std::rotate(study.support.begin(), isolated, isolated + 1);
  }
}

void check_sampling(const TomlTable& table, SamplingConfig& sampling) {
  const std::uint64_t samples = sampling.samples;
  if (sampling.method == SamplingMethod::sobol && !std::has_single_bit(samples)) {
    table.report(
        "samples",
        fmt::format("sampling.samples = {} is not a power of two, as Sobol points need", samples),
        fmt::format("take {} or {}, or method = \"monte_carlo\"", std::bit_floor(samples),
                    std::bit_ceil(samples)));
  }
  if (sampling.samples % sampling.scrambles != 0 ||
      (sampling.method == SamplingMethod::sobol && !std::has_single_bit(sampling.scrambles)))
    table.report("scrambles",
                 "sampling.scrambles = " + std::to_string(sampling.scrambles) +
                     " does not divide the samples into equal parts (of a power of two for Sobol)",
                 "for example 16, with samples = 1024");
  constexpr NumberRule target_rule{"above 0 and below 1",
                                   [](double x) { return x > 0.0 && x < 1.0; }};
  if (const auto error = table.number("target_error", target_rule))
    sampling.target = {*error, sampling.scrambles};
}

}  // namespace glissade
