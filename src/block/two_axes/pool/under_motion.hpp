// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "block/two_axes/pool/rest_tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"

namespace glissade::block_detail::two_axes {

/// Scenes under one motion, and where their results go.
struct Batch {
  std::span<const TwoAxisScene> scenes;
  std::span<TwoAxisPeak> peaks;
  std::span<const double> thresholds_m;
  std::span<Crossing> crossings;

  std::span<Crossing> crossings_of(std::size_t scene) const {
    return crossings.subspan(scene * thresholds_m.size(), thresholds_m.size());
  }
};

/// All histories under one motion.
struct UnderMotion {
  BuildingGround ground;
  GroundNodes nodes;
  double tolerance;
  RestTables tables;

  UnderMotion(const BuildingGround& of, double permitted)
      : ground(of), nodes(of), tolerance(permitted) {}
  /// A scene of the batch, by slide_on_building().
  void by_reference(const Batch& batch, std::size_t scene) const;
};

}  // namespace glissade::block_detail::two_axes
