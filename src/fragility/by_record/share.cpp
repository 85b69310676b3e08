// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/share.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

/// The records' shares of the histories that exceed, and how many histories each record has.
struct Shares {
  const std::vector<double>&shares, &histories;
  double all = std::accumulate(histories.begin(), histories.end(), 0.0);
  double mean = std::inner_product(shares.begin(), shares.end(), histories.begin(), 0.0) / all;
  double records = effective_number(histories);
};

/// How much smaller the standard error's worth in trials is with few degrees of freedom.
double reduction(double freedom, double level) {
  const double p = 0.5 + 0.5 * level;
  const double ratio = normal_quantile(p) / student_quantile(std::max(1.0, freedom), p);
  return ratio * ratio;
}

double effective_trials(const Shares& of, double level) {
  const auto n = static_cast<double>(of.shares.size());
  double squares = 0.0;
  std::vector<double> exceed, others;
  for (std::size_t i = 0; i < of.shares.size(); ++i) {
    const double departure = of.histories[i] * (of.shares[i] - of.mean);
    squares += departure * departure;
    exceed.push_back(of.histories[i] * of.shares[i]);
    others.push_back(of.histories[i] * (1.0 - of.shares[i]));
  }
  const double trials = of.mean * (1.0 - of.mean) * (of.all * of.all / n) * (n - 1.0) / squares;
  const double freedom =
      std::min({effective_number(exceed), effective_number(others), of.records - 1});
  return std::max(trials * reduction(freedom, level), std::min(trials, of.records));
}

/// The lower end for `successes` of `trials`, which are no whole numbers: with less than one
/// success that of none.
double lower_end(double trials, double successes, double tail) {
  return successes < 1.0 ? 0.0 : binomial_lower_end(trials, successes, tail);
}

}  // namespace

UnitValues::UnitValues(const std::vector<double>& values, const std::vector<std::size_t>& unit_of) {
  GLISSADE_EXPECTS(values.size() == unit_of.size());
  std::map<std::size_t, std::size_t> places;  // by unit, in the order of their first records
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = places.try_emplace(unit_of[i], places.size()).first->second;
    if (at == means.size()) {
      means.push_back(0.0);
      records.push_back(0.0);
    }
    means[at] += values[i];
    ++records[at];
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= records[i];
}

double effective_number(const UnitValues& values) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < values.means.size(); ++i)
    sums.push_back(values.means[i] * values.records[i]);
  return effective_number(sums);
}

double effective_number(const std::vector<double>& parts) {
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  return sum * sum / std::inner_product(parts.begin(), parts.end(), parts.begin(), 0.0);
}

Interval share_interval(const std::vector<double>& shares, double level) {
  return share_interval(UnitValues(shares), level);
}

Interval share_interval(const UnitValues& units, double level) {
  const std::vector<double>& shares = units.means;
  GLISSADE_EXPECTS(level > 0.0 && level < 1.0 && shares.size() == units.records.size());
  if (shares.size() < 2) return {};
  const Shares of{shares, units.records};
  const bool decided = of.mean <= 0.0 || of.mean >= 1.0;
  if (!decided && std::ranges::count(shares, shares.front()) == std::ssize(shares))
    return {of.mean, of.mean};
  const double trials = decided ? of.records : effective_trials(of, level);
  const double tail = 0.5 - 0.5 * level;
  return {lower_end(trials, of.mean * trials, tail),
          1.0 - lower_end(trials, (1.0 - of.mean) * trials, tail)};
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

std::size_t records_that_bound(double probability) {
  return static_cast<std::size_t>(std::ceil(std::log(0.025) / std::log1p(-probability)));
}

Interval widened(const Interval& interval, double probability, double units) {
  const double none = std::pow(0.025, 1.0 / units);
  Interval wide = interval;
  if (std::isnan(interval.low) || std::isnan(interval.high)) wide = {probability, probability};
  if (probability <= 0.5) wide.high = std::max(wide.high, 1.0 - none);
  if (probability >= 0.5) wide.low = std::min(wide.low, none);
  return wide;
}

}  // namespace glissade
