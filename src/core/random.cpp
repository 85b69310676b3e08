// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/random.hpp"

#include <algorithm>

#include "glissade/core/normal.hpp"

namespace glissade {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t multiplier0 = 0xD2511F53u, multiplier1 = 0xCD9E8D57u;
  constexpr std::uint32_t weyl0 = 0x9E3779B9u, weyl1 = 0xBB67AE85u;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = multiplier0 * counter[0];
    const std::uint64_t product1 = multiplier1 * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key[0] += weyl0;
    key[1] += weyl1;
  }
  return counter;
}

double open_uniform(std::uint64_t part) {
  return std::min((static_cast<double>(part) + 0.5) * 0x1p-53, 1.0 - 0x1p-53);
}

double keyed_uniform(std::uint64_t seed, RandomPurpose purpose, std::uint64_t item,
                     std::uint32_t index) {
  const auto word =
      philox4x32({static_cast<std::uint32_t>(item), static_cast<std::uint32_t>(item >> 32), index,
                  static_cast<std::uint32_t>(purpose)},
                 {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return open_uniform((std::uint64_t{word[0]} << 32 | word[1]) >> 11);
}

double keyed_normal(std::uint64_t seed, RandomPurpose purpose, std::uint64_t item,
                    std::uint32_t index) {
  return normal_quantile(keyed_uniform(seed, purpose, item, index));
}

}  // namespace glissade
