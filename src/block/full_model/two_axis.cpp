// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/two_axis.hpp"

#include <cmath>
#include <numbers>

#include "block/full_model/two_axis_body.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

using block_detail::FrictionEllipse;
using block_detail::Load;
using block_detail::TwoAxisBody;
using block_detail::TwoAxisLoading;

/// The load at each sample.
class Samples {
 public:
  Samples(const TwoAxisAcceleration& roof, const TwoAxisLoading& loading)
      : roof_(roof), loading_(loading) {}

  Load operator[](std::size_t i) const {
    return loading_.at(roof_.horizontal_factor * roof_.horizontal_mps2[0][i],
                       roof_.horizontal_factor * sample(roof_.horizontal_mps2[1], i),
                       roof_.vertical_factor * sample(roof_.vertical_mps2, i));
  }
  std::size_t size() const { return roof_.horizontal_mps2[0].size(); }
  std::size_t size_without_trailing_zeros() const {
    std::size_t n = size();
    while (n > 1 && roof_.horizontal_mps2[0][n - 1] == 0.0 &&
           sample(roof_.horizontal_mps2[1], n - 1) == 0.0 &&
           sample(roof_.vertical_mps2, n - 1) == 0.0) {
      --n;
    }
    return n;
  }

 private:
  static double sample(std::span<const double> x, std::size_t i) { return x.empty() ? 0.0 : x[i]; }

  const TwoAxisAcceleration& roof_;
  const TwoAxisLoading& loading_;
};

[[maybe_unused]] bool is_whole(std::span<const double> component, std::size_t samples) {
  return component.empty() || component.size() == samples;
}

TwoAxisResult slide_with(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                         double tolerance, std::vector<TwoAxisPoint>* history) {
  const EllipticFriction& mu = block.friction;
  for (const auto& horizontal : roof.horizontal_mps2)
    require_finite(horizontal, "the horizontal roof acceleration");
  require_finite(roof.vertical_mps2, "the vertical roof acceleration");
  require_finite({roof.dt_s, mu.along, mu.across, block.slope_rad, block.gravity_mps2},
                 "step, friction, slope, gravity");
  GLISSADE_EXPECTS(roof.dt_s > 0.0 && !roof.horizontal_mps2[0].empty());
  GLISSADE_EXPECTS(is_whole(roof.horizontal_mps2[1], roof.horizontal_mps2[0].size()) &&
                   is_whole(roof.vertical_mps2, roof.horizontal_mps2[0].size()));
  GLISSADE_EXPECTS(mu.along >= 0.0 && mu.across >= 0.0 && (mu.along > 0.0) == (mu.across > 0.0));
  GLISSADE_EXPECTS(block.slope_rad >= 0.0 && block.slope_rad < std::numbers::pi / 2);
  GLISSADE_EXPECTS(block.law.is_coulomb());
  GLISSADE_EXPECTS(tolerance >= 1e-11 && tolerance <= 1e-2);

  const TwoAxisLoading loading(block);
  const FrictionEllipse friction(block.friction);
  const Samples samples(roof, loading);
  const Load resting = loading.at(0.0, 0.0, 0.0);
  const double beyond = block_detail::beyond_friction(loading.tan_slope(), mu.along);
  const bool slides_at_rest = beyond > 0.0, stops_at_rest = beyond < 0.0;
  // Padding changes nothing, to the last bit; free sliders end with the record.
  const std::size_t n = slides_at_rest ? samples.size() : samples.size_without_trailing_zeros();

  TwoAxisBody body(friction, loading.to_plan(), tolerance, history);
  Load now = samples[0];
  bool rested = friction.may_rest(now);
  const auto pass = [&](double end_s, const Load& next) {
    const bool rests = friction.may_rest(next);
    if (rested && rests && body.at_rest()) {
      body.rest_until(end_s);  // the states of rest are convex
    } else {
      body.interval(roof.dt_s, end_s, now, next);
    }
    now = next;
    rested = rests;
  };
  for (std::size_t i = 1; i < n; ++i) pass(static_cast<double>(i) * roof.dt_s, samples[i]);
  const bool last_lifts = now.normal < 0.0;
  if (!slides_at_rest) pass(static_cast<double>(n) * roof.dt_s, resting);
  const bool free = slides_at_rest || !(body.at_rest() || stops_at_rest);
  if (!free) body.coast(resting, roof.dt_s);

  TwoAxisResult result = body.result();
  result.free_sliding = free;
  result.uplift = result.uplift || last_lifts;
  return result;
}

}  // namespace

double srss_of_maxima_m(const TwoAxisResult& result) {
  return std::hypot(result.peak_by_axis.along_m, result.peak_by_axis.across_m);
}

TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             double tolerance) {
  return slide_with(roof, block, tolerance, nullptr);
}

TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             std::vector<TwoAxisPoint>& history, double tolerance) {
  history.assign(1, TwoAxisPoint{});
  return slide_with(roof, block, tolerance, &history);
}

}  // namespace glissade
