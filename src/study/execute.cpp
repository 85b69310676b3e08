// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/execute.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <span>

#include "glissade/study/scene.hpp"

namespace glissade {
namespace {

constexpr double capacity_tolerance =
    1e-4;  // of the capacity: far below the spread between records

/// One record seen by one sample: the roof it makes, and how far a block slips on it at any
/// intensity.
class Scene {
 public:
  Scene(const Plan& plan, std::size_t record, std::size_t sample)
      : point_(plan.samples[sample]), slope_rad_(point_.slope_deg * rad_per_deg) {
    const Motion& motion = plan.suite.motions[record];
    const VerticalConfig& vertical = plan.config.vertical;
    const int component = motion.horizontal_mps2[1].empty() ? 0 : point_.component;
    const GroundMotion ground{
        motion.dt_s, motion.horizontal_mps2[static_cast<std::size_t>(component)],
        vertical.use == VerticalChoice::none ? std::span<const double>() : motion.vertical_mps2};
    const Building building{{point_.period_s, point_.damping},
                            {vertical.period_s, vertical.damping}};

    std::vector<Block> blocks;
    for (const FrictionRun& run : plan.runs) blocks.push_back(block(run.friction[sample]));
    const double highest = plan.config.intensity.levels.back();
    if (plan.config.intensity.measure == IntensityMeasure::ppa_g) {
      // The factor needs the roof's peak, and the ring-down needs the factor: a first roof motion
      // tells the peak.
      const double peak = roof_motion(ground, building, {}).peak_horizontal_mps2;
      roof_ = roof_motion(ground, building,
                          follow_roof(blocks, highest * standard_gravity_mps2 / peak));
      factor_at_unit_level_ = standard_gravity_mps2 / roof_.peak_horizontal_mps2;
    } else {
      factor_at_unit_level_ = plan.factor_at_unit_level[record];
      roof_ = roof_motion(ground, building, follow_roof(blocks, highest * factor_at_unit_level_));
    }
  }

  Block block(double friction) const { return {.friction = friction, .slope_rad = slope_rad_}; }

  bool held(const Block& block, double level) const {
    const double factor = level * factor_at_unit_level_;
    return cannot_slip(block, factor * roof_.peak_horizontal_mps2,
                       factor * roof_.peak_vertical_mps2);
  }

  SlipResult slip(const Block& block, double level) const {
    const double factor = level * factor_at_unit_level_;
    return slide(felt_by(block, roof_, {point_.sign * factor, factor}), block);
  }

 private:
  SamplePoint point_;
  double slope_rad_;
  double factor_at_unit_level_ = 0.0;
  RoofMotion roof_;
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
  if (first == n) return std::numeric_limits<double>::infinity();

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

}  // namespace

UnitResult execute(const Plan& plan, std::size_t unit_index) {
  const WorkUnit& unit = plan.units[unit_index];
  const std::vector<double>& levels = plan.config.intensity.levels;
  UnitResult result;
  result.unit = unit_index;
  result.runs.resize(plan.runs.size());

  for (std::uint64_t sample = unit.first_sample; sample < unit.first_sample + unit.sample_count;
       ++sample) {
    const Scene scene(plan, unit.record, sample);
    for (std::size_t r = 0; r < plan.runs.size(); ++r) {
      const Block block = scene.block(plan.runs[r].friction[sample]);
      UnitResult::Run& run = result.runs[r];
      const std::size_t begin = run.peak_displacement_m.size();
      for (const double level : levels) {
        const bool held = scene.held(block, level);
        const SlipResult slip = held ? SlipResult{} : scene.slip(block, level);
        ++(held ? result.held : result.integrated);
        run.peak_displacement_m.push_back(slip.peak_displacement_m);
        run.uplift.push_back(slip.uplift ? 1 : 0);
      }
      for (const double threshold : plan.config.thresholds_m) {
        run.capacity.push_back(first_crossing(
            levels, run.peak_displacement_m.data() + begin, threshold, [&](double level) {
              ++result.searched;
              return scene.held(block, level) ? 0.0 : scene.slip(block, level).peak_displacement_m;
            }));
      }
    }
  }
  return result;
}

}  // namespace glissade
