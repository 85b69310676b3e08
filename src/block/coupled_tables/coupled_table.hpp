// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "block/contact/coupled_regime.hpp"
#include "block/coupled_tables/coupled_fill.hpp"
#include "block/coupled_tables/coupled_lanes.hpp"
#include "glissade/building/ground_table.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade::block_detail {

/// Both components of a ground motion, at the same nodes.
struct CoupledNodes {
  explicit CoupledNodes(const GroundMotion& motion);

  GroundTable a, w;  ///< w: nothing where there is no vertical
  bool vertical;
  std::size_t quiet;  ///< the first node from which on both are zero
  double lowest_w_mps2 = 0.0, highest_w_mps2 = 0.0;
  std::vector<double> tile_lowest_w_mps2, tile_highest_w_mps2;  ///< between nodes too

  /// Of a factor times the vertical acceleration.
  double lowest_w(double factor) const {
    return std::min(factor * lowest_w_mps2, factor * highest_w_mps2);
  }
  double lowest_w(double factor, std::size_t tile) const {
    return std::min(factor * tile_lowest_w_mps2[tile], factor * tile_highest_w_mps2[tile]);
  }
};

/// Values whose memory is used again.
template <class Number>
class Numbers {
 public:
  /// Room for this many, of any value, and zeros behind them.
  Number* room(std::size_t count) {
    constexpr std::size_t behind = 16;  // SIMD loads reach no farther
    if (count > count_) values_ = std::make_unique_for_overwrite<Number[]>(count + behind);
    count_ = std::max(count_, count);
    std::fill_n(values_.get() + count, behind, Number{});
    return values_.get();
  }
  const Number* data() const { return values_.get(); }
  Number& operator[](std::size_t i) { return values_[i]; }
  Number operator[](std::size_t i) const { return values_[i]; }

 private:
  std::unique_ptr<Number[]> values_;
  std::size_t count_ = 0;
};

/// What the histories of a motion, building, slope and friction share, whatever the intensity: the
/// response of each regime's oscillator to the motion at unit intensity, from rest, without the
/// block's weight. A history's own state is intensity times this, what the weight does, and the
/// free vibration that its last event left.
class CoupledTable {
 public:
  static constexpr std::size_t tile = 64;  ///< nodes
  /// Tables of so many zeros stand for what follows the record.
  static constexpr std::size_t zeros = 8 * tile;

  /// @param sign of the motion; @param vertical_ratio of the vertical's factor to that of the
  /// horizontal without its sign
  void tabulate(const CoupledNodes& nodes, const CoupledContact& contact,
                const BuildingOscillator& building, double sign, double vertical_ratio);

  /// Of one oscillator.
  struct Response {
    Numbers<double> x, y;  ///< scaled state by node
    // By tile: no more, from its nodes and the one before.
    Numbers<float> amplitude;       ///< |s^2 z|
    Numbers<float> a_mps2, x_mps2;  ///< |a|, |x|, between nodes too
    double largest_a_mps2 = 0.0, largest_x_mps2 = 0.0;
  };
  /// For the search while the block rests: a less what the vertical does to the limit below, and
  /// above. Without vertical the two are the same.
  struct Rest {
    Numbers<float> below, above;            ///< by node; without vertical only above
    Numbers<float> tile_below, tile_above;  ///< extremes, between nodes too
    double largest = 0.0;
  };
  /// For the search while it slides: the speed gained since time zero over drive.a.
  struct Speed {
    Numbers<float> gain;            ///< by node
    Numbers<float> tile_deviation;  ///< by tile: how far it may leave its chord between nodes
    double largest = 0.0;
  };

  /// Direction 0 stuck, +1 sliding down, -1 up.
  static std::size_t index(int direction) { return direction == 0 ? 0 : direction > 0 ? 1 : 2; }
  const RegimeOscillator& regime(int direction) const { return regimes_[index(direction)]; }
  const Response& response(int direction) const { return responses_[source_[index(direction)]]; }
  const Rest& rest() const { return rest_; }
  const float* rest_below() const { return vertical() ? rest_.below.data() : rest_.above.data(); }
  const Speed& speed(int direction) const { return speeds_[speed_source(index(direction)) - 1]; }
  const CoupledNodes& nodes() const { return *nodes_; }
  double sign() const { return sign_; }
  /// For lanes on an elastic building and the same while it yields, if there is such a table.
  LaneTables lanes(const CoupledTable* yielding, const Yielding& spring) const;
  /// Normal force of the block per mass that the table leaves at this intensity, over sin(slope),
  /// less what a free vibration |a| takes: it lifts where this is negative. Infinite: never.
  double contact_margin_mps2(int direction, double intensity, double w_factor) const;
  /// a at which the block begins to slide, per (g + w): it rests between these.
  double lowest_per_g() const { return lowest_per_g_; }
  double highest_per_g() const { return highest_per_g_; }

 private:
  bool vertical() const { return vertical_ratio_ != 0.0; }
  /// Of the two directions of sliding, the one whose speeds are tabulated.
  std::size_t speed_source(std::size_t k) const {
    return !vertical() && source_[1] == source_[2] ? 1 : k;
  }
  void set_response(std::size_t k, const BuildingOscillator& building, TableFill& fill);
  void set_bounds(Response& response, const RegimeOscillator& regime) const;
  void set_rest();
  void set_speed(std::size_t k, const LineFill& fill);

  const CoupledNodes* nodes_ = nullptr;
  double sign_ = 1.0, vertical_ratio_ = 0.0, gravity_mps2_ = 0.0, cot_slope_ = 0.0;
  double lowest_per_g_ = 0.0, highest_per_g_ = 0.0;
  std::array<RegimeOscillator, 3> regimes_;
  std::array<LaneRegime, 3> lane_regimes_;
  std::array<std::size_t, 3> source_{};  // equal regimes have one response
  std::array<Response, 3> responses_;
  Rest rest_;
  std::array<Speed, 2> speeds_;
  std::array<Numbers<float>, 6> extremes_;  // of lines, that are not kept
};

}  // namespace glissade::block_detail
