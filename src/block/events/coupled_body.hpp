// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

#include "block/events/coupled_energy.hpp"
#include "block/events/coupled_motion.hpp"
#include "block/events/coupled_spring.hpp"
#include "block/slip_record/coupled_crossing.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail {

/// Block and building together, over pieces of time in which the ground is linear and no longer
/// than longest_phase.
class CoupledBody {
 public:
  using History = std::function<void(const CoupledPoint&)>;

  CoupledBody(const CoupledContact& contact, const BuildingOscillator& building, const Block& block,
              const Yielding& yielding = {});
  void keep(History history) { history_ = std::move(history); }
  CoupledCrossings& crossings() { return crossings_; }

  void advance(GroundPiece ground, double end_time_s);
  /// The roof is at rest from now on.
  void coast();

  bool slides_at_rest() const { return contact_.at_rest().slides_at_rest(); }
  bool sliding() const { return direction_ != 0; }
  /// While the block stays where it is and the ground is quiet.
  bool may_yield() const;
  /// |a| never exceeds this again then, and if the spring does not yield.
  double largest_acceleration_to_come_mps2() const;
  CoupledResult result() const;

 private:
  /// Regimes: at rest, sliding down or up (direction_); each in contact or lifted (lifted_); with
  /// an elastic or a yielding spring (Spring). An event changes one of the three:
  ///
  ///   event           condition, in a piece                      regime after it
  ///   starts down/up  at rest, a drive rises through zero        sliding
  ///   stops           sliding, the speed falls to zero           at rest
  ///   lifts or lands  the normal force changes sign              without contact, or in contact
  ///   yields up/down  elastic, the spring force is at its limit  yielding
  ///   unloads         yielding, the roof velocity changes sign   elastic
  enum class Event {
    none,
    starts_down,
    starts_up,
    stops,
    lifts_or_lands,
    yields_up,
    yields_down,
    unloads
  };
  struct NextEvent {
    Event event = Event::none;
    double fraction = 1.0;
    void sooner(Event candidate, double tau) {
      if (tau < fraction) *this = {candidate, tau};
    }
  };

  /// What is exactly zero where the last event was, whatever rounding says: the same event does not
  /// follow at once.
  struct AfterEvent {
    bool drive_is_zero = false;         ///< of a phase that has just begun on its threshold
    bool normal_force_is_zero = false;  ///< contact has just been lost or regained
    int stopped_direction = 0;          ///< the drive in this direction is not positive; 0: neither
    bool no_restart = false;            ///< nor does it rise: the phase stopped where it started
  };

  ContactRegime regime() const;
  SlipSeries slip_series(const ContactRegime& regime, const RoofMotionSeries& roof,
                         double length_s) const;
  NextEvent first_event(const RoofMotionSeries& roof, const SlipSeries& slip) const;
  double start_fraction(const RoofMotionSeries& roof, double a_change, int direction) const;
  double contact_fraction(const RoofMotionSeries& roof, double a_change) const;
  void pass(const GroundPiece& ground, const RoofMotionSeries& roof, const SlipSeries& slip,
            const NextEvent& next);
  void apply(const NextEvent& next);
  void start(int direction);
  void stop();
  Envelope free_vibration() const;
  void record(const GroundPiece& ground) const;

  CoupledContact contact_;
  BuildingOscillator building_;
  Block block_;
  bool has_static_friction_;  // above the friction of sliding
  History history_;
  EnergyMeter energy_;
  CoupledCrossings crossings_;

  RoofState roof_;
  Spring spring_;
  int direction_ = 0;  // +1 sliding down, -1 up, 0 at rest
  bool lifted_ = false;
  double speed_ = 0.0, slip_ = 0.0, time_ = 0.0, piece_end_ = 0.0;
  AfterEvent after_;
  bool contact_frozen_ = false;  // contact is not lost or regained any more in this piece

  double velocity_before_coast_ = 0.0;  // the energy balance ends there
  double farthest_down_ = 0.0, farthest_up_ = 0.0;
  double peak_resisting_mps2_ = 0.0, peak_x_mps2_ = 0.0;  // largest |E| and |x|
  CoupledResult result_;
};

}  // namespace glissade::block_detail
