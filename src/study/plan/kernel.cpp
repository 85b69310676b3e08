// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/kernel.hpp"

namespace glissade {
namespace {

/// The vertical's own oscillator takes part in the history.
bool has_vertical_oscillator(const StudyConfig& config) {
  return config.vertical != std::vector{VerticalChoice::none} &&
         !config.quantities.at("vertical", "period_s").is_always(0.0);
}

bool may_yield(const StudyConfig& config) {
  return !config.quantities.at("building", "response_modification").is_always(0.0) ||
         !config.quantities.at("building", "yield_coefficient").is_always(0.0);
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
    return {Kernel::coupled, "friction is stronger at rest"};
  }
  if (is_always("building", "period_s", 0.0))
    return {Kernel::tables, "one axis on a rigid building"};
  const bool coupled = !is_always("building", "mass_ratio", 0.0);
  const bool yields = may_yield(config);
  if (!coupled && !yields)
    return {Kernel::tables, "one axis on a linear building that the array does not move"};
  if (oscillates)
    return {Kernel::full,
            "the vertical has a period of its own beside a building that yields or is coupled with "
            "the array"};
  if (yields) return {Kernel::coupled, "the building yields"};
  return {Kernel::coupled, "building.mass_ratio is above 0"};
}

double history_us(Kernel kernel, const StudyConfig& config) {
  const auto at = [&](const char* key) { return config.quantities.at("friction", key); };
  switch (kernel) {
    case Kernel::tables:
      return 7.0;
    case Kernel::coupled:
      return may_yield(config) ? 300.0 : 100.0;
    case Kernel::full: {
      const bool in_lanes = !config.base_shear && !may_yield(config) &&
                            at("static_over_sliding").is_always(1.0) &&
                            at("fast_over_slow").is_always(1.0);
      return in_lanes ? 200.0 : 2000.0;
    }
  }
  return 0.0;
}

std::string describe(Kernel kernel, bool base_shear) {
  switch (kernel) {
    case Kernel::tables:
      return "one axis over tables of the roof's motion: exact events (peak_slip)";
    case Kernel::coupled:
      return "one axis, coupled building and array: exact events over tables (coupled_slip)";
    case Kernel::full:
      return std::string("full model: two axes, coupled, error-controlled (") +
             (base_shear ? "slide_on_building, which gives base shear)" : "slide_two_axes)");
  }
  return "";
}

}  // namespace glissade
