// SPDX-License-Identifier: GPL-3.0-or-later
#include "histories.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "glissade/block/coupled_slip.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "model_scene.hpp"

namespace glissade {
namespace {

/// What a sample under a run is to every kernel.
struct Scene {
  const Plan& plan;
  const SamplePoint& sample;
  Block block;
  const SampleRoof& roof;
  bool skips;

  double factor(double level) const { return level * roof.factor_at_unit_level; }
  std::span<const double> thresholds_m() const { return plan.config.thresholds_m; }
};

/// A smaller friction than either direction has, under the longer of both axes' peaks together: on
/// a circle the worst direction is straight up the slope.
bool is_held(const Scene& scene, double friction, double level) {
  const RoofTable &first = scene.roof.table, &second = scene.roof.second;
  if (!scene.skips || !first.horizontal) return false;
  Block block = scene.block;
  block.friction = friction;
  const double peak = second.horizontal ? std::hypot(first.horizontal->acceleration_bound_mps2,
                                                     second.horizontal->acceleration_bound_mps2)
                                        : first.horizontal->acceleration_bound_mps2;
  const MotionTable* up = first.vertical.get();
  return cannot_slip(block, scene.factor(level) * peak,
                     up != nullptr ? scene.factor(level) * up->acceleration_bound_mps2 : 0.0);
}

class TableHistories : public Histories {
 public:
  TableHistories(const Scene& scene, SlipCurve* curve, std::function<void()> remake)
      : scene_(scene), curve_(curve), remake_(std::move(remake)) {}

  bool held(double level) const override { return is_held(scene_, scene_.block.friction, level); }

  double tipping_level(const RigidBase& base) const override {
    return tipping_onset_factor(scene_.roof.table, scene_.block, base,
                                {1.0 * scene_.sample.sign, 1.0}) /
           scene_.roof.factor_at_unit_level;
  }

  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    const double factor = scene_.factor(level);
    if (curve_ == nullptr || factor == 0.0 || !crossings.empty())
      return integrate(factor, crossings, count);
    // lambda F(mu / lambda): the motion as it is, under gravity over lambda.
    Block at_unit_factor = scene_.block;
    at_unit_factor.gravity_mps2 = scene_.block.gravity_mps2 / factor;
    const auto key =
        std::bit_cast<std::uint64_t>(at_unit_factor.gravity_mps2 * scene_.block.friction);
    auto point = curve_->find(key);
    if (point != curve_->end()) {
      ++count.from_curve;
    } else {
      ++count.integrated;
      point = curve_->emplace(key, peak_slip(scene_.roof.table, at_unit_factor)).first;
    }
    return {factor * point->second.peak_displacement_m, 0.0, point->second.uplift};
  }

 private:
  History integrate(double factor, std::span<Crossing> crossings, WorkCount& count) const {
    ++count.integrated;
    if (!scene_.skips) remake_();
    const EventSearch search = scene_.skips ? EventSearch::bounds : EventSearch::every_interval;
    const MotionFactors factors{scene_.sample.sign * factor, factor};
    const PeakSlip slip = crossings.empty()
                              ? peak_slip(scene_.roof.table, scene_.block, factors, search)
                              : peak_slip(scene_.roof.table, scene_.block, factors,
                                          scene_.thresholds_m(), crossings, search);
    return {slip.peak_displacement_m, 0.0, slip.uplift};
  }

  Scene scene_;
  SlipCurve* curve_;
  std::function<void()> remake_;
};

GroundMotion ground_of(const Plan& plan, std::size_t record, int component) {
  const Motion& motion = plan.suite.motions[record];
  const auto& horizontal = motion.horizontal_mps2;
  GroundMotion ground{motion.dt_s,
                      horizontal[horizontal[1].empty() ? 0 : static_cast<std::size_t>(component)]};
  if (plan.config.vertical.use != VerticalChoice::none) ground.vertical_mps2 = motion.vertical_mps2;
  return ground;
}

class NoTipping : public Histories {
 public:
  double tipping_level(const RigidBase&) const override {
    throw std::logic_error("tipping_level: not in a plan with this kernel");
  }
};

/// One axis on a building that feels the array, and may yield.
class CoupledHistories : public NoTipping {
 public:
  CoupledHistories(const Scene& scene, const GroundMotion& ground)
      : scene_(scene),
        ground_(ground),
        building_{{scene.sample.period_s, scene.sample.damping},
                  scene.sample.mass_ratio,
                  strength_of(scene.plan, scene.sample.period_s)} {}

