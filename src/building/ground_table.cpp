// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/ground_table.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "ring_down.hpp"

namespace glissade {
namespace {

/// hi + lo += x, without loss (Knuth's two-sum; Dekker 1971's renormalisation).
void add(double& hi, double& lo, double x) {
  const double sum = hi + x, part = sum - hi;
  const double low = lo + ((hi - (sum - part)) + (x - part));
  hi = sum + low;
  lo = low - (hi - sum);
}

std::size_t without_trailing_zeros(std::span<const double> samples) {
  std::size_t n = samples.size();
  while (n > 1 && samples[n - 1] == 0.0) --n;
  return n;
}

}  // namespace

GroundTable::GroundTable(double dt_s, std::span<const double> acceleration_mps2, int parts)
    : step_s_(dt_s / parts) {
  require_acceleration(acceleration_mps2, "the ground acceleration");
  require_finite({dt_s}, "the step");
  GLISSADE_EXPECTS(dt_s > 0.0 && parts >= 1 && !acceleration_mps2.empty());
  const std::size_t samples = without_trailing_zeros(acceleration_mps2);
  const auto steps_of_sample = static_cast<std::size_t>(parts);
  building_detail::require_steps(static_cast<double>(acceleration_mps2.size()) * parts, step_s_);
  last_sample_ = (acceleration_mps2.size() - 1) * steps_of_sample;
  quiet_from_ = samples * steps_of_sample;
  nodes_.reserve(quiet_from_ + 1);
  append(GroundNode{.acceleration_mps2 = acceleration_mps2.front()});
  for (std::size_t i = 0; i < samples; ++i) {
    const double begin = acceleration_mps2[i],
                 end = i + 1 < samples ? acceleration_mps2[i + 1] : 0.0;
    for (int part = 1; part < parts; ++part) append(begin + (end - begin) * part / parts);
    append(end);
  }
  constexpr std::size_t least = 32;  // whole SIMD vectors for records of any length
  extend(std::max(last_sample_ + 1, least));
}

void GroundTable::extend(std::size_t count) {
  building_detail::require_steps(static_cast<double>(count), step_s_);
  while (nodes_.size() < count) append(0.0);
}

void GroundTable::append(double acceleration_mps2) {
  GroundNode next = nodes_.back();
  const double a0 = next.acceleration_mps2, h = step_s_;
  add(next.displacement_m, next.displacement_low_m, h * next.velocity_mps);
  add(next.displacement_m, next.displacement_low_m,
      h * velocity_low_mps_ + h * h * (2.0 * a0 + acceleration_mps2) / 6.0);
  add(next.velocity_mps, velocity_low_mps_, 0.5 * h * (a0 + acceleration_mps2));
  next.acceleration_mps2 = acceleration_mps2;
  append(next);
}

void GroundTable::append(const GroundNode& node) {
  nodes_.push_back(node);
  peak_acceleration_mps2_ = std::max(peak_acceleration_mps2_, std::abs(node.acceleration_mps2));
  acceleration_mps2_.push_back(node.acceleration_mps2);
  velocity_mps_.push_back(node.velocity_mps);
}

}  // namespace glissade
