// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/histories.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "glissade/block/tipping.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/not_converged.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/cases/case_scene.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {
namespace {

/// Bounds on a roof's accelerations at level 1, kept by value: its tables may be replaced before
/// they are needed.
struct RoofPeaks {
  bool known = false;                                 ///< not under a building that yields
  double horizontal_mps2 = 0.0, vertical_mps2 = 0.0;  ///< of two axes: their peaks together

  explicit RoofPeaks(const CaseRoof& roof) : known(roof.table.horizontal != nullptr) {
    if (!known) return;
    horizontal_mps2 = roof.table.horizontal->acceleration_bound_mps2;
    if (roof.second.horizontal)
      horizontal_mps2 =
          std::hypot(horizontal_mps2, roof.second.horizontal->acceleration_bound_mps2);
    if (roof.table.vertical) vertical_mps2 = roof.table.vertical->acceleration_bound_mps2;
  }
};

/// A case under a record, as every kernel needs it.
struct Scene {
  const Plan& plan;
  Case c;
  std::size_t record;
  double factor_at_unit_level;
  RoofPeaks peaks;
  bool skips;
  Block block = block_of(c);

  double factor(double level) const {
    return plan.config.intensity.measure.factor_of_level(level) * factor_at_unit_level;
  }
  /// On the motion along an axis.
  double axis_factor(int axis, double level) const {
    return axis_motion(c.orientation, axis).sign * factor(level);
  }
  std::span<const double> thresholds_m() const { return plan.config.thresholds_m(); }
};

/// A smaller friction than either direction has, under both axes' peaks together: on a circle the
/// worst direction is straight up the slope.
bool is_below_yield(const Scene& scene, double friction, double level) {
  const bool may_skip =
      scene.skips && !is_roof_unknown(scene.plan, scene.c) && !scene.plan.config.base_shear;
  if (!may_skip || !scene.peaks.known) return false;
  Block block = scene.block;
  block.friction = friction;
  const double factor = scene.factor(level);
  return cannot_slip(block, factor * scene.peaks.horizontal_mps2,
                     factor * scene.peaks.vertical_mps2);
}

class TableHistories : public Histories {
 public:
  TableHistories(const Scene& scene, const CaseRoof& roof, SlipCurve* curve,
                 std::function<void()> remake)
      : scene_(scene), roof_(roof), curve_(curve), remake_(std::move(remake)) {}

  bool does_not_slide(double level) const override {
    return is_below_yield(scene_, scene_.block.friction.along, level);
  }

  std::array<double, 2> closing_m(double) const override {
    throw std::logic_error("closing_m: not in a plan with this kernel");
  }

  double tipping_level(const RigidBase& base) const override {
    return tipping_onset_factor(roof_.table, scene_.block, base, {sign_, 1.0}) /
           scene_.factor_at_unit_level;
  }

  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    const double factor = scene_.factor(level);
    if (curve_ == nullptr || factor == 0.0 || !crossings.empty())
      return integrate(factor, crossings, count);
    // lambda F(mu / lambda): the motion as it is, under gravity over lambda.
    Block at_unit_factor = scene_.block;
    at_unit_factor.gravity_mps2 = scene_.block.gravity_mps2 / factor;
    const auto key =
        std::bit_cast<std::uint64_t>(at_unit_factor.gravity_mps2 * scene_.block.friction.along);
    auto point = curve_->find(key);
    if (point != curve_->end()) {
      ++count.from_curve;
    } else {
      ++count.integrated;
      point = curve_->emplace(key, peak_slip(roof_.table, at_unit_factor)).first;
    }
    return {.peak_displacement_m = factor * point->second.peak_displacement_m,
            .uplift = point->second.uplift};
  }

 private:
  History integrate(double factor, std::span<Crossing> crossings, WorkCount& count) const {
    ++count.integrated;
    if (!scene_.skips) remake_();
    const EventSearch search = scene_.skips ? EventSearch::bounds : EventSearch::every_interval;
    const MotionFactors factors{sign_ * factor, factor};
    const SlipPeak slip = crossings.empty() ? peak_slip(roof_.table, scene_.block, factors, search)
                                            : peak_slip(roof_.table, scene_.block, factors,
                                                        scene_.thresholds_m(), crossings, search);
    return {.peak_displacement_m = slip.peak_displacement_m, .uplift = slip.uplift};
  }

  Scene scene_;
  const CaseRoof& roof_;
  double sign_ = axis_motion(scene_.c.orientation, 0).sign;
  SlipCurve* curve_;
  std::function<void()> remake_;
};

