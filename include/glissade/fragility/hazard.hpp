// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/fragility/curve.hpp"

namespace glissade {

struct HazardPoint {
  double intensity = 0.0;    ///< > 0
  double annual_rate = 0.0;  ///< > 0: of shaking above that intensity
};

/// A seismic hazard curve: a power law between neighbouring points (a line in logarithms). Beyond
/// either end the power law of the end's interval goes on; where the curve bends downward in
/// logarithms, as those of sites do, that gives more than the true rate. No intensity has a lower
/// bound: the rate of shaking above 0 is infinite.
class HazardCurve {
 public:
  /// Throws InputError unless there are two points or more, of rising intensity and falling rate.
  explicit HazardCurve(std::vector<HazardPoint> points);
  /// k0 x^-k; both > 0 (InputError).
  static HazardCurve power_law(double k0, double k);
  /// The power law of exponent k by which the risk target of ASCE 7 is met exactly: a structure
  /// that collapses with 10 % probability at `mce` (MCE_R), with log_std 0.6, collapses with 1 % in
  /// 50 years (ASCE 7-16, 21.2.1.2, recalled; Luco et al. 2007). Both > 0 (InputError). No site's
  /// curve: where MCE_R is limited by a deterministic earthquake the rates of the site are higher.
  static HazardCurve of_risk_target(double mce, double k);

  const std::vector<HazardPoint>& points() const { return points_; }
  bool is_power_law() const { return points_.size() == 2; }
  double annual_rate(double intensity) const;     ///< of shaking above it; infinite at 0
  double intensity_at(double annual_rate) const;  ///< the inverse; 0 at an infinite rate
  double exponent(std::size_t interval) const;    ///< k between points `interval` and the next

 private:
  std::vector<HazardPoint> points_;
};

/// The annual rate of exceedance, the integral of P(exceed | x) over |d rate(x)|. By parts it is
/// the mean of the hazard curve over the fragility's capacities, and has a closed form on every
/// interval: no quadrature, accurate to a few parts in 1e13 (to 1e-15 of the largest interval's
/// part). With a floor above 0 it is infinite: that share exceeds without shaking.
double annual_rate(const HazardCurve& hazard, const FragilityCurve& fragility);

/// Of one event or more in so many years, by a Poisson process: 1 - exp(-rate years).
double probability_in(double years, double annual_rate);
/// Its inverse: 1 % in 50 years is 2.01e-4 a year.
double rate_of(double probability, double years);

}  // namespace glissade
