// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/kernel.hpp"

#include <algorithm>

namespace glissade {
namespace {

bool is_always(const Distribution& distribution, double value) {
  const Support range = support(distribution);
  return range.min == value && range.max == value;
}

bool is_rigid(const StudyConfig& config) {
  if (!config.chart) return is_always(config.building.period_s, 0.0);
  const std::vector<double>& periods = config.chart->period_s;
  return std::all_of(periods.begin(), periods.end(), [](double t) { return t == 0.0; });
}

/// The vertical's own oscillator takes part in the history.
bool has_vertical_oscillator(const VerticalConfig& vertical) {
  return vertical.use != VerticalChoice::none && vertical.period_s > 0.0;
}

}  // namespace

KernelChoice cheapest_exact_kernel(const StudyConfig& config) {
  if (config.model.axes == SlidingAxes::two) return {Kernel::full, "[model] axes = 2"};
  const FrictionLaw& law = config.friction.law;
  if (law.depends_on_speed()) return {Kernel::full, "friction depends on speed"};
  if (!law.is_coulomb()) {
    if (has_vertical_oscillator(config.vertical))
      return {Kernel::full,
              "friction is stronger at rest and the vertical has a period of its own"};
    return {Kernel::events, "friction is stronger at rest"};
  }
  if (is_rigid(config)) return {Kernel::tables, "one axis on a rigid building"};
  const bool feels_array = !is_always(config.building.mass_ratio, 0.0);
  const bool yields = config.building.strength.has_value();
  if (!feels_array && !yields)
    return {Kernel::tables, "one axis on a linear building that does not feel the array"};
  if (has_vertical_oscillator(config.vertical))
    return {Kernel::full,
            "the vertical has a period of its own beside a building that yields or "
            "feels the array"};
  if (yields) return {Kernel::events, "the building yields"};
  return {Kernel::coupled, "building.mass_ratio is above 0"};
}

std::string describe(Kernel kernel) {
  switch (kernel) {
    case Kernel::tables:
      return "one axis over tables of the roof's motion: exact events (peak_slip)";
    case Kernel::coupled:
      return "one axis, coupled with a linear building: exact events over tables "
             "(coupled_slip)";
    case Kernel::events:
      return "one axis, coupled with a building that may yield, friction that may be stronger at "
             "rest: exact events (slide_coupled)";
    case Kernel::full:
      return "full model: two axes, coupled, error-controlled (slide_on_building)";
  }
  return "";
}

}  // namespace glissade
