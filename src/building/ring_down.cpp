// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_down.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "glissade/core/error.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::building_detail {

void require_steps(double steps, double step_s) {
  if (steps <= static_cast<double>(most_steps)) return;
  std::ostringstream what;
  what << "a motion of " << steps << " steps of " << step_s << " s, ring-down included; at most "
       << most_steps << " are followed";
  throw InputError(
      {"", what.str(),
       "give a shorter record, a longer time step or a building of longer period; more "
       "damping shortens the ring-down",
       ""});
}

namespace {

/// |acceleration| stays below amplitude exp(-decay steps).
struct Decaying {
  double amplitude_mps2, decay;
};

/// Steps after which the sum of bounds is at most `level`, or `longest`.
double steps_to(double level_mps2, std::span<const Decaying> bounds, double longest) {
  const auto bound_after = [&](double steps) {
    double sum = 0.0;
    for (const Decaying& b : bounds) sum += b.amplitude_mps2 * std::exp(-b.decay * steps);
    return sum;
  };
  const double now = bound_after(0.0);
  if (now <= level_mps2) return 0.0;
  if (bounds.size() == 1)
    return bounds[0].decay == 0.0 ? longest
                                  : std::min(longest, std::log(now / level_mps2) / bounds[0].decay);
  if (bound_after(longest) > level_mps2) return longest;
  double low = 0.0, high = longest;
  while (high - low > 0.5) {
    const double middle = 0.5 * (low + high);
    (bound_after(middle) > level_mps2 ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::size_t ring_down_steps(const Modes& building, double step_s,
                            std::span<const OscillatorState> states, double velocity_range_mps,
                            double quiet_mps2, const RoofMotionOptions& options) {
  if (!(quiet_mps2 > 0.0)) return 0;
  std::vector<Decaying> bounds;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Mode& mode = building[n];
    const double zeta = mode.damping_ratio;
    const double phase = 2.0 * std::numbers::pi * step_s / mode.period_s;
    // |x + 2 zeta y| <= (1 + 2 zeta) envelope.
    const Envelope envelope = free_vibration_envelope(states[n].x, states[n].y, zeta);
    bounds.push_back({std::abs(mode.participation) * ((1.0 + 2.0 * zeta) * envelope.amplitude),
                      envelope.decay * phase});
  }
  const double longest = options.longest_ring_down_s / step_s;
  double steps = steps_to(quiet_mps2, bounds, longest);
  if (options.settle_deceleration_mps2 > 0.0) {
    const double settle_s =
        velocity_range_mps / options.settle_deceleration_mps2 + building.period_s();
    constexpr double negligible = 1e-4;  // of the acceleration that can start the block
    steps = std::min(steps + settle_s / step_s, steps_to(negligible * quiet_mps2, bounds, longest));
  }
  require_steps(steps, step_s);
  return static_cast<std::size_t>(std::ceil(steps));
}

}  // namespace glissade::building_detail
