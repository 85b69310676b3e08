// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  /// @param intensity > 0, times the table's unit; @param w_factor of the vertical
  CoupledHistory(const CoupledTable& table, const CoupledContact& contact,
                 const Subdivision& subdivision, const CoupledScene& scene, double intensity,
                 std::span<const double> thresholds_m, std::span<Crossing> crossings);

  /// False where the block might lift, or the spring yield: then the history is not for this.
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
  const RegimeOscillator& regime() const { return table_.regime(body_.direction()); }
  const CoupledNodes& nodes() const { return table_.nodes(); }
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
  std::size_t next_interval(std::size_t to) const;
  std::size_t next_start_in(std::size_t first, std::size_t last) const;
  std::size_t next_stop_in(std::size_t first, std::size_t last) const;

  bool solve_interval(std::size_t interval);
  bool rest_in(const IntervalState& now);
  bool slide_in(const IntervalState& now);
  std::optional<Begin> begin(const IntervalState& now, double tau, const RoofState& roof,
                             int direction, bool reverses) const;
  void start(const IntervalState& now, const Begin& begin);
  bool rests(const IntervalState& now, double tau, Amplitude z) const;
  void slid(double distance_m, double duration_s, std::size_t end_interval);
  void by_reference_scheme(const IntervalState& now);
  void advance(CoupledBody& body, std::size_t interval, const LinearGround& ground) const;

  const CoupledTable& table_;
  const CoupledContact& contact_;
  Subdivision subdivision_;
  Block block_;
  double intensity_, w_factor_, step_s_;
  double most_a_mps2_, most_x_mps2_;  // it neither lifts nor yields below these
  CoupledBody body_;
  std::optional<CoupledBody> body_before_;    // at the begin of the interval solved
  std::optional<CoupledBody> body_at_phase_;  // and of the one in which the phase began
  std::size_t phase_node_ = 0;
  bool watched_, fits_ = true, ringing_down_ = false, phase_began_ = false;
  std::size_t node_ = 0, quiet_from_, end_;

  // The reference node of the regime, or phase.
  std::size_t from_ = 0;
  Amplitude free_;
  RoofState roof_from_;
  double speed_from_ = 0.0;
};

}  // namespace glissade::block_detail
