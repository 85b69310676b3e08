// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "glissade/motion/motion.hpp"

// Roofs of a building by other means than the library's: full matrices, without modes, and closed
// forms. A model of a frame as an engineer's program would have it, for suites of roof motions.
namespace glissade::test {

/// A shear frame with the same damping ratio in every mode, C = 2 zeta M (M^-1 K)^(1/2).
class ShearFrame {
 public:
  /// @param masses_kg, stiffnesses_npm from the ground up
  ShearFrame(const std::vector<double>& masses_kg, const std::vector<double>& stiffnesses_npm,
             double damping)
      : floors_(static_cast<Eigen::Index>(masses_kg.size())), roof_floor_kg_(masses_kg.back()) {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(floors_, floors_);
    for (Eigen::Index i = 0; i < floors_; ++i) {
      const double k_below = stiffnesses_npm[static_cast<std::size_t>(i)];
      k(i, i) += k_below;
      if (i == 0) continue;
      k(i - 1, i - 1) += k_below;
      k(i, i - 1) = k(i - 1, i) = -k_below;
    }
    for (Eigen::Index i = 0; i < floors_; ++i) k.row(i) /= masses_kg[static_cast<std::size_t>(i)];
    stiffness_ = k;
    damping_ = 2.0 * damping * square_root(k);
  }

  /// Absolute acceleration of the roof at `parts` instants of a sample of the ground, which is
  /// linear between its samples and zero after them; with a time of free vibration.
  std::vector<double> roof_mps2(double dt_s, std::span<const double> ground_mps2, int parts,
                                double free_s) const {
    // (u, v, a_g, rate of a_g)' is linear in itself: its exponential is exact over a part.
    const Eigen::Index n = floors_, size = 2 * n + 2;
    Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(size, size);
    rate.block(0, n, n, n).setIdentity();
    rate.block(n, 0, n, n) = -stiffness_;
    rate.block(n, n, n, n) = -damping_;
    rate.block(n, 2 * n, n, 1).setConstant(-1.0);
    rate(2 * n, 2 * n + 1) = 1.0;
    const double part_s = dt_s / parts;
    const Eigen::MatrixXd step = exponential(part_s * rate);

    Eigen::VectorXd state = Eigen::VectorXd::Zero(size);
    std::vector<double> roof;
    const auto sample = [&](std::size_t i) {
      return i < ground_mps2.size() ? ground_mps2[i] : 0.0;
    };
    const auto samples = ground_mps2.size() + static_cast<std::size_t>(free_s / dt_s);
    for (std::size_t i = 0; i < samples; ++i) {
      state[2 * n] = sample(i);
      state[2 * n + 1] = (sample(i + 1) - sample(i)) / dt_s;
      for (int part = 0; part < parts; ++part) {
        const double forces = (stiffness_ * state.head(n) + damping_ * state.segment(n, n))[n - 1];
        roof.push_back(-forces);
        state = step * state;
      }
    }
    return roof;
  }

  /// Steady displacement of the roof, relative to a ground of a harmonic of 1 m/s2, with more mass
  /// on the roof.
  double roof_amplitude_m(double omega_radps, double roof_mass_kg) const {
    Eigen::VectorXd mass = Eigen::VectorXd::Ones(floors_);  // over that of the floor
    mass[floors_ - 1] += roof_mass_kg / roof_floor_kg_;
    const Eigen::MatrixXcd dynamic = stiffness_ +
                                     std::complex<double>(0.0, omega_radps) * damping_ -
                                     omega_radps * omega_radps * Eigen::MatrixXd(mass.asDiagonal());
    return std::abs(dynamic.lu().solve(mass.cast<std::complex<double>>())[floors_ - 1]);
  }

