// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/rodriguez_nikl.hpp"

#include <algorithm>
#include <cmath>

#include "block/contact/contact.hpp"
#include "block/events/sampled_motion.hpp"

namespace glissade {
namespace {

double sign(double x) { return static_cast<double>((x > 0.0) - (x < 0.0)); }

/// Velocities and positions of the block (x) and of the plane (p), horizontal, relative to the
/// ground at rest.
class SteppedBlock {
 public:
  SteppedBlock(const Block& block, double slope)
      : g_(block.gravity_mps2),
        mu_(block.friction.along),
        sin_(std::sin(slope)),
        cos_(std::cos(slope)),
        tan_(std::tan(slope)),
        one_way_(block.directions == SlipDirections::downslope_only) {}

  /// After the roof has come to rest: under gravity and friction alone the limit of the scheme is a
  /// parabola. False if the block never stops.
  bool coast() {
    const double relative = velocity_x_ - velocity_p_;
    if (sticking_ || relative == 0.0) return true;
    const double along = g_ * (relative > 0.0 ? mu_ * cos_ - sin_
                                              : mu_ * cos_ + sin_);  // deceleration along the slope
    if (!(along > 0.0) || (relative > 0.0 && block_detail::beyond_friction(tan_, mu_) >= 0.0))
      return false;
    const double deceleration = along * cos_;  // of plan velocity
    position_x_ += 0.5 * relative * std::abs(relative) / deceleration;
    duration_ += std::abs(relative) / deceleration;
    velocity_x_ = velocity_p_;
    note_peaks();
    return true;
  }

  /// One substep with the roof acceleration constant at its initial value (paper, "Time-stepping
  /// algorithm").
  void step(const block_detail::Roof& r, double dt) {
    const double relative = velocity_x_ - velocity_p_;  // eq 10
    const double g = g_ + r.w;
    const bool slow_enough = relative == 0.0 || relative * previous_relative_ < 0.0;
    const bool below_friction =
        std::abs(r.a * cos_ - g * sin_) < mu_ * std::abs(g * cos_ + r.a * sin_);
    const bool blocked = one_way_ && relative <= 0.0 && r.a * cos_ > g * sin_;
    sticking_ = slow_enough && (below_friction || blocked);
    double acceleration_x = r.a;  // eq 4
    if (sticking_) {
      velocity_x_ = velocity_p_;               // eq 5
      uplift_ |= g * cos_ + r.a * sin_ < 0.0;  // eq 6
    } else {
      const double A = sin_ - mu_ * sign(relative) * cos_;  // eq 13
      const double B = cos_ + mu_ * sign(relative) * sin_;  // eq 15
      const double C = g + r.a * tan_;                      // eq 16
      const double normal = C / (A * tan_ + B);             // eq 17, per mass
      uplift_ |= normal < 0.0;
      acceleration_x = normal * A;  // eq 18
      duration_ += dt;
      if (relative != 0.0 && sign(relative) != phase_) ++phases_;
    }
    phase_ = sticking_ ? 0.0 : sign(relative);
    previous_relative_ = relative;
    position_p_ += velocity_p_ * dt + 0.5 * r.a * dt * dt;
    position_x_ += velocity_x_ * dt + 0.5 * acceleration_x * dt * dt;
    velocity_p_ += r.a * dt;
    velocity_x_ += acceleration_x * dt;
    note_peaks();
    peak_velocity_ = std::max(peak_velocity_, std::abs(velocity_x_ - velocity_p_));
  }

  SlipResult result() const {
    SlipResult r;
    block_detail::set_peaks(farthest_down_, farthest_up_, position_x_ - position_p_, r);
    r.path_length_m = path_;
    r.peak_velocity_mps = peak_velocity_;
    r.slip_duration_s = duration_;
    r.slip_phases = phases_;
    r.uplift = uplift_;
    return r;
  }

 private:
  void note_peaks() {
    const double slip = position_x_ - position_p_;
    path_ += std::abs(slip - slip_);
    slip_ = slip;
    farthest_down_ = std::max(farthest_down_, slip);
    farthest_up_ = std::min(farthest_up_, slip);
  }

  double g_, mu_, sin_, cos_, tan_;
  bool one_way_;
  double velocity_x_ = 0.0, velocity_p_ = 0.0, position_x_ = 0.0, position_p_ = 0.0;  // eq 19
  double previous_relative_ = 0.0, phase_ = 0.0;
  double slip_ = 0.0, path_ = 0.0;
  double farthest_down_ = 0.0, farthest_up_ = 0.0, peak_velocity_ = 0.0, duration_ = 0.0;
  std::size_t phases_ = 0;
  bool sticking_ = true, uplift_ = false;
};

}  // namespace

SlipResult slide_rodriguez_nikl(const RoofAcceleration& roof, const Block& block, int substeps) {
  block_detail::require_block(block);
  GLISSADE_EXPECTS(substeps >= 1);
  const block_detail::SampledMotion motion(roof, block);
  const double slope = std::abs(block.slope_rad);
  const bool slides_at_rest =
      block_detail::beyond_friction(std::tan(slope), block.friction.along) > 0.0;
  // The end of the record, as in slide(): free sliding ends at the last sample, all others after
  // one more interval to zero.
  const std::size_t intervals =
      slides_at_rest ? motion.size() - 1 : motion.size_without_trailing_zeros();
  const double dt = roof.dt_s / substeps;

  SteppedBlock body(block, slope);
  for (std::size_t i = 0; i < intervals; ++i) {
    const block_detail::Roof r0 = motion.at(i), r1 = motion.at(i + 1);
    for (int j = 0; j < substeps; ++j) {
      const double fraction = static_cast<double>(j) / substeps;
      body.step({r0.a + fraction * (r1.a - r0.a), r0.w + fraction * (r1.w - r0.w)}, dt);
    }
  }
  if (slides_at_rest) {
    SlipResult result = body.result();
    result.free_sliding = true;
    return result;
  }
  const bool stopped = body.coast();
  SlipResult result = body.result();
  result.free_sliding = !stopped;
  return result;
}

}  // namespace glissade
