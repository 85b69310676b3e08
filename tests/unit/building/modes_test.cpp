// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/modes.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "closed_forms/cantilever.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

constexpr double pi = std::numbers::pi;

TEST(cantilever_modes, are_those_of_a_hundred_digits) {
  for (const double alpha : {0.5, 2.0, 10.0, 30.0}) {
    const std::vector<Mode> modes = cantilever_modes(1.0, alpha, 5);
    const closed_forms::Cantilever reference(alpha);
    for (int n = 0; n < 5; ++n) {
      SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", mode " << n + 1);
      const Mode expected = reference.mode(n), found = modes[static_cast<std::size_t>(n)];
      EXPECT_NEAR(found.period_s, expected.period_s, 1e-12);
      EXPECT_NEAR(found.participation, expected.participation, 2e-8);  // Simpson's error
      EXPECT_NEAR(found.mass_share, expected.mass_share, 2e-8);
    }
  }
}

TEST(cantilever_modes, of_flexure_alone_are_the_classical_beam) {
  // cos(gamma) cosh(gamma) = -1 (Chopra 2017, section 17.1).
  const std::vector<Mode> modes = cantilever_modes(1.0, 0.0, 3);
  const double gamma[] = {1.8751040687119611, 4.6940911329741746, 7.8547574382376126};
  for (int n = 0; n < 3; ++n)
    EXPECT_NEAR(modes[static_cast<std::size_t>(n)].period_s, std::pow(gamma[0] / gamma[n], 2),
                1e-12);
  EXPECT_NEAR(modes[0].participation, 1.5660, 5e-5);
  EXPECT_NEAR(modes[0].mass_share, 0.6131, 5e-5);
}

TEST(cantilever_modes, of_much_shear_are_the_uniform_shear_beam) {
  const std::vector<Mode> modes = cantilever_modes(1.0, largest_alpha, 4);
  for (int n = 0; n < 4; ++n) {
    const double odd = 2 * n + 1, sign = n % 2 == 0 ? 1 : -1;
    const Mode& mode = modes[static_cast<std::size_t>(n)];
    EXPECT_NEAR(mode.period_s, 1 / odd, 1e-3);
    EXPECT_NEAR(mode.participation, sign * 4 / (pi * odd), 4e-3);
    EXPECT_NEAR(mode.mass_share, 8 / (pi * pi * odd * odd), 2e-3);
  }
}

TEST(cantilever_modes, of_all_modes_have_the_whole_mass_and_the_ground_s_motion) {
  for (const double alpha : {0.0, 3.0, 40.0}) {
    const std::vector<Mode> modes = cantilever_modes(1.0, alpha, 60);
    double participation = 0.0;
    for (const Mode& mode : modes) participation += mode.participation;
    EXPECT_NEAR(mass_of(modes), 1.0, 0.02) << alpha;
    // The terms alternate and fall as 1/n: half of the last is what is missing.
    EXPECT_NEAR(participation - 0.5 * modes.back().participation, 1.0, 1e-3) << alpha;
  }
}

TEST(shear_building_modes, of_equal_storeys_are_those_in_closed_form) {
  constexpr int storeys = 6;
  const std::vector<double> masses(storeys, 3.0), stiffnesses(storeys, 700.0);
  const std::vector<Mode> modes = shear_building_modes(masses, stiffnesses);
  ASSERT_EQ(modes.size(), 6u);
  for (int n = 0; n < storeys; ++n) {
    const double omega =
        2 * std::sqrt(700.0 / 3.0) * std::sin((2 * n + 1) * pi / (4 * storeys + 2));
    EXPECT_NEAR(modes[static_cast<std::size_t>(n)].period_s, 2 * pi / omega, 1e-12);
  }
}

