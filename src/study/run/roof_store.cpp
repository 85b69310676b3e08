// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/roof_store.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/block/tipping.hpp"
#include "glissade/building/rigid.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/cases/case_scene.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade {
namespace {

bool counts_mass(const Plan& plan, const Case& c) {
  return plan.kernel.kernel != Kernel::tables && c.support != ArraySupport::no_array &&
         c.mass_ratio > 0.0;
}

/// What moves the roof along an axis of the building while the block stays where it is: with the
/// array's mass on it where the kernel counts that. The building alone decides whether it is rigid.
Modes loaded_roof(const Plan& plan, const Case& c, const Modes& building, double dt_s) {
  if (is_rigid(building, dt_s)) return {};
  if (!building.is_one_mass() || !counts_mass(plan, c)) return building;
  const double root = std::sqrt(1.0 + c.mass_ratio);
  return {building[0].period_s * root, building[0].damping_ratio / root};
}

std::vector<double> mix(const Motion& motion, const AxisMotion& axis) {
  const auto& [first, second] = motion.horizontal_mps2;
  const Direction d = ground_direction({.ground_azimuth_deg = axis.azimuth_deg});
  std::vector<double> mixed(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    mixed[i] = axis.component == 0 ? d.cosine * first[i] + d.sine * second[i]
                                   : d.cosine * second[i] - d.sine * first[i];
  }
  return mixed;
}

}  // namespace

bool is_roof_unknown(const Plan& plan, const Case& c) {
  return c.yields() || (!plan.config.building.is_one_mass() && counts_mass(plan, c));
}

RoofStore::RoofStore(const Plan& plan, Skipping skipping) : plan_(plan), skipping_(skipping) {}

Case RoofStore::case_on(std::size_t building) const {
  return plan_.cases[plan_.cases_on(building).front()];
}

std::span<const CaseRoof> RoofStore::under(std::size_t record,
                                           std::span<const std::size_t> buildings) {
  GLISSADE_EXPECTS(buildings.size() <= most_at_once);
  if (record != record_ || skipping_ == Skipping::none) turn_to(record);
  roofs_.assign(buildings.size(), {});
  const auto is_unknown = [&](std::size_t number) {
    return is_roof_unknown(plan_, plan_.cases[number]);
  };
  const bool no_roof_is_known = std::ranges::all_of(buildings, [&](std::size_t building) {
    return std::ranges::all_of(plan_.cases_on(building), is_unknown);
  });
  if (no_roof_is_known) {
    for (CaseRoof& roof : roofs_) roof.factor_at_unit_level = plan_.factor_at_unit_level[record];
  } else if (plan_.roofs_are_kept) {
    for (std::size_t i = 0; i < buildings.size(); ++i) roofs_[i] = kept(buildings[i]);
  } else {
    make(buildings, roofs_);
  }
  return roofs_;
}

SlipCurve* RoofStore::curve(std::size_t case_number) {
  const Case c = plan_.cases[case_number];
  const bool holds = plan_.roofs_are_kept && plan_.frictions_repeat && skipping_ == Skipping::all &&
                     c.slope_deg == 0.0 && vertical_motion(c).empty();
  return holds ? &curve_[plan_.building[case_number]] : nullptr;
}

void RoofStore::turn_to(std::size_t record) {
  record_ = record;
  lanes_.clear();
  mixed_.clear();
  ground_.clear();
  vertical_.clear();
  kept_.clear();
  curve_.clear();
}

std::span<const double> RoofStore::ground_motion(const AxisMotion& axis) {
  const Motion& motion = plan_.motion(record_);
  const auto& horizontal = motion.horizontal_mps2;
  if (axis.azimuth_deg < 0.0)
    return horizontal[horizontal[1].empty() ? 0 : static_cast<std::size_t>(axis.component)];
  std::vector<double>& mixed = mixed_[{axis.component, axis.azimuth_deg}];
  if (mixed.empty()) mixed = mix(motion, axis);
  return mixed;
}

std::span<const double> RoofStore::vertical_motion(const Case& c) const {
  if (c.vertical == VerticalChoice::none) return {};
  return plan_.motion(record_).vertical_mps2;
}

std::shared_ptr<GroundTable> RoofStore::ground(const AxisMotion& axis, int parts) {
  std::shared_ptr<GroundTable>& table = ground_[{{axis.component, axis.azimuth_deg}, parts}];
  if (!table)
    table = std::make_shared<GroundTable>(plan_.motion(record_).dt_s, ground_motion(axis), parts);
  return table;
}

