// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "glissade/block/on_building.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/building/roof_table.hpp"
#include "glissade/study/plan.hpp"

namespace glissade {

/// Whether work a study does not need is left out. `none` does it all the same, and gives the same
/// bits: for tests.
enum class Skipping { all, none };

/// The roof under one sample as long as the block stays where it is (where the array's mass counts,
/// it moves with the roof), and the factor on the motion at intensity 1. No roof is made where it
/// would tell nothing: under a building that yields.
struct SampleRoof {
  RoofTable table;   ///< along the building's first axis, or the only one
  RoofTable second;  ///< of two axes; shares the vertical
  double factor_at_unit_level = 0.0;
};

/// Points of the curve F of theory.md: on a flat roof with no vertical the peak displacement is
/// lambda F(mu / lambda), so a point serves every history with the same quotient.
using SlipCurve = std::unordered_map<std::uint64_t, PeakSlip>;

/// Makes the roofs of a plan's samples, each once: as long as the same record is asked for, its
/// ground, its vertical, and, where its buildings are few, its roofs and curves are kept.
class RoofStore {
 public:
  RoofStore(const Plan& plan, Skipping skipping);

  /// As many roofs at once as go through the SIMD lanes together.
  static constexpr std::uint64_t most_at_once = 16;

  /// The roofs under these samples of a record, most_at_once at most; valid until the next call.
  std::span<const SampleRoof> under(std::size_t record, std::uint64_t first_sample,
                                    std::uint64_t sample_count);

  /// What moves the building under a sample of the record last asked for. Valid as `under` is.
  BuildingGround ground_under(std::uint64_t sample);

  /// The curve that holds for a sample of the record last asked for, or null where none does or its
  /// points would not be met again.
  SlipCurve* curve(std::uint64_t sample, std::size_t run);

  Skipping skipping() const { return skipping_; }
  std::uint64_t roofs_made() const { return roofs_made_; }

 private:
  void turn_to(std::size_t record);
  std::span<const double> ground_motion(int component) const;
  std::shared_ptr<GroundTable> ground(int component, int parts);
  std::shared_ptr<MotionTable> vertical(int parts);
  RoofMotionOptions follow(std::span<const std::uint64_t> samples, double factor) const;
  SampleRoof& kept(std::uint64_t sample);
  void make(std::uint64_t first_sample, std::span<SampleRoof> roofs);
  void make(std::uint64_t first_sample, std::span<const RoofMotionOptions> follow,
            std::span<SampleRoof> roofs);
  RoofTable stand_on(std::shared_ptr<MotionTable> horizontal, int parts);
  int vertical_parts();

  const Plan& plan_;
  Skipping skipping_;
  std::uint64_t roofs_made_ = 0;
  std::vector<std::uint64_t> every_sample_;
  std::map<std::size_t, std::vector<std::uint64_t>> samples_on_;  ///< by building, where kept

  std::size_t record_ = static_cast<std::size_t>(-1);
  std::map<std::pair<int, int>, std::shared_ptr<GroundTable>> ground_;  ///< by component and parts
  std::map<int, std::shared_ptr<MotionTable>> vertical_;                ///< by parts
  std::map<std::size_t, SampleRoof> kept_;                              ///< by building
  std::map<std::size_t, SlipCurve> curve_;                              ///< by building
  std::vector<std::shared_ptr<MotionTable>> pool_;  ///< tables whose memory is used again
  std::vector<SampleRoof> roofs_;
};

}  // namespace glissade