/// Building and array coupled, on one axis or two; the building may yield, and friction have any
/// law: in the lanes of two axes, of which the second may be at rest.
class CoupledHistories : public Histories {
 public:
  CoupledHistories(const Scene& scene, RoofStore& roofs, TwoAxisBatch& batch)
      : scene_(scene),
        ground_(roofs.ground_under(scene.c)),
        building_(
            biaxial_building(scene.c, scene.plan.config.building, scene.plan.target(scene.record))),
        block_(scene.block),
        batch_(batch) {
    if (scene.c.support != ArraySupport::isolated) {
      ground_.vertical = nullptr;
      block_ = anchored_block();
    }
    lanes_ = roofs.two_axis_lanes(ground_);
  }

  bool does_not_slide(double level) const override {
    return is_below_yield(scene_, std::min(block_.friction.along, block_.friction.across), level);
  }

  std::array<double, 2> closing_m(double level) const override {
    if (scene_.c.support != ArraySupport::isolated || scene_.c.neighbour_friction == 0.0) return {};
    const Block neighbour = neighbour_block(scene_.c);
    const EllipticFriction &a = block_.friction, &b = neighbour.friction;
    if (is_below_yield(scene_, std::min({a.along, a.across, b.along, b.across}), level)) return {};
    const PlanVector closing =
        closing_on_building(ground_, factors(level), building_, block_, neighbour);
    return {closing.along_m, closing.across_m};
  }

  double tipping_level(const RigidBase&) const override {
    throw std::logic_error("tipping_level: not in a plan with this kernel");
  }

  void prepare(double level) override {
    batch_.add(lanes_, {building_, block_, factors(level), scene_.plan.config.base_shear}, level,
               known_);
  }
  bool is_ready(double level) const override {
    const auto known = known_.find(level);
    return known != known_.end() && known->second.is_run;
  }

  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    ++count.integrated;
    if (!is_ready(level)) {
      prepare(level);
      batch_.run();
    }
    const TwoAxisRun& known = known_.at(level);
    if (known.peak.failed) throw NotConverged("peak_slip_two_axes: a history did not converge");
    std::copy_n(known.crossings.begin(), crossings.size(), crossings.begin());
    return history(known.peak);
  }

 private:
  MotionFactors factors(double level) const {
    return {{scene_.axis_factor(0, level), scene_.axis_factor(1, level)}, scene_.factor(level)};
  }

  History history(const BuildingPeak& slip) const {
    const bool srss = scene_.plan.config.model.displacement == DisplacementMeasure::srss;
    return {.peak_displacement_m = srss ? srss_of_maxima_m(slip) : slip.peak_displacement_m,
            .peak_vector_m = slip.peak_displacement_m,
            .peak_by_axis_m = {slip.peak_by_axis.along_m, slip.peak_by_axis.across_m},
            .residual_m = {slip.residual.along_m, slip.residual.across_m},
            .base_shear = slip.base_shear,
            .uplift = slip.uplift};
  }

  Scene scene_;
  BuildingGround ground_;
  BiaxialBuilding building_;
  Block block_;
  std::shared_ptr<TwoAxisLanes> lanes_;
  TwoAxisBatch& batch_;
  std::map<double, TwoAxisRun> known_;  ///< by level
};

}  // namespace

History unknown_history() {
  constexpr std::array<double, 2> unknown{infinity, infinity};
  return {.peak_displacement_m = infinity,
          .peak_vector_m = infinity,
          .peak_by_axis_m = unknown,
          .residual_m = unknown,
          .closing_m = unknown,
          .base_shear = unknown};
}

History run_history(Histories& histories, double level, std::span<Crossing> crossings,
                    WorkCount& count) {
  try {
    const History history = histories.at(level, crossings, count);
    if (!std::isnan(history.peak_displacement_m)) return history;
  } catch (const NotConverged&) {
  }
  ++count.failed;
  std::ranges::fill(crossings, Crossing{});
  History history = unknown_history();
  history.failed = true;
  return history;
}

std::unique_ptr<Histories> histories_of(const Plan& plan, RoofStore& roofs, std::size_t record,
                                        std::size_t case_number, const CaseRoof& roof,
                                        TwoAxisBatch& batch, const std::function<void()>& remake) {
  const Case c = plan.cases[case_number];
  const Scene scene{plan,
                    c,
                    record,
                    roof.factor_at_unit_level,
                    RoofPeaks(roof),
                    roofs.skipping() == Skipping::all};
  if (plan.kernel.kernel == Kernel::tables)
    return std::make_unique<TableHistories>(scene, roof, roofs.curve(case_number), remake);
  return std::make_unique<CoupledHistories>(scene, roofs, batch);
}

}  // namespace glissade
