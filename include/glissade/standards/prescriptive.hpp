// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glissade {

enum class Standard { seaoc_pv1_2012, asce7_16 };
/// "seaoc_pv1_2012": in files.
std::string key_of(Standard standard);

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
  std::string basis;  ///< the equation or clause
};

/// SEAOC PV1-2012 design displacement: 60 (S_DS - 0.4)^2 in for SDC D, E, F (checked); not less
/// than 6 in (recalled); 6 in for SDC A-C (recalled). S_DS < 0.4 g counts as 0.4.
Prescription seaoc_pv1_2012_displacement(double sds_g, SeismicDesignCategory category);

/// ASCE 7-16 section 13.6.12: 5 I_e (S_DS - 0.4)^2 ft (checked); not less than 24 in (recalled).
Prescription asce7_16_displacement(double sds_g, double importance);

/// What an array keeps free, of a design displacement.
struct Separation {
  std::string what;  ///< "between similar arrays", ...
  double factor;     ///< times the design displacement
  double least_m;    ///< but not less than this
  double value_m;
  Provenance provenance;
  std::string basis;  ///< where sources differ, and of the least value; else empty
};
/// The four separations of a standard, in one order: between similar arrays, to a fixed object, to
/// an edge with a qualifying parapet, to one without.
std::vector<Separation> separations_of(Standard standard, double displacement_m);

/// Which parapet qualifies, in a sentence.
std::string qualifying_parapet(Standard standard);

}  // namespace glissade
