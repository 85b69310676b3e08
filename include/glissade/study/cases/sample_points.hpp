// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glissade/sampling/point_set.hpp"

namespace glissade {

struct StudyConfig;

/// What varies from sample to sample as one: a quantity, or the orientation.
struct DrawnFactor {
  std::string name;                       ///< "friction", "orientation"
  std::vector<std::uint32_t> dimensions;  ///< of the unit cube
};
/// In the order of parameters(), the orientation last.
std::vector<DrawnFactor> drawn_factors(const StudyConfig& config);

/// The points of a study's samples. A study with [sensitivity] has those of the pick-freeze
/// matrices A, B, and for each factor A with that factor of B, one matrix after the other; each
/// coordinate is one of A or of B, so that a matrix is a matter of identities.
class SamplePoints {
 public:
  explicit SamplePoints(const StudyConfig& config);
  std::uint64_t count() const { return matrices_ * samples_; }
  double coordinate(std::uint64_t sample, std::uint32_t dimension) const;

 private:
  PointSet points_;
  std::uint64_t samples_;  ///< of a matrix
  std::uint64_t matrices_ = 1;
  std::vector<DrawnFactor> factors_;
};

}  // namespace glissade
