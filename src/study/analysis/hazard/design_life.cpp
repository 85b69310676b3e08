// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hazard/design_life.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/random.hpp"
#include "glissade/study/cases/case_scene.hpp"

namespace glissade {
namespace {

constexpr std::array life_quantities = {LifeQuantity::single, LifeQuantity::accumulated,
                                        LifeQuantity::farthest};
constexpr std::array probabilities = {0.5, 0.84, 0.95};
/// Of the distribution over lives; most have no slip.
constexpr std::array distribution_at = {0.01, 0.05,  0.1,  0.25,   0.5,   0.75,   0.84,
                                        0.9,  0.92,  0.94, 0.95,   0.96,  0.97,   0.975,
                                        0.98, 0.985, 0.99, 0.9925, 0.995, 0.9975, 0.999};

/// An earthquake: between two levels of its history, under a record yet to be picked.
struct Event {
  std::size_t level;  ///< the lower one; the highest: beyond it
  double share;       ///< of the way to the next
  double record;      ///< uniform
};

/// All earthquakes of every life, the same in every resample of the records.
struct Lives {
  std::vector<Event> events;
  std::vector<std::size_t> end;  ///< of each life, in `events`
};

Lives draw_lives(const HazardCurve& hazard, const std::vector<double>& levels, std::size_t first,
                 double events_per_life, std::size_t count, std::uint64_t seed) {
  const double highest = hazard.annual_rate(levels.back()), all = hazard.annual_rate(levels[first]);
  Lives lives;
  for (std::size_t life = 0; life < count; ++life) {
    std::uint32_t index = 0;
    const auto uniform = [&] {
      return keyed_uniform(seed, RandomPurpose::design_life, life, index++);
    };
    // Waiting times of a Poisson process, in lives.
    for (double t = -std::log(uniform()) / events_per_life; t <= 1.0;
         t -= std::log(uniform()) / events_per_life) {
      const double rate = all * uniform(), record = uniform();
      if (rate <= highest) {
        lives.events.push_back({levels.size() - 1, 0.0, record});
        continue;
      }
      const double x = hazard.intensity_at(rate);
      const auto above = std::upper_bound(levels.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                                          levels.end() - 1, x);
      const auto level = static_cast<std::size_t>(above - levels.begin()) - 1;
      const double share = (x - levels[level]) / (levels[level + 1] - levels[level]);
      lives.events.push_back({level, std::clamp(share, 0.0, 1.0), record});
    }
    lives.end.push_back(lives.events.size());
  }
  return lives;
}

struct Slip {
  double peak_m, along_m, across_m;
};

class LifeModel {
 public:
  LifeModel(const Results& results, CaseSlice cases)
      : results_(results), table_(results.histories), cases_(cases) {}

  /// Largest single peak, accumulated and farthest distance of each life, by LifeQuantity.
  /// @param weights of the records
  std::array<std::vector<double>, 3> slips_m(const Lives& lives, std::size_t count,
                                             const std::vector<double>& weights) const {
    std::vector<double> cumulative(weights.size());
    std::partial_sum(weights.begin(), weights.end(), cumulative.begin());
    std::array<std::vector<double>, 3> slips;
    std::size_t event = 0;
    for (std::size_t life = 0; life < count; ++life) {
      const std::size_t c = cases_.first + life % cases_.count;
      // Without any earthquake, if it slides freely.
      double along = slides_freely(results_.cases.cases[c]) ? infinity : 0.0;
      double across = 0.0, largest = along, farthest = along;
      for (; event < lives.end[life]; ++event) {
        const Event& e = lives.events[event];
        const auto drawn = std::upper_bound(cumulative.begin(), cumulative.end() - 1,
                                            e.record * cumulative.back());
        const Slip slip = slip_in(e, static_cast<std::size_t>(drawn - cumulative.begin()), c);
        largest = std::max(largest, slip.peak_m);
        farthest = std::max(farthest, std::hypot(along, across) + slip.peak_m);
        along += slip.along_m;
        across += slip.across_m;
      }
      const double at_end = std::hypot(along, across);
      slips[0].push_back(largest);
      slips[1].push_back(at_end);
      slips[2].push_back(std::max(farthest, at_end));
    }
    for (std::vector<double>& values : slips) std::sort(values.begin(), values.end());
    return slips;
  }

 private:
  Slip at_level(std::size_t record, std::size_t c, std::size_t level) const {
    const std::size_t at = table_.at(record, c, level);
    const HistoryFields& f = table_.fields;
    const double peak = f.peak_displacement_m[at];
    if (std::isinf(peak)) return {infinity, infinity, 0.0};
    if (f.residual_along_m.empty()) return {peak, peak, 0.0};
    return {peak, f.residual_along_m[at], f.residual_across_m[at]};
  }

