// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "glissade/building/modes.hpp"

namespace glissade::closed_forms {

using Digits100 = boost::multiprecision::cpp_bin_float_100;

/// Modes of a uniform cantilever of flexure and shear by the equations as they are published
/// (Miranda & Taghavi 2005; theory.md, 2.5), in 100 digits: the root by bisection, the integrals by
/// Simpson's rule, with an error below 1e-8. The first period is 1 s.
class Cantilever {
 public:
  explicit Cantilever(double alpha) : alpha_(alpha) {}

  Mode mode(int n) const {
    const Digits100 g = root(n), b = beta(g);
    const Digits100 eta = (g * g * sin(g) + g * b * sinh(b)) / (g * g * cos(g) + b * b * cosh(b));
    const auto shape = [&](const Digits100& x) {
      return Digits100(sin(g * x) - g / b * sinh(b * x) - eta * cos(g * x) + eta * cosh(b * x));
    };
    constexpr int parts = 1000;
    Digits100 mean = 0, square = 0;
    for (int i = 0; i <= parts; ++i) {
      const Digits100 y = shape(Digits100(i) / parts);
      const int weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
      mean += weight * y / (3 * parts);
      square += weight * y * y / (3 * parts);
    }
    const Digits100 first = root(0);
    return {static_cast<double>(first * beta(first) / (g * b)),
            static_cast<double>(shape(1) * mean / square),
            static_cast<double>(mean * mean / square)};
  }

 private:
  Digits100 beta(const Digits100& g) const { return sqrt(alpha_ * alpha_ + g * g); }
  Digits100 free_end(const Digits100& g) const {
    const Digits100 b = beta(g), ratio = alpha_ * alpha_ / (g * b);
    return 2 + (2 + ratio * ratio) * cos(g) * cosh(b) + ratio * sin(g) * sinh(b);
  }
  Digits100 root(int n) const {
    const Digits100 pi = boost::math::constants::pi<Digits100>();
    Digits100 low = n == 0 ? Digits100(1e-3) : n * pi, high = (n + 1) * pi;
    const bool is_above = free_end(low) > 0;
    for (int i = 0; i < 120; ++i) {
      const Digits100 middle = (low + high) / 2;
      ((free_end(middle) > 0) == is_above ? low : high) = middle;
    }
    return low;
  }
  Digits100 alpha_;
};

}  // namespace glissade::closed_forms