  bool held(double level) const override { return is_held(scene_, scene_.block.friction, level); }

  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    ++count.integrated;
    const std::vector<double>& levels = scene_.plan.config.intensity.levels;
    const auto known = std::find(levels.begin(), levels.end(), level);
    if (known == levels.end()) return run({&level, 1}, crossings).front();
    if (at_levels_.empty()) run_levels();
    const std::size_t i = static_cast<std::size_t>(known - levels.begin());
    const std::size_t n = crossings.size();
    std::copy_n(crossings_.begin() + static_cast<std::ptrdiff_t>(i * n), n, crossings.begin());
    return at_levels_[i];
  }

 private:
  /// The levels go side by side.
  void run_levels() {
    const std::vector<double>& levels = scene_.plan.config.intensity.levels;
    std::vector<double> moving;
    for (const double level : levels)
      if (!held(level)) moving.push_back(level);
    const std::size_t thresholds = scene_.plan.config.impact ? scene_.thresholds_m().size() : 0;
    std::vector<Crossing> crossings(moving.size() * thresholds);
    const std::vector<History> found = run(moving, crossings);
    at_levels_.resize(levels.size());
    crossings_.resize(levels.size() * thresholds);
    for (std::size_t i = 0, k = 0; i < levels.size(); ++i) {
      if (k == moving.size() || levels[i] != moving[k]) continue;
      at_levels_[i] = found[k];
      std::copy_n(crossings.begin() + static_cast<std::ptrdiff_t>(k * thresholds), thresholds,
                  crossings_.begin() + static_cast<std::ptrdiff_t>(i * thresholds));
      ++k;
    }
  }

  std::vector<History> run(std::span<const double> levels, std::span<Crossing> crossings) const {
    std::vector<CoupledScene> scenes;
    for (const double level : levels) {
      const double factor = scene_.factor(level);
      scenes.push_back({building_, scene_.block, {scene_.sample.sign * factor, factor}});
    }
    std::vector<CoupledPeak> peaks(levels.size());
    if (crossings.empty()) {
      coupled_slip(ground_, scenes, peaks);
    } else {
      coupled_slip(ground_, scenes, peaks, scene_.thresholds_m(), crossings);
    }
    std::vector<History> found;
    for (const CoupledPeak& peak : peaks)
      found.push_back({peak.slip.peak_displacement_m, 0.0, peak.slip.uplift});
    return found;
  }

  Scene scene_;
  GroundMotion ground_;
  CoupledBuilding building_;
  std::vector<History> at_levels_;   // as soon as one of them is asked for; a held one is zero
  std::vector<Crossing> crossings_;  // by level, then threshold
};

/// The full model.
class FullHistories : public NoTipping {
 public:
  FullHistories(const Scene& scene, BuildingGround ground, const BiaxialBuilding& building,
                const TwoAxisBlock& block)
      : scene_(scene), ground_(std::move(ground)), building_(building), block_(block) {}

  bool held(double level) const override {
    return is_held(scene_, std::min(block_.friction.along, block_.friction.across), level);
  }

  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    ++count.integrated;
    const double factor = scene_.factor(level);
    const BuildingFactors factors{{scene_.sample.sign * factor, scene_.sample.second_sign * factor},
                                  factor};
    const TwoAxisResult slip =
        slide_on_building(ground_, factors, building_, block_,
                          crossings.empty() ? std::span<const double>() : scene_.thresholds_m(),
                          crossings)
            .slip;
    const bool srss = scene_.plan.config.model.displacement == DisplacementMeasure::srss;
    return {srss ? srss_of_maxima_m(slip) : slip.peak_displacement_m, slip.peak_displacement_m,
            slip.uplift};
  }

 private:
  Scene scene_;
  BuildingGround ground_;
  BiaxialBuilding building_;
  TwoAxisBlock block_;
};

}  // namespace

std::unique_ptr<Histories> histories_of(const Plan& plan, RoofStore& roofs, std::size_t record,
                                        std::size_t sample, std::size_t run, const SampleRoof& roof,
                                        const std::function<void()>& remake) {
  const SamplePoint& point = plan.samples[sample];
  const FrictionRun& friction = plan.runs[run];
  const Block block{.friction = friction.friction[sample],
                    .slope_rad = point.slope_deg * rad_per_deg,
                    .law = plan.config.friction.law};
  const Scene scene{plan, point, block, roof, roofs.skipping() == Skipping::all};
  switch (plan.kernel.kernel) {
    case Kernel::tables:
      return std::make_unique<TableHistories>(scene, roofs.curve(sample, run), remake);
    case Kernel::coupled:
    case Kernel::events:
      return std::make_unique<CoupledHistories>(scene, ground_of(plan, record, point.component));
    case Kernel::full:
      break;
  }
  return std::make_unique<FullHistories>(scene, roofs.ground_under(sample),
                                         biaxial_building(plan, sample),
                                         two_axis_block(plan, run, sample));
}

}  // namespace glissade