  Slip slip_in(const Event& e, std::size_t record, std::size_t c) const {
    if (e.level + 1 == table_.levels) return {infinity, infinity, 0.0};
    const Slip low = at_level(record, c, e.level), high = at_level(record, c, e.level + 1);
    if (std::isinf(low.peak_m) || std::isinf(high.peak_m)) return {infinity, infinity, 0.0};
    const auto between = [&](double Slip::*of) {
      return (1.0 - e.share) * low.*of + e.share * high.*of;
    };
    return {between(&Slip::peak_m), between(&Slip::along_m), between(&Slip::across_m)};
  }

  const Results& results_;
  const HistoryTable& table_;
  CaseSlice cases_;
};

double moving_share(const HistoryTable& table, CaseSlice cases, std::size_t level) {
  double moving = 0.0;
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t i = 0; i < cases.count; ++i)
      moving += table.displacement_m(record, cases.first + i, level) > 0.0 ? 1.0 : 0.0;
  }
  return moving / static_cast<double>(table.records * cases.count);
}

using Percentiles = std::array<std::array<double, 3>, 3>;  // by quantity, then probability

Percentiles percentiles_of(const std::array<std::vector<double>, 3>& slips) {
  Percentiles all;
  for (std::size_t q = 0; q < slips.size(); ++q) {
    for (std::size_t p = 0; p < probabilities.size(); ++p)
      all[q][p] = quantile_of_sorted(slips[q], probabilities[p]);
  }
  return all;
}

}  // namespace

void add_design_life(const HazardConfig& hazard, const Results& results, CaseSlice cases,
                     const BootstrapOptions& options, HazardRun& run) {
  constexpr double most_events = 2e6, most_of_a_life = 2000;
  constexpr std::size_t most_lives = 500000, fewest_lives = 1000, resampled_lives = 20000;
  const std::vector<double>& levels = results.levels;
  std::size_t first = 0;  // the highest level up to which nothing moves
  while (first + 1 < levels.size() && moving_share(results.histories, cases, first) == 0.0 &&
         moving_share(results.histories, cases, first + 1) == 0.0)
    ++first;
  const auto events = [&] {
    return hazard.design_life_years * hazard.curve.annual_rate(levels[first]);
  };
  while (first + 1 < levels.size() && events() > most_of_a_life) ++first;
  run.from_intensity = levels[first];
  run.moving_share = moving_share(results.histories, cases, first);
  run.events = std::min(events(), most_of_a_life);
  const auto count = static_cast<std::size_t>(std::clamp(most_events / run.events,
                                                         static_cast<double>(fewest_lives),
                                                         static_cast<double>(most_lives)));
  const Lives lives = draw_lives(hazard.curve, levels, first, run.events, count, options.seed);
  const LifeModel model(results, cases);
  const HistoryTable& table = results.histories;
  const auto slips = model.slips_m(lives, count, std::vector<double>(table.records, 1.0));
  const Percentiles found = percentiles_of(slips);
  for (std::size_t q = 0; q < life_quantities.size(); ++q)
    for (const double p : distribution_at)
      run.life_distribution.push_back({life_quantities[q], p, quantile_of_sorted(slips[q], p)});
  // One resample gives all percentiles.
  std::map<std::vector<double>, Percentiles> of_weights;
  const auto resampled = [&](const std::vector<double>& weights) -> const Percentiles& {
    const auto [at, is_new] = of_weights.try_emplace(weights);
    if (is_new)
      at->second = percentiles_of(
          model.slips_m(lives, std::min(count, resampled_lives), table.record_weights(weights)));
    return at->second;
  };
  BootstrapOptions few = options;
  few.replicates = std::min(options.replicates, 200);
  for (std::size_t q = 0; q < life_quantities.size(); ++q) {
    std::array<Estimate, 3> life;
    for (std::size_t p = 0; p < probabilities.size(); ++p) {
      life[p].value = found[q][p];
      if (std::isinf(found[q][p]) || run.moving_share > 0.0) continue;  // no interval
      const Interval interval = bootstrap_interval(
          table.units(),
          [&](const std::vector<double>& weights) { return resampled(weights)[q][p]; }, few);
      // Fewer lives in a resample: the estimate may be a rank outside.
      life[p].interval = {std::min(interval.low, found[q][p]),
                          std::max(interval.high, found[q][p])};
    }
    run.life.push_back({life_quantities[q], life[0], life[1], life[2]});
  }
}

}  // namespace glissade
