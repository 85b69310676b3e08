// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "glissade/core/random.hpp"
#include "glissade/motion/response_spectrum.hpp"
#include "simd_targets.hpp"

namespace glissade {
namespace {

TEST(pseudo_acceleration, has_the_same_bits_on_every_simd_target) {
  std::vector<double> motion, periods_s;
  for (std::uint32_t i = 0; i < 900; ++i)
    motion.push_back(keyed_normal(7, RandomPurpose::motion_noise, 0, i));
  for (int k = 0; k < 21; ++k) periods_s.push_back(0.004 * std::exp(0.33 * k));
  const auto expected = pseudo_acceleration_spectrum(0.01, motion, periods_s);
  test::on_each_target(
      [&] { EXPECT_EQ(pseudo_acceleration_spectrum(0.01, motion, periods_s), expected); });
}

}  // namespace
}  // namespace glissade