std::shared_ptr<MotionTable> RoofStore::vertical(const Case& c, int parts) {
  const Motion& motion = plan_.motion(record_);
  const std::span<const double> recorded = vertical_motion(c);
  if (recorded.empty() && skipping_ == Skipping::all) return nullptr;
  // Not skipping, an absent vertical is one that stays at zero.
  const Oscillator oscillator =
      recorded.empty() ? Oscillator{} : Oscillator{c.vertical_period_s, c.vertical_damping};
  std::shared_ptr<MotionTable>& table =
      vertical_[{recorded.empty() ? -1.0 : oscillator.period_s, oscillator.damping_ratio, parts}];
  if (table) return table;
  static const std::vector<double> zero{0.0};
  const auto up = std::make_shared<GroundTable>(
      motion.dt_s, recorded.empty() ? std::span<const double>(zero) : recorded, parts);
  if (parts_needed(oscillator, motion.dt_s) == 0) {
    table = std::make_shared<MotionTable>(tabulate_rigid(up));
  } else {
    // By ppa_g the factor is each roof's own: one that a roof of a fiftieth of the ground's peak
    // has, which only follows the vertical longer.
    const double pga = horizontal_pga_mps2(motion, HorizontalCombination::geometric_mean);
    const double factor = plan_.config.intensity.measure == IntensityMeasure::ppa_g
                              ? 50.0 * standard_gravity_mps2 / pga
                              : plan_.factor_at_unit_level[record_];
    table = std::make_shared<MotionTable>(
        tabulate_response(up, oscillator, for_vertical(follow(least_of_all(), factor))));
  }
  return table;
}

LeastAccelerations RoofStore::least_of(std::span<const CaseNumber> cases) const {
  LeastAccelerations all;
  const bool two_axes = plan_.config.two_axes();
  for (const std::size_t i : cases) {
    const Case c = plan_.cases[i];
    double friction = two_axes ? std::min(c.friction, c.friction_across) : c.friction;
    if (c.neighbour_friction > 0.0) {
      const EllipticFriction neighbour = neighbour_block(c).friction;
      friction = std::min({friction, neighbour.along, neighbour.across});
    }
    const Block block{.friction = friction, .slope_rad = c.slope_deg * rad_per_deg};
    all.include(block);
    if (!plan_.config.tipping) continue;
    const Block rocking = rocking_block(block, *plan_.config.tipping);
    if (rocking.friction.along < block.friction.along) all.include(rocking);
  }
  return all;
}

/// Those of few buildings, or of all cases, are the same under every record.
LeastAccelerations RoofStore::least_on(std::size_t building) {
  if (!plan_.roofs_are_kept) return least_of(plan_.cases_on(building));
  const auto [at, is_new] = least_.try_emplace(building);
  if (is_new) at->second = least_of(plan_.cases_on(building));
  return at->second;
}

const LeastAccelerations& RoofStore::least_of_all() {
  if (!least_of_all_) least_of_all_ = least_of(plan_.order);
  return *least_of_all_;
}

/// How far a roof must be followed. @param factor on the motion at level 1
RoofMotionOptions RoofStore::follow(const LeastAccelerations& least, double factor) const {
  // Of two axes each leaves room for the other: together they are below the limit.
  const double both = plan_.config.two_axes() ? std::numbers::sqrt2 : 1.0;
  const IntensityConfig& intensity = plan_.config.intensity;
  return follow_roof(least,
                     both * intensity.measure.factor_of_level(intensity.levels.back()) * factor);
}

CaseRoof& RoofStore::kept(std::size_t building) {
  CaseRoof& roof = kept_[building];
  if (!roof.table.horizontal) make({&building, 1}, {&roof, 1});
  return roof;
}

void RoofStore::make(std::span<const std::size_t> buildings, std::span<CaseRoof> roofs) {
  const bool by_peak = plan_.config.intensity.measure == IntensityMeasure::ppa_g;
  std::vector<RoofMotionOptions> options(roofs.size());
  if (by_peak) {
    // The factor needs the roof's peak, and the ring-down needs the factor: a first roof motion
    // gives the peak.
    make(buildings, options, roofs);
    for (CaseRoof& roof : roofs)
      roof.factor_at_unit_level =
          standard_gravity_mps2 / peak_acceleration_mps2(*roof.table.horizontal);
  } else {
    for (CaseRoof& roof : roofs) roof.factor_at_unit_level = plan_.factor_at_unit_level[record_];
  }
  for (std::size_t i = 0; i < roofs.size(); ++i)
    options[i] = follow(least_on(buildings[i]), roofs[i].factor_at_unit_level);
  make(buildings, options, roofs);
}

