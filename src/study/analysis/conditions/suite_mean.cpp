// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/conditions/suite_mean.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/random.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// Dense rows x columns x depth, last index fastest.
struct Array3 {
  std::size_t rows = 0, columns = 0, depth = 0;
  std::vector<double> data;
  Array3() = default;
  Array3(std::size_t r, std::size_t c, std::size_t d)
      : rows(r), columns(c), depth(d), data(r * c * d) {}
  double& operator()(std::size_t i, std::size_t j, std::size_t k) {
    return data[(i * columns + j) * depth + k];
  }
  double operator()(std::size_t i, std::size_t j, std::size_t k) const {
    return data[(i * columns + j) * depth + k];
  }
};

/// What a mean is taken of: the number of each (period, orientation, record) a question is about.
class Values {
 public:
  Values(const Results& results, const MeanQuestion& question, const Condition& at, Periods periods)
      : records_(records_of(results, question.suite)),
        orientations_(orientations_of(results, question)) {
    for (const std::size_t record : records_) units_.push_back(results.histories.unit(record));
    const ConditionGrid grid(results);
    const std::vector<Condition> places =
        periods == Periods::one ? std::vector{at} : along(grid, ConditionAxis::period, at);
    values_ = {places.size(), orientations_.size(), records_.size()};
    for (std::size_t p = 0; p < places.size(); ++p) {
      for (std::size_t o = 0; o < orientations_.size(); ++o) {
        for (std::size_t r = 0; r < records_.size(); ++r) {
          values_(p, o, r) =
              number_of(question.number, grid.history(records_[r], orientations_[o], places[p]));
        }
      }
    }
  }

  const std::vector<std::size_t>& records() const { return records_; }
  const std::vector<std::size_t>& orientations() const { return orientations_; }

  /// The largest over the periods of the mean of value(period, record).
  double largest_mean(const std::function<double(std::size_t, std::size_t)>& value) const {
    double largest = 0.0;
    for (std::size_t p = 0; p < values_.rows; ++p) {
      double sum = 0.0;
      for (std::size_t r = 0; r < values_.depth; ++r) sum += value(p, r);
      largest = std::max(largest, sum / static_cast<double>(values_.depth));
    }
    return largest;
  }
  /// Each record r as `orientation_of(r)` has it.
  double mean_as(const std::function<std::size_t(std::size_t)>& orientation_of) const {
    return largest_mean(
        [&](std::size_t p, std::size_t r) { return values_(p, orientation_of(r), r); });
  }
  /// All records in one orientation, and the interval in the period of the largest mean.
  double orientation_mean(std::size_t orientation) const {
    return mean_as([&](std::size_t) { return orientation; });
  }
  Interval orientation_interval(std::size_t orientation) const {
    const double largest = orientation_mean(orientation);
    std::vector<double> values(values_.depth);
    for (std::size_t p = 0; p < values_.rows; ++p) {
      for (std::size_t r = 0; r < values_.depth; ++r) values[r] = values_(p, orientation, r);
      const double sum = std::accumulate(values.begin(), values.end(), 0.0);
      if (sum / static_cast<double>(values_.depth) == largest) break;
    }
    return positive_mean_interval(UnitValues(values, units_));
  }
  /// Of all records and orientations.
  double largest() const { return *std::max_element(values_.data.begin(), values_.data.end()); }
  double extreme(std::size_t period, std::size_t record,
                 const double& (*pick)(const double&, const double&)) const {
    double value = values_(period, 0, record);
    for (std::size_t o = 1; o < values_.columns; ++o)
      value = pick(value, values_(period, o, record));
    return value;
  }

 private:
  std::vector<std::size_t> records_, orientations_, units_;
  Array3 values_;
};

std::vector<double> orientation_means(const Values& values) {
  std::vector<double> means;
  for (std::size_t o = 0; o < values.orientations().size(); ++o)
    means.push_back(values.orientation_mean(o));
  return means;
}

}  // namespace

