// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/pooled_level.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"

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

PooledLevel::PooledLevel(std::vector<std::vector<double>> slips_m, double units)
    : by_unit_(std::move(slips_m)) {
  std::erase_if(by_unit_, [](const std::vector<double>& slips) { return slips.empty(); });
  std::size_t most = 0;
  for (const std::vector<double>& slips : by_unit_) most = std::max(most, slips.size());
  for (std::vector<double>& slips : by_unit_) {
    means_.means.push_back(mean_of(slips));
    means_.records.push_back(static_cast<double>(slips.size()) / static_cast<double>(most));
    std::sort(slips.begin(), slips.end());
  }
  units_ = units > 0.0 ? units : static_cast<double>(by_unit_.size());
  sorted_ = merged(by_unit_);
}

double PooledLevel::quantile_m(double probability) const {
  return quantile_of_sorted(sorted_, probability);
}

double PooledLevel::mean_m() const {
  const auto& [means, parts] = means_;
  return std::inner_product(means.begin(), means.end(), parts.begin(), 0.0) /
         std::accumulate(parts.begin(), parts.end(), 0.0);
}

double PooledLevel::share_above(double slip_m) const {
  const auto above = sorted_.end() - std::upper_bound(sorted_.begin(), sorted_.end(), slip_m);
  return static_cast<double>(above) / static_cast<double>(sorted_.size());
}

Interval PooledLevel::mean_interval() const { return positive_mean_interval(means_); }

Interval PooledLevel::share_interval(double slip_m) const {
  UnitValues shares;
  for (const std::vector<double>& slips : by_unit_) {
    const auto above = slips.end() - std::upper_bound(slips.begin(), slips.end(), slip_m);
    shares.records.push_back(static_cast<double>(slips.size()));
    shares.means.push_back(static_cast<double>(above) / shares.records.back());
  }
  return glissade::share_interval(shares);
}

Interval PooledLevel::wide_share_interval(double slip_m) const {
  return widened(share_interval(slip_m), share_above(slip_m), units_);
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
  std::map<std::size_t, std::size_t> places;  // by unit
  for (std::size_t record = 0; record < histories.records; ++record) {
    if (!histories.has(record, level)) continue;
    const std::size_t at = places.try_emplace(histories.unit(record), slips.size()).first->second;
    if (at == slips.size()) slips.emplace_back();
    std::vector<double>& of_unit = slips[at];
    of_unit.reserve(of_unit.size() + cases.count);
    for (std::size_t i = 0; i < cases.count; ++i)
      of_unit.push_back((histories.fields.*field)[histories.at(record, cases.first + i, level)]);
  }
  std::vector<double> sizes;
  for (const std::vector<double>& of_unit : slips)
    sizes.push_back(static_cast<double>(of_unit.size() / cases.count));
  return PooledLevel(std::move(slips), effective_number(sizes));
}

}  // namespace glissade
