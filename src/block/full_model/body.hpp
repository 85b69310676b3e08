// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "block/full_model/coupled_step.hpp"
#include "block/full_model/excitation.hpp"
#include "block/full_model/two_axis_track.hpp"

namespace glissade::block_detail {

/// Block and building together on two axes, over pieces of time in which the ground is linear and
/// the vertical a quartic.
class FullModelBody {
 public:
  /// @param pieces number of pieces of a sample interval, for the building; each of piece_s
  FullModelBody(const BuildingContact& contact, const std::array<BuildingAxis, 2>& axes,
                double mass_ratio, int pieces, double piece_s, double tolerance,
                TwoAxisTrack track);

  /// The whole history, from rest: the record, and the ring-down of the building.
  void follow(const Excitation& excitation, double longest_period_s);

  SlipResult result() const;
  /// Largest |base shear| over the building's mass, and |x| of the roof (AxisSeries::roof_x).
  struct Peaks {
    Axes shear{}, x{};
  };
  const Peaks& peaks() const { return peaks_; }

 private:
  /// The building alone over a piece, from its present state.
  struct UncoupledRoof {
    AxisSeries axis[2];
    const ExcitationPiece& excitation;
    Axes e(double fraction) const {
      return {axis[0].resisting.at(fraction), axis[1].resisting.at(fraction)};
    }
    StageLoads at_stages(double fraction) const;
    double largest_w;  ///< |w|
  };

  /// The building over a piece with the block at rest on it.
  struct RestingRoof {
    AxisSeries axis[2];
    Axes mass;
    const ExcitationPiece& excitation;
    double a(std::size_t n, double fraction) const {
      return axis[n].resisting.at(fraction) / mass[n];
    }
  };
  RestingRoof resting_motion(const ExcitationPiece& piece) const;
  Load load_at(const RestingRoof& resting, double fraction) const;

  bool at_rest() const { return !sliding_; }
  /// Whether a roof at rest stops the block; if not, it slides freely.
  bool will_stop() const;
  /// The block cannot start again while the ground is at rest, and the springs cannot yield.
  bool is_settled() const;
  /// Until nothing can move the block again and the building's own peaks are past.
  void ring_down(double dt_s, double longest_period_s);
  /// The roof is at rest from now on, and every motion stops.
  void coast(double step_s);

  /// Steps from node to node while the block rests without an event; returns the last node. Only if
  /// an interval is one piece.
  std::size_t rest_through(const Excitation& excitation, std::size_t from, std::size_t to);
  /// One sample interval that ends at time `end_s`.
  void interval(const ExcitationPiece& excitation, double end_s);
  template <class Nodes>
  std::size_t rest_over(const Nodes& nodes, std::size_t from, std::size_t to);
  template <class Nodes>
  std::size_t rest_over_on_modes(const Nodes& nodes, std::size_t from, std::size_t to);
  /// N - |M^-1 F| of a block at rest: negative where it slides.
  double friction_margin(double a1, double a2, double w) const;
  bool rest_quickly(const ExcitationPiece& piece);
  void advance(ExcitationPiece piece, double end_s);
  // Each returns the elapsed fraction of the piece.
  double rest(const ExcitationPiece& piece);
  double slide(const ExcitationPiece& piece);

  void start(Vector acceleration, const ExcitationPiece& piece);
  UncoupledRoof uncoupled_motion(const ExcitationPiece& piece) const;
  double first_lift(const UncoupledRoof& uncoupled) const;
  double normal_force_bound(const UncoupledRoof& uncoupled) const;
  double step(const UncoupledRoof& uncoupled, double longest);
  BuildingStep try_step(const UncoupledRoof& uncoupled, double length_s) const;
  Axes next_yields(const UncoupledRoof& uncoupled, const BuildingStep& step, double length_s) const;
  void yield(const Axes& when);
  void take(const UncoupledRoof& uncoupled, const BuildingStep& step, double length_s);
  AxisSeries with_block(const UncoupledRoof& uncoupled, const BuildingStep& step, std::size_t n,
                        double length_s) const;
  void raise_peaks(std::size_t n, const UncoupledRoof& uncoupled, const BuildingStep& step,
                   double length_s);
  /// The block brought to rest along a straight line.
  struct StraightStop {
    double time_s = never;
    Vector along;                           ///< its direction, of unit length
    double begin_rate = 0.0, end_rate = 0;  ///< of its speed, now and at the stop
    Axes interaction{};                     ///< now
    Axes e_end{};                           ///< E at the stop
    double residual_speed = 0.0;            ///< that it may still have at the stop
  };
  bool may_stop(const UncoupledRoof& uncoupled, double left_s) const;
  StraightStop find_straight_stop(const UncoupledRoof& uncoupled, double left_s) const;
  Stop find_stop(const UncoupledRoof& uncoupled, double left_s, std::array<Ramp, 2>& interaction);
  Stop find_curved_stop(const UncoupledRoof& uncoupled, double left_s, double allowed,
                        std::array<Ramp, 2>& interaction) const;
  Axes interaction_of(Vector acceleration, const Axes& e, double w) const;
  Axes e_after(const UncoupledRoof& uncoupled, double after_s, const Axes& interaction) const;
  Load load_at_rest(const UncoupledRoof& uncoupled, double after_s, const Axes& interaction) const;
  bool passes_no_peak(Vector drive) const;
  bool stop_there(const Stop& stop, const UncoupledRoof& uncoupled,
                  const std::array<Ramp, 2>& interaction);
  void raise_peaks(std::size_t axis, const AxisSeries& motion, double fraction);
  Axes force_on_roof(const ContactState& contact) const;

  BuildingContact contact_;
  std::array<BuildingAxis, 2> axes_;
  std::vector<RestMap> rest_maps_;  // by axis, where one is of several modes
  double mass_ratio_;
  Accelerance accelerance_;  // at an instant
  int pieces_;
  double tolerance_, friction_bound_;
  Vector per_friction_;                 // inverse of the coefficients at rest
  double margin_per_a_, margin_per_w_;  // largest decrease of N - |M^-1 F| per acceleration

  bool sliding_ = false;
  Sliding now_;
  Vector friction_now_;  // initial value of the iteration
  double time_s_ = 0.0;
  double step_s_ = never;             // the longest to be tried
  std::int64_t steps_left_ = 100000;  // of the history: a second

  TwoAxisTrack track_;
  Peaks peaks_;
  double peak_speed_ = 0.0;  // per cos(slope), at the ends of steps
  std::size_t phases_ = 0;
  bool uplift_ = false, slides_at_rest_ = false;
};

}  // namespace glissade::block_detail
