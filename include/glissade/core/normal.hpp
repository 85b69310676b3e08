// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

// The standard normal distribution by Boost.Math: a few ulp in both tails; NaN of NaN.

double normal_cdf(double z);
/// Its inverse: -inf at 0, inf at 1.
double normal_quantile(double probability);

}  // namespace glissade