const char* to_string(OrientationRule rule) {
  return rule == OrientationRule::largest ? "largest" : "median";
}

double number_of(HistoryNumber number, const ConditionHistory& history) {
  switch (number) {
    case HistoryNumber::displacement:
      return history.displacement_m();
    case HistoryNumber::vector_peak:
      return history.peak_m();
    case HistoryNumber::base_shear:
      return history.base_shear();
  }
  return nan;
}

std::vector<std::size_t> records_of(const Results& results, std::size_t suite) {
  std::vector<std::size_t> of_suite;
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    if (results.records[i].suite == suite) of_suite.push_back(i);
  }
  return of_suite;
}

std::vector<std::size_t> orientations_of(const Results& results, const MeanQuestion& question) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < results.cases.orientations; ++i) {
    if (!question.slope_axis || orientation_at(results, i).slope_axis == *question.slope_axis)
      found.push_back(i);
  }
  return found;
}

double suite_mean(const Results& results, const MeanQuestion& question, std::size_t orientation,
                  const Condition& at) {
  const std::vector<std::size_t> records = records_of(results, question.suite);
  const ConditionGrid grid(results);
  double sum = 0.0;
  for (const std::size_t record : records)
    sum += number_of(question.number, grid.history(record, orientation, at));
  return sum / static_cast<double>(records.size());
}

std::vector<double> means_by_orientation(const Results& results, const MeanQuestion& question,
                                         const Condition& at, Periods periods) {
  return orientation_means(Values(results, question, at, periods));
}

double mean_by(OrientationRule rule, const std::vector<double>& means) {
  return rule == OrientationRule::largest ? std::ranges::max(means) : quantile_of(means, 0.5);
}

OrientationRange over_orientations(const Results& results, const MeanQuestion& question,
                                   const Condition& at, Periods periods) {
  const Values values(results, question, at, periods);
  const std::vector<double> means = orientation_means(values);
  const auto [low, high] = std::minmax_element(means.begin(), means.end());
  std::vector<double> lows, highs;
  for (std::size_t o = 0; o < means.size(); ++o) {
    const Interval interval = values.orientation_interval(o);
    lows.push_back(interval.low);
    highs.push_back(interval.high);
  }
  const auto at_high = static_cast<std::size_t>(high - means.begin());
  const Interval median = std::isnan(lows.front())
                              ? Interval{}
                              : Interval{quantile_of(lows, 0.5), quantile_of(highs, 0.5)};
  return {*low,
          mean_by(OrientationRule::median, means),
          *high,
          median,
          {lows[at_high], highs[at_high]}};
}

std::size_t governing_period(const Results& results, const MeanQuestion& question,
                             const Condition& at, OrientationRule rule) {
  std::size_t governing = 0;
  double largest = -1.0;
  for (const Condition& place : along(ConditionGrid(results), ConditionAxis::period, at)) {
    const double mean = mean_by(rule, means_by_orientation(results, question, place, Periods::one));
    if (mean > largest) {
      largest = mean;
      governing = place[ConditionAxis::period];
    }
  }
  return governing;
}

PerRecordBounds per_record_bounds(const Results& results, const MeanQuestion& question,
                                  const Condition& at, Periods periods) {
  const Values values(results, question, at, periods);
  const auto bound = [&](const double& (*pick)(const double&, const double&)) {
    return values.largest_mean(
        [&](std::size_t p, std::size_t r) { return values.extreme(p, r, pick); });
  };
  return {bound(std::min<double>), bound(std::max<double>)};
}

