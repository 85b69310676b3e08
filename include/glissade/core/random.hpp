// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace glissade {

/// Philox4x32-10, a counter-based generator (Salmon, Moraes, Dror & Shaw 2011, "Parallel random
/// numbers: as easy as 1, 2, 3", SC11): a number depends on its key and counter, not on a sequence,
/// so any rank can draw any number in any order. Passes the published known-answer vectors.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// Purpose of a random number. Streams of different purpose never share a number.
enum class RandomPurpose : std::uint32_t {
  sample_point = 1,    ///< plain Monte Carlo points
  sobol_scramble = 2,  ///< scrambling of Sobol points
  motion_noise = 3,    ///< the white noise of simulated motions
  motion_parameters = 4,
  bootstrap = 5,
  design_life = 6,       ///< earthquakes of a design life
  target_spectra = 7,    ///< spectra of a target, which selected records resemble
  goodness_of_fit = 11,  ///< capacities of a null model
  test = 99,
};

/// The middle of the given of 2^53 equal parts of (0, 1); the last is below 1 in rounding too.
double open_uniform(std::uint64_t part);

/// A uniform number in the open interval (0, 1), 53 bits, keyed by its purpose.
double keyed_uniform(std::uint64_t seed, RandomPurpose purpose, std::uint64_t item,
                     std::uint32_t index);

/// A standard normal number by inversion (accuracy of Boost.Math's quantile: a few ulp).
double keyed_normal(std::uint64_t seed, RandomPurpose purpose, std::uint64_t item,
                    std::uint32_t index);

}  // namespace glissade
