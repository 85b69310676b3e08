// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "coupled_bank.hpp"
#include "coupled_body.hpp"
#include "glissade/block/coupled_slip.hpp"
#include "glissade/building/ground_table.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail {

/// What all lanes of a batch walk through.
struct LaneGround {
  GroundTable a, w;  ///< w: of zeros where there is no vertical
  bool vertical = false;
  struct Largest {
    double value = 0.0, change = 0.0;  ///< at a node, between neighbours
  } largest_a, largest_w;

  std::size_t longest_ring_down_nodes;

  LaneGround(const GroundMotion& motion, int pieces);
  void extend(std::size_t nodes);
  BankGround nodes() const;
  /// The first node from which on both are zero, and the last that anything is followed to.
  std::size_t quiet_from() const { return std::max(a.quiet_from(), w.quiet_from()); }
  std::size_t longest_end() const { return quiet_from() + longest_ring_down_nodes; }
};

/// True where a history can go through the lanes, as long as its spring does not yield.
bool fits_lane(const CoupledScene& scene, const GroundMotion& ground);

/// One history in its lane of a bank, its spring elastic: the modes' constants, and the scalar
/// scheme for the intervals in which the lane is flagged.
class CoupledLane {
 public:
  CoupledLane(const CoupledScene& scene, const Cut& cut, const LaneGround& ground,
              std::span<const double> thresholds_m, std::span<Crossing> crossings);

  /// Puts the history into its lane, at rest at node 0.
  void load(CoupledBank& bank, std::size_t lane);
  /// Goes again, scalar, through the interval that ended at `node`.
  void resolve(CoupledBank& bank, std::size_t lane, std::size_t node);
  /// |P| or |x| may have its largest value so far in the interval that ended at `node`.
  void note_turn(CoupledBank& bank, std::size_t lane, std::size_t node);
  /// At a node after the ground is quiet: true when nothing more can happen.
  bool is_over(const CoupledBank& bank, std::size_t lane, std::size_t node);
  bool ends_with_record() const { return contact_.slides_at_rest(); }
  CoupledPeak result(const CoupledBank& bank, std::size_t lane, std::size_t node);

 private:
  /// Of what keeps an interval without events (CoupledBank).
  struct Limits {
    double lowest, highest, lowest_w, highest_w;
    double least_speed, sag;
    double bound;                   ///< of |P|
    double elastic_cubic, x_cubic;  ///< error of the cubic between nodes, of P and of x
  };
  /// Stuck, sliding down or up.
  struct LaneMode {
    Mode mode;
    OscillatorStep step;
    Limits limits;
  };
  /// An interval in which |P| or |x| turns, not yet looked into, as long as it may hold the peak.
  struct Turn {
    double most = 0.0;  ///< no more than this
    const Mode* mode = nullptr;
    RoofState roof;
    std::size_t node = 0;  ///< at its end
  };
  const LaneMode& mode() const {
    return modes_[body_.direction() == 0 ? 0 : body_.direction() > 0 ? 1 : 2];
  }
  Limits limits(const Mode& mode, int direction) const;
  void set_limits();
  void look_into(const Turn& turn);
  GroundPiece ground_before(std::size_t node) const;
  double forcing(const Mode& mode, std::size_t node) const;
  Roof roof_ground(std::size_t node) const;
  /// Brings the body from base_ to a node, no event between.
  void catch_up(const CoupledBank::State& state, std::size_t lane, std::size_t node);
  /// A distance that is watched for lies between the slip and `to`, which it has at a node.
  void cross(double to, std::size_t node);
  void store_state(CoupledBank& bank, std::size_t lane, std::size_t node);
  void store_mode(CoupledBank& bank, std::size_t lane) const;
  void store_limits(CoupledBank& bank, std::size_t lane, std::size_t node);
  bool gathers_speed(const CoupledBank::State& state, std::size_t lane, std::size_t node) const;

  const LaneGround& ground_;
  Block block_;  // on a slope >= 0
  double mass_ratio_, a_factor_, w_factor_, step_s_, period_s_;
  Frame frame_;
  CoupledContact contact_;
  CoupledBody body_;
  std::array<LaneMode, 3> modes_;
  std::size_t base_ = 0, at_rest_since_ = 0;
  RoofState base_roof_;
  double base_speed_ = 0.0;
  double elastic_bound_ = 0.0, y_bound_ = 0.0;
  const LaneMode* stored_ = nullptr;  // whose constants are in the bank
  Turn elastic_turn_, x_turn_;
};

CoupledPeak peak_of(const CoupledResult& result);

}  // namespace glissade::block_detail