std::vector<SuiteMean> suite_means(const Results& results, HistoryNumber number,
                                   const std::vector<Condition>& places, Periods periods,
                                   OrientationRule rule) {
  std::vector<SuiteMean> means;
  for (std::size_t suite = 0; suite < results.suites.size(); ++suite) {
    const MeanQuestion question{.suite = suite, .number = number};
    for (const Condition& place : places) {
      const Condition at =
          periods == Periods::one
              ? place
              : place.with(ConditionAxis::period, governing_period(results, question, place, rule));
      means.push_back({.suite = suite,
                       .at = at,
                       .range = over_orientations(results, question, place, periods),
                       .bounds = per_record_bounds(results, question, place, periods),
                       .largest = Values(results, question, place, periods).largest(),
                       .by_orientation = means_by_orientation(results, question, place, periods)});
    }
  }
  return means;
}

std::vector<Condition> sliding_conditions(const ConditionGrid& grid, Periods periods) {
  std::vector<Condition> places =
      periods == Periods::one ? all_conditions(grid) : all_but(grid, ConditionAxis::period);
  std::erase_if(places, [&](const Condition& at) {
    return grid.case_at(at).support != ArraySupport::isolated;
  });
  return places;
}

std::vector<double> per_record_means(const Results& results, const MeanQuestion& question,
                                     const Condition& at, Periods periods) {
  constexpr std::uint64_t draws = 10000;
  const Values values(results, question, at, periods);
  const std::vector<std::size_t>& run = values.orientations();
  // Orientations for each axis the slope may have: places in `run`.
  std::vector<std::vector<std::size_t>> choices;
  for (const SlopeAxis axis : {SlopeAxis::e_w, SlopeAxis::n_s}) {
    std::vector<std::size_t> of_axis;
    for (std::size_t o = 0; o < run.size(); ++o) {
      if (orientation_at(results, run[o]).slope_axis == axis) of_axis.push_back(o);
    }
    if (!of_axis.empty()) choices.push_back(std::move(of_axis));
  }
  const auto pick = [&](std::uint64_t draw, std::size_t which, std::size_t count) {
    const double u = keyed_uniform(results.seed, RandomPurpose::sample_point, draw,
                                   static_cast<std::uint32_t>(which));
    return static_cast<std::size_t>(u * static_cast<double>(count));
  };
  std::vector<double> means;
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    const std::vector<std::size_t>& of_axis = choices[pick(draw, 0, choices.size())];
    means.push_back(values.mean_as(
        [&](std::size_t record) { return of_axis[pick(draw, 1 + record, of_axis.size())]; }));
  }
  std::sort(means.begin(), means.end());
  return means;
}

double share_below(const std::vector<double>& sorted, double value) {
  const auto [from, to] = std::equal_range(sorted.begin(), sorted.end(), value);
  const auto below = static_cast<double>(from - sorted.begin());
  const auto ties = static_cast<double>(to - from);
  return sorted.empty() ? nan : (below + 0.5 * ties) / static_cast<double>(sorted.size());
}

StrongerAlong stronger_along(const Results& results, const MeanQuestion& question,
                             const Condition& at, Periods periods) {
  const Values values(results, question, at, periods);
  const auto mean = [&](double turned_deg) {
    bool found = true;
    const double largest = values.mean_as([&](std::size_t r) {
      const double azimuth =
          turned_deg + (results.records[values.records()[r]].stronger == 1 ? 90.0 : 0.0);
      for (std::size_t o = 0; o < values.orientations().size(); ++o) {
        if (orientation_at(results, values.orientations()[o]).ground_azimuth_deg == azimuth)
          return o;
      }
      found = false;
      return std::size_t{0};
    });
    return found ? largest : nan;
  };
  return {mean(0.0), mean(180.0)};
}

double uplift_share(const Results& results) {
  const ConditionGrid grid(results);
  std::size_t isolated = 0, uplift = 0;
  for (const Condition& at : sliding_conditions(grid, Periods::one)) {
    for (std::size_t record = 0; record < results.records.size(); ++record) {
      for (std::size_t o = 0; o < results.cases.orientations; ++o) {
        ++isolated;
        uplift += grid.history(record, o, at).lifts_off();
      }
    }
  }
  return isolated == 0 ? 0.0 : static_cast<double>(uplift) / static_cast<double>(isolated);
}

}  // namespace glissade
