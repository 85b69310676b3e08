// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/kernel.hpp"

namespace glissade {
namespace {

/// The vertical's own oscillator takes part in the history.
bool has_vertical_oscillator(const StudyConfig& config) {
  return config.vertical != std::vector{VerticalChoice::none} &&
         !config.quantities.at("vertical", "period_s").is_always(0.0);
}

}  // namespace

KernelChoice cheapest_exact_kernel(const StudyConfig& config) {
  const auto is_always = [&](const char* table, const char* key, double value) {
    return config.quantities.at(table, key).is_always(value);
  };
  if (config.two_axes()) return {Kernel::full, "both horizontal components act at once"};
  if (!is_always("friction", "fast_over_slow", 1.0) && !is_always("friction", "rate_s_per_m", 0.0))
    return {Kernel::full, "friction depends on speed"};
  const bool oscillates = has_vertical_oscillator(config);
  if (!is_always("friction", "static_over_sliding", 1.0)) {
    if (oscillates)
      return {Kernel::full,
              "friction is stronger at rest and the vertical has a period of its own"};
    return {Kernel::events, "friction is stronger at rest"};
  }
  if (is_always("building", "period_s", 0.0))
    return {Kernel::tables, "one axis on a rigid building"};
  const bool coupled = !is_always("building", "mass_ratio", 0.0);
  const bool yields = !is_always("building", "response_modification", 0.0) ||
                      !is_always("building", "yield_coefficient", 0.0);
  if (!coupled && !yields)
    return {Kernel::tables, "one axis on a linear building that the array does not move"};
  if (oscillates)
    return {Kernel::full,
            "the vertical has a period of its own beside a building that yields or is coupled with "
            "the array"};
  if (yields) return {Kernel::events, "the building yields"};
  return {Kernel::coupled, "building.mass_ratio is above 0"};
}

std::string describe(Kernel kernel, bool base_shear) {
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
      return std::string("full model: two axes, coupled, error-controlled (") +
             (base_shear ? "slide_on_building, which gives base shear)" : "slide_two_axes)");
  }
  return "";
}

}  // namespace glissade
