// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/building/mode_rules.hpp"
#include "glissade/building/rigid.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/oscillator.hpp"
#include "ring_down.hpp"

namespace glissade {
namespace {

/// Bounds the length of the roof motion.
constexpr int most_substeps = 1024;

/// Number of substeps of dt for which a period has at least `steps_per_period` of them.
int substeps(const Modes& building, double dt_s, int steps_per_period) {
  if (is_rigid(building, dt_s)) return 1;
  const double wanted = std::ceil(steps_per_period * dt_s / shortest_period_s(building) - 1e-9);
  return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_substeps)));
}

/// Visits the linear pieces of a record divided into `parts` each: visit(a_begin, a_end).
template <class Visit>
void for_each_piece(std::span<const double> ground, bool to_zero, int parts, Visit visit) {
  const std::size_t intervals = ground.size() - (to_zero ? 0 : 1);
  for (std::size_t i = 0; i < intervals; ++i) {
    const double begin = ground[i], end = i + 1 < ground.size() ? ground[i + 1] : 0.0;
    double left = begin;
    for (int part = 1; part <= parts; ++part) {
      const double right = part == parts ? end : begin + (end - begin) * part / parts;
      visit(left, right);
      left = right;
    }
  }
}

std::vector<double> rigid_response(std::span<const double> ground, bool to_zero, int parts) {
  std::vector<double> roof;
  roof.reserve((ground.size() + 1) * static_cast<std::size_t>(parts));
  roof.push_back(ground.front());
  for_each_piece(ground, to_zero, parts, [&](double, double end) { roof.push_back(end); });
  return roof;
}

/// Largest minus smallest velocity of a roof that starts from rest.
double velocity_range(const std::vector<double>& acceleration_mps2, double dt_s) {
  double velocity = 0.0, least = 0.0, most = 0.0;
  for (std::size_t i = 1; i < acceleration_mps2.size(); ++i) {
    velocity += 0.5 * dt_s * (acceleration_mps2[i - 1] + acceleration_mps2[i]);
    least = std::min(least, velocity);
    most = std::max(most, velocity);
  }
  return most - least;
}

std::vector<double> response_of_modes(const Modes& building, double dt_s,
                                      std::span<const double> ground, int parts, double quiet_mps2,
                                      const RoofMotionOptions& options) {
  std::vector<OscillatorStep> steps_of_modes;
  for (const Mode& mode : building)
    steps_of_modes.push_back(oscillator_step(
        2.0 * std::numbers::pi * dt_s / (parts * mode.period_s), mode.damping_ratio));
  std::vector<OscillatorState> states(building.size());
  const double share = building.is_one_mass() ? 0.0 : building.ground_share();
  const bool rings = quiet_mps2 > 0.0;

  std::vector<double> roof;
  roof.reserve((ground.size() + 1) * static_cast<std::size_t>(parts));
  const auto advance = [&](double a0, double a1) {
    double a = share * a1;
    for (std::size_t n = 0; n < building.size(); ++n) {
      states[n] = steps_of_modes[n].after(states[n], a0, a1);
      a -=
          building[n].participation * (states[n].x + 2.0 * building[n].damping_ratio * states[n].y);
    }
    roof.push_back(a);
  };
  roof.push_back(share * ground.front());  // at rest
  for_each_piece(ground, rings, parts, advance);
  if (rings) {
    const double step_s = dt_s / parts;
    const std::size_t steps = building_detail::ring_down_steps(
        building, step_s, states, velocity_range(roof, step_s), quiet_mps2, options);
    for (std::size_t left = steps; left > 0; --left) advance(0.0, 0.0);
  }
  return roof;
}

double peak(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

RoofMotion roof_motion(const GroundMotion& ground, const Building& building,
                       const RoofMotionOptions& options) {
  return roof_motion(ground, building.horizontal, building.vertical, options);
}

RoofMotion roof_motion(const GroundMotion& ground, const Modes& horizontal,
                       const Oscillator& vertical, const RoofMotionOptions& options) {
  require_acceleration(ground.horizontal_mps2, "the ground acceleration");
  require_acceleration(ground.vertical_mps2, "the vertical ground acceleration");
  require_finite({ground.dt_s}, "the step");
  GLISSADE_EXPECTS(ground.dt_s > 0.0 && !ground.horizontal_mps2.empty());
  GLISSADE_EXPECTS(ground.vertical_mps2.empty() ||
                   ground.vertical_mps2.size() == ground.horizontal_mps2.size());
  const bool has_vertical = !ground.vertical_mps2.empty();
  const int parts =
      std::max(substeps(horizontal, ground.dt_s, options.steps_per_period),
               has_vertical ? substeps(vertical, ground.dt_s, options.steps_per_period) : 1);
  building_detail::require_steps(static_cast<double>(ground.horizontal_mps2.size()) * parts,
                                 ground.dt_s / parts);

  const auto response = [&](const Modes& modes, std::span<const double> input, double quiet_mps2) {
    if (is_rigid(modes, ground.dt_s)) return rigid_response(input, false, parts);
    return response_of_modes(modes, ground.dt_s, input, parts, quiet_mps2, options);
  };
  RoofMotion roof;
  roof.dt_s = ground.dt_s / parts;
  roof.horizontal_mps2 =
      response(horizontal, ground.horizontal_mps2, options.quiet_horizontal_mps2);
  if (has_vertical)
    roof.vertical_mps2 = response(vertical, ground.vertical_mps2, options.quiet_vertical_mps2);
  roof.record_samples = (ground.horizontal_mps2.size() - 1) * static_cast<std::size_t>(parts) + 1;
  roof.peak_horizontal_mps2 = peak(roof.horizontal_mps2);
  roof.peak_vertical_mps2 = peak(roof.vertical_mps2);
  if (has_vertical && roof.vertical_mps2.size() != roof.horizontal_mps2.size()) {
    // The component that ends first goes to zero over one record interval, divided like the others,
    // and remains zero.
    auto& shorter = roof.vertical_mps2.size() < roof.horizontal_mps2.size() ? roof.vertical_mps2
                                                                            : roof.horizontal_mps2;
    const std::size_t full = std::max(roof.vertical_mps2.size(), roof.horizontal_mps2.size());
    const double last = shorter.back();
    for (int part = 1; part < parts; ++part) shorter.push_back(last * (parts - part) / parts);
    shorter.resize(full, 0.0);
  }
  return roof;
}

}  // namespace glissade
