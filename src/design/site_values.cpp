// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "glissade/design/design_clearance.hpp"

namespace glissade {
namespace {

/// From S_MS = F_a S_S; of the class that governs.
double coefficient(const DesignTarget& target, double design_g, double mapped_g) {
  return target.is_mapped() ? mce_over_dbe * design_g / mapped_g : 0.0;
}

CodeCondition condition(const std::string& text, const std::string& found, bool is_met,
                        Provenance provenance) {
  return {text, found, is_met, provenance};
}

std::string steepest_text(const Project& project) {
  return fmt::format("{:.3g} degrees", project.slope_deg.back());
}

std::string friction_text(const Project& project) {
  return fmt::format("{:.3f}", project.friction.design());
}

/// Both standards have them.
std::vector<CodeCondition> building_conditions(const Project& project) {
  CodeCondition low{"six storeys or fewer", "not stated", std::nullopt, Provenance::recalled};
  if (const auto storeys = project.building.storeys) {
    low.is_met = *storeys <= 6.0;
    low.found = fmt::format("{:g}", *storeys);
  }
  return {condition("risk category I, II or III", to_string(project.site.risk),
                    project.site.risk != RiskCategory::iv, Provenance::recalled),
          low};
}

PrescribedValue seaoc(const Project& project, const SiteValues& site) {
  const double steepest = project.slope_deg.back();
  // Slope and friction as Walters et al. (2012) quote them, which is not the standard itself.
  PrescribedValue value{
      .standard = Standard::seaoc_pv1_2012,
      .prescribed = seaoc_pv1_2012_displacement(site.sds_g, site.category),
      .conditions = {condition(fmt::format("roof slope below {:g} degrees", seaoc_slope_limit_deg),
                               steepest_text(project), steepest < seaoc_slope_limit_deg,
                               Provenance::recalled),
                     condition(fmt::format("coefficient of friction above {:g}", seaoc_mu_limit),
                               friction_text(project), project.friction.design() > seaoc_mu_limit,
                               Provenance::recalled)},
      .floor_share = 0.5,
      .floor_basis = "half of the prescribed value, unless the analysis is peer reviewed"};
  const std::vector<CodeCondition> of_building = building_conditions(project);
  value.conditions.insert(value.conditions.end(), of_building.begin(), of_building.end());
  return value;
}

PrescribedValue asce7_16(const Project& project, const SiteValues& site) {
  PrescribedValue value{
      .standard = Standard::asce7_16,
      .prescribed = asce7_16_displacement(site.sds_g, project.importance),
      .conditions = {condition("roof slope of 1 in 20 or less", steepest_text(project),
                               project.slope_deg.back() <= asce7_16_slope_limit_deg,
                               Provenance::recalled),
                     condition(
                         fmt::format("coefficient of friction of {:g} or more", asce7_16_mu_limit),
                         friction_text(project), project.friction.design() >= asce7_16_mu_limit,
                         Provenance::recalled)},
      .floor_share = 0.8,
      .floor_basis = "80 % of the prescribed value, unless the analysis is peer reviewed"};
  const std::vector<CodeCondition> of_building = building_conditions(project);
  value.conditions.insert(value.conditions.end(), of_building.begin(), of_building.end());
  return value;
}

}  // namespace

double ProjectFriction::design() const { return design_friction(Normal{mean, std}); }

std::string category_text(const ProjectSite& site, const SiteValues& values) {
  const bool knows_s1 = site.target.is_mapped() || site.mapped;
  const bool is_open = !knows_s1 && values.category == SeismicDesignCategory::d;
  return to_string(values.category) + (is_open ? ", E or F" : "");  // these from S_1 of 0.75 g on
}

SiteValues site_values(const ProjectSite& site) {
  const TargetSpectrum spectrum(site.target);
  SiteValues values{.sds_g = spectrum.sds_g(), .sd1_g = spectrum.sd1_g()};
  values.fa = coefficient(site.target, values.sds_g, site.target.ss_g);
  values.fv = coefficient(site.target, values.sd1_g, site.target.s1_g);
  values.category = seismic_design_category(
      values.sds_g, values.sd1_g, site.mapped ? site.mapped->s1_g : site.target.s1_g, site.risk);
  return values;
}

bool PrescribedValue::may_be_used() const {
  return std::ranges::all_of(conditions,
                             [](const CodeCondition& c) { return c.is_met.value_or(false); });
}

std::string PrescribedValue::not_met() const {
  std::string text;
  for (const CodeCondition& c : conditions) {
    if (!c.is_met.value_or(false))
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", c.text, c.found);
  }
  return text;
}

std::vector<PrescribedValue> prescribed_values(const Project& project, const SiteValues& site) {
  return {asce7_16(project, site), seaoc(project, site)};
}

}  // namespace glissade
