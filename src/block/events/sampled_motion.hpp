// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/contact.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade::block_detail {

/// Samples of a horizontal and a vertical acceleration times their factors, in the axes of a block
/// (mirror()); zero after the last.
class SampledMotion {
 public:
  /// @throw std::invalid_argument if a number is not finite
  SampledMotion(const RoofAcceleration& roof, const Block& block)
      : samples_(roof),
        a_factor_(mirror(block) * roof.horizontal_factor),
        w_factor_(roof.vertical_factor) {
    require_acceleration(roof.horizontal_mps2, "the horizontal acceleration");
    require_acceleration(roof.vertical_mps2, "the vertical acceleration");
    require_finite({roof.dt_s}, "the step");
    require_acceleration({a_factor_, w_factor_}, "the factors");
    GLISSADE_EXPECTS(roof.dt_s > 0.0 && size() > 0);
    GLISSADE_EXPECTS(roof.vertical_mps2.empty() || roof.vertical_mps2.size() == size());
  }
  SampledMotion(const GroundMotion& ground, const MotionFactors& factors, const Block& block)
      : SampledMotion(RoofAcceleration{ground.dt_s, ground.horizontal_mps2, ground.vertical_mps2,
                                       factors.horizontal[0], factors.vertical},
                      block) {}

  double dt_s() const { return samples_.dt_s; }
  std::size_t size() const { return samples_.horizontal_mps2.size(); }
  /// The number of samples up to the last non-zero one, at least one: padding changes no bit.
  std::size_t size_without_trailing_zeros() const {
    std::size_t n = size();
    while (n > 1 && samples_.horizontal_mps2[n - 1] == 0.0 &&
           (samples_.vertical_mps2.empty() || samples_.vertical_mps2[n - 1] == 0.0))
      --n;
    return n;
  }
  Roof at(std::size_t i) const {
    if (i >= size()) return {};
    return {a_factor_ * samples_.horizontal_mps2[i],
            samples_.vertical_mps2.empty() ? 0.0 : w_factor_ * samples_.vertical_mps2[i]};
  }

 private:
  RoofAcceleration samples_;
  double a_factor_, w_factor_;
};

}  // namespace glissade::block_detail
