// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "two_axis_truth/radau.hpp"
#include "two_axis_truth/two_axis_truth.hpp"

namespace glissade::test {

constexpr std::size_t most_floors = 3;
using Floors = std::array<Long, most_floors>;
using Matrix = std::array<Floors, most_floors>;

/// One axis of the building by the matrices M^-1 K and M^-1 C of its floors; no floors: rigid.
/// A damping ratio of all modes is C = 2 zeta M (M^-1 K)^(1/2), without the modes.
class Storeys {
 public:
  Storeys() = default;
  /// One mass.
  Storeys(Long omega, Long zeta) : floors_(1) {
    stiffness_[0][0] = omega * omega;
    damping_[0][0] = 2.0L * zeta * omega;
  }
  explicit Storeys(const ShearBuilding& of) : floors_(of.masses.size()) {
    Long total = 0;
    for (const double mass : of.masses) total += mass;
    for (std::size_t i = 0; i < floors_; ++i) {
      share_[i] = of.masses[i] / total;
      stiffness_[i][i] += of.stiffnesses[i];
      if (i == 0) continue;
      stiffness_[i - 1][i - 1] += of.stiffnesses[i];
      stiffness_[i][i - 1] = stiffness_[i - 1][i] = -static_cast<Long>(of.stiffnesses[i]);
    }
    for (std::size_t i = 0; i < floors_; ++i)
      for (Long& k : stiffness_[i]) k /= of.masses[i];
    damping_ = root(stiffness_);
    for (Floors& row : damping_)
      for (Long& c : row) c *= 2.0L * of.damping_ratio;
  }

  std::size_t floors() const { return floors_; }
  /// Of a floor's mass in that of the building.
  Long share(std::size_t floor) const { return share_[floor]; }
  /// Bound by the rows of M^-1 K (Gershgorin); 0: rigid.
  Long largest_omega() const {
    Long largest = 0;
    for (std::size_t i = 0; i < floors_; ++i) {
      Long sum = 0;
      for (std::size_t j = 0; j < floors_; ++j) sum += std::abs(stiffness_[i][j]);
      largest = std::max(largest, std::sqrt(sum));
    }
    return largest;
  }
  /// A floor's acceleration by springs and dampers.
  Long pull(std::size_t floor, const Floors& u, const Floors& rate) const {
    Long a = 0;
    for (std::size_t j = 0; j < floors_; ++j)
      a -= stiffness_[floor][j] * u[j] + damping_[floor][j] * rate[j];
    return a;
  }

 private:
  Matrix inverse(const Matrix& of) const {
    Matrix inverse{};
    for (std::size_t j = 0; j < most_floors; ++j) {
      Matrix a = of;
      for (std::size_t i = floors_; i < most_floors; ++i) a[i][i] = 1;
      Floors column{};
      column[j] = 1;
      solve_linear(a, column);
      for (std::size_t i = 0; i < most_floors; ++i) inverse[i][j] = column[i];
    }
    return inverse;
  }
  /// Square root by Denman & Beavers (1976).
  Matrix root(Matrix y) const {
    Matrix z{};
    for (std::size_t i = 0; i < most_floors; ++i) z[i][i] = 1;
    for (int pass = 0; pass < 40; ++pass) {
      const Matrix per_y = inverse(y), per_z = inverse(z);
      for (std::size_t i = 0; i < floors_; ++i)
        for (std::size_t j = 0; j < floors_; ++j) {
          y[i][j] = 0.5L * (y[i][j] + per_z[i][j]);
          z[i][j] = 0.5L * (z[i][j] + per_y[i][j]);
        }
    }
    return y;
  }

  std::size_t floors_ = 0;
  Floors share_{1};
  Matrix stiffness_{}, damping_{};
};

}  // namespace glissade::test
