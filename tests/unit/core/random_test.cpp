// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glissade {
namespace {

using Words = std::array<std::uint32_t, 4>;

// Known-answer vectors published with Random123 (Salmon et al. 2011, kat_vectors: philox4x32 10).
TEST(philox, gives_the_published_known_answers) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t f = 0xffffffff;
  EXPECT_EQ(philox4x32({f, f, f, f}, {f, f}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(keyed_uniform, depends_on_every_part_of_its_key) {
  const double u = keyed_uniform(1, RandomPurpose::test, 2, 3);
  EXPECT_EQ(u, keyed_uniform(1, RandomPurpose::test, 2, 3));
  EXPECT_NE(u, keyed_uniform(2, RandomPurpose::test, 2, 3));
  EXPECT_NE(u, keyed_uniform(1, RandomPurpose::bootstrap, 2, 3));
  EXPECT_NE(u, keyed_uniform(1, RandomPurpose::test, 3, 3));
  EXPECT_NE(u, keyed_uniform(1, RandomPurpose::test, 2, 4));
  EXPECT_NE(u, keyed_uniform(1, RandomPurpose::test, 2 + (std::uint64_t{1} << 32), 3));
}

// (2^53 - 1) + 0.5 rounds to 2^53.
TEST(open_uniform, is_never_0_nor_1) {
  EXPECT_EQ(open_uniform(0), 0x1p-54);
  EXPECT_LT(open_uniform((std::uint64_t{1} << 53) - 1), 1.0);
  EXPECT_LE(open_uniform((std::uint64_t{1} << 53) - 2), open_uniform((std::uint64_t{1} << 53) - 1));
}

// Mean and variance of n standard normals: limits at 99.99 % confidence (z = 3.89), fixed seed.
TEST(keyed_normal, has_mean_zero_and_variance_one) {
  constexpr int n = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double x = keyed_normal(7, RandomPurpose::test, i, 0);
    sum += x;
    squares += x * x;
  }
  EXPECT_LT(std::abs(sum / n), 3.89 / std::sqrt(n));
  EXPECT_LT(std::abs(squares / n - 1), 3.89 * std::sqrt(2.0 / n));
}

}  // namespace
}  // namespace glissade
