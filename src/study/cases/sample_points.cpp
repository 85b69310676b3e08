// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/sample_points.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/sampling/importance.hpp"
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
      factors.push_back({p.words, {p.dimension}, [&p](const Case& c) { return value_of(p, c); }});
  }
  const OrientationConfig& o = config.orientation;
  if (o.choice != OrientationChoice::random) return factors;
  DrawnFactor orientation{"orientation", {}, [](const Case& c) {
                            return c.orientation.across_sign *
                                   (360.0 + c.orientation.ground_azimuth_deg);
                          }};
  if (o.component == ComponentChoice::random) orientation.dimensions.push_back(component_dimension);
  if (o.sign == SignChoice::random) orientation.dimensions.push_back(sign_dimension);
  if (config.two_axes() && o.second_sign == SignChoice::random)
    orientation.dimensions.push_back(second_sign_dimension);
  if (!orientation.dimensions.empty()) factors.push_back(std::move(orientation));
  return factors;
}

std::vector<std::uint32_t> unbounded_dimensions(const StudyConfig& config) {
  std::vector<std::uint32_t> dimensions;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    if (!config.quantities[i].is_drawn()) continue;
    const Support range = support(*config.quantities[i].drawn);
    if (std::isinf(range.min) || std::isinf(range.max))
      dimensions.push_back(parameters()[i].dimension);
  }
  return dimensions;
}

SamplePoints::SamplePoints(const StudyConfig& config)
    : samples_(config.draws() ? config.sampling.samples : 1) {
  // The golden ratio of 2^64: seeds of neighbouring studies and blocks do not meet.
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15u;
  const std::uint64_t blocks = config.draws() ? config.sampling.scrambles : 1;
  for (std::uint64_t block = 0; block < blocks; ++block)
    blocks_.emplace_back(config.sampling.method, config.seed + block * step);
  if (config.rare) {
    widening_ = config.rare->widening;
    widened_ = unbounded_dimensions(config);
  }
  if (!config.sensitivity) return;
  factors_ = drawn_factors(config);
  matrices_ = factors_.size() + 2;
}

double SamplePoints::drawn(std::uint64_t sample, std::uint32_t dimension) const {
  const std::uint64_t matrix = sample / samples_, k = sample % samples_;
  const bool from_b =
      matrix == 1 ||
      (matrix > 1 && std::ranges::count(factors_[matrix - 2].dimensions, dimension) > 0);
  const std::uint64_t size = samples_ / blocks_.size();
  return blocks_[k / size].coordinate(k % size, from_b ? dimension + dimension_of_b : dimension);
}

double SamplePoints::coordinate(std::uint64_t sample, std::uint32_t dimension) const {
  const double u = drawn(sample, dimension);
  return std::ranges::count(widened_, dimension) > 0 ? widened_coordinate(u, widening_).u : u;
}

double SamplePoints::weight(std::uint64_t sample) const {
  double weight = 1.0;
  for (const std::uint32_t dimension : widened_)
    weight *= widened_coordinate(drawn(sample, dimension), widening_).weight;
  return weight;
}

}  // namespace glissade
