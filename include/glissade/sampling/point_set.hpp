// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glissade {

enum class SamplingMethod { sobol, monte_carlo };

/// Points in the open unit cube. A coordinate depends on (seed, sample, dimension) only: not on the
/// number of samples, the other dimensions or the rank. sobol: Joe & Kuo (2008) direction numbers
/// (from Boost.Random), with point 0, and a separate nested uniform scramble of 32 bits for each
/// dimension (Owen 1995), computed from hashes. The number of samples should be a power of two;
/// replicate with different seeds for intervals. monte_carlo: Philox.
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
/// Saleev 1980) with point 0 at the origin: the basis of the scrambled points.
/// @param dimension < 64
double sobol_coordinate(std::uint32_t sample, std::uint32_t dimension);

}  // namespace glissade
