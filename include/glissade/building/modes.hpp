// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace glissade {

/// A linear single-degree-of-freedom oscillator. period_s = 0: rigid, the roof moves with the
/// ground.
struct Oscillator {
  double period_s = 0.0;        ///< >= 0
  double damping_ratio = 0.05;  ///< >= 0
};

/// A mode of a linear, classically damped building along one axis, as the array on its roof meets
/// it (Chopra 2017, chapter 13): with M_n = phi^T M phi and L_n = phi^T M 1,
///   gamma = (L_n / M_n) phi at the array,   e = L_n^2 / (M_n M),
/// and the roof's absolute acceleration is a_g + sum of gamma D_n'' over the modes. One mass on one
/// spring is gamma = e = 1. Over all modes the sum of gamma and that of e are 1.
struct Mode {
  double period_s = 0.0;        ///< > 0
  double participation = 1.0;   ///< gamma, at the array
  double mass_share = 1.0;      ///< e, (0, 1]
  double damping_ratio = 0.05;  ///< >= 0

  Oscillator oscillator() const { return {period_s, damping_ratio}; }
  auto operator<=>(const Mode&) const = default;
};

/// The most modes that a building is computed with along an axis.
inline constexpr std::size_t most_modes = 6;

/// A building along one axis: one mass on one spring, or some of its modes, the longest period
/// first. Those that it has not move with the ground.
class Modes {
 public:
  Modes() = default;  ///< rigid
  // One mass. NOLINTNEXTLINE(google-explicit-constructor): an oscillator is a building.
  Modes(const Oscillator& one_mass) : Modes(one_mass.period_s, one_mass.damping_ratio) {}
  Modes(double period_s, double damping_ratio) : modes_{{{period_s, 1.0, 1.0, damping_ratio}}} {}
  /// @param modes at most most_modes
  explicit Modes(std::span<const Mode> modes);

  std::size_t size() const { return size_; }
  const Mode* begin() const { return modes_.data(); }
  const Mode* end() const { return modes_.data() + size_; }
  const Mode& operator[](std::size_t n) const { return modes_[n]; }
  Mode& operator[](std::size_t n) { return modes_[n]; }

  /// The longest period; 0: rigid.
  double period_s() const { return modes_[0].period_s; }
  bool rigid() const { return period_s() == 0.0; }
  bool is_one_mass() const {
    return size_ == 1 && modes_[0].participation == 1.0 && modes_[0].mass_share == 1.0;
  }
  /// The part of the ground's acceleration that the roof has from modes that are left out,
  /// 1 - sum of gamma.
  double ground_share() const;
  /// The roof's acceleration by a force at the array that would give the whole building 1:
  /// sum of gamma^2 / e.
  double accelerance() const;

  auto operator<=>(const Modes&) const = default;

 private:
  std::size_t size_ = 1;
  std::array<Mode, most_modes> modes_{};
};

/// The largest shear-to-flexure parameter of cantilever_modes(): beyond it the building is one of
/// uniform shear to 1e-3.
inline constexpr double largest_alpha = 500.0;

/// A uniform cantilever of flexure and shear (Miranda & Taghavi 2005, J. Struct. Eng. 131(2):
/// 203-211): `alpha`, their alpha_0, is 0 for flexure alone (usual ones: mode_rules.hpp). The array
/// is at its top. Accurate to 1e-12 of the periods and
/// 2e-8 of the other numbers, for alpha to 30 (modes_test).
/// @param period_s of the first mode, > 0
/// @param alpha from 0 to largest_alpha
std::vector<Mode> cantilever_modes(double period_s, double alpha, std::size_t count);

/// A shear building: masses of the floors and stiffnesses of the storeys below them, from the
/// ground up, in any consistent units (kg and N/m for seconds). The array is on the last floor. As
/// many modes as floors, the longest period first.
/// @throw InputError where a mass or stiffness is not above 0, or their numbers differ
std::vector<Mode> shear_building_modes(std::span<const double> masses,
                                       std::span<const double> stiffnesses);

/// The same building, stiffer or softer: its first mode has this period.
std::vector<Mode> with_first_period(std::vector<Mode> modes, double period_s);

/// Modes after the first of shorter periods are not governing.
inline constexpr double shortest_governing_period_s = 0.05;

/// The first, and those with the largest mass shares: to 95 % of the mass, without periods below
/// 0.05 s, at most six, the longest first. Modes that are left out move with the ground.
std::vector<Mode> governing_modes(std::span<const Mode> modes);

/// Sum of the mass shares.
double mass_of(std::span<const Mode> modes);

/// Sentences on modes along one axis that are possible and not probable: too little mass, or
/// participations that are not those at a roof.
std::vector<std::string> improbable_modes(std::span<const Mode> modes);

}  // namespace glissade
