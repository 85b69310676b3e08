// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "block/coupled_tables/coupled_lanes.hpp"
#include "block/coupled_tables/coupled_search.hpp"
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
  /// A history's searches in a regime of contact and spring, as far as they do not depend on where
  /// it is.
  struct Searches {
    const RegimeOscillator* regime = nullptr;
    const CoupledTable::Response* response = nullptr;
    RestSearch rest;
    SpeedSearch speed;
    LimitSearch limit;
    double table_a_mps2 = 0.0, table_speed_mps = 0.0, table_x_mps2 = 0.0;  ///< no more, in size
    /// The speed of a free vibration, and how far it leaves its chord, per size of it.
    double speed_per_free = 0.0, deviation_per_free = 0.0;
    double contact_margin_mps2 = 0.0;  ///< it lifts only if a free vibration has more
  };
  const CoupledNodes& nodes() const { return elastic_table_.nodes(); }
  void set_searches(std::size_t index, const CoupledTable& table);
  void begin_ring_down();
  Next search(CoupledLanes& lanes, std::size_t lane);
  struct FreeVibration {
    Amplitude amplitude;
    double size;
    bool reaches_limits;
  };
  std::size_t next_interval(const CoupledLanes& lanes, std::size_t lane, const FreeVibration& at,
                            std::size_t from, std::size_t to);
  bool may_reach_limits(const CoupledLanes& lanes, std::size_t lane, const Searches& searches,
                        double size) const;
  std::size_t next_start(Searches& searches, const FreeVibration& at, std::size_t first,
                         std::size_t last) const;
  std::size_t next_stop(Searches& searches, const CoupledLanes& lanes, std::size_t lane,
                        const FreeVibration& at, std::size_t from, std::size_t first,
                        std::size_t last) const;

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
  std::array<Searches, 6> searches_;          // by index in LaneTables::regimes
  CoupledBody body_;                          // at rest; its crossings are those of the history
  std::optional<CoupledBody> body_at_phase_;  // where thresholds are watched
  double phase_tau_ = 0.0;                    // where in its interval the phase began
  std::size_t phase_node_ = 0;
  bool watched_, ringing_down_ = false, finishes_ = false;
  std::size_t quiet_from_, end_;
};

}  // namespace glissade::block_detail
