// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "glissade/fragility/shape.hpp"
#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

/// Left out: no record.
inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Capacities by threshold and record, summed once.
class SurfaceData {
 public:
  explicit SurfaceData(const ShapeData& data);
  /// With its intervals where no record is left out.
  std::optional<FragilitySurface> fit(std::size_t without = none) const;

 private:
  void add_intervals(const Eigen::VectorXd& point, const Eigen::MatrixXd& information,
                     FragilitySurface& surface) const;

  std::vector<double> thresholds_m_;
  std::vector<std::vector<LogRows>> by_threshold_;  // [threshold][record]
};

/// Non-decreasing shares with the greatest likelihood of k of n (pooled adjacent violators).
std::vector<double> monotone_shares(const std::map<double, CutWeight>& levels);

}  // namespace glissade::fragility
