// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "glissade/building/ground_table.hpp"
#include "glissade/building/roof_motion.hpp"

namespace glissade {

/// Bounds on a motion, on the safe side and in single precision: they limit the search for events
/// and never affect results. Accelerations are multiplied by acceleration_scale, velocities by
/// velocity_scale, which are powers of two, so that motions of any size fit.
struct MotionBounds {
  static constexpr std::size_t tile = 64;  ///< intervals covered by a coarse bound

  double acceleration_scale = 1.0, velocity_scale = 1.0;
  // Of the acceleration in the interval after each node.
  std::vector<float> lowest, highest;
  std::vector<float> tile_lowest, tile_highest;
  // V, lowered and raised by its largest departure from the chord between its values at the nodes,
  // in the intervals on either side of the node.
  std::vector<float> velocity_below, velocity_above;
  double largest_velocity_mps = 0.0;  ///< |V|
};

/// Bernstein coefficients of a quartic on an interval.
struct Quartic {
  double b[5];
};

/// Raises `largest` >= 0 to the largest value of a quartic on its interval, to 1e-12 of it.
void raise_to_largest(const Quartic& quartic, double& largest);

/// Read access to the exact values of a table. Contains pointers: valid until the table or its
/// ground changes.
class MotionNodes {
 public:
  bool rigid() const { return x_ == nullptr; }

  double acceleration_mps2(std::size_t i) const {
    return rigid() ? ground_[i].acceleration_mps2 : -(x_[i] + twice_zeta_ * y_[i]);
  }
  double velocity_mps(std::size_t i) const {
    const double v = ground_[i].velocity_mps;
    return rigid() ? v : v + y_[i] * per_omega_s_;
  }
  /// U(i) - U(from), without loss of digits by earlier drift of the ground.
  double displacement_from_m(std::size_t from, std::size_t i) const {
    const GroundNode &a = ground_[from], &b = ground_[i];
    const double moved =
        (b.displacement_m - a.displacement_m) + (b.displacement_low_m - a.displacement_low_m);
    return rigid() ? moved : moved + (x_[i] - x_[from]) * (per_omega_s_ * per_omega_s_);
  }
  /// The acceleration in the interval after node i; a straight line if the roof is rigid.
  Quartic acceleration_after(std::size_t i) const {
    const double a0 = acceleration_mps2(i), a1 = acceleration_mps2(i + 1);
    if (rigid()) return {{a0, a0 + 0.25 * (a1 - a0), 0.5 * (a0 + a1), a1 - 0.25 * (a1 - a0), a1}};
    const double b1 = a0 + quarter_step_s_ * jerk_mps3(i);
    const double b3 = a1 - quarter_step_s_ * jerk_mps3(i + 1);
    // The mean of the coefficients is the mean of a, which follows from V.
    const double sum = five_per_step_ * (velocity_mps(i + 1) - velocity_mps(i));
    return {{a0, b1, sum - ((a0 + a1) + (b1 + b3)), b3, a1}};
  }

 private:
  friend struct MotionTable;
  double jerk_mps3(std::size_t i) const {
    const double resisting = x_[i] + twice_zeta_ * y_[i];
    return omega_radps_ * (twice_zeta_ * (resisting + ground_[i].acceleration_mps2) - y_[i]);
  }

  const GroundNode* ground_ = nullptr;
  const double *x_ = nullptr, *y_ = nullptr;
  double omega_radps_ = 0.0, per_omega_s_ = 0.0, twice_zeta_ = 0.0;
  double quarter_step_s_ = 0.0, five_per_step_ = 0.0;
};

/// One component of a roof motion, tabulated for the kernel: V, U and a exact at equally spaced
/// nodes, and bounds to skip intervals without events. It is linear in the ground motion, so one
/// table serves every intensity, friction and slope (theory.md, 2.1).
///
/// Rigid: the ground itself, linear between nodes. Oscillator: exact at the nodes (Nigam & Jennings
/// 1969); between them V is the quintic with the exact V, a and da/dt at both ends, so a is a
/// quartic whose integral is exact.
struct MotionTable {
  std::shared_ptr<GroundTable> ground;
  Oscillator oscillator;  ///< period 0: rigid
  double omega_radps = 0.0;
  std::vector<double> x, y;  ///< an oscillator's scaled state (core/oscillator.hpp) at the nodes
  std::size_t nodes = 0;
  std::size_t end = 0;  ///< the last node required by the ring-down; the rest is for free sliding
  double acceleration_bound_mps2 = 0.0;  ///< at least max |a|
  MotionBounds bounds;

  bool rigid() const { return oscillator.period_s == 0.0; }
  double step_s() const { return ground->step_s(); }
  MotionNodes at_nodes() const;
};

/// The ground as the motion of a rigid roof.
MotionTable tabulate_rigid(std::shared_ptr<GroundTable> ground);

/// Number of parts into which a sample interval is divided for an oscillator of this period: a
/// power of two up to 256, one except for the shortest periods. 0: is_rigid() (rigid.hpp), the roof
/// motion is the ground motion.
int parts_needed(const Oscillator& oscillator, double dt_s);

/// Responses of oscillators (period > 0) to one ground motion, with the ring-down given by
/// `follow`, each in its own table, whose memory is reused. Sixteen at a time are computed in SIMD
/// lanes; run times are in tests/bench (table `roofs`).
/// @param follow as many as oscillators; @throw InputError above 2^25 nodes
void tabulate_responses(const std::shared_ptr<GroundTable>& ground,
                        std::span<const Oscillator> oscillators,
                        std::span<const RoofMotionOptions> follow, std::span<MotionTable> tables);

/// max |a| up to `end`, between nodes too, with a relative error of 1e-12.
double peak_acceleration_mps2(const MotionTable& table);

/// Continues the motion to at least `nodes` nodes: the ground at rest, an oscillator in free
/// vibration.
void extend(MotionTable& table, std::size_t nodes);

}  // namespace glissade
