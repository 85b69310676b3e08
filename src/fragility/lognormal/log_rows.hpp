// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade::fragility {

/// What is known at one y: the weight of histories that exceed there, and of those that do not.
struct CutWeight {
  double exceeding = 0.0, held = 0.0;

  double trials() const { return exceeding + held; }
};

/// Capacities that are known exactly: their weight, the sums of y and its square, the range of y.
struct ExactRows {
  double count = 0.0, sum = 0.0, sum_squares = 0.0;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
};

/// Rows in y = ln x - center, summed where they say the same. The center only conditions the
/// numbers.
struct LogRows {
  double center = 0.0;
  ExactRows exact;
  std::map<double, CutWeight> cuts;  ///< by y: counts, and brackets open on a side
  std::map<std::pair<double, double>, double> between;  ///< weights by both ends

  void add_counts(double y, double exceeding, double held);
  void add_bracket(double low, double high, double weight);
  void scale(double factor);
  LogRows& operator+=(const LogRows& other);

  bool has_only_cuts() const { return exact.count == 0 && between.empty(); }
  /// Every capacity is known exactly.
  bool is_exact() const { return exact.count > 0 && cuts.empty() && between.empty(); }
  double highest_low() const;  ///< that a history has not exceeded; -infinity: none
  double lowest_high() const;  ///< that a history has exceeded; infinity: none
  Interval range() const;      ///< of all ends
};

double mean_log(const std::vector<double>& values);  ///< 0 if there are none

}  // namespace glissade::fragility
