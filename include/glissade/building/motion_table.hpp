// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "glissade/building/ground_table.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/oscillator.hpp"

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

/// Of several modes at the nodes, each times its participation: absolute acceleration and its
/// derivative in time. Their displacement and velocity relative to the ground are MotionTable::x
/// and y.
struct ModeSum {
  std::vector<double> a, jerk;
  std::vector<OscillatorState> last;  ///< of each mode, at the last node
};

/// Read access to the exact values of a table. Contains pointers: valid until the table or its
/// ground changes.
class MotionNodes {
 public:
  bool rigid() const { return x_ == nullptr; }

  double acceleration_mps2(std::size_t i) const {
    if (rigid()) return ground_[i].acceleration_mps2;
    if (modes_ != nullptr) return ground_share_ * ground_[i].acceleration_mps2 + modes_->a[i];
    return -(x_[i] + twice_zeta_ * y_[i]);
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
    if (modes_ != nullptr) return acceleration_of_modes_after(i);
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
  /// What moves with the ground is a straight line, the rest as of one oscillator.
  Quartic acceleration_of_modes_after(std::size_t i) const {
    const double g0 = ground_share_ * ground_[i].acceleration_mps2,
                 g1 = ground_share_ * ground_[i + 1].acceleration_mps2, g = 0.25 * (g1 - g0);
    const double a0 = modes_->a[i], a1 = modes_->a[i + 1];
    const double b1 = a0 + quarter_step_s_ * modes_->jerk[i],
                 b3 = a1 - quarter_step_s_ * modes_->jerk[i + 1];
    const double moved =
        (1.0 - ground_share_) * (ground_[i + 1].velocity_mps - ground_[i].velocity_mps) +
        (y_[i + 1] - y_[i]);
    const double b2 = five_per_step_ * moved - ((a0 + a1) + (b1 + b3));
    return {{g0 + a0, g0 + g + b1, 0.5 * (g0 + g1) + b2, g1 - g + b3, g1 + a1}};
  }
  double jerk_mps3(std::size_t i) const {
    const double resisting = x_[i] + twice_zeta_ * y_[i];
    return omega_radps_ * (twice_zeta_ * (resisting + ground_[i].acceleration_mps2) - y_[i]);
  }

  const GroundNode* ground_ = nullptr;
  const double *x_ = nullptr, *y_ = nullptr;
  const ModeSum* modes_ = nullptr;
  double ground_share_ = 0.0;
  double omega_radps_ = 0.0, per_omega_s_ = 0.0, twice_zeta_ = 0.0;
  double quarter_step_s_ = 0.0, five_per_step_ = 0.0;
};

/// One component of a roof motion, tabulated for the kernel: V, U and a exact at equally spaced
/// nodes, and bounds to skip intervals without events. It is linear in the ground motion, so one
/// table serves every intensity, friction and slope (theory.md, 2.1).
///
/// Rigid: the ground itself, linear between nodes. Oscillator: exact at the nodes (Nigam & Jennings
/// 1969); between them V is the quintic with the exact V, a and da/dt at both ends, so a is a
/// quartic whose integral is exact. Several modes: their sum, so that a history costs the same.
struct MotionTable {
  std::shared_ptr<GroundTable> ground;
  Modes building;            ///< rigid: the ground itself
  double omega_radps = 0.0;  ///< of one mass; 1 of several modes
  std::vector<double> x, y;  ///< omega^2 u and omega u' at the nodes (core/oscillator.hpp)
  ModeSum modes;             ///< empty: one mass
  std::size_t nodes = 0;
  std::size_t end = 0;  ///< the last node required by the ring-down; the rest is for free sliding
  double acceleration_bound_mps2 = 0.0;  ///< at least max |a|
  MotionBounds bounds;

  bool rigid() const { return building.rigid(); }
  bool is_one_mass() const { return building.is_one_mass(); }
  double step_s() const { return ground->step_s(); }
  MotionNodes at_nodes() const;
};

/// The ground as the motion of a rigid roof.
MotionTable tabulate_rigid(std::shared_ptr<GroundTable> ground);

/// Number of parts into which a sample interval is divided for the shortest period of a building: a
/// power of two up to 256, one except for the shortest periods. 0: is_rigid() (rigid.hpp), the roof
/// motion is the ground motion.
int parts_needed(const Modes& building, double dt_s);

/// Responses of buildings (period > 0) to one ground motion, with the ring-down given by `follow`,
/// each in its own table, whose memory is reused. Sixteen oscillators at a time are computed in
/// SIMD lanes; run times are in tests/bench (table `roofs`).
/// @param follow as many as buildings; @throw InputError above 2^25 nodes
void tabulate_responses(const std::shared_ptr<GroundTable>& ground,
                        std::span<const Modes> buildings, std::span<const RoofMotionOptions> follow,
                        std::span<MotionTable> tables);

MotionTable tabulate_response(const std::shared_ptr<GroundTable>& ground, const Modes& building,
                              const RoofMotionOptions& follow);

/// max |a| up to `end`, between nodes too, with a relative error of 1e-12.
double peak_acceleration_mps2(const MotionTable& table);

/// Continues the motion to at least `nodes` nodes: the ground at rest, an oscillator in free
/// vibration.
void extend(MotionTable& table, std::size_t nodes);

}  // namespace glissade
