// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace glissade::test {

inline constexpr double shaking_dt_s = 0.02;

/// Doubles survive the way through a file: 17 digits.
inline std::string exact(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// Two columns: time in s and acceleration in g.
inline std::string two_columns(const std::vector<double>& acceleration_g) {
  std::string text = "# time_s acceleration_g\n";
  for (std::size_t i = 0; i < acceleration_g.size(); ++i) {
    char time[32];
    std::snprintf(time, sizeof time, "%.2f ", shaking_dt_s * static_cast<double>(i));
    text += time + exact(acceleration_g[i]) + "\n";
  }
  return text;
}

/// A made-up shaking of 8 s: two sines with an envelope.
inline std::vector<double> shaking_g(double phase = 0.0) {
  std::vector<double> a(400);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double t = shaking_dt_s * static_cast<double>(i);
    a[i] = std::sin(std::numbers::pi * t / 8.0) *
           (0.5 * std::sin(7.0 * t + phase) + 0.3 * std::sin(17.0 * t + 1.0 + phase));
  }
  return a;
}

inline std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace glissade::test
