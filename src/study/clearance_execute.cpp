// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include "glissade/block/on_building.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/clearance_study.hpp"

namespace glissade {
namespace {

using Horizontal = std::array<std::shared_ptr<const GroundTable>, 2>;

struct Direction {
  double cosine, sine;
};

/// Quarter turns exactly.
Direction direction(double azimuth_deg) {
  if (azimuth_deg == 0.0) return {1.0, 0.0};
  if (azimuth_deg == 90.0) return {0.0, 1.0};
  if (azimuth_deg == 180.0) return {-1.0, 0.0};
  if (azimuth_deg == 270.0) return {0.0, -1.0};
  return {std::cos(azimuth_deg * rad_per_deg), std::sin(azimuth_deg * rad_per_deg)};
}

/// The ground along the roof's two axes: where it falls, and a quarter turn on.
std::array<std::vector<double>, 2> turned(const Motion& motion, const GroundOrientation& o) {
  const auto& [first, second] = motion.horizontal_mps2;
  const auto [c, s] = direction(o.azimuth_deg);
  std::array<std::vector<double>, 2> axes;
  for (std::size_t i = 0; i < first.size(); ++i) {
    axes[0].push_back(c * first[i] + s * second[i]);
    axes[1].push_back(o.across_sign * (c * second[i] - s * first[i]));
  }
  return axes;
}

/// What shakes the building in one orientation of one record.
class OrientedGround {
 public:
  OrientedGround(const ClearancePlan& plan, const Motion& motion,
                 const GroundOrientation& orientation)
      : motion_(motion) {
    const ClearanceConfig& c = plan.config;
    for (const VerticalCondition& condition : c.grid.vertical) {
      if (uses(condition))
        parts_ =
            std::max(parts_, parts_needed({condition.period_s, c.vertical_damping}, motion.dt_s));
    }
    const auto axes = turned(motion, orientation);
    for (std::size_t i = 0; i < 2; ++i)
      horizontal_[i] = std::make_shared<GroundTable>(motion.dt_s, axes[i], parts_);
    for (const VerticalCondition& condition : c.grid.vertical)
      vertical_.push_back(vertical_of(condition, c.vertical_damping));
  }

  BuildingGround ground(std::size_t vertical) const { return {horizontal_, vertical_[vertical]}; }

 private:
  bool uses(const VerticalCondition& condition) const {
    return condition.use != VerticalChoice::none && !motion_.vertical_mps2.empty();
  }

  std::shared_ptr<const MotionTable> vertical_of(const VerticalCondition& condition,
                                                 double damping) const {
    if (!uses(condition)) return nullptr;
    auto ground = std::make_shared<GroundTable>(motion_.dt_s, motion_.vertical_mps2, parts_);
    const Oscillator oscillator{condition.period_s, damping};
    if (parts_needed(oscillator, motion_.dt_s) == 0)
      return std::make_shared<MotionTable>(tabulate_rigid(std::move(ground)));
    auto table = std::make_shared<MotionTable>();
    // Below 1 % of g the vertical decides nothing any more.
    const RoofMotionOptions follow =
        for_vertical({.quiet_vertical_mps2 = 0.01 * standard_gravity_mps2});
    tabulate_responses(ground, {&oscillator, 1}, {&follow, 1}, {table.get(), 1});
    return table;
  }

