// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "block/contact/plane_vector.hpp"
#include "glissade/block/slip_result.hpp"
#include "glissade/core/hull_maximum.hpp"

namespace glissade::block_detail {

/// A piece of path in plan: the velocity is the cubic through the velocities and accelerations of
/// both ends (Hermite), of order 4 as the step.
struct Path {
  double length_s = 0.0;
  Vector begin, end;        ///< displacement
  std::array<Vector, 4> v;  ///< Bernstein coefficients of the cubic, which stays in their hull

  Path(double length, Vector from, Vector v0, Vector a0, Vector v1, Vector a1)
      : length_s(length),
        begin(from),
        end(from + (0.5 * length) * (v0 + v1) + (length * length / 12.0) * (a0 - a1)),
        v{v0, v0 + (length / 3.0) * a0, v1 - (length / 3.0) * a1, v1} {}

  Vector velocity(double fraction) const;
  Vector displacement(double fraction) const;
  /// Bernstein coefficients of the displacement.
  std::array<Vector, 5> displacement_points() const;
  /// By Simpson's rule on the speed.
  double path_length() const;
};

/// The largest values of a history.
class Extremes {
 public:
  Extremes() = default;
  /// Those of a history so far.
  Extremes(double displacement, double speed, Vector ahead, Vector back)
      : displacement_(displacement), speed_(speed), ahead_(ahead), back_(back) {}
  void at(Vector displacement);
  void at_speed(double speed) { speed_ = std::max(speed_, speed); }
  void along(const Path& path);
  double displacement() const { return displacement_; }
  /// The largest displacement in the positive and in the negative direction of each axis, >= 0.
  Vector ahead() const { return ahead_; }
  Vector back() const { return back_; }
  double speed() const { return speed_; }

 private:
  double displacement_ = 0.0, speed_ = 0.0;
  Vector ahead_, back_;
};

void set_peaks(const Extremes& extremes, SlipPeak& slip);

}  // namespace glissade::block_detail
