// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "block/full_model/on_building_shaking.hpp"
#include "block/full_model/on_building_step.hpp"
#include "block/slip_record/two_axis_track.hpp"

namespace glissade::block_detail {

/// Block and building together on two axes, over pieces of time in which the ground is linear and
/// the vertical a quartic.
class OnBuildingBody {
 public:
  /// @param pieces number of pieces of a sample interval, for the building
  OnBuildingBody(const BuildingContact& contact, const std::array<BuildingAxis, 2>& axes,
                 double mass_ratio, int pieces, double tolerance, TwoAxisTrack track);

  /// The whole history, from rest: the record, and the ring-down of the building.
  void follow(const Shaken& shaken, double longest_period_s);

  TwoAxisResult result() const;
  /// Largest |E| and |x|.
  struct Peaks {
    Axes elastic{}, x{};
  };
  const Peaks& peaks() const { return peaks_; }

 private:
  /// The building alone over a piece, from its present state.
  struct Bare {
    AxisSeries axis[2];
    const Shaking& shaking;
    Axes e(double share) const { return {axis[0].elastic.at(share), axis[1].elastic.at(share)}; }
    StageLoads at_stages(double share) const;
    double largest_w;  ///< |w|
  };

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
  std::size_t rest_through(const Shaken& shaken, std::size_t from, std::size_t to);
  /// One sample interval that ends at time `end_s`.
  void interval(const Shaking& shaking, double end_s);
  template <class Nodes>
  std::size_t rest_over(const Nodes& nodes, std::size_t from, std::size_t to);
  bool rest_quickly(const Shaking& piece);
  void advance(Shaking piece, double end_s);
  // Each returns the elapsed fraction of the piece.
  double rest(const Shaking& piece);
  double slide(const Shaking& piece);

  void start(Vector acceleration, const Shaking& piece);
  Bare alone(const Shaking& piece) const;
  double first_lift(const Bare& bare) const;
  double heaviest(const Bare& bare) const;
  double step(const Bare& bare, double longest);
  BuildingStep try_step(const Bare& bare, double length_s) const;
  Axes next_yields(const Bare& bare, const BuildingStep& step, double length_s) const;
  void yield(const Axes& when);
  void take(const Bare& bare, const BuildingStep& step, double length_s);
  AxisSeries with_block(const Bare& bare, const BuildingStep& step, std::size_t n,
                        double length_s) const;
  void raise_peaks(std::size_t n, const Bare& bare, const BuildingStep& step, double length_s);
  Stop find_stop(const Bare& bare, double left_s, std::array<Ramp, 2>& push);
  Stop find_curved_stop(const Bare& bare, double left_s, double allowed) const;
  Load load_at_rest(const Bare& bare, double after_s) const;
  bool passes_no_peak(Vector drive) const;
  bool stop_there(const Stop& stop, const Bare& bare, const std::array<Ramp, 2>& push);
  void raise_peaks(std::size_t axis, const AxisSeries& motion, double share);

  BuildingContact contact_;
  std::array<BuildingAxis, 2> axes_;
  double mass_ratio_;
  Mobility mobility_;  // at an instant
  int pieces_;
  double tolerance_, strongest_;
  double margin_per_a_, margin_per_w_;  // largest decrease of N - |M^-1 F| per acceleration

  bool sliding_ = false;
  Sliding now_;
  Vector friction_now_;  // initial value of the iteration
  double time_s_ = 0.0;
  double step_s_ = never;  // the longest to be tried

  TwoAxisTrack track_;
  Peaks peaks_;
  double peak_speed_ = 0.0;  // per cos(slope), at the ends of steps
  std::size_t phases_ = 0;
  bool uplift_ = false, slides_at_rest_ = false;
};

}  // namespace glissade::block_detail
