// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "block/contact/plane_vector.hpp"
#include "block/slip_record/first_reach.hpp"
#include "glissade/block/crossing.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade::block_detail {

/// Time and speed of the first crossing of each threshold, for one history.
class DistanceCrossings {
 public:
  DistanceCrossings() = default;
  /// @param thresholds_m > 0, increasing, in plan; @param crossings as many
  DistanceCrossings(std::span<const double> thresholds_m, std::span<Crossing> crossings)
      : thresholds_m_(thresholds_m), crossings_(crossings) {
    require_finite(thresholds_m, "the thresholds");
    GLISSADE_EXPECTS(thresholds_m.size() == crossings.size());
    GLISSADE_EXPECTS(std::ranges::is_sorted(thresholds_m));
    GLISSADE_EXPECTS(thresholds_m.empty() || thresholds_m.front() > 0.0);
    std::ranges::fill(crossings, Crossing{});
  }

  /// A displacement of this length may reach the next threshold.
  bool may_reach(double distance_m) const {
    return next_ < thresholds_m_.size() && distance_m >= thresholds_m_[next_];
  }
  /// Below it, squared, no threshold is reached.
  double next2() const { return next_m() * next_m() * (1.0 - 1e-12); }

  /// A piece of the path, after which the block has been `farthest_m` from where it lay.
  /// @param at from the fraction of the piece in [0, 1] to displacement and velocity, in plan
  template <class At>
  void pass(const At& at, double begin_s, double length_s, double farthest_m) {
    for (; may_reach(farthest_m); ++next_) {
      const double fraction =
          first_reach([&](double tau) { return at(tau).displacement; },
                      [&](double tau) { return at(tau).velocity; }, thresholds_m_[next_]);
      crossings_[next_] = {begin_s + fraction * length_s, length(at(fraction).velocity)};
    }
  }
  /// The crossing of the next threshold.
  void add(const Crossing& crossing) { crossings_[next_++] = crossing; }
  double next_m() const {
    return next_ < thresholds_m_.size() ? thresholds_m_[next_]
                                        : std::numeric_limits<double>::infinity();
  }

 private:
  std::span<const double> thresholds_m_;
  std::span<Crossing> crossings_;
  std::size_t next_ = 0;
};

/// Displacement and velocity, in plan.
struct PathPoint {
  Vector displacement, velocity;
};

}  // namespace glissade::block_detail
