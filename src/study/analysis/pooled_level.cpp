// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/pooled_level.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

constexpr std::size_t bins = 512;

// An infinite slip (beyond the largest threshold, not run) has its place among the others, but
// differences of two have none: resampling takes a number above all that happens for it.
constexpr double stand_in = 1e100;
double finite(double value) { return std::isinf(value) ? stand_in : value; }
double infinite(double value) { return value > 1e-3 * stand_in ? infinity : value; }

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The values of sorted lists, sorted.
std::vector<double> merged(const std::vector<std::vector<double>>& lists) {
  std::vector<double> all;
  std::size_t count = 0;
  for (const std::vector<double>& list : lists) count += list.size();
  all.reserve(count);
  std::vector<std::ptrdiff_t> ends{0};
  for (const std::vector<double>& list : lists) {
    all.insert(all.end(), list.begin(), list.end());
    ends.push_back(static_cast<std::ptrdiff_t>(all.size()));
  }
  for (std::size_t step = 1; step < lists.size(); step *= 2) {
    for (std::size_t i = 0; i + step < lists.size(); i += 2 * step)
      std::inplace_merge(all.begin() + ends[i], all.begin() + ends[i + step],
                         all.begin() + ends[std::min(i + 2 * step, lists.size())]);
  }
  return all;
}

}  // namespace

PooledLevel::PooledLevel(std::vector<std::vector<double>> slips_m)
    : by_record_(std::move(slips_m)) {
  for (std::vector<double>& slips : by_record_) {
    record_means_.push_back(mean_of(slips));
    std::sort(slips.begin(), slips.end());
  }
  sorted_ = merged(by_record_);
  for (std::size_t bin = 1; bin <= bins; ++bin)
    bin_edges_.push_back(sorted_[(sorted_.size() * bin - 1) / bins]);
  for (const std::vector<double>& slips : by_record_) {
    std::vector<double> cumulative;
    for (const double edge : bin_edges_) {
      cumulative.push_back(
          static_cast<double>(std::upper_bound(slips.begin(), slips.end(), edge) - slips.begin()));
    }
    record_cumulative_.push_back(std::move(cumulative));
  }
}

double PooledLevel::quantile_m(double probability) const {
  return quantile_of_sorted(sorted_, probability);
}

double PooledLevel::mean_m() const { return mean_of(record_means_); }

double PooledLevel::share_above(double slip_m) const {
  const auto above = sorted_.end() - std::upper_bound(sorted_.begin(), sorted_.end(), slip_m);
  return static_cast<double>(above) / static_cast<double>(sorted_.size());
}

Interval PooledLevel::quantile_interval(double probability, const BootstrapOptions& options) const {
  Interval interval = bootstrap_interval(
      by_record_.size(),
      [&](const std::vector<double>& weights) {
        const auto count_up_to = [&](std::size_t bin) {
          double count = 0.0;
          for (std::size_t record = 0; record < weights.size(); ++record) {
            count += weights[record] * record_cumulative_[record][bin];
          }
          return count;
        };
        const double drawn = count_up_to(bins - 1), wanted = probability * drawn;
        if (drawn == 0.0) return std::numeric_limits<double>::quiet_NaN();
        std::size_t low = 0, high = bins - 1;  // the first bin that holds the wanted count
        while (low < high) {
          const std::size_t middle = (low + high) / 2;
          if (count_up_to(middle) >= wanted) {
            high = middle;
          } else {
            low = middle + 1;
          }
        }
        return finite(bin_edges_[low]);
      },
      options);
  // The bins' quantile may be one rank from the estimate.
  interval.low = std::min(infinite(interval.low), quantile_m(probability));
  interval.high = std::max(infinite(interval.high), quantile_m(probability));
  return interval;
}

Interval PooledLevel::mean_interval(const BootstrapOptions& options) const {
  if (std::isinf(mean_m())) return {};  // no interval
  return bootstrap_interval(
      record_means_.size(),
      [&](const std::vector<double>& weights) {
        return std::inner_product(weights.begin(), weights.end(), record_means_.begin(), 0.0) /
               static_cast<double>(weights.size());
      },
      options);
}

Interval PooledLevel::share_interval(double slip_m) const {
  std::vector<double> shares;
  for (const std::vector<double>& slips : by_record_) {
    const auto above = slips.end() - std::upper_bound(slips.begin(), slips.end(), slip_m);
    shares.push_back(static_cast<double>(above) / static_cast<double>(slips.size()));
  }
  return glissade::share_interval(shares);
}

Interval PooledLevel::wide_share_interval(double slip_m) const {
  return widened(share_interval(slip_m), share_above(slip_m), by_record_.size());
}

Interval PooledLevel::exceeded_interval(double probability) const {
  const double quantile = quantile_m(1.0 - probability);
  const auto low = std::ranges::partition_point(
      sorted_, [&](double slip_m) { return wide_share_interval(slip_m).low > probability; });
  // From above: the upper end of a share's interval need not fall everywhere as slip grows.
  auto high = sorted_.end();
  while (high != sorted_.begin() && wide_share_interval(*std::prev(high)).high <= probability)
    --high;
  return {low == sorted_.end() ? quantile : std::min(*low, quantile),
          high == sorted_.end() ? infinity : std::max(*high, quantile)};
}

PooledLevel pooled_at(const HistoryTable& histories, CaseSlice cases, std::size_t level,
                      HistoryValues<double> HistoryFields::*field) {
  std::vector<std::vector<double>> slips;
  for (std::size_t record = 0; record < histories.records; ++record) {
    if (!histories.has(record, level)) continue;
    slips.emplace_back().reserve(cases.count);
    for (std::size_t i = 0; i < cases.count; ++i)
      slips.back().push_back(
          (histories.fields.*field)[histories.at(record, cases.first + i, level)]);
  }
  return PooledLevel(std::move(slips));
}

}  // namespace glissade
