// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "block/full_model/building_axis.hpp"
#include "block/polynomial/power_series.hpp"
#include "glissade/block/on_building.hpp"

namespace glissade::block_detail {

/// Excitation of the building over a piece of time: the ground along both axes, linear, and the
/// vertical roof acceleration, a polynomial in the elapsed fraction of the piece.
struct ExcitationPiece {
  double length_s = 0.0;
  std::array<Ramp, 2> ground{};
  std::array<double, 5> vertical{};  ///< coefficients of the powers of the fraction
  int vertical_terms = 0;            ///< 0: none, 2: linear, 5

  double w(double fraction) const {
    double sum = 0.0;
    for (int k = vertical_terms; k-- > 0;)
      sum = sum * fraction + vertical[static_cast<std::size_t>(k)];
    return sum;
  }
  double coefficient(int k) const {
    return k < vertical_terms ? vertical[static_cast<std::size_t>(k)] : 0.0;
  }
  /// Bound of the departure of w from the line between its values at both ends.
  double w_deviation() const {
    double sum = 0.0;
    for (std::size_t k = 2; k < 5; ++k) sum += std::abs(vertical[k]);
    return vertical_terms > 2 ? sum : 0.0;
  }
  /// No |w| is larger.
  double largest_w() const {
    double sum = 0.0;
    for (int k = 0; k < vertical_terms; ++k) sum += std::abs(coefficient(k));
    return sum;
  }
  /// Keeps the part after tau.
  void keep_after(double tau) { restrict_to(tau, 1.0); }
  /// Keeps the part between two fractions.
  void restrict_to(double from, double to) {
    const double fraction = to - from;
    for (Ramp& g : ground) g = {g.at(from), to == 1.0 ? g.end : g.at(to)};
    // Horner's shift to `from`, then a change of scale.
    for (int i = 0; i < vertical_terms; ++i)
      for (int k = vertical_terms - 1; k-- > i;)
        vertical[static_cast<std::size_t>(k)] += from * vertical[static_cast<std::size_t>(k) + 1];
    double scale = 1.0;
    for (double& c : vertical) {
      c *= scale;
      scale *= fraction;
    }
    length_s *= fraction;
  }
};

/// Excitation of the building, interval by interval. Refers to what it is made from.
class Excitation {
 public:
  Excitation(const BuildingGround& ground, const MotionFactors& factors)
      : dt_s_(ground.horizontal[0]->step_s()),
        factors_{factors.horizontal[0], factors.horizontal[1], factors.vertical} {
    for (std::size_t n = 0; n < 2; ++n)
      if (ground.horizontal[n] != nullptr) take(n, *ground.horizontal[n]);
    if (ground.vertical == nullptr) return;
    const MotionTable& up = *ground.vertical;
    if (up.rigid()) {
      take(vertical, *up.ground);
      return;
    }
    vertical_ = up.at_nodes();
    vertical_end_ = up.end;
    last_sample_ = std::max(last_sample_, up.ground->last_sample());
    quiet_from_ = std::max(quiet_from_, vertical_end_ + 1);
  }

  /// Of a rigid building: the ground is the roof.
  explicit Excitation(const TwoAxisAcceleration& roof)
      : dt_s_(roof.dt_s),
        factors_{roof.horizontal_factor, roof.horizontal_factor, roof.vertical_factor},
        last_sample_(roof.horizontal_mps2[0].size() - 1) {
    for (std::size_t n = 0; n < 3; ++n) {
      const auto& all = n == vertical ? roof.vertical_mps2 : roof.horizontal_mps2[n];
      std::size_t samples = all.size();
      while (samples > 0 && all[samples - 1] == 0.0) --samples;
      samples_mps2_[n] = all.first(samples);
      quiet_from_ = std::max(quiet_from_, samples);
    }
  }

  double dt_s() const { return dt_s_; }
  /// The first node from which on the excitation is zero.
  std::size_t quiet_from() const { return quiet_from_; }
  std::size_t last_sample() const { return last_sample_; }

  /// The ground at node i, and the vertical.
  double ground(std::size_t n, std::size_t i) const {
    return i < samples_mps2_[n].size() ? factors_[n] * samples_mps2_[n][i] : 0.0;
  }
  double w(std::size_t i) const {
    if (vertical_.rigid()) return ground(vertical, i);
    return i <= vertical_end_ ? factors_[vertical] * vertical_.acceleration_mps2(i) : 0.0;
  }
  /// Bound of the departure of w from the line between nodes i and i + 1.
  double w_deviation(std::size_t i) const {
    return vertical_.rigid() ? 0.0 : after(i).w_deviation();
  }

  /// The interval after node i.
  ExcitationPiece after(std::size_t i) const {
    ExcitationPiece s;
    s.length_s = dt_s();
    for (std::size_t n = 0; n < 2; ++n) s.ground[n] = {ground(n, i), ground(n, i + 1)};
    set_vertical(s, i);
    return s;
  }

 private:
  static constexpr std::size_t vertical = 2;

  void take(std::size_t component, const GroundTable& ground) {
    samples_mps2_[component] = ground.acceleration_mps2().first(ground.quiet_from());
    quiet_from_ = std::max(quiet_from_, ground.quiet_from());
    last_sample_ = std::max(last_sample_, ground.last_sample());
  }

  /// After the end of its table the vertical of an oscillator goes linearly to zero.
  void set_vertical(ExcitationPiece& s, std::size_t i) const {
    if (i >= (vertical_.rigid() ? samples_mps2_[vertical].size() : vertical_end_ + 1)) return;
    const double begin = w(i);
    if (vertical_.rigid() || i == vertical_end_) {
      s.vertical = {begin, w(i + 1) - begin};
      s.vertical_terms = 2;
      return;
    }
    const double f = factors_[vertical];
    const Quartic q = vertical_.acceleration_after(i);
    const double* b = q.b;
    s.vertical = {f * b[0], f * 4.0 * (b[1] - b[0]), f * 6.0 * ((b[2] - b[1]) - (b[1] - b[0])),
                  f * 4.0 * ((b[3] - b[0]) - 3.0 * (b[2] - b[1])),
                  f * ((b[4] - b[3]) - 3.0 * (b[3] - b[2]) + 3.0 * (b[2] - b[1]) - (b[1] - b[0]))};
    s.vertical_terms = 5;
  }

  double dt_s_;
  std::array<double, 3> factors_;                          // along both axes, vertical
  std::array<std::span<const double>, 3> samples_mps2_{};  // without trailing zeros
  MotionNodes vertical_;  // of an oscillator; rigid: it is among the samples
  std::size_t vertical_end_ = 0, quiet_from_ = 1, last_sample_ = 0;
};

}  // namespace glissade::block_detail
