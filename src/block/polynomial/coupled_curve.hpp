// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/coupled_regime.hpp"

namespace glissade::block_detail {

/// A drive or a speed over what is left of an interval, t in fractions of a whole one:
///   f(t) = c0 + c1 t + c2 t^2 + Re(b exp(s dt t)),   0 <= t <= length
struct Curve {
  double c0 = 0.0, c1 = 0.0, c2 = 0.0;
  Amplitude b;
};
inline Curve operator-(const Curve& f) { return {-f.c0, -f.c1, -f.c2, -1.0 * f.b}; }

/// What bounds on f's derivatives prove.
enum class Proof {
  negative,  ///< throughout
  rises,     ///< from below zero to above, and never falls
  unknown
};

/// A curve with what it is at both ends.
class BoundedCurve {
 public:
  /// @param at_end exp(s dt length)
  BoundedCurve(const Curve& f, const RegimeOscillator& regime, double length, Amplitude at_end);

  Proof proof() const;
  /// Never falls.
  bool never_falls() const { return lower(begin_slope_, end_slope_) > slope_deviation_; }
  bool never_rises() const { return upper(begin_slope_, end_slope_) < -slope_deviation_; }
  double begin() const { return begin_; }
  double end() const { return end_; }

  struct Root {
    double t;
    Amplitude power;  ///< exp(s dt t)
    bool found;
  };
  /// @pre proof() == rises
  Root root() const;

 private:
  bool is_below_zero() const { return upper(begin_, end_) + deviation_ < 0.0; }
  static double lower(double p, double q) { return p < q ? p : q; }
  static double upper(double p, double q) { return p > q ? p : q; }
  /// The largest value of the cubic with f's values and slopes at both ends.
  double highest_of_cubic() const;
  double first_guess() const;

  const Curve& f_;
  const RegimeOscillator& regime_;
  double length_;
  double begin_, end_;
  double deviation_;  ///< f leaves its chord by no more
  // Of a curve that its chord does not show to be below zero throughout:
  double begin_slope_ = 0.0, end_slope_ = 0.0;  ///< per length
  double slope_deviation_ = 0.0;                ///< f' leaves its own chord by no more
  double cubic_error_ = 0.0;                    ///< f leaves the cubic by no more
  double largest_third_ = 0.0;                  ///< |f'''|, per interval
};

}  // namespace glissade::block_detail
