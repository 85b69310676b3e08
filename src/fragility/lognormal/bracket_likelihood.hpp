// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

/// A capacity between two values of y = ln x - center; equal: exact; infinite: open.
struct LogBracket {
  double low, high;
};

/// ln of the probability that z = b0 + b1 y is between the two ends, or of the density of y where
/// they are equal. Concave in the line (Burridge 1981, J. Royal Statistical
/// Society B 43(1):41-45).
Evaluation bracket_likelihood(const LogBracket& bracket, const ProbitLine& line);

}  // namespace glissade::fragility
