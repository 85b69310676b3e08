// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "block/coupled_tables/coupled_table.hpp"
#include "block/events/coupled_body.hpp"
#include "block/polynomial/coupled_curve.hpp"
#include "glissade/block/coupled_slip.hpp"

namespace glissade::block_detail {

/// Through a history by its tables: from one interval in which an event is possible to the next.
/// There, starts and stops that bounds on derivatives prove to be the only ones are solved in
/// closed form between them; all else is left to the scalar scheme (CoupledBody) for that interval.
class CoupledHistory {
 public:
  /// @param table of the elastic building
  /// @param yielding_table of the same building, yielding; or none
  /// @param intensity > 0, times the table's unit; @param w_factor of the vertical
  CoupledHistory(const CoupledTable& table, const CoupledTable* yielding_table,
                 const CoupledContact& contact, const Subdivision& subdivision,
                 const CoupledScene& scene, double intensity, std::span<const double> thresholds_m,
                 std::span<Crossing> crossings);

  /// False where the block lifts: then the history is not for this.
  bool run();
  SlipResult result() const;

 private:
  /// An interval to be solved, and the state at its begin.
  struct IntervalState {
    std::size_t interval;
    LinearGround ground;
    RoofState roof;
    Amplitude z;
    double speed;
  };
  /// How a phase that begins at a fraction of an interval goes on to the interval's end.
  struct Begin {
    int direction;
    RoofState roof;
    double distance, speed, duration;
  };
  const RegimeOscillator& regime() const { return table_->regime(body_.direction()); }
  const CoupledNodes& nodes() const { return elastic_table_.nodes(); }
  double time_s(std::size_t node, double tau = 0.0) const {
    return (static_cast<double>(node) + tau) * step_s_;
  }
  Roof ground(std::size_t node) const;
  LinearGround ground_after(std::size_t node) const;
  RoofState roof(std::size_t node) const;
  double travel(std::size_t node, const RoofState& roof) const;
  double speed(std::size_t node, const RoofState& roof) const;

  void set_reference(std::size_t node, const RoofState& roof, double speed_mps);
  void set_reference_here();
  void begin_ring_down();
  bool finished() const;
  std::size_t next_interval(std::size_t to);
  std::size_t next_start_in(std::size_t first, std::size_t last) const;
  std::size_t next_stop_in(std::size_t first, std::size_t last) const;
  std::size_t next_limit_in(std::size_t first, std::size_t last) const;

  bool solve_interval(std::size_t interval);
  bool rest_in(const IntervalState& now);
  bool slide_in(const IntervalState& now);
  bool within_limits(const RegimeOscillator& regime, double length, Amplitude z,
                     const LinearGround& ground, const RoofState& begin,
                     const RoofState& end) const;
  bool within_limits(const RegimeOscillator& regime, double bend_mps2, const RoofState& roof,
                     const Roof& at) const;
  std::optional<Begin> begin(const IntervalState& now, double tau, const RoofState& roof,
                             int direction, bool drive_jumps) const;
  void start(const IntervalState& now, const Begin& begin);
  bool rests(const IntervalState& now, double tau, Amplitude z, Amplitude to_end) const;
  void slid(double distance_m, double duration_s, std::size_t end_interval);
  void by_reference_scheme(const IntervalState& now);
  void advance(CoupledBody& body, std::size_t interval, const LinearGround& ground) const;

  const CoupledTable& elastic_table_;
  const CoupledTable* yielding_table_;  // none: the scalar scheme while the spring yields
  const CoupledTable* table_;           // of the two, by the state of the spring
  const CoupledContact& contact_;
  Subdivision subdivision_;
  Block block_;
  double intensity_, w_factor_, step_s_;
  double cot_slope_;
  bool has_limits_;  // a slope on which it may lift, or a spring that may yield
  // Elastic or yielding, by CoupledTable::index: a free vibration may have less.
  std::array<std::array<double, 3>, 2> contact_margin_mps2_{};
  CoupledBody body_;
  std::optional<CoupledBody> body_before_;    // at the begin of the interval solved
  std::optional<CoupledBody> body_at_phase_;  // and of the one in which the phase began
  std::size_t phase_node_ = 0;
  bool watched_, ringing_down_ = false, phase_began_ = false;
  bool limit_ahead_ = false;  // in the next interval it may lift, yield or unload
  std::size_t node_ = 0, quiet_from_, end_;

  // The reference node of the regime, or phase.
  std::size_t from_ = 0;
  Amplitude free_;
  RoofState roof_from_;
  double speed_from_ = 0.0;
  bool may_lift_ = false, spring_may_change_ = false;
  int yield_side_ = 0;
  bool by_scalar_scheme_ = false;  // until the spring unloads: there is no table
  Spring::Range elastic_;
};

}  // namespace glissade::block_detail
