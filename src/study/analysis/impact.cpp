// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/impact.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/pooled_level.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

/// With fewer units that reach it the scatter between them is not estimated.
constexpr std::ptrdiff_t fewest_units = 3;

/// Whether a history did not converge, so that it counts as beyond every threshold.
bool is_unknown(const HistoryTable& all, std::size_t history) {
  const auto& failed = all.fields.failed;
  return !failed.empty() && failed[history] != 0 &&
         std::isinf(all.fields.peak_displacement_m[history]);
}

/// The crossings of one threshold at one level that happen, by independent unit. Of a history that
/// did not converge the speed is unknown, and counted as above every other, and the time is left
/// out.
struct Happened {
  std::vector<std::vector<double>> time_s, speed_mps;
  std::vector<double> reached;  ///< by record: how many histories

  Happened(const HistoryTable& all, CaseSlice cases, std::size_t level, std::size_t threshold)
      : time_s(all.units()), speed_mps(all.units()), reached(all.records) {
    for (std::size_t record = 0; record < all.records; ++record) {
      const std::size_t unit = all.unit(record);
      for (std::size_t i = 0; i < cases.count; ++i) {
        const std::size_t history = all.at(record, cases.first + i, level),
                          at = history * all.thresholds + threshold;
        if (std::isnan(all.fields.crossing_time_s[at])) {
          if (!is_unknown(all, history)) continue;
          speed_mps[unit].push_back(infinity);
          ++reached[record];
          continue;
        }
        ++reached[record];
        time_s[unit].push_back(all.fields.crossing_time_s[at]);
        speed_mps[unit].push_back(all.fields.crossing_speed_mps[at]);
      }
    }
  }

  std::ptrdiff_t units() const {
    return std::ranges::count_if(speed_mps, [](const auto& speeds) { return !speeds.empty(); });
  }
};

std::vector<double> sorted_together(const std::vector<std::vector<double>>& by_unit) {
  std::vector<double> all;
  for (const std::vector<double>& values : by_unit)
    all.insert(all.end(), values.begin(), values.end());
  std::ranges::sort(all);
  return all;
}

ImpactStatistics statistics_of(const HistoryTable& all, const Happened& happened,
                               std::size_t samples) {
  const std::vector<double> times = sorted_together(happened.time_s),
                            speeds = sorted_together(happened.speed_mps);
  const std::size_t histories = all.records * samples;
  ImpactStatistics s;
  s.reached_share.value = static_cast<double>(speeds.size()) / static_cast<double>(histories);
  s.speed_p16_mps = quantile_of_sorted(speeds, 0.16);
  s.speed_median_mps.value = quantile_of_sorted(speeds, 0.5);
  s.speed_p84_mps.value = quantile_of_sorted(speeds, 0.84);
  s.speed_p95_mps = quantile_of_sorted(speeds, 0.95);
  s.speed_largest_mps = quantile_of_sorted(speeds, 1.0);
  s.time_median_s = quantile_of_sorted(times, 0.5);
  s.time_p16_s = quantile_of_sorted(times, 0.16);
  s.time_p84_s = quantile_of_sorted(times, 0.84);
  if (happened.units() < fewest_units) return s;
  std::vector<double> shares = happened.reached;
  for (double& share : shares) share /= static_cast<double>(samples);
  if (speeds.size() < histories) s.reached_share.interval = share_interval(all.by_unit(shares));
  const PooledLevel pooled(happened.speed_mps);
  s.speed_median_mps.interval = pooled.exceeded_interval(0.5);
  s.speed_p84_mps.interval = pooled.exceeded_interval(0.16);
  return s;
}

}  // namespace

std::vector<ImpactStatistics> impact_statistics(const HistoryTable& histories, CaseSlice cases,
                                                std::span<const double> levels,
                                                std::span<const double> thresholds_m) {
  GLISSADE_EXPECTS(histories.records > 0 && cases.count > 0);
  std::vector<ImpactStatistics> all(thresholds_m.size() * levels.size());
  in_parallel(all.size(), [&](std::size_t i) {
    const std::size_t t = i / levels.size(), l = i % levels.size();
    all[i] = statistics_of(histories, Happened(histories, cases, l, t), cases.count);
    all[i].level = levels[l];
    all[i].threshold_m = thresholds_m[t];
  });
  return all;
}

}  // namespace glissade
