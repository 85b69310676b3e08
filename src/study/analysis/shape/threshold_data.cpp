// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/shape/threshold_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "glissade/study/cases/case_scene.hpp"

namespace glissade {

namespace {

/// Whether two records are one motion: all that is known of it as recorded is the same.
bool is_same_motion(const RecordSummary& a, const RecordSummary& b) {
  const auto known = [](const RecordSummary& r) {
    return std::tuple(r.pga_g, r.pgv_mps, r.pgd_m, r.duration_s, r.dt_s, r.samples);
  };
  return known(a) == known(b);
}

/// By record: its independent unit. Of multiple stripes without events its motion, named by the
/// first record that is it.
std::vector<std::size_t> stripe_units(const Results& results) {
  const HistoryTable& table = results.histories;
  std::vector<std::size_t> units;
  for (std::size_t record = 0; record < table.records; ++record) {
    std::size_t first = table.unit(record);
    if (results.by_stripes && table.unit_of.empty()) {
      first = 0;
      while (!is_same_motion(results.records[first], results.records[record])) ++first;
    }
    units.push_back(first);
  }
  return units;
}

}  // namespace

std::vector<Bracket> capacities_of(const HistoryTable& histories,
                                   const std::vector<std::size_t>& cases, std::size_t threshold,
                                   double highest_level) {
  std::vector<Bracket> rows;
  for (std::size_t record = 0; record < histories.records; ++record)
    for (const std::size_t i : cases) {
      const double capacity = histories.capacity(record, i, threshold);
      rows.push_back({std::min(capacity, highest_level), capacity, 1.0, record});
    }
  return rows;
}

std::vector<std::size_t> all_of(CaseSlice cases) {
  std::vector<std::size_t> all(cases.count);
  std::iota(all.begin(), all.end(), cases.first);
  return all;
}

std::vector<Bracket> capacities_of(const Results& results, CaseSlice cases, std::size_t threshold) {
  return capacities_of(results.histories, all_of(cases), threshold, results.levels.back());
}

std::vector<Bracket> by_unit(std::vector<Bracket> rows, const HistoryTable& histories) {
  for (Bracket& row : rows) row.record = histories.unit(row.record);
  return rows;
}

std::vector<Stripe> stripes_of(const Results& results, const std::vector<std::size_t>& cases,
                               std::size_t threshold) {
  const HistoryTable& table = results.histories;
  const auto needs_shaking = [&](std::size_t record, std::size_t i) {
    return results.by_stripes ? !slides_freely(results.cases.cases[i])
                              : table.capacity(record, i, threshold) > 0.0;
  };
  const std::vector<std::size_t> units = stripe_units(results);
  // By unit: its records at each stripe. Those at the one with the most have all of its histories.
  std::map<std::size_t, std::map<std::size_t, std::size_t>> records_at;
  std::map<std::size_t, std::size_t> most;
  std::vector<Stripe> rows;
  for (std::size_t record = 0; record < table.records; ++record) {
    std::vector<std::size_t> others;  // than those that slide freely
    for (const std::size_t i : cases)
      if (needs_shaking(record, i)) others.push_back(i);
    const auto trials = static_cast<double>(others.size()),
               free = static_cast<double>(cases.size()) - trials;
    const std::size_t unit = units[record],
                      at =
                          ++records_at[unit][table.stripe_of.empty() ? 0 : table.stripe_of[record]];
    if (at > most[unit]) {
      most[unit] = at;
      rows.push_back({0.0, free, free, 1.0, unit});
    }
    for (std::size_t level = 0; level < results.levels.size(); ++level) {
      if (!table.has(record, level)) continue;
      const auto exceed = std::ranges::count_if(others, [&](std::size_t i) {
        return table.displacement_m(record, i, level) >= results.thresholds_m[threshold];
      });
      rows.push_back({results.levels[level], trials, static_cast<double>(exceed), 1.0, unit});
    }
  }
  return rows;
}

namespace {

/// By unit and level; empty where a displacement is not known.
std::vector<std::vector<SlipSums>> slips_of(const Results& results, CaseSlice cases) {
  const HistoryTable& table = results.histories;
  std::vector<SlipSums> none;
  for (const double level : results.levels) none.push_back({.intensity = level});
  std::vector<std::vector<SlipSums>> slips(table.units(), none);
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t level = 0; level < table.levels; ++level) {
      SlipSums& sums = slips[table.unit(record)][level];
      for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
        if (slides_freely(results.cases.cases[i])) continue;
        const double displacement_m = table.displacement_m(record, i, level);
        if (std::isinf(displacement_m)) return {};
        sums.add(displacement_m);
      }
    }
  }
  return slips;
}

}  // namespace

ShapeData shape_data(const Results& results, CaseSlice cases) {
  ShapeData data{.intensities = results.levels,
                 .thresholds_m = results.thresholds_m,
                 .slips = slips_of(results, cases)};
  for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
    data.stripes.push_back(stripes_of(results, all_of(cases), t));
    data.capacities.push_back(by_unit(capacities_of(results, cases, t), results.histories));
  }
  return data;
}

}  // namespace glissade
