// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/clearance_reading.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/core/contract.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What a mean is taken of: the number of each (period, orientation, record) a question is about.
class Values {
 public:
  Values(const ClearanceResults& results, const ClearanceQuestion& question,
         const ClearancePosition& at, Periods periods)
      : records_(records_of(results, question.suite)),
        orientations_(orientations_of(results, question)) {
    const std::vector<ClearancePosition> places =
        periods == Periods::one ? std::vector{at} : along(results.grid, ClearanceAxis::period, at);
    values_ = {places.size(), orientations_.size(), records_.size()};
    for (std::size_t p = 0; p < places.size(); ++p) {
      const std::size_t condition = results.grid.index(places[p]);
      for (std::size_t o = 0; o < orientations_.size(); ++o) {
        for (std::size_t r = 0; r < records_.size(); ++r) {
          values_(p, o, r) =
              number_of(question.number, results.at(records_[r], orientations_[o], condition));
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
  /// All records in one orientation, each with its weight.
  double weighted_mean(std::size_t orientation, const std::vector<double>& weights) const {
    double largest = 0.0;
    for (std::size_t p = 0; p < values_.rows; ++p) {
      double sum = 0.0, weight = 0.0;
      for (std::size_t r = 0; r < values_.depth; ++r) {
        sum += weights[r] * values_(p, orientation, r);
        weight += weights[r];
      }
      largest = std::max(largest, sum / weight);
    }
    return largest;
  }
  double extreme(std::size_t period, std::size_t record,
                 const double& (*pick)(const double&, const double&)) const {
    double value = values_(period, 0, record);
    for (std::size_t o = 1; o < values_.columns; ++o)
      value = pick(value, values_(period, o, record));
    return value;
  }

 private:
  std::vector<std::size_t> records_, orientations_;
  Array3<double> values_;
};

std::vector<double> weighted_means(const Values& values, const std::vector<double>& weights) {
  std::vector<double> means;
  for (std::size_t o = 0; o < values.orientations().size(); ++o)
    means.push_back(values.weighted_mean(o, weights));
  return means;
}

}  // namespace

double number_of(HistoryNumber number, const ClearanceHistory& history) {
  switch (number) {
    case HistoryNumber::displacement:
      return history.displacement_m;
    case HistoryNumber::vector_peak:
      return history.peak_m;
    case HistoryNumber::base_shear:
      return base_shear(history);
  }
  return nan;
}

std::vector<std::size_t> records_of(const ClearanceResults& results, std::size_t suite) {
  std::vector<std::size_t> of_suite;
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    if (results.records[i].suite == suite) of_suite.push_back(i);
  }
  return of_suite;
}

std::vector<std::size_t> orientations_of(const ClearanceResults& results,
                                         const ClearanceQuestion& question) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < results.orientations.size(); ++i) {
    if (!question.slope_axis || results.orientations[i].slope_axis == *question.slope_axis)
      found.push_back(i);
  }
  return found;
}

double suite_mean(const ClearanceResults& results, const ClearanceQuestion& question,
                  std::size_t orientation, const ClearancePosition& at) {
  const std::vector<std::size_t> records = records_of(results, question.suite);
  double sum = 0.0;
  for (const std::size_t record : records) {
    sum += number_of(question.number, results.at(record, orientation, results.grid.index(at)));
  }
  return sum / static_cast<double>(records.size());
}

std::vector<double> means_by_orientation(const ClearanceResults& results,
                                         const ClearanceQuestion& question,
                                         const ClearancePosition& at, Periods periods) {
  const Values values(results, question, at, periods);
  return weighted_means(values, std::vector<double>(values.records().size(), 1.0));
}

OrientationRange over_orientations(const ClearanceResults& results,
                                   const ClearanceQuestion& question, const ClearancePosition& at,
                                   Periods periods) {
  const Values values(results, question, at, periods);
  const std::size_t records = values.records().size();
  const std::vector<double> means = weighted_means(values, std::vector<double>(records, 1.0));
  const auto [low, high] = std::minmax_element(means.begin(), means.end());
  const auto median = [&](const std::vector<double>& weights) {
    return quantile_of(weighted_means(values, weights), 0.5);
  };
  return {*low, quantile_of(means, 0.5), *high,
          bootstrap_interval(records, median, {.seed = results.seed})};
}

std::size_t governing_period(const ClearanceResults& results, const ClearanceQuestion& question,
                             const ClearancePosition& at) {
  std::size_t governing = 0;
  double largest = -1.0;
  for (std::size_t p = 0; p < results.grid.period_s.size(); ++p) {
    const double median = quantile_of(
        means_by_orientation(results, question, at.with(ClearanceAxis::period, p), Periods::one),
        0.5);
    if (median > largest) {
      largest = median;
      governing = p;
    }
  }
  return governing;
}

PerRecordBounds per_record_bounds(const ClearanceResults& results,
                                  const ClearanceQuestion& question, const ClearancePosition& at,
                                  Periods periods) {
  const Values values(results, question, at, periods);
  const auto bound = [&](const double& (*pick)(const double&, const double&)) {
    return values.largest_mean(
        [&](std::size_t p, std::size_t r) { return values.extreme(p, r, pick); });
  };
  return {bound(std::min<double>), bound(std::max<double>)};
}

std::vector<double> per_record_means(const ClearanceResults& results,
                                     const ClearanceQuestion& question, const ClearancePosition& at,
                                     Periods periods) {
  constexpr std::uint64_t draws = 10000;
  const Values values(results, question, at, periods);
  const std::vector<std::size_t>& run = values.orientations();
  // Orientations for each axis the slope may have: places in `run`.
  std::vector<std::vector<std::size_t>> choices;
  for (const SlopeAxis axis : {SlopeAxis::e_w, SlopeAxis::n_s}) {
    std::vector<std::size_t> of_axis;
    for (std::size_t o = 0; o < run.size(); ++o) {
      if (results.orientations[run[o]].slope_axis == axis) of_axis.push_back(o);
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

StrongerAlong stronger_along(const ClearanceResults& results, const ClearanceQuestion& question,
                             const ClearancePosition& at, Periods periods) {
  const Values values(results, question, at, periods);
  const auto mean = [&](double turned_deg) {
    bool found = true;
    const double largest = values.mean_as([&](std::size_t r) {
      const double azimuth =
          turned_deg + (results.records[values.records()[r]].stronger == 1 ? 90.0 : 0.0);
      for (std::size_t o = 0; o < values.orientations().size(); ++o) {
        if (results.orientations[values.orientations()[o]].ground_azimuth_deg == azimuth) return o;
      }
      found = false;
      return std::size_t{0};
    });
    return found ? largest : nan;
  };
  return {mean(0.0), mean(180.0)};
}

double uplift_share(const ClearanceResults& results) {
  std::size_t isolated = 0, uplift = 0;
  for (std::size_t i = 0; i < results.histories.size(); ++i) {
    const ClearancePosition at = results.grid.position(i % results.grid.count());
    if (results.grid.support[at[ClearanceAxis::support]] != ArraySupport::isolated) continue;
    ++isolated;
    uplift += results.histories[i].uplift;
  }
  return isolated == 0 ? 0.0 : static_cast<double>(uplift) / static_cast<double>(isolated);
}

}  // namespace glissade
