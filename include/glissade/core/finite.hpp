// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

namespace glissade {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Refuses NaN and infinity, in every build: kernels compare and iterate, and would return a number
/// or not return.
/// @throw std::invalid_argument
inline void require_finite(std::span<const double> values, const char* what) {
  double zero_or_nan = 0.0;
  for (const double value : values) zero_or_nan += 0.0 * value;
  if (!(zero_or_nan == 0.0)) throw std::invalid_argument(std::string(what) + " must be finite");
}
inline void require_finite(std::initializer_list<double> values, const char* what) {
  require_finite(std::span(values.begin(), values.size()), what);
}

/// Largest acceleration (m/s2), and factor on one, that a kernel takes: with it no square or
/// product of what the kernel computes overflows.
inline constexpr double largest_acceleration = 1e12;

/// Refuses NaN and what is larger than largest_acceleration, in every build.
/// @throw std::invalid_argument
inline void require_acceleration(std::span<const double> values, const char* what) {
  require_finite(values, what);
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest > largest_acceleration)
    throw std::invalid_argument(std::string(what) + " must be 1e12 at most");
}
inline void require_acceleration(std::initializer_list<double> values, const char* what) {
  require_acceleration(std::span(values.begin(), values.size()), what);
}

/// @throw std::invalid_argument unless least <= tolerance <= 0.01, in every build: with 0 a kernel
/// would not return
inline void require_tolerance(double tolerance, double least) {
  if (!(tolerance >= least && tolerance <= 1e-2))
    throw std::invalid_argument("the tolerance is smaller than the kernel allows, or above 0.01");
}

/// The same where infinity has a meaning.
/// @throw std::invalid_argument
inline void require_no_nan(double value, const char* what) {
  if (std::isnan(value)) throw std::invalid_argument(std::string(what) + " must be a number");
}

}  // namespace glissade
