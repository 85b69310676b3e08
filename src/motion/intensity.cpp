// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/intensity.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "glissade/core/contract.hpp"
#include "glissade/core/oscillator.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

bool has_second(const Motion& motion) { return !motion.horizontal_mps2[1].empty(); }

/// `measure` of each horizontal component, as one number.
template <typename Measure>
double combined(const Motion& motion, HorizontalCombination combination, Measure measure) {
  const double first = measure(motion.horizontal_mps2[0]);
  return has_second(motion) ? combine(combination, first, measure(motion.horizontal_mps2[1]))
                            : first;
}

double peak_roof_velocity_mps(double dt_s, std::span<const double> acceleration_mps2,
                              double period_s, double damping_ratio) {
  const double omega = 2.0 * std::numbers::pi / period_s;
  const OscillatorStep step = oscillator_step(omega * dt_s, damping_ratio);
  OscillatorState state;
  double ground = 0.0, peak = 0.0;
  for (std::size_t n = 0; n < acceleration_mps2.size(); ++n) {
    const double a = acceleration_mps2[n];
    const double b = n + 1 < acceleration_mps2.size() ? acceleration_mps2[n + 1] : 0.0;
    state = step.after(state, a, b);
    ground += 0.5 * dt_s * (a + b);
    peak = std::max(peak, std::abs(ground + state.y / omega));
  }
  return peak;
}

}  // namespace

double peak_ground_acceleration_mps2(std::span<const double> acceleration_mps2) {
  double peak = 0.0;
  for (const double a : acceleration_mps2) peak = std::max(peak, std::abs(a));
  return peak;
}

double peak_ground_velocity_mps(double dt_s, std::span<const double> acceleration_mps2) {
  GLISSADE_EXPECTS(dt_s > 0.0);
  double velocity = 0.0;
  double peak = 0.0;
  for (std::size_t n = 0; n < acceleration_mps2.size(); ++n) {
    const double a = acceleration_mps2[n];
    const double b = n + 1 < acceleration_mps2.size() ? acceleration_mps2[n + 1] : 0.0;
    // a + (b - a) t/dt is zero at t = dt a/(a - b): until then the velocity changes by a t/2.
    if (a * b < 0.0) peak = std::max(peak, std::abs(velocity + 0.5 * dt_s * a * (a / (a - b))));
    velocity += 0.5 * dt_s * (a + b);
    peak = std::max(peak, std::abs(velocity));
  }
  return peak;
}

double peak_ground_displacement_m(double dt_s, std::span<const double> acceleration_mps2) {
  GLISSADE_EXPECTS(dt_s > 0.0);
  double velocity = 0.0, displacement = 0.0, peak = 0.0;
  for (std::size_t n = 0; n < acceleration_mps2.size(); ++n) {
    const double a = acceleration_mps2[n];
    const double b = n + 1 < acceleration_mps2.size() ? acceleration_mps2[n + 1] : 0.0;
    displacement += dt_s * (velocity + dt_s * (2.0 * a + b) / 6.0);
    velocity += 0.5 * dt_s * (a + b);
    peak = std::max(peak, std::abs(displacement));
  }
  return peak;
}

std::array<double, 2> arias_times_s(double dt_s, std::span<const double> first_mps2,
                                    std::span<const double> second_mps2,
                                    const std::array<double, 2>& shares) {
  GLISSADE_EXPECTS(dt_s > 0.0);
  const auto at = [](std::span<const double> component, std::size_t n) {
    return n < component.size() ? component[n] : 0.0;
  };
  // The integral of a^2 over a step on which a is linear, over dt / 3.
  const auto step = [&](std::span<const double> component, std::size_t n) {
    const double a = at(component, n), b = at(component, n + 1);
    return a * a + a * b + b * b;
  };
  const std::size_t size = std::max(first_mps2.size(), second_mps2.size());
  std::vector<double> sum{0.0};
  for (std::size_t n = 0; n < size; ++n)
    sum.push_back(sum.back() + step(first_mps2, n) + step(second_mps2, n));
  if (sum.back() == 0.0) return {0.0, 0.0};
  const auto time_s = [&](double share) {
    const auto after = std::ranges::lower_bound(sum, share * sum.back());
    if (after == sum.begin()) return 0.0;
    const auto n = static_cast<double>(after - sum.begin());
    return dt_s * (n - (*after - share * sum.back()) / (*after - *std::prev(after)));
  };
  return {time_s(shares[0]), time_s(shares[1])};
}

