// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace glissade::test {

using Long = long double;

/// A x = b by elimination with row pivots; x replaces b. False if A is singular.
template <std::size_t n>
bool solve_linear(std::array<std::array<Long, n>, n>& a, std::array<Long, n>& b) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (!(std::abs(a[pivot][k]) > 0.0L)) return false;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Long m = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= m * a[k][j];
      b[i] -= m * b[k];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return true;
}

/// Root of a function that changes its sign between low and high: regula falsi (Illinois).
template <class Function>
Long root_between(Long low, Long at_low, Long high, Long at_high, int evaluations, Function&& f) {
  for (int i = 0; i < evaluations && at_high != 0.0L; ++i) {
    const Long t = high - at_high * (high - low) / (at_high - at_low), at_t = f(t);
    if ((at_t > 0.0L) != (at_high > 0.0L)) {
      low = high, at_low = at_high;
    } else {
      at_low *= 0.5L;
    }
    high = t, at_high = at_t;
  }
  return high;
}

/// Radau IIA with `stages` stages: collocation of order 2 stages - 1, L-stable (Hairer & Wanner
/// 1996, section IV.5). The last node is 1, the last row of `a` holds the weights.
struct RadauIIA {
  static constexpr std::size_t stages = 5;
  std::array<Long, stages> at{};
  std::array<std::array<Long, stages>, stages> a{};

  RadauIIA() {
    // Nodes c: P_s(x) = P_{s-1}(x), Legendre polynomials, x = 2 c - 1.
    const auto difference = [](Long c) {
      const Long x = 2.0L * c - 1.0L;
      Long last = 1.0L, legendre = x;
      for (std::size_t k = 1; k < stages; ++k) {
        const auto degree = static_cast<Long>(k);
        const Long next = ((2.0L * degree + 1.0L) * x * legendre - degree * last) / (degree + 1.0L);
        last = std::exchange(legendre, next);
      }
      return legendre - last;
    };
    constexpr int cells = 1000;
    std::size_t found = 0;
    for (int i = 0; i + 1 < cells; ++i) {
      const Long low = static_cast<Long>(i) / cells, high = static_cast<Long>(i + 1) / cells;
      if ((difference(low) > 0.0L) != (difference(high) > 0.0L))
        at[found++] = root_between(low, difference(low), high, difference(high), 60, difference);
    }
    at[stages - 1] = 1.0L;
    // Quadrature up to each node is exact for polynomials of degree stages - 1.
    for (std::size_t i = 0; i < stages; ++i) {
      std::array<std::array<Long, stages>, stages> powers;
      for (std::size_t k = 0; k < stages; ++k) {
        const auto degree = static_cast<Long>(k);
        for (std::size_t j = 0; j < stages; ++j) powers[k][j] = std::pow(at[j], degree);
        a[i][k] = std::pow(at[i], degree + 1.0L) / (degree + 1.0L);
      }
      solve_linear(powers, a[i]);
    }
  }
};

}  // namespace glissade::test
