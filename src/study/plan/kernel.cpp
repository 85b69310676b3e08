// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/kernel.hpp"

#include <algorithm>

namespace glissade {
namespace {

/// A value other than the usual one, where the quantity has any.
double unusual_value(const Quantity& quantity, double usual) {
  std::vector<double> values = quantity.values;
  if (quantity.drawn) values = {support(*quantity.drawn).max, support(*quantity.drawn).min};
  const auto other = std::ranges::find_if(values, [&](double value) { return value != usual; });
  return other == values.end() ? usual : *other;
}

/// A case in which nothing is as usual that is not so in every case of the study.
Case unusual_case(const StudyConfig& config) {
  Case c;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    double& value = parameters()[i].of(c);
    value = unusual_value(config.quantities[i], value);
  }
  return c;
}

}  // namespace

KernelChoice cheapest_exact_kernel(const StudyConfig& config) {
  const Case c = unusual_case(config);
  if (config.two_axes()) return {Kernel::full, "both horizontal components act at once"};
  if (c.law.depends_on_speed()) return {Kernel::full, "friction depends on speed"};
  // The vertical's own oscillator takes part in the history.
  const bool oscillates =
      config.vertical != std::vector{VerticalChoice::none} && c.vertical_period_s != 0.0;
  if (!c.law.is_coulomb()) {
    if (oscillates)
      return {Kernel::full,
              "friction is stronger at rest and the vertical has a period of its own"};
    return {Kernel::coupled, "friction is stronger at rest"};
  }
  if (c.period_s == 0.0) return {Kernel::tables, "one axis on a rigid building"};
  if (c.mass_ratio == 0.0 && !c.yields())
    return {Kernel::tables, "one axis on a linear building that the array does not move"};
  if (oscillates)
    return {Kernel::full,
            "the vertical has a period of its own beside a building that yields or is coupled with "
            "the array"};
  if (c.yields()) return {Kernel::coupled, "the building yields"};
  return {Kernel::coupled, "building.mass_ratio is above 0"};
}

double history_us(Kernel kernel, const StudyConfig& config) {
  const Case c = unusual_case(config);
  switch (kernel) {
    case Kernel::tables:
      return 7.0;
    case Kernel::coupled:
    case Kernel::full:
      if (!config.building.is_one_mass() && c.mass_ratio > 0.0) return 7700.0;
      return config.base_shear || c.yields() || !c.law.is_coulomb() ? 2000.0 : 200.0;
  }
  return 0.0;
}

std::string describe(Kernel kernel, bool base_shear) {
  switch (kernel) {
    case Kernel::tables:
      return "one axis over tables of the roof's motion: exact events (peak_slip)";
    case Kernel::coupled:
      return "one axis, coupled building and array: error-controlled (peak_slip_two_axes), or "
             "exact "
             "events where the building yields or friction is stronger at rest (slide_coupled)";
    case Kernel::full:
      return std::string("full model: two axes, coupled, error-controlled (") +
             (base_shear ? "slide_on_building, which gives base shear)" : "peak_slip_two_axes)");
  }
  return "";
}

}  // namespace glissade