double significant_duration_s(double dt_s, std::span<const double> first_mps2,
                              std::span<const double> second_mps2) {
  const auto [from_s, to_s] = arias_times_s(dt_s, first_mps2, second_mps2, {0.05, 0.95});
  return to_s - from_s;
}

double combine(HorizontalCombination combination, double first, double second) {
  return combination == HorizontalCombination::srss ? std::hypot(first, second)
                                                    : std::sqrt(first) * std::sqrt(second);
}

std::vector<double> horizontal_spectrum_mps2(const Motion& motion,
                                             std::span<const double> periods_s,
                                             HorizontalCombination combination,
                                             double damping_ratio) {
  std::vector<double> spectrum = pseudo_acceleration_spectrum(
      motion.dt_s, motion.horizontal_mps2[0], periods_s, damping_ratio);
  if (!has_second(motion)) return spectrum;
  const std::vector<double> second = pseudo_acceleration_spectrum(
      motion.dt_s, motion.horizontal_mps2[1], periods_s, damping_ratio);
  std::ranges::transform(spectrum, second, spectrum.begin(),
                         [&](double a, double b) { return combine(combination, a, b); });
  return spectrum;
}

double horizontal_pga_mps2(const Motion& motion, HorizontalCombination combination) {
  return combined(motion, combination, [](std::span<const double> component) {
    return peak_ground_acceleration_mps2(component);
  });
}

double horizontal_pgv_mps(const Motion& motion, HorizontalCombination combination) {
  return combined(motion, combination, [&](std::span<const double> component) {
    return peak_ground_velocity_mps(motion.dt_s, component);
  });
}

double horizontal_pgd_m(const Motion& motion, HorizontalCombination combination) {
  return combined(motion, combination, [&](std::span<const double> component) {
    return peak_ground_displacement_m(motion.dt_s, component);
  });
}

double arias_intensity_mps(const Motion& motion) {
  const auto of = [&](std::span<const double> a) {
    double integral = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double next = i + 1 < a.size() ? a[i + 1] : 0.0;
      integral += motion.dt_s / 3.0 * (a[i] * a[i] + a[i] * next + next * next);
    }
    return std::numbers::pi / (2.0 * standard_gravity_mps2) * integral;
  };
  const auto& [first, second] = motion.horizontal_mps2;
  return second.empty() ? of(first)
                        : combine(HorizontalCombination::geometric_mean, of(first), of(second));
}

std::vector<double> horizontal_roof_velocity_mps(const Motion& motion,
                                                 std::span<const double> periods_s,
                                                 double damping_ratio) {
  std::vector<double> velocities;
  for (const double period_s : periods_s) {
    velocities.push_back(combined(
        motion, HorizontalCombination::geometric_mean, [&](std::span<const double> component) {
          return period_s > 0.0
                     ? peak_roof_velocity_mps(motion.dt_s, component, period_s, damping_ratio)
                     : peak_ground_velocity_mps(motion.dt_s, component);
        }));
  }
  return velocities;
}

double average_sa_mps2(const Motion& motion, std::span<const double> periods_s,
                       double damping_ratio) {
  GLISSADE_EXPECTS(!periods_s.empty());
  double sum_of_logs = 0.0;
  for (const double sa : horizontal_spectrum_mps2(
           motion, periods_s, HorizontalCombination::geometric_mean, damping_ratio)) {
    sum_of_logs += std::log(sa);
  }
  return std::exp(sum_of_logs / static_cast<double>(periods_s.size()));
}

}  // namespace glissade
