// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace glissade {

/// Ground motion at an instant: acceleration, and velocity and displacement integrated from rest.
/// The displacement is a sum of two doubles, so that differences of neighbouring values keep their
/// digits at any drift.
struct GroundNode {
  double acceleration_mps2 = 0.0;
  double velocity_mps = 0.0;
  double displacement_m = 0.0;
  double displacement_low_m = 0.0;
};

/// A digitised record, linear between samples, with V = integral of a and U = integral of V exact
/// at equally spaced nodes: `parts` of them a sample interval. After the last sample the
/// acceleration goes linearly to zero over one interval and stays there.
class GroundTable {
 public:
  /// @param dt_s > 0, the record's step
  /// @param acceleration_mps2 at least one sample; zeros at its end have no effect
  /// @param parts >= 1
  GroundTable(double dt_s, std::span<const double> acceleration_mps2, int parts = 1);

  double step_s() const { return step_s_; }
  /// The node of the last given sample, zeros included: the end of free sliding.
  std::size_t last_sample() const { return last_sample_; }
  /// The first node from which on the ground stays at zero acceleration.
  std::size_t quiet_from() const { return quiet_from_; }

  double peak_acceleration_mps2() const { return peak_acceleration_mps2_; }

  /// Nodes 0 .. count - 1. Those after quiet_from() are made on demand.
  void extend(std::size_t count);
  std::span<const GroundNode> nodes() const { return nodes_; }
  /// Accelerations and velocities of the nodes as arrays, for loops over all of them.
  std::span<const double> acceleration_mps2() const { return acceleration_mps2_; }
  std::span<const double> velocity_mps() const { return velocity_mps_; }

 private:
  double step_s_;
  std::size_t last_sample_ = 0, quiet_from_ = 0;
  double peak_acceleration_mps2_ = 0.0;
  double velocity_low_mps_ = 0.0;  ///< rounding remainder of velocity_mps of the last node
  std::vector<GroundNode> nodes_;
  std::vector<double> acceleration_mps2_, velocity_mps_;

  void append(double acceleration_mps2);
  void append(const GroundNode& node);
};

}  // namespace glissade
