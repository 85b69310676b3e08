// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/execute.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "histories.hpp"

namespace glissade {
namespace {

constexpr double capacity_tolerance =
    1e-4;  // of the capacity: far below the spread between records
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The lowest level at which the peak displacement reaches the threshold: bracketed on the study's
/// levels, then solved in the square root of slip, which is nearly linear in intensity (TOMS 748:
/// Alefeld, Potra & Shi 1995).
template <class PeakAt>
double first_crossing(const std::vector<double>& levels, const double* peaks, double threshold_m,
                      PeakAt peak_at) {
  const auto excess = [&](double peak) { return std::sqrt(peak) - std::sqrt(threshold_m); };
  const std::size_t n = levels.size();
  const std::size_t first = static_cast<std::size_t>(
      std::find_if(peaks, peaks + n, [&](double p) { return p >= threshold_m; }) - peaks);
  if (first == n) return infinity;

  double high = levels[first], low = first > 0 ? levels[first - 1] : 0.0;
  double at_high = excess(peaks[first]),
         at_low = excess(first > 0 ? peaks[first - 1] : peak_at(0.0));
  if (at_low >= 0.0) return 0.0;  // it gets there with no shaking at all
  if (at_high == 0.0) return high;
  std::uintmax_t evaluations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](double level) { return excess(peak_at(level)); }, low, high, at_low, at_high,
      [](double a, double b) { return b - a <= capacity_tolerance * b; }, evaluations);
  return 0.5 * (bracket.first + bracket.second);
}

/// All levels and thresholds of one sample and run.
void fill(const Plan& plan, Histories& histories, Skipping skipping, UnitResult::Run& run,
          WorkCount& count) {
  const std::vector<double>& levels = plan.config.intensity.levels;
  const std::vector<double>& thresholds = plan.config.thresholds_m;
  const bool two_axes = plan.config.model.axes == SlidingAxes::two;
  const std::size_t begin = run.peak_displacement_m.size();
  bool beyond = false;  // the largest threshold is reached, and nothing above it is asked
  for (const double level : levels) {
    History history;
    std::vector<Crossing> crossings(plan.config.impact ? thresholds.size() : 0);
    if (beyond) {
      if (skipping == Skipping::all) {
        ++count.beyond;
      } else {
        histories.at(level, crossings, count);
      }
      history = {infinity, infinity};
    } else if (histories.held(level)) {
      ++count.held;
    } else {
      history = histories.at(level, crossings, count);
      beyond =
          plan.config.stop_at_largest_threshold && history.peak_displacement_m >= thresholds.back();
    }
    run.peak_displacement_m.push_back(history.peak_displacement_m);
    if (two_axes) run.peak_vector_m.push_back(history.peak_vector_m);
    run.uplift.push_back(history.uplift ? 1 : 0);
    for (const Crossing& crossing : crossings) {
      run.crossing_time_s.push_back(crossing.time_s);
      run.crossing_speed_mps.push_back(crossing.speed_mps);
    }
  }
  if (plan.config.base) {
    const double tipping = histories.tipping_level(*plan.config.base);
    for (const double level : levels) run.tips.push_back(level > tipping ? 1 : 0);
  }
  for (const double threshold : thresholds) {
    WorkCount search;
    run.capacity.push_back(first_crossing(
        levels, run.peak_displacement_m.data() + begin, threshold, [&](double level) {
          return histories.held(level) ? 0.0 : histories.at(level, {}, search).peak_displacement_m;
        }));
    count.searched += search.integrated;
    if (search.integrated == 0) ++count.decided;
  }
}

}  // namespace

UnitResult execute(const Plan& plan, std::size_t unit_index, RoofStore& roofs) {
  const WorkUnit& unit = plan.units[unit_index];
  UnitResult result;
  result.unit = unit_index;
  result.runs.resize(plan.runs.size());
  const std::uint64_t roofs_before = roofs.roofs_made();
  const bool skips = roofs.skipping() == Skipping::all;
  const std::uint64_t at_once = skips ? RoofStore::most_at_once : 1;
  const std::uint64_t end = unit.first_sample + unit.sample_count;
  for (std::uint64_t first = unit.first_sample; first < end; first += at_once) {
    const auto make = [&] {
      return roofs.under(unit.record, first, std::min(at_once, end - first));
    };
    const auto under = make();
    const std::function<void()> remake = skips ? std::function<void()>() : [&] { make(); };
    for (std::size_t i = 0; i < under.size(); ++i) {
      for (std::size_t r = 0; r < plan.runs.size(); ++r) {
        const auto histories =
            histories_of(plan, roofs, unit.record, first + i, r, under[i], remake);
        fill(plan, *histories, roofs.skipping(), result.runs[r], result.count);
      }
    }
  }
  result.count.roofs = roofs.roofs_made() - roofs_before;
  return result;
}

UnitResult execute(const Plan& plan, std::size_t unit, Skipping skipping) {
  RoofStore roofs(plan, skipping);
  return execute(plan, unit, roofs);
}

}  // namespace glissade
