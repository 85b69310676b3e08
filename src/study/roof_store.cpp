// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/roof_store.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/block/tipping.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/scene.hpp"

namespace glissade {
namespace {

/// The oscillator that moves the roof along one of the building's axes while the block stays where
/// it is: with the array's mass on it where the kernel counts that.
Oscillator held_roof(const Plan& plan, const SamplePoint& sample, int axis) {
  const double period_s =
      axis == 0 ? sample.period_s : plan.config.building.period_ratio * sample.period_s;
  const double mass = plan.kernel.kernel == Kernel::tables ? 1.0 : 1.0 + sample.mass_ratio;
  return {period_s * std::sqrt(mass), sample.damping / std::sqrt(mass)};
}

}  // namespace

RoofStore::RoofStore(const Plan& plan, Skipping skipping) : plan_(plan), skipping_(skipping) {
  for (std::uint64_t i = 0; i < plan.samples.size(); ++i) {
    every_sample_.push_back(i);
    if (plan.roofs_are_kept) samples_on_[plan.building[i]].push_back(i);
  }
}

std::span<const SampleRoof> RoofStore::under(std::size_t record, std::uint64_t first_sample,
                                             std::uint64_t sample_count) {
  GLISSADE_EXPECTS(sample_count <= most_at_once);
  if (record != record_ || skipping_ == Skipping::none) turn_to(record);
  roofs_.assign(sample_count, {});
  if (plan_.config.building.strength) {
    for (SampleRoof& roof : roofs_) roof.factor_at_unit_level = plan_.factor_at_unit_level[record];
  } else if (plan_.roofs_are_kept) {
    for (std::uint64_t i = 0; i < sample_count; ++i) roofs_[i] = kept(first_sample + i);
  } else {
    make(first_sample, roofs_);
  }
  return roofs_;
}

SlipCurve* RoofStore::curve(std::uint64_t sample, std::size_t run) {
  const bool holds = plan_.roofs_are_kept && plan_.runs[run].repeats &&
                     skipping_ == Skipping::all && plan_.samples[sample].slope_deg == 0.0 &&
                     vertical(1) == nullptr;
  return holds ? &curve_[plan_.building[sample]] : nullptr;
}

void RoofStore::turn_to(std::size_t record) {
  record_ = record;
  ground_.clear();
  vertical_.clear();
  kept_.clear();
  curve_.clear();
}

std::span<const double> RoofStore::ground_motion(int component) const {
  const auto& horizontal = plan_.suite.motions[record_].horizontal_mps2;
  return horizontal[horizontal[1].empty() ? 0 : static_cast<std::size_t>(component)];
}

std::shared_ptr<GroundTable> RoofStore::ground(int component, int parts) {
  std::shared_ptr<GroundTable>& table = ground_[{component, parts}];
  if (!table)
    table = std::make_shared<GroundTable>(plan_.suite.motions[record_].dt_s,
                                          ground_motion(component), parts);
  return table;
}

std::shared_ptr<MotionTable> RoofStore::vertical(int parts) {
  const Motion& motion = plan_.suite.motions[record_];
  const VerticalConfig& config = plan_.config.vertical;
  const bool there = config.use != VerticalChoice::none && !motion.vertical_mps2.empty();
  if (!there && skipping_ == Skipping::all) return nullptr;
  std::shared_ptr<MotionTable>& table = vertical_[parts];
  if (table) return table;
  // Not skipping, an absent vertical is one that stays at zero.
  const auto up = std::make_shared<GroundTable>(
      motion.dt_s, there ? motion.vertical_mps2 : std::vector<double>{0.0}, parts);
  const Oscillator oscillator{config.period_s, config.damping};
  if (!there || parts_needed(oscillator, motion.dt_s) == 0) {
    table = std::make_shared<MotionTable>(tabulate_rigid(up));
  } else {
    // By ppa_g the factor is each roof's own: one that a roof of a fiftieth of the ground's peak
    // has, which only follows the vertical longer.
    const double pga = horizontal_pga_mps2(motion, HorizontalCombination::geometric_mean);
    const double factor = plan_.config.intensity.measure == IntensityMeasure::ppa_g
                              ? 50.0 * standard_gravity_mps2 / pga
                              : plan_.factor_at_unit_level[record_];
    const RoofMotionOptions options = for_vertical(follow(every_sample_, factor));
    table = std::make_shared<MotionTable>();
    tabulate_responses(up, {&oscillator, 1}, {&options, 1}, {table.get(), 1});
  }
  return table;
}

/// How far a roof under these samples must be followed. @param factor on the motion at intensity 1
RoofMotionOptions RoofStore::follow(std::span<const std::uint64_t> samples, double factor) const {
  std::vector<Block> blocks;
  for (const std::uint64_t i : samples) {
    for (const FrictionRun& run : plan_.runs) {
      const Block block{.friction = run.friction_across.empty()
                                        ? run.friction[i]
                                        : std::min(run.friction[i], run.friction_across[i]),
                        .slope_rad = plan_.samples[i].slope_deg * rad_per_deg};
      blocks.push_back(block);
      if (!plan_.config.base) continue;
      const Block rocking = rocking_block(block, *plan_.config.base);
      if (rocking.friction < block.friction) blocks.push_back(rocking);
    }
  }
  // Of two axes each leaves room for the other: together they are below the limit.
  const double both = plan_.config.model.axes == SlidingAxes::two ? std::numbers::sqrt2 : 1.0;
  return follow_roof(blocks, both * plan_.config.intensity.levels.back() * factor);
}

SampleRoof& RoofStore::kept(std::uint64_t sample) {
  SampleRoof& roof = kept_[plan_.building[sample]];
  if (!roof.table.horizontal) make(sample, {&roof, 1});
  return roof;
}

void RoofStore::make(std::uint64_t first_sample, std::span<SampleRoof> roofs) {
  const bool by_peak = plan_.config.intensity.measure == IntensityMeasure::ppa_g;
  std::vector<RoofMotionOptions> options(roofs.size());
  if (by_peak) {
    // The factor needs the roof's peak, and the ring-down needs the factor: a first roof motion
    // tells the peak.
    make(first_sample, options, roofs);
    for (SampleRoof& roof : roofs)
      roof.factor_at_unit_level =
          standard_gravity_mps2 / peak_acceleration_mps2(*roof.table.horizontal);
  } else {
    for (SampleRoof& roof : roofs) roof.factor_at_unit_level = plan_.factor_at_unit_level[record_];
  }
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    const double factor = roofs[i].factor_at_unit_level;
    const std::uint64_t sample = first_sample + i;
    options[i] = plan_.roofs_are_kept ? follow(samples_on_[plan_.building[sample]], factor)
                                      : follow({&sample, 1}, factor);
  }
  make(first_sample, options, roofs);
}

