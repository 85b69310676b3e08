// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/clusters.hpp"

#include <cmath>
#include <map>

#include "by_record/sandwich.hpp"

namespace glissade::fragility {

Clusters::Clusters(const std::vector<std::size_t>& records, const std::vector<double>& weights) {
  check_weights(weights);
  std::map<std::size_t, Eigen::Index> known;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (weights[i] == 0) {
      of_row_.push_back(-1);
      continue;
    }
    const auto [at, is_new] = known.emplace(records[i], static_cast<Eigen::Index>(known.size()));
    of_row_.push_back(at->second);
  }
  weight_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(known.size()));
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (of_row_[i] >= 0) weight_[of_row_[i]] += weights[i];
  }
}

double Clusters::effective() const { return effective_number(weight_); }

void check_weights(const std::vector<double>& weights) {
  double sum = 0;
  for (const double weight : weights) {
    if (!(weight >= 0 && std::isfinite(weight)))
      throw InputError(
          {"weights", std::to_string(weight) + " is not a weight", "give 0 or more", ""});
    sum += weight;
  }
  if (!weights.empty() && sum == 0)
    throw InputError({"weights", "all of them are 0", "give at least one above 0", ""});
}

}  // namespace glissade::fragility
