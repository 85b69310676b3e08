// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/core/error.hpp"
#include "glissade/fragility/fit.hpp"

namespace glissade::fragility {

/// Throw InputError listing every row that breaks its rule.
void check(const std::vector<Stripe>& rows);
void check(const std::vector<Bracket>& rows);

/// Throws InputError for a weight below 0 or not finite, and where all are 0.
template <class Row>
void check_weights(const std::vector<Row>& rows) {
  double sum = 0;
  for (const Row& row : rows) {
    if (!(row.weight >= 0 && std::isfinite(row.weight)))
      throw InputError(
          {"weights", std::to_string(row.weight) + " is not a weight", "give 0 or more", ""});
    sum += row.weight;
  }
  if (!rows.empty() && sum == 0)
    throw InputError({"weights", "all of them are 0", "give at least one above 0", ""});
}

/// The unit of weights: the largest. Divided by it their sums of squares and fourths are finite.
template <class Row>
double largest_weight(const std::vector<Row>& rows) {
  double largest = 0;
  for (const Row& row : rows) largest = std::max(largest, row.weight);
  return largest;
}

}  // namespace glissade::fragility
