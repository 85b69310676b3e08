// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "glissade/standards/prescriptive.hpp"

// Values of ASCE 7-16 that lead from a site and a building to a design displacement. Those that are
// not marked checked are recalled: verify against the standard.
namespace glissade {

enum class RiskCategory { i, ii, iii, iv };
std::string to_string(RiskCategory category);  ///< "I" ... "IV"

/// Importance factor I_e, table 1.5-2 (recalled): 1, 1, 1.25, 1.5.
double importance_factor(RiskCategory category);

/// Tables 11.6-1 and 11.6-2 and section 11.6 (recalled): the more severe category of both spectral
/// accelerations; E, or F of risk category IV, where s1_g is 0.75 or more (0: not known).
SeismicDesignCategory seismic_design_category(double sds_g, double sd1_g, double s1_g,
                                              RiskCategory category);

/// A row of table 12.8-2.
struct StructuralSystem {
  const char* name;  ///< in files: "steel_moment_frame"
  const char* text;  ///< "steel moment-resisting frame"
  double ct;         ///< with the height in feet
  double exponent;
  Provenance provenance;
  /// Shear-to-flexure parameter of a uniform cantilever with such a system: moment frames 5 to 20,
  /// braced frames and walls with frames 1.5 to 6, walls and what is not known 0 to 2 (Miranda &
  /// Taghavi 2005, recalled: verify).
  double least_alpha, most_alpha;
};
inline constexpr std::array<StructuralSystem, 4> structural_systems{
    {{"steel_moment_frame", "steel moment-resisting frame", 0.028, 0.8, Provenance::recalled, 5,
      20},
     {"concrete_moment_frame", "concrete moment-resisting frame", 0.016, 0.9, Provenance::recalled,
      5, 20},
     {"eccentrically_braced_frame", "eccentrically or buckling-restrained braced steel frame", 0.03,
      0.75, Provenance::recalled, 1.5, 6},
     {"other", "all other structural systems", 0.02, 0.75, Provenance::checked, 0, 2}}};

/// Equation 12.8-7: T_a = C_t h^x in s. Valid for height_m > 0.
double approximate_period_s(const StructuralSystem& system, double height_m);

}  // namespace glissade
