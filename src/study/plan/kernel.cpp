// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/kernel.hpp"

#include <algorithm>

namespace glissade {
namespace {

enum class CaseValues { usual, unusual };

/// A value that is the usual one, or one that is not, where the quantity has any.
double value_of(const Quantity& quantity, double usual, CaseValues wanted) {
  std::vector<double> values = quantity.values;
  if (quantity.drawn) values = {support(*quantity.drawn).max, support(*quantity.drawn).min};
  const auto found = std::ranges::find_if(
      values, [&](double value) { return (value == usual) == (wanted == CaseValues::usual); });
  return found == values.end() ? values.front() : *found;
}

/// A case in which all is as usual that is so in any case of the study, or nothing that is not so
/// in every case.
Case case_of(const StudyConfig& config, CaseValues wanted) {
  Case c;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    double& value = parameters()[i].of(c);
    value = value_of(config.quantities[i], value, wanted);
  }
  return c;
}

/// The vertical's own oscillator takes part in the history.
bool oscillates(const StudyConfig& config, const Case& c) {
  return config.vertical != std::vector{VerticalChoice::none} && c.vertical_period_s != 0.0;
}

/// The function that computes the histories of a case.
enum class KernelFunction { peak_slip, peak_slip_two_axes, slide_on_building };
constexpr const char* function_names[] = {"peak_slip", "peak_slip_two_axes", "slide_on_building"};

KernelFunction function_of(Kernel kernel, const StudyConfig& config, const Case& c) {
  if (kernel == Kernel::tables) return KernelFunction::peak_slip;
  const bool shear_of_modes = config.base_shear && !config.building.is_one_mass();
  return shear_of_modes || oscillates(config, c) ? KernelFunction::slide_on_building
                                                 : KernelFunction::peak_slip_two_axes;
}

}  // namespace

KernelChoice cheapest_exact_kernel(const StudyConfig& config) {
  const Case c = case_of(config, CaseValues::unusual);
  if (config.two_axes()) return {Kernel::full, "both horizontal components act at once"};
  if (c.law.depends_on_speed()) return {Kernel::full, "friction depends on speed"};
  if (!c.law.is_coulomb()) {
    if (oscillates(config, c))
      return {Kernel::full,
              "friction is stronger at rest and the vertical has a period of its own"};
    return {Kernel::coupled, "friction is stronger at rest"};
  }
  if (c.period_s == 0.0) return {Kernel::tables, "one axis on a rigid building"};
  if (c.mass_ratio == 0.0 && !c.yields())
    return {Kernel::tables, "one axis on a linear building that the array does not move"};
  if (oscillates(config, c))
    return {Kernel::full,
            "the vertical has a period of its own beside a building that yields or is coupled with "
            "the array"};
  if (c.yields()) return {Kernel::coupled, "the building yields"};
  return {Kernel::coupled, "building.mass_ratio is above 0"};
}

double history_us(Kernel kernel, const StudyConfig& config) {
  const Case c = case_of(config, CaseValues::unusual);
  if (kernel == Kernel::tables) return 7.0;
  const bool coupled_modes = !config.building.is_one_mass() && c.mass_ratio > 0.0;
  if (function_of(kernel, config, c) == KernelFunction::peak_slip_two_axes)
    return coupled_modes || c.yields() ? 350.0 : 200.0;
  return coupled_modes ? 7700.0 : 2000.0;
}

std::string describe(Kernel kernel, const StudyConfig& config) {
  const KernelFunction usual = function_of(kernel, config, case_of(config, CaseValues::usual)),
                       unusual = function_of(kernel, config, case_of(config, CaseValues::unusual));
  const auto name = [](KernelFunction f) {
    return std::string(function_names[static_cast<std::size_t>(f)]);
  };
  const std::string functions =
      usual == unusual ? name(usual) : name(usual) + " or " + name(unusual);
  switch (kernel) {
    case Kernel::tables:
      return "one axis over tables of the roof's motion: exact events (" + functions + ")";
    case Kernel::coupled:
      return "one axis, coupled building and array: error-controlled (" + functions + ")";
    case Kernel::full:
      break;
  }
  return "full model: two axes, coupled, error-controlled (" + functions + ")";
}

}  // namespace glissade
