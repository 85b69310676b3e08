// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_down.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "glissade/core/error.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::building_detail {

void require_steps(double steps, double step_s, std::size_t most) {
  if (steps <= static_cast<double>(most)) return;
  std::ostringstream what;
  what << "a motion of " << steps << " steps of " << step_s << " s, ring-down included; at most "
       << most << " are followed";
  throw InputError(
      {"", what.str(),
       "give the record a longer time step, or the building a longer period or more damping", ""});
}

std::size_t ring_down_steps(const Oscillator& oscillator, double step_s, double x, double y,
                            double velocity_range_mps, double quiet_mps2,
                            const RoofMotionOptions& options) {
  if (!(quiet_mps2 > 0.0)) return 0;
  const double zeta = oscillator.damping_ratio;
  const double phase = 2.0 * std::numbers::pi * step_s / oscillator.period_s;
  // |x + 2 zeta y| <= (1 + 2 zeta) envelope.
  const Envelope envelope = free_vibration_envelope(x, y, zeta);
  const double bound = (1.0 + 2.0 * zeta) * envelope.amplitude;
  const double longest = options.longest_ring_down_s / step_s;
  const auto steps_to = [&](double level_mps2) {
    if (bound <= level_mps2) return 0.0;
    if (envelope.decay == 0.0) return longest;
    return std::min(longest, std::log(bound / level_mps2) / (envelope.decay * phase));
  };
  double steps = steps_to(quiet_mps2);
  if (options.settle_deceleration_mps2 > 0.0) {
    const double settle_s =
        velocity_range_mps / options.settle_deceleration_mps2 + oscillator.period_s;
    steps = std::min(steps + settle_s / step_s, steps_to(1e-4 * quiet_mps2));
  }
  require_steps(steps, step_s, most_steps);
  return static_cast<std::size_t>(std::ceil(steps));
}

}  // namespace glissade::building_detail
