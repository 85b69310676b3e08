// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/share.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

/// How many shares a sum effectively has: n if all are equal, 1 if one is all of it.
double contributing(const std::vector<double>& shares, double (*of)(double)) {
  double sum = 0.0, squares = 0.0;
  for (const double share : shares) {
    sum += of(share);
    squares += of(share) * of(share);
  }
  return sum * sum / squares;
}

/// How much smaller the standard error's worth in trials is with few degrees of freedom.
double reduction(double freedom, double level) {
  const double p = 0.5 + 0.5 * level;
  const double ratio = normal_quantile(p) / student_quantile(std::max(1.0, freedom), p);
  return ratio * ratio;
}

double effective_trials(const std::vector<double>& shares, double mean, double level) {
  const double n = static_cast<double>(shares.size());
  double squares = 0.0;
  for (const double share : shares) squares += (share - mean) * (share - mean);
  const double trials = mean * (1.0 - mean) * n * (n - 1.0) / squares;
  const double freedom = std::min({contributing(shares, [](double p) { return p; }),
                                   contributing(shares, [](double p) { return 1.0 - p; }), n - 1});
  return std::max(trials * reduction(freedom, level), std::min(trials, n));
}

/// The lower end for `successes` of `trials`, which are no whole numbers: with less than one
/// success that of none.
double lower_end(double trials, double successes, double tail) {
  return successes < 1.0 ? 0.0 : binomial_lower_end(trials, successes, tail);
}

}  // namespace

Interval share_interval(const std::vector<double>& shares, double level) {
  GLISSADE_EXPECTS(level > 0.0 && level < 1.0);
  if (shares.size() < 2) return {};
  const double n = static_cast<double>(shares.size());
  const double mean = std::accumulate(shares.begin(), shares.end(), 0.0) / n;
  const bool decided = mean <= 0.0 || mean >= 1.0;
  if (!decided && std::ranges::count(shares, shares.front()) == std::ssize(shares))
    return {mean, mean};
  const double trials = decided ? n : effective_trials(shares, mean, level);
  const double tail = 0.5 - 0.5 * level;
  return {lower_end(trials, mean * trials, tail),
          1.0 - lower_end(trials, (1.0 - mean) * trials, tail)};
}

void order_intervals(const std::vector<double>& shares, std::vector<Interval>& intervals) {
  GLISSADE_EXPECTS(shares.size() == intervals.size());
  std::vector<std::size_t> order;  // a share without an interval keeps none
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (!std::isnan(intervals[i].low)) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return shares[i]; });
  double high = 0.0, low = 1.0;
  for (const std::size_t i : order) high = intervals[i].high = std::fmax(intervals[i].high, high);
  std::ranges::reverse(order);
  for (const std::size_t i : order) low = intervals[i].low = std::fmin(intervals[i].low, low);
}

Interval widened(const Interval& interval, double probability, std::size_t records) {
  const double none = std::pow(0.025, 1.0 / static_cast<double>(records));
  Interval wide = interval;
  if (std::isnan(interval.low) || std::isnan(interval.high)) wide = {probability, probability};
  if (probability <= 0.5) wide.high = std::max(wide.high, 1.0 - none);
  if (probability >= 0.5) wide.low = std::min(wide.low, none);
  return wide;
}

}  // namespace glissade
