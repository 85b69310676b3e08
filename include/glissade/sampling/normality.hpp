// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glissade {

/// Test of the hypothesis that the values are a sample of a normal distribution.
struct ShapiroWilk {
  double w;        ///< (0, 1]; near 1 if the ordered values are linear in normal scores
  double p_value;  ///< probability of a W as small for normal values; small: evidence against them
};

/// The W test of Shapiro & Wilk (1965) with the weights and p-values of Royston (1995, Applied
/// Statistics 44(4), AS R94). W does not depend on origin and scale of the values. For three values
/// the p-value is exact; otherwise Royston's approximation. For 3 to 5,000 values that are not all
/// equal. (The test of Anderson and Darling has p-values from eight values on only, and pull tests
/// are often fewer.)
ShapiroWilk shapiro_wilk(std::vector<double> values);

}  // namespace glissade
