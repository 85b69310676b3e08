// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glissade {

enum class SeismicDesignCategory { a, b, c, d, e, f };
SeismicDesignCategory parse_seismic_design_category(const std::string& text);
std::string to_string(SeismicDesignCategory category);

/// Source of a provision.
enum class Provenance {
  checked,   ///< reproduced from a source
  recalled,  ///< from memory of the standard: verify against the standard
};

/// A prescribed displacement or separation, with its source.
struct Prescription {
  double value_m = 0.0;
  Provenance provenance = Provenance::checked;
  std::string
      basis;  ///< the equation or clause, and, where recalled, "verify against the standard"
};

/// SEAOC PV1-2012 prescribes for slopes below and friction above these (checked: Rodriguez-Nikl et
/// al. 2019).
inline constexpr double seaoc_slope_limit_deg = 3.0, seaoc_mu_limit = 0.4;
inline constexpr bool seaoc_pv1_2012_applies(double slope_deg, double mu) {
  return slope_deg < seaoc_slope_limit_deg && mu > seaoc_mu_limit;
}

/// ASCE 7-16 section 13.6.12 is for roofs up to 1 in 20 (recalled: verify against the standard).
inline constexpr double asce7_16_slope_limit_deg = 2.8624052261117474;
/// And for friction of this or more (recalled).
inline constexpr double asce7_16_mu_limit = 0.4;

/// SEAOC PV1-2012 design displacement: 60 (S_DS - 0.4)^2 in for SDC D, E, F (checked); not less
/// than 6 in (recalled); 6 in for SDC A-C (recalled). S_DS < 0.4 g counts as 0.4.
Prescription seaoc_pv1_2012_displacement(double sds_g, SeismicDesignCategory category);

/// ASCE 7-16 section 13.6.12: 5 I_e (S_DS - 0.4)^2 ft (checked); not less than 24 in (recalled).
Prescription asce7_16_displacement(double sds_g, double importance);

struct Separation {
  std::string what;  ///< "between similar arrays", ...
  double factor;     ///< times the design displacement
  double value_m;
  Provenance provenance;
};
/// The four separations of ASCE 7-16 section 13.6.12 for a design displacement.
std::vector<Separation> asce7_16_separations(double displacement_m);

}  // namespace glissade
