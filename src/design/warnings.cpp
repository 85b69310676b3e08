// SPDX-License-Identifier: GPL-3.0-or-later
#include "warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/premises.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/cases/probable.hpp"
#include "glissade/study/plan/one_mass.hpp"

namespace glissade {
namespace {

constexpr double most_rounding_m = foot_m;

/// Outside of what buildings have. All limits are recalled.
std::vector<std::string> improbable_values(const ProjectBuilding& building, UnitSystem units) {
  constexpr double most_storeys = 163.0;                       // Burj Khalifa
  constexpr double least_storey_m = 2.2, most_storey_m = 8.0;  // height of a storey
  constexpr double most_single_storey_m = 30.0;                // a hall
  std::vector<std::string> texts;
  const double ta_s = building.approximate_period_s.value_or(building.period_s.front());
  if (ta_s < building.period_s.front() || ta_s > building.period_s.back())
    texts.push_back(fmt::format("building.period_bounds leave out T_a itself, {:.3g} s", ta_s));
  if (!building.storeys) return texts;
  const double storeys = *building.storeys;
  if (storeys > most_storeys)
    texts.push_back(fmt::format("{:g} storeys are more than any building has", storeys));
  const double most_m = storeys == 1.0 ? most_single_storey_m : most_storey_m;
  const double storey_m = building.height_m.value_or(0.0) / storeys;
  if (building.height_m && (storey_m < least_storey_m || storey_m > most_m))
    texts.push_back(fmt::format("{:g} storeys in a height of {}: {} for each is improbable",
                                storeys, both_units(*building.height_m, units),
                                both_units(storey_m, units)));
  return texts;
}

/// Of pull tests: a direction that is not the least favourable, and values to check.
std::vector<std::string> choices_of(const ProjectFriction& friction) {
  std::vector<std::string> texts;
  for (const DirectionFriction& d : friction.tested) {
    if (d.sliding.tests < 2)
      texts.push_back(fmt::format(
          "direction {} of the pull tests has one test, which gives no design friction: it is not "
          "used",
          d.direction));
    if (d.sliding.mean_minus_2_std < friction.design())
      texts.push_back(fmt::format(
          "friction.direction = \"{}\" has the design friction {:.3f}, direction {} only {:.3f}: "
          "the array slides in both",
          friction.direction, friction.design(), d.direction, d.sliding.mean_minus_2_std));
    for (const std::string& note : outliers_in(d)) texts.push_back("pull tests " + note);
    if (!d.note.empty()) texts.push_back("pull tests, " + d.note);
  }
  return texts;
}

std::string improbable_hazard(const Project& project) {
  const double sms_g = site_values(project.site).sms_g();
  const double rate = HazardCurve(project.hazard->points).annual_rate(sms_g);
  return improbable_mce_rate(rate, fmt::format("S_MS, {:.3g} g,", sms_g));
}

}  // namespace

std::string both_units(double length_m, UnitSystem units) {
  const bool is_long = length_m > 2.0;
  const std::string us = is_long ? fmt::format("{:.3g} ft", length_m / foot_m)
                                 : fmt::format("{:.1f} in", length_m / inch_m);
  const std::string si = fmt::format("{:.3g} m", length_m);
  return units == UnitSystem::si ? si + " (" + us + ")" : us + " (" + si + ")";
}

std::vector<DesignWarning> warnings_on(const Project& project) {
  std::vector<DesignWarning> warnings;
  for (const Premise& premise : premises_of(project))
    if (!premise.found.is_met) warnings.push_back({not_met_text(premise), true});
  const auto add = [&](bool met, const std::string& text) {
    if (met) warnings.push_back({text});
  };
  const auto add_all = [&](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) warnings.push_back({text});
  };
  add(project.peer_reviewed,
      "standards.peer_reviewed = true: the least value of the standard is not applied");
  const DesignTarget& target = project.site.target;
  add(!target.period_s.empty() && !project.site.mapped && target.edition == AsceEdition::asce7_22,
      "the spectrum is taken for the multi-period one of ASCE 7-22, 11.4.5.1; whether one of a "
      "site-specific analysis is 80 % of that or more (21.3) is not checked");
  add(!project.of_roof && !project.site.states_tl && project.site.target.period_s.empty(),
      fmt::format("site.tl_s is not stated: T_L = {:g} s is assumed", project.site.target.tl_s));
  add(project.friction.mean < 2.0 * project.friction.std,
      fmt::format("mean - 2 std of the friction is {:.3g}: 0 is taken",
                  project.friction.mean - 2.0 * project.friction.std));
  const auto add_found = [&](const std::string& text) { add(!text.empty(), text); };
  if (!project.of_roof) {
    add_all(improbable_values(project.building, project.units));
    add_found(gaps_between(project.building.period_s));
    for (const auto& [key, value] : {std::pair{"mass_ratio", project.building.mass_ratio.back()},
                                     {"damping", project.building.damping}})
      add_found(improbable_value(parameters()[parameter_index("building", key)], value));
    const std::string one_mass =
        one_mass_sentence(project.building.storeys, project.building.period_s.back());
    if (project.building.alpha.empty() && !one_mass.empty())
      add_found(one_mass + ". State building.storeys (1: it has one)");
  }
  std::vector<std::optional<double>> available_m = project.available_m;
  for (const ProjectGap& gap : project.gaps) available_m.emplace_back(gap.available_m);
  for (const auto& clearance_m : available_m)
    add(clearance_m && *clearance_m > largest_probable_clearance_m,
        fmt::format("an available separation of {} is more than a roof has",
                    both_units(clearance_m.value_or(0.0), project.units)));
  add(project.round_up_m > most_rounding_m,
      fmt::format("displacements are rounded up to steps of {}",
                  both_units(project.round_up_m, project.units)));
  add(project.friction.std == 0.0,
      "the friction has no scatter (std 0): its design value is the mean");
  add_found(improbable_friction("a mean friction", project.friction.mean));
  add_all(choices_of(project.friction));
  if (project.hazard) {
    add_found(improbable_hazard(project));
    add_found(improbable_rates(HazardCurve(project.hazard->points)));
    add_found(improbable_design_life(project.hazard->design_life_years));
  }
  add_found(improbable_slope(project.slope_deg.front()));
  return warnings;
}

