// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "block/full_model/stop.hpp"
#include "block/slip_record/distance_crossings.hpp"
#include "block/two_axes/roof/roof_piece.hpp"
#include "block/two_axes/roof/spring_step.hpp"
#include "block/two_axes/roof/tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"

namespace glissade::block_detail::two_axes {

class RoofAtRest;

/// The root of a function, almost a line, that rises from at most zero at `low` to above zero at
/// `high`: the secant rule, kept within the bracket.
template <class Function>
double rise_by_secant(const Function& f, double f_low, double f_high, double low = 0.0,
                      double high = 1.0) {
  constexpr double converged = 1e-9, rounding = 1e-13;  // of an interval of length one
  double x0 = low, f0 = f_low, x1 = high, f1 = f_high;
  for (int i = 0; i < 60; ++i) {
    double x = x1 - f1 * (x1 - x0) / (f1 - f0);
    if (!(x >= low && x <= high)) x = 0.5 * (low + high);
    const double value = f(x);
    (value > 0.0 ? high : low) = x;
    const double moved = std::abs(x - x1);
    x0 = x1;
    f0 = f1;
    x1 = x;
    f1 = value;
    if (moved < converged || value == 0.0 || high - low < rounding) break;
  }
  return x1;
}

inline Vector velocity(const HistoryState& state) { return {state.motion.v_s, state.motion.v_y}; }

/// One history: all of it but its sliding, which the lanes do.
class LaneHistory {
 public:
  /// @param base_shear wanted
  LaneHistory(const SceneConstants& constants, RoofKind roof, const GroundNodes& ground,
              std::shared_ptr<const RestTable> table, const DistanceCrossings& crossings,
              bool base_shear);

  enum class Next {
    slides,  ///< in a lane, from the state on: by an implicit step first
    finished,
    unsupported,  ///< something the lanes do not cover: it is for the scalar scheme
    rests,        ///< on a spring that has yielded or unloaded (inside LaneHistory)
  };
  /// From rest at the first node.
  Next begin(HistoryState& state);
  /// Of a lane at rest, or near its next stop.
  Next event(HistoryState& state);
  BuildingPeak result(const HistoryState& state) const;
  const SceneConstants& constants() const { return constants_; }
  /// DistanceCrossings::next2
  double next2() const { return crossings_.next2(); }
  /// LaneStates::rows
  std::int64_t rows() const;
  /// LaneStates::limit
  std::int64_t limit() const {
    return static_cast<std::int64_t>(roof_ == RoofKind::modes ? table_->end : ground_.end);
  }
  /// A lane's step reached it.
  void crossed(const LaneStates& lanes, std::size_t lane);
  /// LaneStates::Shear::largest
  const std::array<double, 2>& largest_a() const { return largest_a_; }
  /// A lane's step might exceed it.
  void raise_shear(const LaneStates& lanes, std::size_t lane);
  /// A lane's normal force was below zero.
  void lifted() { uplift_ = true; }
  bool uplift() const { return uplift_; }

 private:
  // Rest (rest.cpp).
  Next rest(HistoryState& state);
  Next rest_from_node(HistoryState& state);
  double release(const RoofPiece& piece);
  Next next_after(std::size_t node, const RoofAtRest& roof, HistoryState& state);
  /// From a node on while a spring yields, over whole intervals in which nothing happens.
  void rest_on_springs(HistoryState& state);
  void change_spring(HistoryState& state, const RoofPiece::SpringEvent& event) const;
  /// A block at rest at a node, on this roof.
  void put_at(HistoryState& state, std::size_t node, const RoofState& roof) const;
  HistoryState resting_at(std::size_t node, const RoofState& roof) const {
    HistoryState state;
    put_at(state, node, roof);
    return state;
  }
  Next start(HistoryState& state);
  Next go_on_from_rest(HistoryState& state);

  // Base shear (shear.cpp).
  bool follows_shear() const { return largest_a_[0] != never; }
  /// At rest, from a node to another.
  void raise_shear(const RoofAtRest& roof, std::size_t from, std::size_t to);
  /// At rest, from a node on.
  void raise_shear_to_end(RoofAtRest& roof, std::size_t from);
  /// Over a stop.
  void raise_shear(const HistoryState& state, const RoofPiece& piece, const Stop& stop);

  // Stops (stop.cpp).
  RoofPiece stopping_piece(const HistoryState& state, const Stop& stop) const;
  bool meets_spring_event(const HistoryState& state, const Stop& stop) const;
  bool stop(HistoryState& state, const RoofPiece& piece);
  bool reverse(HistoryState& state, const RoofPiece& piece);
  double deceleration(const Load& load, Vector v) const;
  void take_stop(HistoryState& state, const RoofPiece& piece, const Stop& stop);
  double time_s(const HistoryState& state) const {
    return (static_cast<double>(state.node + 1) - state.motion.left) * ground_.dt_s;
  }
  double frictionless_normal(const Load& load) const;
  RoofPiece::BlockVelocity plan_velocity(Vector v) const;
  RoofPiece piece(const HistoryState& state,
                  const RoofPiece::BlockVelocity& block_velocity = {}) const {
    return RoofPiece(state, ground_, *table_, constants_, roof_, block_velocity);
  }
  template <class At>
  void displace(HistoryState& state, Vector displacement, const At& at, double begin_s,
                double length_s);

  SceneConstants constants_;
  FrictionEllipse ellipse_;
  RoofKind roof_;
  const GroundNodes& ground_;
  std::shared_ptr<const RestTable> table_;
  double start_s_ = 0.0, duration_s_ = 0.0;  ///< of the last phase; of all
  std::size_t phases_ = 0;
  bool uplift_ = false;
  DistanceCrossings crossings_;
  std::array<double, 2> largest_a_;
  std::array<std::array<SpringStep, 2>, 2> spring_steps_;  ///< by axis; elastic, yielding
};

/// The block has moved by `displacement`, as `at` says (DistanceCrossings::pass).
template <class At>
void LaneHistory::displace(HistoryState& state, Vector displacement, const At& at, double begin_s,
                           double length_s) {
  LaneMotion<double>& m = state.motion;
  m.at_s += displacement.s;
  m.at_y += displacement.y;
  m.farthest2 = std::max(m.farthest2, m.at_s * m.at_s + m.at_y * m.at_y);
  m.ahead_s = std::max(m.ahead_s, m.at_s);
  m.back_s = std::max(m.back_s, -m.at_s);
  m.ahead_y = std::max(m.ahead_y, m.at_y);
  m.back_y = std::max(m.back_y, -m.at_y);
  if (m.farthest2 >= next2()) crossings_.pass(at, begin_s, length_s, std::sqrt(m.farthest2));
}

}  // namespace glissade::block_detail::two_axes