/// Into how many parts the vertical's oscillator asks a sample interval to be cut.
int RoofStore::vertical_parts() {
  const VerticalConfig& up = plan_.config.vertical;
  if (vertical(1) == nullptr) return 1;
  return std::max(1, parts_needed({up.period_s, up.damping}, plan_.suite.motions[record_].dt_s));
}

BuildingGround RoofStore::ground_under(std::uint64_t sample) {
  const int parts = vertical_parts(), component = plan_.samples[sample].component;
  BuildingGround result{{ground(component, parts), nullptr}, nullptr};
  if (!plan_.suite.motions[record_].vertical_mps2.empty() &&
      plan_.config.vertical.use != VerticalChoice::none)
    result.vertical = vertical(parts);
  if (plan_.config.model.axes == SlidingAxes::two)
    result.horizontal[1] = ground(1 - component, parts);
  return result;
}

/// Roofs of one component and step go through the oscillators' bank together.
void RoofStore::make(std::uint64_t first_sample, std::span<const RoofMotionOptions> follow,
                     std::span<SampleRoof> roofs) {
  const double dt = plan_.suite.motions[record_].dt_s;
  const int up_parts = vertical_parts();
  const int axes = plan_.config.model.axes == SlidingAxes::two ? 2 : 1;
  while (pool_.size() < roofs.size() * 2) pool_.push_back(nullptr);

  struct Member {
    std::size_t roof;
    int axis;
  };
  struct Group {
    std::vector<Member> members;
    std::vector<Oscillator> oscillators;
    std::vector<RoofMotionOptions> follow;
  };
  const auto table_of = [&](Member m) -> RoofTable& {
    return m.axis == 0 ? roofs[m.roof].table : roofs[m.roof].second;
  };
  const auto pooled = [&](Member m) -> std::shared_ptr<MotionTable>& {
    return pool_[2 * m.roof + static_cast<std::size_t>(m.axis)];
  };
  std::map<std::pair<int, int>, Group> groups;  // by component and parts
  for (std::size_t i = 0; i < roofs.size(); ++i) {
    const SamplePoint& sample = plan_.samples[first_sample + i];
    for (int axis = 0; axis < axes; ++axis) {
      const Oscillator oscillator = held_roof(plan_, sample, axis);
      const int component = axis == 0 ? sample.component : 1 - sample.component;
      const int parts = parts_needed(oscillator, dt), used = std::max({1, parts, up_parts});
      ++roofs_made_;
      if (parts == 0) {
        table_of({i, axis}) =
            stand_on(std::make_shared<MotionTable>(tabulate_rigid(ground(component, used))), used);
        continue;
      }
      Group& group = groups[{component, used}];
      group.members.push_back({i, axis});
      group.oscillators.push_back(oscillator);
      group.follow.push_back(follow[i]);
    }
  }
  for (const auto& [key, group] : groups) {
    const auto [component, parts] = key;
    std::vector<MotionTable> tables(group.members.size());
    for (std::size_t k = 0; k < tables.size(); ++k) {
      std::shared_ptr<MotionTable>& table = pooled(group.members[k]);
      if (table && table.use_count() == 1) tables[k] = std::move(*table);  // its memory
    }
    tabulate_responses(ground(component, parts), group.oscillators, group.follow, tables);
    for (std::size_t k = 0; k < tables.size(); ++k) {
      auto table = std::make_shared<MotionTable>(std::move(tables[k]));
      table_of(group.members[k]) = stand_on(table, parts);
      pooled(group.members[k]) = std::move(table);
    }
  }
}

RoofTable RoofStore::stand_on(std::shared_ptr<MotionTable> horizontal, int parts) {
  const std::shared_ptr<MotionTable> up = vertical(parts);
  if (up) {
    extend(*horizontal, up->end + 1);
    extend(*up, horizontal->end + 1);
    extend(*up, horizontal->ground->last_sample() + 1);
  }
  return {std::move(horizontal), up};
}

}  // namespace glissade