  const Motion& motion_;
  int parts_ = 1;
  Horizontal horizontal_;
  std::vector<std::shared_ptr<const MotionTable>> vertical_;
};

/// One condition of the grid, as the kernel takes it.
struct GridScene {
  BiaxialBuilding building;
  TwoAxisBlock block;
  BuildingFactors factors;
};

/// Strength belongs to the building: what the design spectrum asks of it elastically, over R.
Yielding yielding_of(const ClearanceConfig& c, const Suite& suite, double period_s, double r) {
  if (r == 1.0) return {};
  const double demand_g = TargetSpectrum(*suite.target).design_sa_g(period_s);
  return {demand_g * standard_gravity_mps2 / r, c.hardening_ratio};
}

GridScene scene_at(const ClearancePlan& plan, const Suite& suite, const Motion& motion,
                   const GroundOrientation& orientation, const ClearancePosition& at) {
  const ClearanceConfig& c = plan.config;
  const ClearanceGrid& grid = c.grid;
  const double period_s = grid.period_s[at[ClearanceAxis::period]];
  const double factor = grid.fraction_of_mce[at[ClearanceAxis::level]] * motion.scale;
  const Yielding yielding = yielding_of(
      c, suite, period_s, grid.response_modification[at[ClearanceAxis::response_modification]]);
  const auto slope_axis = static_cast<std::size_t>(orientation.slope_axis);
  GridScene scene{
      .building = {.horizontal = {Oscillator{period_s, c.damping}, {period_s, c.damping}},
                   .yielding = {yielding, yielding},
                   .mass_ratio = grid.mass_ratio[at[ClearanceAxis::mass]]},
      .block = {.friction = {.along = c.friction[slope_axis].design(),
                             .across = c.friction[1 - slope_axis].design()},
                .slope_rad = grid.slope_deg[at[ClearanceAxis::slope]] * rad_per_deg},
      .factors = {.horizontal = {factor, factor}, .vertical = factor}};
  if (grid.support[at[ClearanceAxis::support]] == ArraySupport::no_array)
    scene.building.mass_ratio = 0.0;
  return scene;
}

/// The base shear alone, of a mass that stays where it is: on a flat roof that does not move
/// vertically, by friction that nothing overcomes.
ClearanceHistory fixed_to_building(BuildingGround ground, GridScene scene) {
  ground.vertical = nullptr;
  scene.block = {.friction = {1e6, 1e6}};
  const BuildingSlip slip = slide_on_building(ground, scene.factors, scene.building, scene.block);
  GLISSADE_EXPECTS(slip.slip.peak_displacement_m == 0.0);
  ClearanceHistory history;
  history.shear_along = slip.peak_base_shear[0];
  history.shear_across = slip.peak_base_shear[1];
  return history;
}

ClearanceHistory slide(const BuildingGround& ground, const GridScene& scene) {
  const BuildingSlip on_building =
      slide_on_building(ground, scene.factors, scene.building, scene.block);
  const TwoAxisResult& slip = on_building.slip;
  return {.peak_m = slip.peak_displacement_m,
          .peak_along_m = slip.peak_by_axis.along_m,
          .peak_across_m = slip.peak_by_axis.across_m,
          .residual_along_m = slip.residual.along_m,
          .residual_across_m = slip.residual.across_m,
          .shear_along = on_building.peak_base_shear[0],
          .shear_across = on_building.peak_base_shear[1],
          .uplift = static_cast<std::uint8_t>(slip.uplift ? 1 : 0)};
}

}  // namespace

ClearanceUnit execute(const ClearancePlan& plan, std::size_t unit) {
  GLISSADE_EXPECTS(unit < plan.units());
  const PlannedRecord& record = plan.records[unit / plan.run.size()];
  const GroundOrientation& orientation = plan.orientations[plan.run[unit % plan.run.size()]];
  const Suite& suite = plan.suites[record.suite];
  const Motion& motion = suite.motions[record.motion];
  const ClearanceGrid& grid = plan.config.grid;
  const OrientedGround shaking(plan, motion, orientation);
  ClearanceUnit result{unit, {}};
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const ClearancePosition at = grid.position(i);
    const GridScene scene = scene_at(plan, suite, motion, orientation, at);
    const BuildingGround ground = shaking.ground(at[ClearanceAxis::vertical]);
    const bool slides = grid.support[at[ClearanceAxis::support]] == ArraySupport::isolated;
    result.histories.push_back(slides ? slide(ground, scene) : fixed_to_building(ground, scene));
  }
  return result;
}

}  // namespace glissade
