// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/code_values.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"

namespace glissade {
namespace {

/// The first limit that the value is below: 0 (category A) to 3 (D).
int row_of(double value, const std::array<double, 3>& limits) {
  return static_cast<int>(std::ranges::upper_bound(limits, value) - limits.begin());
}

}  // namespace

std::string to_string(RiskCategory category) {
  constexpr std::array<const char*, 4> names{"I", "II", "III", "IV"};
  return names[static_cast<std::size_t>(category)];
}

double importance_factor(RiskCategory category) {
  constexpr std::array<double, 4> factors{1.0, 1.0, 1.25, 1.5};
  return factors[static_cast<std::size_t>(category)];
}

SeismicDesignCategory seismic_design_category(double sds_g, double sd1_g, double s1_g,
                                              RiskCategory category) {
  const bool is_iv = category == RiskCategory::iv;
  if (s1_g >= 0.75) return is_iv ? SeismicDesignCategory::f : SeismicDesignCategory::e;
  int row = std::max(row_of(sds_g, {0.167, 0.33, 0.50}), row_of(sd1_g, {0.067, 0.133, 0.20}));
  if (is_iv && row > 0 && row < 3) ++row;
  return static_cast<SeismicDesignCategory>(row);
}

double approximate_period_s(const StructuralSystem& system, double height_m) {
  GLISSADE_EXPECTS(height_m > 0.0);
  return system.ct * std::pow(height_m / foot_m, system.exponent);
}

}  // namespace glissade
