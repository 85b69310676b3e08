// SPDX-License-Identifier: GPL-3.0-or-later
// A building of several modes with the block at rest on it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "block/two_axes/roof/tables.hpp"

namespace glissade::block_detail::two_axes {
namespace {

using Complex = std::complex<double>;

/// A vibration exp(rate t) of the states x, Y of the modes of an axis (ModeMotion). With
///   q = 1 + 2 zeta rate / omega,   p = q + (rate / omega)^2
/// of each mode, p x = -share E and E = -sum of q x, so that 1 = sum of share q / p.
struct VibrationRates {
  std::size_t count;
  const double *omega, *twice_zeta, *share;

  Complex q(std::size_t n, Complex rate) const { return 1.0 + twice_zeta[n] / omega[n] * rate; }
  Complex p(std::size_t n, Complex rate) const {
    const Complex ratio = rate / omega[n];
    return q(n, rate) + ratio * ratio;
  }
  /// The polynomial of leading coefficient 1 whose roots the rates are.
  Complex polynomial(Complex rate) const {
    Complex product = 1.0, sum = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const double square = omega[n] * omega[n];
      const Complex of_mode = square * p(n, rate);
      sum = sum * of_mode + square * share[n] * q(n, rate) * product;
      product *= of_mode;
    }
    return product - sum;
  }
  /// Its roots above the real axis, by the rule of Weierstrass (Durand 1960, Kerner 1966).
  std::array<Complex, most_modes> roots() const {
    std::array<Complex, most_modes> root{};
    for (std::size_t n = 0; n < count; ++n) {
      const double zeta = 0.5 * twice_zeta[n];
      root[n] = omega[n] * std::sqrt(1.0 - share[n]) * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
    }
    constexpr double rounding = 1e-14;
    double moved = 1.0;
    for (int i = 0; i < 100 && moved > rounding; ++i) {
      moved = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        Complex distances = root[k] - std::conj(root[k]);
        for (std::size_t j = 0; j < count; ++j)
          if (j != k) distances *= (root[k] - root[j]) * (root[k] - std::conj(root[j]));
        const Complex change = polynomial(root[k]) / distances;
        root[k] -= change;
        moved = std::max(moved, std::abs(change / root[k]));
      }
    }
    return root;
  }
};

}  // namespace

RestModes::RestModes(const SceneConstants& c, std::size_t axis)
    : count(c.count[axis]), ground_share(c.modes.per_mass[axis] * c.modes.ground_share[axis]) {
  const ModeConstants<double>& of = c.modes;
  const VibrationRates rates{count, of.omega[axis], of.twice_zeta[axis], of.share[axis]};
  rate = rates.roots();
  double largest_to = 0.0, largest_from = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    // The vibration that accelerates the roof by 1, and its product with the states that gives how
    // much of it they have: the eigenvectors on either side.
    Complex shape[2 * most_modes], product[2 * most_modes], norm = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
      const double omega = of.omega[axis][n];
      const Complex p = rates.p(n, rate[k]), q = rates.q(n, rate[k]);
      shape[2 * n] = -of.share[axis][n] / of.per_mass[axis] / p;
      shape[2 * n + 1] = rate[k] / omega * shape[2 * n];
      product[2 * n] = (1.0 - q / p) / rate[k];
      product[2 * n + 1] = q / (omega * p);
      norm += product[2 * n] * shape[2 * n] + product[2 * n + 1] * shape[2 * n + 1];
    }
    for (std::size_t j = 0; j < 2 * count; ++j) {
      from[j][2 * k] = shape[j].real();
      from[j][2 * k + 1] = -shape[j].imag();
      const Complex part = 2.0 * product[j] / norm;
      to[2 * k][j] = part.real();
      to[2 * k + 1][j] = part.imag();
      largest_to = std::max(largest_to, std::abs(part));
      largest_from = std::max(largest_from, std::abs(shape[j]));
      if (j % 2 == 1)
        per_ground[k] -= part * (of.omega_share[axis][j / 2] * of.ground_share[axis] +
                                 of.omega[axis][j / 2] * of.gamma[axis][j / 2]);
    }
    found = found && rate[k].imag() > 0.0;
  }
  constexpr double ill_conditioned = 1e6;
  found = found && largest_to * largest_from < ill_conditioned;
}