/// Into how many parts the vertical's oscillator requires a sample interval to be cut.
int RoofStore::vertical_parts(const Case& c) const {
  if (vertical_motion(c).empty()) return 1;
  return std::max(1, parts_needed(Oscillator{c.vertical_period_s, c.vertical_damping},
                                  plan_.motion(record_).dt_s));
}

BuildingGround RoofStore::ground_under(const Case& c) {
  const int parts = vertical_parts(c);
  BuildingGround result{{ground(axis_motion(c.orientation, 0), parts), nullptr}, nullptr};
  if (!vertical_motion(c).empty()) result.vertical = vertical(c, parts);
  if (plan_.config.two_axes()) result.horizontal[1] = ground(axis_motion(c.orientation, 1), parts);
  return result;
}

std::shared_ptr<TwoAxisLanes> RoofStore::two_axis_lanes(const BuildingGround& ground) {
  for (const auto& lanes : lanes_)
    if (lanes->ground() == ground) return lanes;
  return lanes_.emplace_back(std::make_shared<TwoAxisLanes>(ground));
}

namespace {

/// One axis of a roof.
struct RoofAxis {
  RoofTable* to;
  std::shared_ptr<MotionTable>* memory;  ///< of a table that nobody needs
  std::shared_ptr<MotionTable> up;
};

/// Those over one ground and step: they go through the oscillators' bank together.
struct AxesOnGround {
  std::shared_ptr<GroundTable> ground;
  std::vector<RoofAxis> axes;
  std::vector<Modes> buildings;
  std::vector<RoofMotionOptions> follow;
};

RoofTable stand_on(std::shared_ptr<MotionTable> horizontal,
                   const std::shared_ptr<MotionTable>& up) {
  if (up) {
    extend(*horizontal, up->end + 1);
    extend(*up, horizontal->end + 1);
    extend(*up, horizontal->ground->last_sample() + 1);
  }
  return {std::move(horizontal), up};
}

void tabulate(const AxesOnGround& on) {
  std::vector<MotionTable> tables(on.axes.size());
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const std::shared_ptr<MotionTable>& memory = *on.axes[k].memory;
    if (memory && memory.use_count() == 1) tables[k] = std::move(*memory);
  }
  tabulate_responses(on.ground, on.buildings, on.follow, tables);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    auto table = std::make_shared<MotionTable>(std::move(tables[k]));
    *on.axes[k].to = stand_on(table, on.axes[k].up);
    *on.axes[k].memory = std::move(table);
  }
}

}  // namespace

void RoofStore::make(std::span<const std::size_t> buildings,
                     std::span<const RoofMotionOptions> follow, std::span<CaseRoof> roofs) {
  const double dt = plan_.motion(record_).dt_s;
  const std::size_t axes = plan_.config.two_axes() ? 2 : 1;
  while (pool_.size() < roofs.size() * 2) pool_.push_back(nullptr);
  std::map<std::pair<AxisKey, int>, AxesOnGround> grounds;  // and parts
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    const Case c = case_on(buildings[i]);
    const std::array<Modes, 2> own = building_axes(c, plan_.config.building);
    for (std::size_t n = 0; n < axes; ++n) {
      const Modes building = loaded_roof(plan_, c, own[n], dt);
      const AxisMotion motion = axis_motion(c.orientation, static_cast<int>(n));
      const int parts = parts_needed(building, dt);
      const int used = std::max({1, parts, vertical_parts(c)});
      const RoofAxis axis{n == 0 ? &roofs[i].table : &roofs[i].second, &pool_[2 * i + n],
                          vertical(c, used)};
      ++roofs_made_;
      if (parts == 0) {
        *axis.to =
            stand_on(std::make_shared<MotionTable>(tabulate_rigid(ground(motion, used))), axis.up);
        continue;
      }
      AxesOnGround& on = grounds[{{motion.component, motion.azimuth_deg}, used}];
      on.ground = ground(motion, used);
      on.axes.push_back(axis);
      on.buildings.push_back(building);
      on.follow.push_back(follow[i]);
    }
  }
  for (const auto& [key, on] : grounds) tabulate(on);
}

}  // namespace glissade