/// The modes' sum is the building: its static response to a force on the array's floor, and its
/// response to a harmonic ground motion, as the full matrices give them.
TEST(shear_building_modes, superposed_are_the_full_matrices) {
  const std::vector<double> masses{4.0, 3.0, 2.5, 1.0}, stiffnesses{900.0, 800.0, 500.0, 300.0};
  const std::vector<Mode> modes = shear_building_modes(masses, stiffnesses);
  Eigen::Matrix4d k = Eigen::Matrix4d::Zero();
  Eigen::Vector4d m(masses.data());
  for (int i = 0; i < 4; ++i) {
    k(i, i) += stiffnesses[static_cast<std::size_t>(i)];
    if (i > 0) {
      k(i - 1, i - 1) += stiffnesses[static_cast<std::size_t>(i)];
      k(i, i - 1) = k(i - 1, i) = -stiffnesses[static_cast<std::size_t>(i)];
    }
  }
  const Eigen::Vector4d force = Eigen::Vector4d::Unit(3);
  double by_modes = 0.0, participation = 0.0;
  for (const Mode& mode : modes) {
    const double omega = 2 * pi / mode.period_s;
    // gamma^2 F / (e M omega^2)
    by_modes +=
        mode.participation * mode.participation / (mode.mass_share * m.sum() * omega * omega);
    participation += mode.participation;
  }
  EXPECT_NEAR(by_modes, k.llt().solve(force)[3], 1e-14);
  EXPECT_NEAR(participation, 1.0, 1e-13);
  EXPECT_NEAR(mass_of(modes), 1.0, 1e-13);
  for (const double omega : {1.0, 7.0, 15.0}) {
    const Eigen::Matrix4d dynamic = k - omega * omega * Eigen::Matrix4d(m.asDiagonal());
    const double roof = dynamic.lu().solve(Eigen::Vector4d(-m))[3];
    double sum = 0.0;
    for (const Mode& mode : modes) {
      const double omega_n = 2 * pi / mode.period_s;
      sum -= mode.participation / (omega_n * omega_n - omega * omega);
    }
    EXPECT_NEAR(sum, roof, 1e-12 * std::abs(roof) + 1e-14) << omega;
  }
}

TEST(shear_building_modes, refuse_storeys_without_mass_or_stiffness) {
  const std::vector<double> one{1.0}, two{1.0, 1.0}, zero{1.0, 0.0};
  EXPECT_THROW(shear_building_modes({}, {}), InputError);
  EXPECT_THROW(shear_building_modes(one, two), InputError);
  EXPECT_THROW(shear_building_modes(two, zero), InputError);
  EXPECT_THROW(shear_building_modes(zero, two), InputError);
}

TEST(governing_modes, carry_95_percent_or_are_slow_enough_and_are_six_at_most) {
  // Uniform shear: 81, 90, 93.3, 95.0 %.
  const std::vector<double> ones(40, 1.0);
  EXPECT_EQ(governing_modes(shear_building_modes(ones, ones)).size(), 4u);
  EXPECT_EQ(governing_modes(cantilever_modes(9.0, 0.0, 20)).size(), 6u);
  EXPECT_EQ(governing_modes(cantilever_modes(0.2, 0.0, 20)).size(), 1u);  // 0.2, 0.032 s
  EXPECT_EQ(governing_modes(cantilever_modes(0.01, 0.0, 20)).size(), 1u);
}

TEST(governing_modes, are_those_with_the_largest_mass_shares) {
  std::vector<Mode> modes;
  for (const double period_s : {0.9, 0.8, 0.7, 0.6, 0.5, 0.4})
    modes.push_back({period_s, 0.01, 1e-4});
  modes.push_back({0.3, 1.2, 0.8});
  modes.push_back({0.2, -0.2, 0.16});
  modes.push_back({0.04, 0.1, 0.03});
  const std::vector<Mode> governing = governing_modes(modes);
  ASSERT_EQ(governing.size(), 3u);  // the first, and 96 % of the mass
  EXPECT_EQ(governing[0].period_s, 0.9);
  EXPECT_EQ(governing[1].period_s, 0.3);
  EXPECT_EQ(governing[2].period_s, 0.2);
}

}  // namespace
}  // namespace glissade