 private:
  /// Taylor's series of a small matrix.
  static Eigen::MatrixXd exponential(const Eigen::MatrixXd& a) {
    Eigen::MatrixXd term = Eigen::MatrixXd::Identity(a.rows(), a.cols()), sum = term;
    for (int k = 1; k < 30; ++k) {
      term = term * a / k;
      sum += term;
    }
    return sum;
  }
  /// Denman & Beavers (1976).
  static Eigen::MatrixXd square_root(const Eigen::MatrixXd& a) {
    const double scale = a.norm();
    Eigen::MatrixXd y = a / scale, z = Eigen::MatrixXd::Identity(a.rows(), a.cols());
    for (int i = 0; i < 30; ++i) {
      const Eigen::MatrixXd next = 0.5 * (y + z.inverse());
      z = 0.5 * (z + y.inverse());
      y = next;
    }
    return std::sqrt(scale) * y;
  }

  Eigen::Index floors_;
  double roof_floor_kg_;
  Eigen::MatrixXd stiffness_, damping_;  ///< per mass
};

/// The suite of its roofs under the motions of another, both horizontals on the same frame.
inline Suite roofs_of(const ShearFrame& frame, const Suite& ground, int parts, double free_s) {
  Suite roofs = ground;
  roofs.of_roof = true;
  roofs.target.reset();
  for (Motion& m : roofs.motions) {
    for (auto& component : m.horizontal_mps2)
      component = frame.roof_mps2(m.dt_s, component, parts, free_s);
    m.vertical_mps2 = std::vector<double>();
    m.dt_s /= parts;
  }
  return roofs;
}

/// A mode of N equal storeys of mass m and stiffness k, from 1 (closed form of the chain with one
/// free end): w = 2 sqrt(k/m) sin(a/2), phi_i = sin(i a), a = (2 j - 1) pi / (2 N + 1).
struct ChainMode {
  double omega_radps = 0.0, participation = 0.0, mass_share = 0.0;  ///< at the roof

  ChainMode(int storeys, int j, double mass_kg, double stiffness_npm) {
    const double a = (2 * j - 1) * std::numbers::pi / (2 * storeys + 1);
    double sum = 0.0, squares = 0.0;
    for (int i = 1; i <= storeys; ++i) {
      sum += std::sin(i * a);
      squares += std::sin(i * a) * std::sin(i * a);
    }
    omega_radps = 2.0 * std::sqrt(stiffness_npm / mass_kg) * std::sin(0.5 * a);
    participation = sum / squares * std::sin(storeys * a);
    mass_share = sum * sum / squares / storeys;
  }

  /// D'' + a_g of a ground that is linear between its samples: closed form in each interval.
  std::vector<double> acceleration_mps2(double dt_s, std::span<const double> ground_mps2, int parts,
                                        double free_s, double damping) const {
    const double w = omega_radps, z = damping, wd = w * std::sqrt(1.0 - z * z);
    const auto sample = [&](std::size_t i) {
      return i < ground_mps2.size() ? ground_mps2[i] : 0.0;
    };
    double d = 0.0, v = 0.0;
    std::vector<double> all;
    const auto samples = ground_mps2.size() + static_cast<std::size_t>(free_s / dt_s);
    for (std::size_t i = 0; i < samples; ++i) {
      // -a_g = p + q t has the particular solution c + b t.
      const double p = -sample(i), q = -(sample(i + 1) - sample(i)) / dt_s;
      const double b = q / (w * w), c = (p - 2.0 * z * w * b) / (w * w);
      const double s = d - c, r = (v - b + z * w * s) / wd;
      for (int part = 0; part <= parts; ++part) {
        const double t = dt_s * part / parts, decay = std::exp(-z * w * t);
        const double wave = decay * (s * std::cos(wd * t) + r * std::sin(wd * t));
        const double turned = decay * (r * std::cos(wd * t) - s * std::sin(wd * t));
        d = wave + c + b * t;
        v = -z * w * wave + wd * turned + b;
        if (part < parts) all.push_back(-2.0 * z * w * v - w * w * d);
      }
    }
    return all;
  }
};

}  // namespace glissade::test
