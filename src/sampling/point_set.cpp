// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/point_set.hpp"

#include <array>
#include <boost/random/sobol.hpp>

#include "glissade/core/contract.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace {

constexpr std::uint32_t dimensions = 64;
constexpr std::uint32_t bits = 32;
using DirectionNumbers = std::array<std::array<std::uint32_t, bits>, dimensions>;

/// Point n is the exclusive or of the direction numbers at the bits of its Gray code n ^ n/2, so
/// that point 2^(k+1) - 1, whose Gray code is 2^k, is direction number k itself. The engine of
/// Boost skips point 0: seeded with n it continues with point n + 1.
DirectionNumbers direction_numbers_from_boost() {
  DirectionNumbers numbers{};
  boost::random::sobol_engine<std::uint32_t, bits> engine(dimensions);
  for (std::uint32_t k = 0; k < bits; ++k) {
    engine.seed(static_cast<std::uint32_t>((std::uint64_t{2} << k) - 2));
    for (auto& of_dimension : numbers) of_dimension[k] = engine();
  }
  return numbers;
}

std::uint32_t sobol_bits(std::uint32_t sample, std::uint32_t dimension) {
  static const DirectionNumbers numbers = direction_numbers_from_boost();
  std::uint32_t point = 0;
  std::uint32_t gray = sample ^ (sample >> 1);
  for (std::uint32_t k = 0; gray != 0; ++k, gray >>= 1) {
    if ((gray & 1) != 0) point ^= numbers[dimension][k];
  }
  return point;
}

/// The finalizer of SplitMix64 (Steele, Lea & Flood 2014): every input bit flips every output bit
/// with a probability near one half.
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Nested uniform scramble (Owen 1995): a bit is flipped or not by a random bit that depends on the
/// bits above it. The cell of a bit is those bits behind a leading 1, which distinguishes the cells
/// of different depths.
std::uint32_t owen_scramble(std::uint32_t point, std::uint64_t key) {
  std::uint32_t scrambled = point;
  for (std::uint32_t bit = 0; bit < bits; ++bit) {
    const std::uint64_t cell = (std::uint64_t{1} << bits | point) >> (bit + 1);
    scrambled ^= static_cast<std::uint32_t>(mix(mix(cell) ^ key) >> 63) << bit;
  }
  return scrambled;
}

std::uint64_t scramble_key(std::uint64_t seed, std::uint32_t dimension) {
  const auto word =
      philox4x32({dimension, 0, 0, static_cast<std::uint32_t>(RandomPurpose::sobol_scramble)},
                 {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return std::uint64_t{word[0]} << 32 | word[1];
}

}  // namespace

PointSet::PointSet(SamplingMethod method, std::uint64_t seed) : method_(method), seed_(seed) {}

double PointSet::coordinate(std::uint64_t sample, std::uint32_t dimension) const {
  GLISSADE_EXPECTS(sample >> bits == 0);
  GLISSADE_EXPECTS(dimension < dimensions);
  if (method_ == SamplingMethod::monte_carlo) {
    return keyed_uniform(seed_, RandomPurpose::sample_point, sample, dimension);
  }
  const std::uint32_t point = sobol_bits(static_cast<std::uint32_t>(sample), dimension);
  return (owen_scramble(point, scramble_key(seed_, dimension)) + 0.5) * 0x1p-32;
}

double sobol_coordinate(std::uint32_t sample, std::uint32_t dimension) {
  GLISSADE_EXPECTS(dimension < dimensions);
  return sobol_bits(sample, dimension) * 0x1p-32;
}

}  // namespace glissade
