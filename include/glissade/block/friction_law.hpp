// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace glissade {

/// Dependence of friction on the state of the block (theory.md, 3.5): factors on every coefficient
/// of the block, which are those of slow sliding, as measured by a pull test.
///   at rest    mu_static = static_over_sliding mu: it sticks while |tangential force| <= mu_static
///   N sliding    mu(|v|) = mu (fast_over_slow - (fast_over_slow - 1) exp(-rate_s_per_m |v|))
/// The latter is mu_fast - (mu_fast - mu_slow) exp(-a |v|) (Constantinou, Mokha & Reinhorn 1990,
/// J. Struct. Eng. 116(2):455-474) with mu_fast = fast_over_slow mu_slow. By default Coulomb's
/// law.
struct FrictionLaw {
  double static_over_sliding = 1.0;  ///< >= 1
  double fast_over_slow = 1.0;       ///< > 0
  double rate_s_per_m = 0.0;         ///< a, s/m along the slope, >= 0

  bool is_valid() const {
    return static_over_sliding >= 1.0 && fast_over_slow > 0.0 && rate_s_per_m >= 0.0;
  }
  bool depends_on_speed() const { return fast_over_slow != 1.0 && rate_s_per_m != 0.0; }
  /// mu(|v|) / mu, its derivative, s/m, and its limits: it is monotonic.
  double factor(double speed_mps) const {
    return fast_over_slow - (fast_over_slow - 1.0) * decay(speed_mps);
  }
  double factor_rate(double speed_mps) const {
    return (fast_over_slow - 1.0) * rate_s_per_m * decay(speed_mps);
  }
  double least_factor() const { return std::min(1.0, fast_over_slow); }
  double largest_factor() const { return std::max(1.0, fast_over_slow); }
  /// By how much it falls at most, s/m; 0 where it rises.
  double steepest_fall() const { return std::max(0.0, -factor_rate(0.0)); }

  bool is_coulomb() const { return static_over_sliding == 1.0 && !depends_on_speed(); }

 private:
  double decay(double speed_mps) const { return std::exp(-rate_s_per_m * speed_mps); }
};

}  // namespace glissade