RestModes::States RestModes::times(const Matrix& matrix, const States& states) const {
  States result{};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      result[i].x += matrix[2 * i][2 * j] * states[j].x + matrix[2 * i][2 * j + 1] * states[j].y;
      result[i].y +=
          matrix[2 * i + 1][2 * j] * states[j].x + matrix[2 * i + 1][2 * j + 1] * states[j].y;
    }
  return result;
}

namespace {

/// Of a vibration over a step of the ground, linear between its ends; exact.
struct VibrationStep {
  Complex decay, of_begin, of_end;
  Complex first_of_z, first_of_ground;  ///< z' at the begin, per step
  double phase, rise;                   ///< bounds: |rate|, |per_ground|, both times the step

  VibrationStep(Complex rate_per_s, Complex per_ground, double dt_s) {
    const Complex p = rate_per_s * dt_s, by = per_ground * dt_s;
    // (e^p - 1) / p and (e^p - 1 - p) / p^2.
    Complex mean = 1.0, end = 0.5, term_1 = 1.0, term_2 = 0.5;
    for (int k = 1; k < 40; ++k) {
      mean += term_1 *= p / (k + 1.0);
      end += term_2 *= p / (k + 2.0);
    }
    decay = std::exp(p);
    of_begin = by * (mean - end);
    of_end = by * end;
    first_of_z = p;
    first_of_ground = by;
    phase = std::abs(p);
    rise = std::abs(by);
  }
};

double size_bound(Complex z) { return std::abs(z.real()) + std::abs(z.imag()); }
/// Without the care for numbers that are not finite, which takes longer.
Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

double RestTable::tabulate_modes_at_rest(std::size_t n, const GroundNodes& ground,
                                         const SceneConstants& c) {
  const RestModes& modes = rest[n] = RestModes(c, n);
  const std::size_t quiet = ground.quiet, count = modes.count;
  std::vector<VibrationStep> steps;
  for (std::size_t k = 0; k < count; ++k) {
    free[n].emplace_back(modes.rate[k], ground.dt_s, quiet);
    steps.emplace_back(modes.rate[k], modes.per_ground[k], ground.dt_s);
  }
  // A table made again overwrites all but the padding, which is zero.
  x[n].resize((quiet + 1) * count);
  y[n].resize((quiet + 1) * count);
  own_a[n].resize(quiet + 1 + padding);
  std::fill_n(x[n].begin(), count, 0.0);
  std::fill_n(y[n].begin(), count, 0.0);
  const double* g = ground.a[n].data();
  own_a[n][0] = modes.ground_share * g[0];
  std::array<Complex, most_modes> z{};  // from rest at the first sample
  double largest = 0.0;                 // departure in a tile
  for (std::size_t i = 0; i < quiet; ++i) {
    const double begin = g[i], end = g[i + 1], change = std::abs(end - begin);
    double departs = 0.0, a = modes.ground_share * end;
    for (std::size_t k = 0; k < count; ++k) {
      const VibrationStep& s = steps[k];
      // |z''| is at most phase (|z'| at the begin + rise change) + rise change.
      const double rate = size_bound(times(s.first_of_z, z[k]) + s.first_of_ground * begin);
      departs += s.phase * (rate + s.rise * change) + s.rise * change;
      z[k] = times(s.decay, z[k]) + (s.of_begin * begin + s.of_end * end);
      x[n][(i + 1) * count + k] = z[k].real();
      y[n][(i + 1) * count + k] = z[k].imag();
      a += z[k].real();
    }
    own_a[n][i + 1] = a;
    largest = std::max(largest, 0.125 * departs);
    if (i % tile_nodes == tile_nodes - 1 || i + 1 == quiet)
      deviation[n][i / tile_nodes] = std::exchange(largest, 0.0);
  }
  add_interval_before(deviation[n]);
  a[n] = own_a[n].data();
  double after = 0.0;
  for (std::size_t k = 0; k < count; ++k) after += free[n][k].bound({z[k].real(), z[k].imag()});
  return after;
}

}  // namespace glissade::block_detail::two_axes
