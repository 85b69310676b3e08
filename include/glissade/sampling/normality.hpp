// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glissade {

/// Could these values be a sample of a normal distribution?
struct ShapiroWilk {
  double w;        ///< (0, 1]; near 1 where the ordered values lie on a line over normal scores
  double p_value;  ///< chance of a W as small from normal values; small speaks against normality
};

/// The W test of Shapiro & Wilk (1965) with the weights and p-values of Royston (1995, Applied
/// Statistics 44(4), AS R94). W does not change with the values' origin and scale. For three values
/// the p-value is exact; else Royston's approximation. Takes 3 to 5,000 values that are not all
/// equal. (Anderson and Darling's test, the other usual one, has p-values from eight values on
/// only, and pull tests are often fewer.)
ShapiroWilk shapiro_wilk(std::vector<double> values);

}  // namespace glissade
