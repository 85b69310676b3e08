// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/execute.hpp"

#include <algorithm>
#include <bit>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "glissade/block/tipping.hpp"

namespace glissade {
namespace {

constexpr double capacity_tolerance =
    1e-4;  // of the capacity: far below the spread between records
constexpr double infinity = std::numeric_limits<double>::infinity();

/// One block on one roof: how far it slips at any intensity.
class Scene {
 public:
  /// @param remake makes the roof anew: called before every history where nothing is skipped
  Scene(const SampleRoof& roof, const Block& block, int sign, SlipCurve* curve,
        const std::function<void()>& remake)
      : roof_(roof), block_(block), sign_(sign), curve_(curve), remake_(remake) {}
  bool skips() const { return remake_ == nullptr; }

  /// The peak of the roof's acceleration leaves it in the stick range.
  bool held(double level) const {
    if (!skips()) return false;
    const double factor = level * roof_.factor_at_unit_level;
    const MotionTable* up = roof_.table.vertical.get();
    return cannot_slip(block_, factor * roof_.table.horizontal->acceleration_bound_mps2,
                       up != nullptr ? factor * up->acceleration_bound_mps2 : 0.0);
  }

  /// The level above which the body begins to rock on its base.
  double tipping_level(const RigidBase& base) const {
    return tipping_onset_factor(roof_.table, block_, base, {1.0 * sign_, 1.0}) /
           roof_.factor_at_unit_level;
  }

  struct Slip {
    double peak_displacement_m = 0.0;
    bool uplift = false;
  };
  Slip at(double level, std::uint64_t& integrated, std::uint64_t& from_curve) const {
    const double factor = level * roof_.factor_at_unit_level;
    if (curve_ == nullptr || factor == 0.0) return integrate(factor, factor, integrated);
    // lambda F(mu / lambda): the motion as it is, under gravity over lambda.
    Block at_unit_factor = block_;
    at_unit_factor.gravity_mps2 = block_.gravity_mps2 / factor;
    const auto key = std::bit_cast<std::uint64_t>(at_unit_factor.gravity_mps2 * block_.friction);
    auto point = curve_->find(key);
    if (point != curve_->end()) {
      ++from_curve;
    } else {
      ++integrated;
      point = curve_->emplace(key, peak_slip(roof_.table, at_unit_factor)).first;
    }
    return {factor * point->second.peak_displacement_m, point->second.uplift};
  }

 private:
  Slip integrate(double horizontal, double vertical, std::uint64_t& integrated) const {
    ++integrated;
    if (!skips()) remake_();
    const EventSearch search = skips() ? EventSearch::bounds : EventSearch::every_interval;
    const PeakSlip slip = peak_slip(roof_.table, block_, {sign_ * horizontal, vertical}, search);
    return {slip.peak_displacement_m, slip.uplift};
  }

  const SampleRoof& roof_;
  Block block_;
  int sign_;
  SlipCurve* curve_;
  const std::function<void()>& remake_;
};

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
void fill(const Plan& plan, const Scene& scene, UnitResult::Run& run, WorkCount& count) {
  const std::vector<double>& levels = plan.config.intensity.levels;
  const std::vector<double>& thresholds = plan.config.thresholds_m;
  const std::size_t begin = run.peak_displacement_m.size();
  bool beyond = false;  // the largest threshold is reached, and nothing above it is asked
  for (const double level : levels) {
    Scene::Slip slip;
    if (beyond) {
      if (scene.skips()) {
        ++count.beyond;
      } else {
        scene.at(level, count.integrated, count.from_curve);
      }
      slip.peak_displacement_m = infinity;
    } else if (scene.held(level)) {
      ++count.held;
    } else {
      slip = scene.at(level, count.integrated, count.from_curve);
      beyond =
          plan.config.stop_at_largest_threshold && slip.peak_displacement_m >= thresholds.back();
    }
    run.peak_displacement_m.push_back(slip.peak_displacement_m);
    run.uplift.push_back(slip.uplift ? 1 : 0);
  }
  if (plan.config.base) {
    const double tipping = scene.tipping_level(*plan.config.base);
    for (const double level : levels) run.tips.push_back(level > tipping ? 1 : 0);
  }
  for (const double threshold : thresholds) {
    const std::uint64_t before = count.searched;
    run.capacity.push_back(first_crossing(
        levels, run.peak_displacement_m.data() + begin, threshold, [&](double level) {
          std::uint64_t known = 0;
          return scene.held(level) ? 0.0
                                   : scene.at(level, count.searched, known).peak_displacement_m;
        }));
    if (count.searched == before) ++count.decided;
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
      const SamplePoint& sample = plan.samples[first + i];
      for (std::size_t r = 0; r < plan.runs.size(); ++r) {
        const Block block{.friction = plan.runs[r].friction[first + i],
                          .slope_rad = sample.slope_deg * rad_per_deg};
        const Scene scene(under[i], block, sample.sign, roofs.curve(first + i, r), remake);
        fill(plan, scene, result.runs[r], result.count);
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
