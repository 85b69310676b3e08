// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "glissade/core/error.hpp"

namespace glissade::fragility {

/// Throws InputError for a weight below 0 or not finite, and where all are 0.
void check_weights(const std::vector<double>& weights);

/// The records that have weight, numbered from 0, and which one each row belongs to.
class Clusters {
 public:
  Clusters(const std::vector<std::size_t>& records, const std::vector<double>& weights);
  Eigen::Index count() const { return weight_.size(); }
  bool has(std::size_t row) const { return of_row_[row] >= 0; }
  Eigen::Index of(std::size_t row) const { return of_row_[row]; }
  double effective() const;  ///< (sum W)^2 / sum W^2 over the records' weights

 private:
  std::vector<Eigen::Index> of_row_;  // -1: without weight
  Eigen::VectorXd weight_;
};

}  // namespace glissade::fragility
