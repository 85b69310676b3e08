// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/standards/code_values.hpp"

// What a standard requires of array, roof and building before its prescribed displacement may be
// used: one table, from which every output takes what it shows and judges. All conditions are
// recalled: verify against the standard.
namespace glissade {

/// Of slope and friction alone, as designs and charts are judged.
double slope_limit_deg(Standard standard);  ///< this or less
double friction_limit(Standard standard);   ///< this or more

/// Of an array and the building below it; none: not known.
struct ArrayFacts {
  std::optional<double> slope_deg, friction;
  std::string friction_basis = {};           ///< "mean - 2 std"; empty: none to state
  std::optional<std::string> test_standard;  ///< of the tests of friction
  std::optional<RiskCategory> risk;
  std::optional<double> storeys;
  std::optional<double> centre_of_mass_m;   ///< above the roof
  std::optional<double> support_spacing_m;  ///< the least, in plan
  /// Horizontal design strength across any section over the weight of its lighter side.
  std::optional<double> interconnection;
  std::optional<double> sds_g;
};

/// A row of the table, and whether it is met.
struct CodeCondition {
  std::string what, limit;  ///< "roof slope", "1 in 20 (2.86 degrees) or less"
  std::string found;        ///< "4 degrees", "not stated"
  std::string clause;       ///< "13.6.12"
  Provenance provenance = Provenance::recalled;
  std::optional<bool> is_met;  ///< none: not known

  std::string text() const { return what + " of " + limit; }
};
std::vector<CodeCondition> conditions_of(Standard standard, const ArrayFacts& array);

/// None is known not to be met.
bool is_within(Standard standard, const ArrayFacts& array);

/// Of the prescribed displacement, what an analysis without peer review may not go below.
double least_share(Standard standard);

/// What a standard requires of an analysis in place of its prescribed displacement, a sentence.
std::string analysis_provision(Standard standard);

/// Of conditions that are not met or, with `unknown`, not known: "storeys: 10, required 6 or
/// fewer".
std::string not_met_text(const std::vector<CodeCondition>& conditions, bool unknown = true);

}  // namespace glissade
