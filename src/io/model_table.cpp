// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_table.hpp"

#include <limits>

#include "distribution_table.hpp"
#include "glissade/io/csv.hpp"
#include "tested_friction.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// [building] says how strong the building is, or nothing of it.
std::optional<StrengthConfig> read_strength(const TomlTable& table) {
  constexpr NumberRule r_rule{"1 or more", [](double x) { return x >= 1.0; },
                              "R divides the elastic demand"};
  constexpr NumberRule stiffness_ratio{"0 or more and below 1",
                                       [](double x) { return x >= 0.0 && x < 1.0; }};
  StrengthConfig strength;
  strength.response_modification = table.number("response_modification", r_rule);
  strength.yield_coefficient = table.number("yield_coefficient", above_zero);
  strength.hardening_ratio = table.number("hardening_ratio", stiffness_ratio).value_or(0.0);
  const bool has_r = table.has("response_modification"), has_c = table.has("yield_coefficient");
  if (has_r && has_c) {
    table.report("yield_coefficient",
                 "building.response_modification and building.yield_coefficient are both given",
                 "give one of them: each tells how strong the building is");
  }
  if (!has_r && !has_c) {
    if (table.has("hardening_ratio")) {
      table.report("hardening_ratio",
                   "building.hardening_ratio has no effect on a building that stays elastic",
                   "give response_modification or yield_coefficient too, or leave it out");
    }
    return std::nullopt;
  }
  return strength;
}

/// A coefficient of friction by `PREFIXmu`, or by `PREFIXmean` and `PREFIXstd`. Nothing where none
/// of them is there, or one is wrong.
std::optional<Distribution> read_coefficient(const TomlTable& table, const std::string& prefix) {
  const std::string mu = prefix + "mu", mean = prefix + "mean", std = prefix + "std";
  const bool has_moments = table.has(mean) || table.has(std);
  if (table.has(mu)) {
    if (has_moments) {
      table.report(mu, "friction." + mu + " and friction." + mean + "/" + std + " are both given",
                   "give " + mu + ", or " + mean + " and " + std);
    }
    table.number(mean);
    table.number(std);
    return read_distribution(table, mu.c_str(), {0.0, 10.0, Bounds::Top::closed, "0 to 10"});
  }
  if (!has_moments) return std::nullopt;
  const std::size_t problems_before = table.problem_count();
  const double centre = table.required_number(mean, friction_rule);
  const double spread = table.number(std, not_negative).value_or(0.0);
  if (table.problem_count() > problems_before) return std::nullopt;
  return spread == 0.0 ? Distribution{Fixed{centre}}
                       : Distribution{TruncatedNormal{centre, spread, 0.0, infinity}};
}

/// An ellipse of friction has two axes.
void refuse_zero(const TomlTable& table, const Distribution& mu, const char* direction) {
  if (support(mu).max > 0.0) return;
  table.report("", std::string("friction ") + direction + " the slope is zero",
               "on two axes friction lies on an ellipse, and both of its axes are above zero");
}

}  // namespace

void needs_two_axes(const TomlTable& table, const char* key, SlidingAxes axes) {
  if (axes == SlidingAxes::two || !table.has(key)) return;
  table.report(key, table.name_of(key) + " goes with [model] axes = 2 only",
               "leave it out, or let the array slide along two axes");
}

ModelConfig read_model(const TomlTable& table) {
  ModelConfig model;
  if (table.whole("axes", 1, 2).value_or(1) == 2) model.axes = SlidingAxes::two;
  model.displacement =
      table
          .choice<DisplacementMeasure>("displacement", {{"srss", DisplacementMeasure::srss},
                                                        {"vector", DisplacementMeasure::vector}})
          .value_or(model.displacement);
  needs_two_axes(table, "displacement", model.axes);
  return model;
}

BuildingConfig read_building(const TomlTable& table, SlidingAxes axes) {
  BuildingConfig building;
  building.period_s = read_distribution(table, "period_s",
                                        {0.0, infinity, Bounds::Top::closed, "0 (rigid) or more"})
                          .value_or(building.period_s);
  building.damping =
      read_distribution(table, "damping",
                        {0.0, 1.0, Bounds::Top::open, "a ratio, 0 or more and below 1"})
          .value_or(building.damping);
  building.mass_ratio = read_distribution(table, "mass_ratio",
                                          {0.0, 1.0, Bounds::Top::closed,
                                           "the array's mass over the building's, 0 to 1"})
                            .value_or(building.mass_ratio);
  building.period_ratio = table.number("period_ratio", above_zero).value_or(building.period_ratio);
  needs_two_axes(table, "period_ratio", axes);
  building.strength = read_strength(table);
  return building;
}

RoofConfig read_roof(const TomlTable& table, SlidingAxes axes) {
  RoofConfig roof;
  roof.slope_deg =
      read_distribution(table, "slope_deg",
                        {-89.9, 89.9, Bounds::Top::closed, "in degrees, -89.9 to 89.9"})
          .value_or(roof.slope_deg);
  roof.azimuth_deg =
      read_distribution(table, "azimuth_deg",
                        {-360.0, 360.0, Bounds::Top::closed, "in degrees, -360 to 360"})
          .value_or(roof.azimuth_deg);
  needs_two_axes(table, "azimuth_deg", axes);
  return roof;
}

FrictionLaw read_friction_law(const TomlTable& table) {
  constexpr NumberRule ratio_rule{"1 or more", [](double x) { return x >= 1.0; },
                                  "static friction is not below sliding friction"};
  FrictionLaw law;
  law.static_ratio = table.number("static_ratio", ratio_rule).value_or(law.static_ratio);
  law.fast_ratio = table.number("fast_ratio", above_zero).value_or(law.fast_ratio);
  law.rate_spm = table.number("rate_spm", above_zero).value_or(law.rate_spm);
  if (table.has("fast_ratio") != table.has("rate_spm")) {
    const char* there = table.has("fast_ratio") ? "fast_ratio" : "rate_spm";
    table.report(there,
                 std::string("friction.") + there + " is one half of how friction depends on speed",
                 "give fast_ratio (mu_fast / mu_slow) and rate_spm (the rate a, s/m)");
  }
  return law;
}

FrictionConfig read_friction(const TomlTable& table, SlidingAxes axes,
                             const std::filesystem::path& study_file) {
  FrictionConfig friction;
  friction.design_run = table.flag("design_run").value_or(friction.design_run);
  friction.law = read_friction_law(table);
  for (const char* key : {"across_mu", "across_mean", "across_std", "across_direction"})
    needs_two_axes(table, key, axes);
  if (table.has("file")) {
    read_tested_friction(table, study_file.parent_path(), friction);
  } else {
    const std::size_t problems_before = table.problem_count();
    const auto along = read_coefficient(table, "");
    if (!along && table.problem_count() == problems_before)
      table.report_missing("mean", "give mean and std, or mu, or a file of pull tests");
    friction.mu = along.value_or(friction.mu);
    friction.across = read_coefficient(table, "across_");
    if (table.has("across_direction")) {
      table.report("across_direction", "friction.across_direction goes with friction.file only",
                   "give across_mean and across_std, or across_mu");
    }
  }
  if (axes == SlidingAxes::two) {
    refuse_zero(table, friction.mu, "along");
    if (friction.across) refuse_zero(table, *friction.across, "across");
  }
  return friction;
}

}  // namespace glissade
