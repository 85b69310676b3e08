// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <vector>

#include "glissade/core/random.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

void use_targets(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(pseudo_acceleration, has_the_same_bits_on_every_simd_target) {
  std::vector<double> motion, periods_s;
  for (std::uint32_t i = 0; i < 900; ++i)
    motion.push_back(keyed_normal(7, RandomPurpose::motion_noise, 0, i));
  for (int k = 0; k < 21; ++k) periods_s.push_back(0.004 * std::exp(0.33 * k));
  const auto expected = pseudo_acceleration_spectrum(0.01, motion, periods_s);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    use_targets(target);
    ASSERT_EQ(hwy::SupportedTargets(), target);  // it is the one that runs
    EXPECT_EQ(pseudo_acceleration_spectrum(0.01, motion, periods_s), expected)
        << hwy::TargetName(target);
  }
  use_targets(0);
}

}  // namespace
}  // namespace glissade
