// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "glissade/building/mode_rules.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

// The textbook coefficients (Chopra, Dynamics of Structures, table 5.2.1) in 50 digits, where their
// cancellation does no harm.
struct Textbook {
  Real A, B, C, D, A1, B1, C1, D1;  // u1 = A u0 + B v0 + C p0 + D p1, with p = -a and unit mass
  Textbook(const Real& w, const Real& z, const Real& dt) {
    // Beyond critical damping sine and cosine become hyperbolic.
    const Real k = w * w, root = sqrt(abs(1 - z * z)), wd = w * root, e = exp(-z * w * dt),
               s = z < 1 ? sin(wd * dt) : sinh(wd * dt), c = z < 1 ? cos(wd * dt) : cosh(wd * dt);
    A = e * (z / root * s + c);
    B = e * (s / wd);
    C = (2 * z / (w * dt) +
         e * (((1 - 2 * z * z) / (wd * dt) - z / root) * s - (1 + 2 * z / (w * dt)) * c)) /
        k;
    D = (1 - 2 * z / (w * dt) + e * ((2 * z * z - 1) / (wd * dt) * s + 2 * z / (w * dt) * c)) / k;
    A1 = -e * (w / root * s);
    B1 = e * (c - z / root * s);
    C1 = (-1 / dt + e * ((w / root + z / (dt * root)) * s + c / dt)) / k;
    D1 = (1 - e * (z / root * s + c)) / (k * dt);
  }
};

TEST(oscillator_step, has_the_textbook_coefficients_to_1e_13_for_any_step) {
  for (const double phase : {1e-6, 1e-3, 0.0157, 0.3, 0.999, 1.001, 3.0, 40.0}) {
    for (const double zeta : {0.0, 0.02, 0.05, 0.3, 0.9, 1.0, 1.5, 20.0}) {
      const Real w = 2, dt = Real(phase) / w;  // omega = 2 rad/s
      const Textbook t(w, zeta == 1.0 ? Real("1.0000000000000001") : Real(zeta), dt);
      const OscillatorStep s = oscillator_step(phase, zeta);
      const auto near = [&](double got, const Real& want) {
        EXPECT_NEAR(got, static_cast<double>(want),
                    std::max(1e-13 * std::max(std::abs(static_cast<double>(want)), 1e-3 * phase),
                             zeta < 1 ? 0.0 : 1e-14))
            << "phase " << phase << " zeta " << zeta;
      };
      near(s.xx, t.A);
      near(s.xy, t.B * w);  // x = w^2 u, y = w v
      near(-s.xy, t.A1 / w);
      near(s.yy, t.B1);
      near(s.x_start, t.C * w * w);
      near(s.x_end, t.D * w * w);
      near(s.y_start, t.C1 * w);
      near(s.y_end, t.D1 * w);
    }
  }
}

TEST(roof_motion, passes_unchanged_through_a_rigid_building) {
  const std::vector<double> a = {0.1, 0.5, -0.7, 0.2}, w = {0.0, 0.2, 0.1, -0.3};
  const RoofMotion roof = roof_motion({0.01, a, w}, Building{}, {.quiet_horizontal_mps2 = 1e-3});
  EXPECT_EQ(roof.horizontal_mps2, a);
  EXPECT_EQ(roof.vertical_mps2, w);
  EXPECT_EQ(roof.dt_s, 0.01);
  EXPECT_EQ(roof.peak_horizontal_mps2, 0.7);
}

TEST(roof_motion, does_not_depend_on_how_finely_it_is_sampled) {
  const std::vector<double> a = {0.0, 1.0, -2.0, 3.0, 0.5, -1.0};
  const Building building{.horizontal = {0.3, 0.05}};
  const RoofMotion coarse = roof_motion({0.02, a}, building, {.steps_per_period = 1});
  const RoofMotion fine = roof_motion({0.02, a}, building, {.steps_per_period = 60});
  EXPECT_EQ(coarse.dt_s, 0.02);
  EXPECT_EQ(fine.dt_s, 0.005);
  for (std::size_t i = 0; i < coarse.horizontal_mps2.size(); ++i) {
    EXPECT_NEAR(fine.horizontal_mps2[4 * i], coarse.horizontal_mps2[i], 1e-13);
  }
}

/// Each mode by itself, times its participation, and the ground for those that are left out.
TEST(roof_motion, of_modes_is_the_sum_of_their_motions) {
  const std::vector<double> a = {0.2, 1.0, -2.0, 3.0, 0.5, -1.0};
  const std::vector<Mode> modes{{0.5, 1.3, 0.8, 0.05}, {0.2, -0.4, 0.1, 0.02}};
  const double dt_s = 0.02;
  const auto motion = [&](const Modes& building) {
    return roof_motion({dt_s, a}, building, {}, {.steps_per_period = 1}).horizontal_mps2;
  };
  const std::vector<double> roof = motion(Modes(modes)), first = motion(modes[0].oscillator()),
                            second = motion(modes[1].oscillator());
  ASSERT_EQ(roof.size(), a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(roof[i], 1.3 * first[i] - 0.4 * second[i] + 0.1 * a[i], 1e-14);
}

TEST(roof_motion, rings_down_until_it_is_quiet_and_no_longer) {
  const std::vector<double> a = {0.0, 3.0, -3.0, 3.0, -3.0, 3.0};
  const RoofMotion roof =
      roof_motion({0.05, a}, {.horizontal = {0.5, 0.05}}, {.quiet_horizontal_mps2 = 0.01});
  const auto& r = roof.horizontal_mps2;
  const std::size_t period = static_cast<std::size_t>(std::lround(0.5 / roof.dt_s));
  const auto loudest = [&](std::size_t from, std::size_t to) {
    double largest = 0;
    for (std::size_t i = from; i < to; ++i) largest = std::max(largest, std::abs(r[i]));
    return largest;
  };
  EXPECT_LT(std::abs(r.back()), 0.01);
  EXPECT_GT(loudest(r.size() - 3 * period, r.size()), 0.005);  // not followed far beyond need
  const RoofMotion none = roof_motion({0.05, a}, {.horizontal = {0.5, 0.05}}, {});
  EXPECT_EQ(none.horizontal_mps2.size(),
            5 * static_cast<std::size_t>(std::lround(0.05 / roof.dt_s)) + 1);
  const RoofMotion undamped =
      roof_motion({0.05, a}, {.horizontal = {0.4, 0.0}},
                  {.quiet_horizontal_mps2 = 0.01, .longest_ring_down_s = 10});
  EXPECT_NEAR(static_cast<double>(undamped.horizontal_mps2.size()) * undamped.dt_s, 10.3, 0.1);
}

TEST(roof_motion, is_padded_to_one_length_when_the_vertical_rings_longer) {
  const std::vector<double> a = {0.0, 1.0, 2.0}, w = {0.0, 1.0, -1.0};
  const RoofMotion roof = roof_motion({0.05, a, w}, {.vertical = {0.5, 0.05}},
                                      {.quiet_vertical_mps2 = 0.01, .steps_per_period = 40});
  ASSERT_EQ(roof.horizontal_mps2.size(), roof.vertical_mps2.size());
  const std::size_t parts = static_cast<std::size_t>(std::lround(0.05 / roof.dt_s));
  EXPECT_EQ(parts, 4u);
  EXPECT_EQ(roof.horizontal_mps2[2 * parts], 2.0);
  EXPECT_EQ(roof.horizontal_mps2[2 * parts + 2],
            1.0);  // on its way to zero over one interval of the record
  EXPECT_EQ(roof.horizontal_mps2[3 * parts], 0.0);
}

}  // namespace
}  // namespace glissade
