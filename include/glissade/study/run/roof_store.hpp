// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "glissade/block/on_building.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/building/roof_table.hpp"
#include "glissade/study/cases/axis_motion.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade {

/// Whether work a study does not need is left out. `none` does it all the same, and gives the same
/// bits: for tests.
enum class Skipping { all, none };

/// The roof under one case as long as the block stays where it is (where the array's mass counts,
/// it moves with the roof), and the factor on the motion at level 1. No roof is made where it would
/// say nothing: under a building that yields.
struct CaseRoof {
  RoofTable table;   ///< along the building's first axis, or the only one
  RoofTable second;  ///< of two axes; shares the vertical
  double factor_at_unit_level = 0.0;
};

/// No roof at rest is made: of a building that yields, and of several modes under the array's mass,
/// which are then others and not classically damped.
bool is_roof_unknown(const Plan& plan, const Case& c);

/// Points of the curve F of src/theory.md: on a flat roof with no vertical the peak displacement is
/// lambda F(mu / lambda), so a point serves every history with the same quotient.
using SlipCurve = std::unordered_map<std::uint64_t, SlipPeak>;

/// Makes the roofs of a plan's buildings, each once: as long as the same record is used, its
/// ground, its vertical, and, where its buildings are few, its roofs and curves are kept.
class RoofStore {
 public:
  RoofStore(const Plan& plan, Skipping skipping);

  /// As many roofs at once as go through the SIMD lanes together.
  static constexpr std::size_t most_at_once = 16;

  /// The roofs of these buildings (numbers of the plan) under a record, most_at_once at most; valid
  /// until the next call.
  std::span<const CaseRoof> under(std::size_t record, std::span<const std::size_t> buildings);

  /// What moves the building of a case under the record last used. Valid as `under` is.
  BuildingGround ground_under(const Case& c);
  /// Lanes on it, each once. They outlive the store's change to another record.
  std::shared_ptr<TwoAxisLanes> two_axis_lanes(const BuildingGround& ground);

  /// The motion of the ground along an axis, as recorded but for mixes of both components; its sign
  /// is not applied.
  std::span<const double> ground_motion(const AxisMotion& axis);
  /// The vertical of the record last used; empty where there is none, or the case does without.
  std::span<const double> vertical_motion(const Case& c) const;

  /// The curve that is valid for a case under the record last used, or null where none does or its
  /// points would not be met again.
  SlipCurve* curve(std::size_t case_number);

  Skipping skipping() const { return skipping_; }
  std::uint64_t roofs_made() const { return roofs_made_; }

 private:
  /// Of the roof's vertical: which oscillator, and how finely cut.
  struct VerticalKey {
    double period_s, damping;
    int parts;
    auto operator<=>(const VerticalKey&) const = default;
  };
  using AxisKey = std::pair<int, double>;  ///< component or axis, azimuth of a mix

  void turn_to(std::size_t record);
  std::shared_ptr<GroundTable> ground(const AxisMotion& axis, int parts);
  std::shared_ptr<MotionTable> vertical(const Case& c, int parts);
  int vertical_parts(const Case& c) const;
  LeastAccelerations least_of(std::span<const CaseNumber> cases) const;
  LeastAccelerations least_on(std::size_t building);
  const LeastAccelerations& least_of_all();
  RoofMotionOptions follow(const LeastAccelerations& least, double factor) const;
  CaseRoof& kept(std::size_t building);
  void make(std::span<const std::size_t> buildings, std::span<CaseRoof> roofs);
  void make(std::span<const std::size_t> buildings, std::span<const RoofMotionOptions> follow,
            std::span<CaseRoof> roofs);
  Case case_on(std::size_t building) const;

  const Plan& plan_;
  Skipping skipping_;
  std::uint64_t roofs_made_ = 0;
  std::map<std::size_t, LeastAccelerations> least_;  ///< by building, where roofs are kept
  std::optional<LeastAccelerations> least_of_all_;

  std::size_t record_ = static_cast<std::size_t>(-1);
  std::map<AxisKey, std::vector<double>> mixed_;                            ///< of both components
  std::map<std::pair<AxisKey, int>, std::shared_ptr<GroundTable>> ground_;  ///< and parts
  std::map<VerticalKey, std::shared_ptr<MotionTable>> vertical_;
  std::vector<std::shared_ptr<TwoAxisLanes>> lanes_;  ///< by ground
  std::map<std::size_t, CaseRoof> kept_;              ///< by building
  std::map<std::size_t, SlipCurve> curve_;            ///< by building
  std::vector<std::shared_ptr<MotionTable>> pool_;    ///< tables whose memory is used again
  std::vector<CaseRoof> roofs_;
};

}  // namespace glissade
