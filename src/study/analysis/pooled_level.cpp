// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/pooled_level.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

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
  std::erase_if(by_record_, [](const std::vector<double>& slips) { return slips.empty(); });
  for (std::vector<double>& slips : by_record_) {
    record_means_.push_back(mean_of(slips));
    std::sort(slips.begin(), slips.end());
  }
  sorted_ = merged(by_record_);
}

double PooledLevel::quantile_m(double probability) const {
  return quantile_of_sorted(sorted_, probability);
}

double PooledLevel::mean_m() const { return mean_of(record_means_); }

double PooledLevel::share_above(double slip_m) const {
  const auto above = sorted_.end() - std::upper_bound(sorted_.begin(), sorted_.end(), slip_m);
  return static_cast<double>(above) / static_cast<double>(sorted_.size());
}

Interval PooledLevel::mean_interval() const { return positive_mean_interval(record_means_); }

Interval PooledLevel::share_interval(double slip_m) const {
  std::vector<double> shares, histories;
  for (const std::vector<double>& slips : by_record_) {
    const auto above = slips.end() - std::upper_bound(slips.begin(), slips.end(), slip_m);
    histories.push_back(static_cast<double>(slips.size()));
    shares.push_back(static_cast<double>(above) / histories.back());
  }
  return glissade::share_interval(shares, histories);
}

Interval PooledLevel::wide_share_interval(double slip_m) const {
  return widened(share_interval(slip_m), share_above(slip_m), by_record_.size());
}

Interval PooledLevel::exceeded_interval(double probability) const {
  const double quantile = quantile_m(1.0 - probability);
  const auto low = std::ranges::partition_point(
      sorted_, [&](double slip_m) { return wide_share_interval(slip_m).low > probability; });
  const auto is_above = [&](double slip_m) {
    return wide_share_interval(slip_m).high > probability;
  };
  // From above, in steps: the upper end of a share's interval need not fall everywhere as slip
  // grows.
  const std::ptrdiff_t step = std::max<std::ptrdiff_t>(1, std::ssize(sorted_) / 512);
  auto begin = sorted_.end(), end = sorted_.end();
  do {
    end = begin;
    begin = end - std::min(step, end - sorted_.begin());
  } while (begin != end && !is_above(*begin));
  const auto high = std::partition_point(begin, end, is_above);
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
