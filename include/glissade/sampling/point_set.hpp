// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glissade {

enum class SamplingMethod { sobol, monte_carlo };

/// Points in the open unit cube. A coordinate belongs to (seed, sample, dimension) alone: not to
/// the number of samples, not to which other dimensions are used, not to a rank. sobol: Joe & Kuo
/// (2008) direction numbers (Boost.Random's), point 0 kept, each dimension with its own nested
/// uniform scramble of 32 bits (Owen 1995), made on the fly from hashes. Use a power of two of
/// samples; replicate with different seeds for intervals. monte_carlo: Philox.
class PointSet {
 public:
  PointSet(SamplingMethod method, std::uint64_t seed);
  /// @param sample < 2^32, @param dimension < 64
  double coordinate(std::uint64_t sample, std::uint32_t dimension) const;

 private:
  SamplingMethod method_;
  std::uint64_t seed_;
};

/// Unscrambled Sobol coordinate in [0, 1), exact in double, points in Gray-code order (Antonov &
/// Saleev 1980) with point 0 at the origin: the reference the scrambled points are made from.
/// @param dimension < 64
double sobol_coordinate(std::uint32_t sample, std::uint32_t dimension);

}  // namespace glissade
