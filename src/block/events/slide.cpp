// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/slide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "block/events/sampled_motion.hpp"
#include "block/events/sliding_block.hpp"
#include "block/slip_record/crossing_watch.hpp"

namespace glissade {
namespace {

using block_detail::Contact;
using block_detail::CrossingWatch;
using block_detail::Drive;
using block_detail::NoHistory;
using block_detail::require_block;
using block_detail::Roof;
using block_detail::SampledMotion;
using block_detail::SlidingBlock;
using block_detail::WatchHistory;

/// Keeps the points of a history, in plan.
class Points : public NoHistory {
 public:
  Points(std::vector<SlipPoint>& points, double cos_slope)
      : points_(points), cos_slope_(cos_slope) {}
  void operator()(double time, double slip, double velocity) const {
    points_.push_back({time, slip * cos_slope_, velocity * cos_slope_});
  }

 private:
  std::vector<SlipPoint>& points_;
  double cos_slope_;
};

template <class History>
SlipResult slide_with(const RoofAcceleration& roof, const Block& block, History history) {
  require_block(block);
  GLISSADE_EXPECTS(block.law.is_coulomb());
  const SampledMotion motion(roof, block);
  const Contact contact(block);
  const auto may_rest = [&](const Roof& r) {
    const Drive drive = contact.sliding(r);
    return drive.down <= 0.0 &&
           (drive.up <= 0.0 || block.directions == SlipDirections::downslope_only) &&
           contact.normal(r) >= 0.0;
  };

  SlidingBlock<History> body(contact, block.directions, history);
  const std::size_t n =
      contact.slides_at_rest() ? motion.size() : motion.size_without_trailing_zeros();
  Roof now = motion.at(0);
  bool rested = may_rest(now);
  for (std::size_t i = 1; i < n; ++i) {
    const Roof next = motion.at(i);
    const bool rests = may_rest(next);
    const double end = static_cast<double>(i) * roof.dt_s;
    if (rested && rests && body.direction() == 0) {
      body.rest_until(end);  // both ends of the interval too small to start sliding, so all between
    } else {
      body.interval(roof.dt_s, end, now, next);
    }
    now = next;
    rested = rests;
  }

  SlipResult result;
  if (contact.slides_at_rest()) {
    result = body.result(contact.cos_slope());
    result.free_sliding = true;
  } else {
    body.interval(roof.dt_s, static_cast<double>(n) * roof.dt_s, now, Roof{});
    const bool stopped = body.coast(roof.dt_s);
    result = body.result(contact.cos_slope());
    result.free_sliding = !stopped;
  }
  result.uplift = result.uplift || contact.normal(now) < 0.0;
  return result;
}

}  // namespace

SlipResult slide(const RoofAcceleration& roof, const Block& block) {
  return slide_with(roof, block, NoHistory{});
}

SlipResult slide(const RoofAcceleration& roof, const Block& block,
                 std::vector<SlipPoint>& history) {
  history.assign(1, SlipPoint{});
  return slide_with(roof, block, Points(history, std::cos(block.slope_rad)));
}

SlipResult slide(const RoofAcceleration& roof, const Block& block,
                 std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  CrossingWatch watch(thresholds_m, crossings, std::cos(block.slope_rad));
  return slide_with(roof, block, WatchHistory{&watch});
}

bool cannot_slip(const Block& block, double peak_horizontal_mps2, double peak_vertical_mps2) {
  const Contact contact(block);
  for (const double a : {-peak_horizontal_mps2, peak_horizontal_mps2}) {
    for (const double w : {-peak_vertical_mps2, peak_vertical_mps2}) {
      const Drive drive = contact.sliding({a, w});
      if (drive.down > 0.0 || drive.up > 0.0 || contact.normal({a, w}) < 0.0) return false;
    }
  }
  return true;
}

double resting_deceleration_mps2(const Block& block) {
  const Contact contact(block);
  return std::max(0.0, -contact.sliding({}).down);
}

double yield_acceleration_mps2(const Block& block) {
  const Contact contact(block);
  if (!contact.stops_at_rest()) return 0.0;
  const auto down = contact.down(), up = contact.up();
  return std::min(down.constant / down.a,
                  up.a > 0.0 ? -up.constant / up.a : std::numeric_limits<double>::infinity());
}

}  // namespace glissade