std::vector<DesignWarning> warnings_on(const Project& project, const Results& demand,
                                       const DesignClearance& design) {
  std::vector<DesignWarning> warnings;
  const auto add = [&](std::string text) { warnings.push_back({std::move(text)}); };
  const std::vector<DesignWarning> of_project = warnings_on(project);
  for (const std::string& text : texts_of(demand.warnings))
    if (std::ranges::find(of_project, text, &DesignWarning::text) == of_project.end() &&
        !is_of_premise(project, text))
      add(text);
  std::ranges::copy(of_project, std::back_inserter(warnings));
  for (const DesignCheck& check : design.checks) {
    if (!check.is_met) warnings.push_back({not_met_text(check), true});
  }
  if (const auto lifted = records_with_uplift(demand, at_mce); !lifted.empty())
    add(fmt::format(
        "at the MCE the array lifts off under {} of {} records ({}): the probability of exceedance "
        "at the MCE is outside the model; the required displacement is that of the DBE",
        lifted.size(), demand.records.size(), fmt::join(lifted, ", ")));
  if (design.bound_analysis_m > design.governing_m)
    add(fmt::format(
        "with friction {:.3f} ({}) the required displacement, {}, is above the governing one",
        *project.friction.lower_bound, bound_name(project.friction),
        both_units(*design.bound_analysis_m, project.units)));
  const bool moves = design.demand.back().largest_m > 0.0 || design.analysis_m > 0.0;
  if (project.of_roof) return warnings;
  if (moves && design.demand.size() == 1) {
    add(fmt::format(
        "one building period is given, {:.3g} s: at others the displacement may be larger",
        design.period_s));
  } else if (moves && (design.period_s == design.demand.front().period_s ||
                       design.period_s == design.demand.back().period_s)) {
    add(fmt::format(
        "the displacement is largest at an end of the range of periods, {:.3g} s: outside the "
        "range it may be larger; where the period may be outside, widen {}",
        design.period_s,
        project.building.approximate_period_s ? "building.period_bounds" : "building.period_s"));
  }
  return warnings;
}

}  // namespace glissade
