// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/sample_points.hpp"

#include <algorithm>

#include "glissade/study/cases/case.hpp"
#include "glissade/study/config.hpp"

namespace glissade {
namespace {

/// Coordinates of B are those of other dimensions, of the same points.
constexpr std::uint32_t dimension_of_b = 32;

}  // namespace

std::vector<DrawnFactor> drawn_factors(const StudyConfig& config) {
  std::vector<DrawnFactor> factors;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const bool is_mu = p.table == std::string("friction") &&
                       (p.key == std::string("mu") || p.key == std::string("across_mu"));
    if (config.quantities[i].is_drawn() && (!is_mu || config.samples_friction()))
      factors.push_back({p.words, {p.dimension}});
  }
  const OrientationConfig& o = config.orientation;
  if (o.choice != OrientationChoice::random) return factors;
  DrawnFactor orientation{"orientation", {}};
  if (o.component == ComponentChoice::random) orientation.dimensions.push_back(component_dimension);
  if (o.sign == SignChoice::random) orientation.dimensions.push_back(sign_dimension);
  if (config.two_axes() && o.second_sign == SignChoice::random)
    orientation.dimensions.push_back(second_sign_dimension);
  if (!orientation.dimensions.empty()) factors.push_back(std::move(orientation));
  return factors;
}

SamplePoints::SamplePoints(const StudyConfig& config)
    : points_(config.sampling.method, config.seed),
      samples_(config.draws() ? config.sampling.samples : 1) {
  if (!config.sensitivity) return;
  factors_ = drawn_factors(config);
  matrices_ = factors_.size() + 2;
}

double SamplePoints::coordinate(std::uint64_t sample, std::uint32_t dimension) const {
  const std::uint64_t matrix = sample / samples_;
  const bool from_b =
      matrix == 1 ||
      (matrix > 1 && std::ranges::count(factors_[matrix - 2].dimensions, dimension) > 0);
  return points_.coordinate(sample % samples_, from_b ? dimension + dimension_of_b : dimension);
}

}  // namespace glissade
