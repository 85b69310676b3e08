// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The same where infinity has a meaning.
/// @throw std::invalid_argument
inline void require_no_nan(double value, const char* what) {
  if (std::isnan(value)) throw std::invalid_argument(std::string(what) + " must be a number");
}

}  // namespace glissade
