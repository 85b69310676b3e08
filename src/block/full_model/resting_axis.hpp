// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/full_model/building_axis.hpp"
#include "block/full_model/chord_deviation.hpp"

namespace glissade::block_detail {

/// One axis of the building over whole pieces at rest. A rigid one has no state, and
/// E = mass a_ground.
class RestingAxis {
 public:
  struct Node {
    OscillatorState state;  ///< x is the spring's force
    double ground, e;
  };

  RestingAxis(BuildingAxis& axis, double mass)
      : axis_(axis),
        step_(axis.rest_step()),
        twice_zeta_(axis.twice_zeta()),
        phase_(axis.phase()),
        per_mass_(1.0 / mass),
        carried_(axis.rigid() ? mass : 0.0),
        held_(axis.spring()),
        yield_left_(axis.yield_left()) {
    const double left = 1.0 - (phase_ + twice_zeta_) * phase_ * per_mass_;
    per_left_ = left > 0.0 ? 1.0 / left : never;
  }

  Node now(double ground) const {
    return {{axis_.spring(), axis_.y()}, ground, axis_.resisting(ground)};
  }
  Node after(const Node& now, double ground) const {
    const OscillatorState state = step_.after(now.state, now.ground, ground);
    return {state, ground, carried_ * ground - (twice_zeta_ * state.y + state.x)};
  }
  /// Between two nodes.
  ChordDeviation deviation(const Node& now, const Node& next) const {
    return {phase_,
            twice_zeta_,
            per_mass_,
            per_left_,
            std::abs(now.e * per_mass_ - now.ground),
            std::abs(now.state.y),
            std::abs(next.ground - now.ground)};
  }
  bool may_yield(const Node& now, const Node& next, const ChordDeviation& deviation) const {
    return axis_.yields() &&
           std::max(std::abs(now.state.x - held_), std::abs(next.state.x - held_)) + deviation.s >=
               yield_left_;
  }
  bool may_exceed(double shear, double x, const Node& now, const Node& next,
                  const ChordDeviation& deviation) const {
    const double drift = std::abs(axis_.x() - held_);
    return std::max(std::abs(now.e), std::abs(next.e)) + deviation.e > shear ||
           std::max(std::abs(now.state.x), std::abs(next.state.x)) + deviation.s + drift > x;
  }
  /// Takes the building's axis to a node.
  void hold(const Node& node) {
    axis_.rest_to(node.state.x, node.state.y);
    held_ = node.state.x;
    yield_left_ = axis_.yield_left();
  }

 private:
  BuildingAxis& axis_;
  OscillatorStep step_;
  double twice_zeta_, phase_, per_mass_, carried_, per_left_;
  double held_, yield_left_;  // of the spring, where the axis is
};

}  // namespace glissade::block_detail
