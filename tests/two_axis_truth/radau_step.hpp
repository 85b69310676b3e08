// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "two_axis_truth/free_bodies.hpp"

namespace glissade::test {

using Stages = std::array<State, RadauIIA::stages>;

/// A step of block and building together: Newton's method for the velocity of the block, with
/// Jacobians by differences, and substitution for the building.
class RadauStep : RadauIIA {
 public:
  explicit RadauStep(const FreeBodies& bodies) : bodies_(bodies) {}

  Long node(std::size_t i) const { return at[i]; }

  /// The stages of a step of length h from `from` at time t; false if they are not found.
  bool operator()(Long t, const State& from, Long h, Stages& y) const {
    if (!guess(t, from, h, y)) return false;
    for (int iteration = 0; iteration < 60; ++iteration) {
      std::array<FreeBodies::Motion, stages> m;
      std::array<std::array<Long, 4>, stages> jacobian;  // of v' over v
      for (std::size_t j = 0; j < stages; ++j) {
        const Long tj = t + at[j] * h;
        m[j] = bodies_.contact(tj, y[j]);
        const Long delta = 1e-9L * length(y[j].v);
        for (std::size_t n = 0; n < 2; ++n) {
          State shifted = y[j];
          shifted.v[n] += delta;
          const FreeBodies::Motion other = bodies_.contact(tj, shifted);
          for (std::size_t k = 0; k < 2; ++k)
            jacobian[j][2 * k + n] = (other.block[k] - m[j].block[k]) / delta;
        }
      }
      std::array<std::array<Long, 2 * stages>, 2 * stages> matrix{};
      std::array<Long, 2 * stages> change{};
      Long largest = 0;  // relative change of any velocity
      const Stages last = y;
      for (std::size_t i = 0; i < stages; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
          Long v = 0;
          for (std::size_t j = 0; j < stages; ++j) {
            const Long weight = h * a[i][j];
            v += weight * m[j].block[k];
            for (std::size_t n = 0; n < 2; ++n)
              matrix[2 * i + k][2 * j + n] = (i == j && k == n) - weight * jacobian[j][2 * k + n];
          }
          change[2 * i + k] = from.v[k] + v - y[i].v[k];
          for (std::size_t f = 0; f < bodies_.floors(k); ++f) {
            Long u = from.u[k][f], rate = from.rate[k][f];
            for (std::size_t j = 0; j < stages; ++j) {
              const Long weight = h * a[i][j];
              u += weight * last[j].rate[k][f];
              rate += weight * (m[j].floor[k][f] - bodies_.ground(k, t + at[j] * h));
            }
            y[i].u[k][f] = u;
            y[i].rate[k][f] = rate;
            largest = std::max(largest, bodies_.omega(k) * std::abs(u - last[i].u[k][f]) +
                                            std::abs(rate - last[i].rate[k][f]));
          }
        }
      }
      Long moves = 0;
      for (const Floors& rate : from.rate)
        for (const Long r : rate) moves = std::max(moves, std::abs(r));
      largest /= h * bodies_.gravity() + moves;
      if (!solve_linear(matrix, change)) return false;
      for (std::size_t i = 0; i < stages; ++i) {
        const Two by{change[2 * i], change[2 * i + 1]};
        const Long rounding = 0.01L * h * bodies_.gravity();
        largest = std::max(largest, length(by) / (length(y[i].v) + rounding));
        y[i].v = {y[i].v[0] + by[0], y[i].v[1] + by[1]};
      }
      if (!(largest < 1e6L)) return false;
      if (largest < 1e-16L) return finish(from, h, y);
    }
    return false;
  }

 private:
  bool guess(Long t, const State& from, Long h, Stages& y) const {
    const bool starts = length(from.v) == 0.0L;
    const Two direction = starts ? bodies_.release_direction(t, from) : from.v;
    const FreeBodies::Motion now = bodies_.contact(t, from, bodies_.friction(direction));
    for (std::size_t i = 0; i < stages; ++i) {
      const Long after = at[i] * h;
      y[i] = from;
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t f = 0; f < bodies_.floors(k); ++f) {
          y[i].u[k][f] += after * from.rate[k][f];
          y[i].rate[k][f] += after * (now.floor[k][f] - bodies_.ground(k, t));
        }
      if (starts) {
        const FreeBodies::Motion then =
            bodies_.contact(t + after, y[i], bodies_.friction(direction));
        const Long gain = dot(direction, then.block);
        if (!(gain > 0.0L)) return false;
        const Long size = 0.5L * after * gain / dot(direction, direction);
        y[i].v = {size * direction[0], size * direction[1]};
      } else {
        y[i].v = {from.v[0] + after * now.block[0], from.v[1] + after * now.block[1]};
        if (!(dot(y[i].v, from.v) > 0.0L)) y[i].v = {0.1L * from.v[0], 0.1L * from.v[1]};
      }
    }
    return true;
  }

  /// Slip at the stages. False if the velocity turns too far from one to the next.
  bool finish(const State& from, Long h, Stages& y) const {
    Two last = from.v;
    for (std::size_t i = 0; i < stages; ++i) {
      if (dot(last, y[i].v) < 0.7L * length(last) * length(y[i].v)) return false;
      last = y[i].v;
      for (std::size_t k = 0; k < 2; ++k) {
        y[i].x[k] = from.x[k];
        for (std::size_t j = 0; j < stages; ++j) y[i].x[k] += h * a[i][j] * y[j].v[k];
      }
    }
    return true;
  }

  const FreeBodies& bodies_;
};

}  // namespace glissade::test
