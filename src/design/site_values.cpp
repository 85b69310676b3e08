// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/contract.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/motion/improbable.hpp"

namespace glissade {
namespace {

/// From S_MS = F_a S_S; of the class that governs.
double coefficient(const DesignTarget& target, double design_g, double mapped_g) {
  return target.is_mapped() ? mce_over_dbe * design_g / mapped_g : 0.0;
}

}  // namespace

double ProjectFriction::design() const { return design_friction(Normal{mean, std}); }

std::string ProjectFriction::surface_text() const {
  return surface + (surface.empty() || surface_description.empty() ? "" : ": ") +
         surface_description;
}

bool ProjectSite::is_of_analysis() const {
  if (!target.period_s.empty()) return !mapped || !takes_exception_2(*mapped);
  return !target.is_mapped() && target.edition == AsceEdition::asce7_16;
}

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

std::string PrescribedValue::not_met() const { return not_met_text(conditions); }

std::string PrescribedValue::violated() const {
  return not_met_text(conditions, /*unknown=*/false);
}

ArrayFacts facts_of(const Project& project, const SiteValues& site) {
  return {.slope_deg = project.slope_deg.back(),
          .friction = project.friction.design(),
          .friction_basis = "mean - 2 std",
          .test_standard = project.friction.test_standard,
          .risk = project.site.risk,
          .storeys = project.building.storeys,
          .centre_of_mass_m = project.array.centre_of_mass_m,
          .support_spacing_m = project.array.support_spacing_m,
          .interconnection = project.array.interconnection,
          .sds_g = site.sds_g};
}

std::vector<PrescribedValue> prescribed_values(const Project& project, const SiteValues& site) {
  const ArrayFacts facts = facts_of(project, site);
  return {{Standard::asce7_16, asce7_16_displacement(site.sds_g, project.importance),
           conditions_of(Standard::asce7_16, facts), least_share(Standard::asce7_16),
           "80 % of the prescribed value, unless the analysis is peer reviewed"},
          {Standard::seaoc_pv1_2012, seaoc_pv1_2012_displacement(site.sds_g, site.category),
           conditions_of(Standard::seaoc_pv1_2012, facts), least_share(Standard::seaoc_pv1_2012),
           "half of the prescribed value, unless the analysis is peer reviewed"}};
}

const PrescribedValue& of_standard(const Project& project, const DesignClearance& design) {
  const auto value =
      std::ranges::find(design.prescribed, project.standard, &PrescribedValue::standard);
  GLISSADE_EXPECTS(value != design.prescribed.end());
  return *value;
}

}  // namespace glissade
