// SPDX-License-Identifier: GPL-3.0-or-later
#include "newmark_trapezoid.hpp"

#include <algorithm>
#include <cmath>

namespace glissade::bench {

double newmark_trapezoid_peak_m(const RoofAcceleration& roof, const Block& block, int substeps) {
  const double sine = std::sin(std::abs(block.slope_rad)), cosine = std::cos(block.slope_rad),
               mu = block.friction.along, g = block.gravity_mps2;
  const bool both_ways = block.directions == SlipDirections::both;
  const double mirror = block.slope_rad < 0.0 ? -1.0 : 1.0;
  const std::size_t n = roof.horizontal_mps2.size();
  const auto a_at = [&](std::size_t i) {
    return i < n ? mirror * roof.horizontal_factor * roof.horizontal_mps2[i] : 0.0;
  };
  const auto w_at = [&](std::size_t i) {
    return i < n && !roof.vertical_mps2.empty() ? roof.vertical_factor * roof.vertical_mps2[i]
                                                : 0.0;
  };
  // Relative acceleration along the slope of a block that slides down (direction 1) or up (-1).
  const auto sliding = [&](double a, double w, int direction) {
    return (g + w) * sine - a * cosine - direction * mu * ((g + w) * cosine + a * sine);
  };

  double velocity = 0.0, acceleration = 0.0, displacement = 0.0, lowest = 0.0, highest = 0.0;
  const double dt = roof.dt_s / substeps;
  const auto step = [&](double a, double w) {
    int direction = velocity > 0.0 ? 1 : velocity < 0.0 ? -1 : 0;
    if (direction == 0) {
      if (sliding(a, w, 1) > 0.0) direction = 1;
      if (both_ways && sliding(a, w, -1) < 0.0) direction = -1;
    }
    double new_acceleration = direction == 0 ? 0.0 : sliding(a, w, direction);
    double new_velocity = velocity + 0.5 * dt * (acceleration + new_acceleration);
    if (direction * new_velocity <= 0.0) new_velocity = new_acceleration = 0.0;  // it sticks
    displacement += 0.5 * dt * (velocity + new_velocity);
    velocity = new_velocity;
    acceleration = new_acceleration;
    lowest = std::min(lowest, displacement);
    highest = std::max(highest, displacement);
  };

  const bool slides_at_rest = std::tan(std::abs(block.slope_rad)) > mu;
  if (sliding(a_at(0), w_at(0), 1) > 0.0)
    acceleration = sliding(a_at(0), w_at(0), 1);
  else if (both_ways && sliding(a_at(0), w_at(0), -1) < 0.0)
    acceleration = sliding(a_at(0), w_at(0), -1);
  for (std::size_t i = 0; i + (slides_at_rest ? 1 : 0) < n; ++i) {
    const double a0 = a_at(i), a1 = a_at(i + 1), w0 = w_at(i), w1 = w_at(i + 1);
    for (int j = 1; j <= substeps; ++j) {
      const double share = static_cast<double>(j) / substeps;
      step(a0 + share * (a1 - a0), w0 + share * (w1 - w0));
    }
  }
  if (!slides_at_rest && velocity != 0.0) {
    // It coasts to rest: its acceleration has the sign opposite to its velocity's.
    displacement -= 0.5 * velocity * velocity / sliding(0.0, 0.0, velocity > 0.0 ? 1 : -1);
    lowest = std::min(lowest, displacement);
    highest = std::max(highest, displacement);
  }
  return std::max(highest, -lowest) * cosine;
}

}  // namespace glissade::bench
