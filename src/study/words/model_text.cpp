// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/model_text.hpp"

#include <fmt/format.h>

#include "glissade/motion/design_spectrum.hpp"
#include "glissade/study/cases/case_scene.hpp"

namespace glissade {
namespace {

std::string building_text(const Quantities& q) {
  const Quantity& r = q.at("building", "response_modification");
  const Quantity& coefficient = q.at("building", "yield_coefficient");
  std::string at;
  if (!r.is_always(0.0)) {
    at = fmt::format(
        "the design spectrum's elastic demand at its period over R ({}; 0: it stays elastic)",
        describe(r));
  } else if (!coefficient.is_always(0.0)) {
    at = fmt::format("this part of its weight: {}", describe(coefficient));
  } else {
    return "";
  }
  return fmt::format(
      "It yields at {}, bilinear with kinematic hardening, with {} of its stiffness from there "
      "on. ",
      at, describe(q.at("building", "hardening_ratio")));
}

std::string friction_text(const Quantities& q) {
  const Quantity& at_rest = q.at("friction", "static_over_sliding");
  const Quantity& fast = q.at("friction", "fast_over_slow");
  const Quantity& rate = q.at("friction", "rate_s_per_m");
  std::string text;
  if (!at_rest.is_always(1.0)) {
    text += fmt::format("Static friction is {} times sliding friction. ", describe(at_rest));
  }
  if (!fast.is_always(1.0) && !rate.is_always(0.0)) {
    text += fmt::format(
        "The coefficients are those of slow sliding; with the sliding velocity v they go to r "
        "times that, as r - (r - 1) exp(-a v), r = {}, a = {} s/m. ",
        describe(fast), describe(rate));
  }
  return text;
}

std::string displacement_text(const ModelConfig& model) {
  if (model.axes == SlidingAxes::one) return "";
  if (model.displacement == DisplacementMeasure::vector)
    return "The longest displacement vector in plan. ";
  return "The SRSS of the separate maxima along and across the slope (Walters et al. 2012), which "
         "is not less than the longest displacement vector. ";
}

std::string name_of(const BuildingModel& model) {
  switch (model.kind) {
    case BuildingModel::Kind::one_mass:
      break;
    case BuildingModel::Kind::cantilever:
      return "a uniform cantilever of flexure and shear (Miranda & Taghavi 2005)";
    case BuildingModel::Kind::storeys:
      return "a shear building";
    case BuildingModel::Kind::modes:
      return "the stated modes";
  }
  return "one mass";
}

}  // namespace

/// Suites that differ in S_DS have no common one.
double dbe_level(const Plan& plan) {
  if (plan.config.intensity.measure != IntensityMeasure::sds_g) return 0.0;
  double level = 0.0;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    const DesignTarget* target = plan.target_of(suite);
    const double sds_g = target == nullptr ? 0.0 : TargetSpectrum(*target).sds_g();
    if (suite > 0 && sds_g != level) return 0.0;
    level = sds_g;
  }
  return level;
}

std::string modes_text(const Plan& plan) {
  const BuildingModel& model = plan.config.building;
  if (model.is_one_mass()) return "";
  constexpr std::size_t looked_at = 200;  // cases
  std::size_t fewest = most_modes, most = 0;
  double least_mass = 1.0, most_mass = 0.0;
  const std::size_t step = plan.cases.size() / looked_at + 1;
  for (std::size_t i = 0; i < plan.cases.size(); i += step) {
    const std::array<Modes, 2> axes = building_axes(plan.cases[i], model);
    for (std::size_t axis = 0; axis < (plan.config.two_axes() ? 2 : 1); ++axis) {
      const double mass = mass_of({axes[axis].begin(), axes[axis].size()});
      fewest = std::min(fewest, axes[axis].size());
      most = std::max(most, axes[axis].size());
      least_mass = std::min(least_mass, mass);
      most_mass = std::max(most_mass, mass);
    }
  }
  return fmt::format(
      "{}: {} modes along an axis, with {} % of its mass", name_of(model),
      fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most),
      most_mass - least_mass < 0.005
          ? fmt::format("{:.0f}", 100 * most_mass)
          : fmt::format("{:.0f} to {:.0f}", 100 * least_mass, 100 * most_mass));
}

ModelText model_text(const Plan& plan) {
  const Quantities& q = plan.config.quantities;
  return {describe(plan.kernel.kernel, plan.config) + "; because " + plan.kernel.reason,
          modes_text(plan),
          building_text(q),
          friction_text(q),
          displacement_text(plan.config.model),
          dbe_level(plan)};
}

}  // namespace glissade
