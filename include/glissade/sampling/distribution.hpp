// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

namespace glissade {

struct Fixed {
  double value;
};
struct Normal {
  double mean, std;
};  ///< std > 0
/// mean and std are those of the parent; min < max, either may be infinite, but part of the parent
/// must be between them: they may not both be more than 35 std to the same side of the mean.
struct TruncatedNormal {
  double mean, std, min, max;
};
struct LogNormal {
  double median, log_std;
};  ///< both > 0
struct Uniform {
  double min, max;
};  ///< min < max
struct Triangular {
  double min, mode, max;
};  ///< min <= mode <= max, min < max
struct Discrete {
  std::vector<double> values, weights;
};  ///< weights > 0, as many as values; need not sum to 1
struct Empirical {
  std::vector<double> values;
};  ///< at least two; linear between order statistics

/// Distribution of an uncertain parameter. A plain value type.
using Distribution = std::variant<Fixed, Normal, TruncatedNormal, LogNormal, Uniform, Triangular,
                                  Discrete, Empirical>;

/// Throws InputError (where = "") with every parameter that violates its rule. The functions below
/// require a valid distribution.
void validate(const Distribution& distribution);

/// The quantile of u in (0, 1). Monotone in u, so that quasi-random points remain quasi-random;
/// never outside the support. Accuracy of Boost.Math's normal quantile (a few ulp),
/// in both tails. Discrete: by increasing value, whatever their order. Empirical: Hyndman & Fan
/// (1996) type 7.
double quantile(const Distribution& distribution, double u);

/// Of the distribution that quantile() samples (so for Empirical not exactly those of its values).
double mean(const Distribution& distribution);
double standard_deviation(const Distribution& distribution);
/// The smallest and the largest possible value; may be infinite.
struct Support {
  double min, max;
};
Support support(const Distribution& distribution);

}  // namespace glissade
