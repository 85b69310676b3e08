// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ranges>
#include <span>

#include "block/contact/line.hpp"
#include "block/polynomial/linear_piece.hpp"
#include "block/slip_record/distance_crossings.hpp"
#include "block/slip_record/slide_state.hpp"

namespace glissade::block_detail {

/// Time, not after `end`, at which a piece of sliding from speed v0 reaches a distance: the root of
/// v0 t + travel(t), which does not decrease there. Newton's method, kept in its bracket, to
/// rounding.
template <class Piece>
double fraction_at_distance(const Piece& piece, double v0, double distance, double end) {
  const auto distance_at = [&](double tau) {
    return v0 * piece.length_s * tau + piece.travel(tau);
  };
  if (!(distance > 0.0)) return 0.0;
  if (!(distance_at(end) > distance)) return end;
  double low = 0.0, high = end, tau = 0.5 * end;
  for (int i = 0; i < 200; ++i) {
    const double miss = distance_at(tau) - distance;
    if (miss == 0.0) return tau;
    (miss > 0.0 ? high : low) = tau;
    const double step = miss / (piece.length_s * (v0 + piece.gain(tau)));
    if (std::abs(step) <= 0x1p-53 * tau) return tau;
    const double next = tau - step;
    tau = next > low && next < high ? next : 0.5 * (low + high);
    if (tau == low || tau == high) return tau;
  }
  return tau;
}

/// Observes the sliding of a block, piece by piece, and records time and speed of the first
/// crossing of each distance from the initial position. Slip is along the slope and has one
/// direction within a piece.
class CrossingWatch {
 public:
  /// @param factor of the motion that the slip is divided by (see Scaled)
  CrossingWatch(std::span<const double> thresholds_m, std::span<Crossing> crossings,
                double cos_slope, double factor = 1.0)
      : crossings_(thresholds_m, crossings), cos_slope_(cos_slope), factor_(factor) {}

  /// The next threshold is not beyond this slip. Rounded like peak displacements, so that a
  /// threshold is crossed exactly if the peak is at least as large, to the last bit.
  bool passes(double slip) const { return crossings_.may_reach(in_plan(slip)); }

  /// A piece of sliding from `from`, up to its fraction `end`, where the block is at `to`.
  template <class Piece>
  void slides(const SlideState& from, const Piece& piece, double end, const SlideState& to) {
    while (passes(to.slip)) {
      const double target = crossings_.next_m() / (factor_ * cos_slope_);
      const double distance = target - from.direction * from.slip;
      const double tau = fraction_at_distance(piece, from.speed, distance, end);
      const bool at_end = tau >= end || in_plan(to.slip) == crossings_.next_m();
      note(at_end ? to.time : from.time + tau * piece.length_s,
           at_end ? to.speed : from.speed + piece.gain(tau));
    }
  }

  /// Several intervals of sliding without a stop: from node `first` to the fraction `end` of the
  /// interval after node `last`, where the block is at `to`. Only those with a threshold are
  /// searched.
  /// @param state (node) -> SlideState; @param piece (node) -> the drive in the interval after it
  template <class State, class PieceAt>
  void slides(std::size_t first, std::size_t last, const State& state, const PieceAt& piece,
              double end, const SlideState& to) {
    while (passes(to.slip)) {
      const auto nodes = std::views::iota(first, last);
      const std::size_t node = *std::ranges::partition_point(
          nodes, [&](std::size_t i) { return !passes(state(i + 1).slip); });
      if (node < last) {
        slides(state(node), piece(node), 1.0, state(node + 1));
      } else {
        slides(state(node), piece(node), end, to);
      }
      first = node;
    }
  }

 private:
  double in_plan(double slip) const { return factor_ * (std::abs(slip) * cos_slope_); }
  void note(double time, double speed) { crossings_.add({time, in_plan(std::max(speed, 0.0))}); }

  DistanceCrossings crossings_;
  double cos_slope_, factor_;
};

/// Passes the pieces that a SlidingBlock computes itself to a watch, if there is one.
struct WatchHistory {
  CrossingWatch* watch = nullptr;

  void operator()(double, double, double) const {}
  void slides(const SlideState& from, const Line& drive, double length,
              const SlideState& to) const {
    if (watch != nullptr)
      watch->slides(from, LinearPiece(drive.value, drive.at(length), length), 1.0, to);
  }
};

}  // namespace glissade::block_detail
