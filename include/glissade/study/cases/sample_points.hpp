// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "glissade/sampling/point_set.hpp"

namespace glissade {

struct Case;
struct StudyConfig;

/// What varies from sample to sample as one: a quantity, or the orientation.
struct DrawnFactor {
  std::string name;                          ///< "friction", "orientation"
  std::vector<std::uint32_t> dimensions;     ///< of the unit cube
  std::function<double(const Case&)> value;  ///< cases with one value have the same factor
};
/// In the order of parameters(), the orientation last.
std::vector<DrawnFactor> drawn_factors(const StudyConfig& config);

/// The dimensions of drawn quantities without a bound on one side: those that [rare] widens.
std::vector<std::uint32_t> unbounded_dimensions(const StudyConfig& config);

/// The points of a study's samples. A study with [sensitivity] has those of the pick-freeze
/// matrices A, B, and for each factor A with that factor of B, one matrix after the other; each
/// coordinate is one of A or of B, so that a matrix is a matter of identities. The samples of a
/// matrix are in blocks of equal size, each with a scrambling (or seed) of its own; the first has
/// that of the study. In a study with [rare] the coordinates of unbounded quantities are widened.
class SamplePoints {
 public:
  explicit SamplePoints(const StudyConfig& config);
  std::uint64_t count() const { return matrices_ * samples_; }
  double coordinate(std::uint64_t sample, std::uint32_t dimension) const;
  double weight(std::uint64_t sample) const;  ///< 1 without [rare]

 private:
  double drawn(std::uint64_t sample, std::uint32_t dimension) const;

  std::vector<PointSet> blocks_;
  std::uint64_t samples_;  ///< of a matrix
  std::vector<std::uint32_t> widened_;
  double widening_ = 1.0;
  std::uint64_t matrices_ = 1;
  std::vector<DrawnFactor> factors_;
};

}  // namespace glissade
