// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "block/coupled_tables/coupled_lanes.hpp"
#include "block/coupled_tables/coupled_table.hpp"
#include "block/events/coupled_body.hpp"
#include "glissade/block/coupled_slip.hpp"

namespace glissade::block_detail {

/// A history in a lane: what is not done side by side. It is taken through its tables from one
/// interval in which an event is possible to the next, by bounds that miss none. What the lane does
/// not decide is left to the scalar scheme (CoupledBody) for that interval.
class CoupledHistory {
 public:
  /// @param table of the elastic building
  /// @param yielding_table of the same building, yielding; or none
  /// @param intensity > 0, times the table's unit; @param w_factor of the vertical
  CoupledHistory(const CoupledTable& table, const CoupledTable* yielding_table,
                 const CoupledContact& contact, const Subdivision& subdivision,
                 const CoupledScene& scene, double intensity, std::span<const double> thresholds_m,
                 std::span<Crossing> crossings);

  enum class Next { interval, finished, lifts };  ///< lifts: the history is not for this
  /// At rest at time zero, in a lane.
  Next begin(CoupledLanes& lanes, std::size_t lane);
  /// After a step.
  Next go_on(CoupledLanes& lanes, std::size_t lane, const LanesDone& done);
  SlipResult result() const;

 private:
  /// What a lane holds at its reference node, from which the tables are searched.
  struct Reference {
    std::size_t node = 0;
    int direction = 0, side = 0;
    RoofState roof;
    double speed = 0.0;
    Amplitude free;     ///< the free vibration there
    double size = 0.0;  ///< of it
    bool ringing_down = false;
    bool may_lift = false, spring_may_change = false;
    Spring::Range elastic;
  };
  const CoupledTable& table(const Reference& at) const {
    return at.side != 0 ? *yielding_table_ : elastic_table_;
  }
  const RegimeOscillator& regime(const Reference& at) const {
    return table(at).regime(at.direction);
  }
  const CoupledNodes& nodes() const { return elastic_table_.nodes(); }
  Reference reference(const CoupledLanes& lanes, std::size_t lane) const;
  bool finished(const Reference& at) const;

  Next search(CoupledLanes& lanes, std::size_t lane);
  std::size_t next_interval(const Reference& at, std::size_t from, std::size_t to) const;
  std::size_t next_start_in(const Reference& at, std::size_t from, std::size_t first,
                            std::size_t last) const;
  std::size_t next_stop_in(const Reference& at, std::size_t from, std::size_t first,
                           std::size_t last) const;
  std::size_t next_limit_in(const Reference& at, std::size_t from, std::size_t first,
                            std::size_t last, std::size_t found) const;

  double time_s(std::size_t node, double tau = 0.0) const {
    return (static_cast<double>(node) + tau) * step_s_;
  }
  LinearGround ground_after(std::size_t node) const;
  void put(CoupledLanes& lanes, std::size_t lane, const CoupledBody::State& state);
  CoupledBody body(const CoupledLanes& lanes, std::size_t lane, double now_s) const;
  void advance(CoupledBody& body, std::size_t interval, double from) const;
  Next finish(const CoupledLanes& lanes, std::size_t lane);
  Next by_reference_scheme(CoupledLanes& lanes, std::size_t lane);
  void watch(const CoupledBody& now, std::size_t interval, double tau);
  void cross(double slip_m, std::size_t end_interval);

  const CoupledTable& elastic_table_;
  const CoupledTable* yielding_table_;  // none: the scalar scheme while the spring yields
  const CoupledContact& contact_;
  Subdivision subdivision_;
  Block block_;
  double intensity_, w_factor_, step_s_;
  double cot_slope_;
  // Elastic or yielding, by CoupledTable::index: a free vibration may have less.
  std::array<std::array<double, 3>, 2> contact_margin_mps2_{};
  CoupledBody body_;                          // at rest; its crossings are those of the history
  std::optional<CoupledBody> body_at_phase_;  // where thresholds are watched
  double phase_tau_ = 0.0;                    // where in its interval the phase began
  std::size_t phase_node_ = 0;
  bool watched_, finishes_ = false;
  std::size_t quiet_from_, end_;
};

}  // namespace glissade::block_detail
