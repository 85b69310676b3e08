// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "block/events/coupled_body.hpp"
#include "glissade/block/coupled.hpp"

namespace glissade::block_detail {

/// Outputs of a history besides its peaks.
struct CoupledWatch {
  CoupledBody::Keeps keeps = CoupledBody::Keeps::all;
  std::span<const double> thresholds_m = {};
  std::span<Crossing> crossings = {};
  CoupledBody::History history = {};
};

/// @throw std::invalid_argument
void require_finite_scene(const CoupledBuilding& building, const Block& block,
                          const MotionFactors& factors);

/// slide_coupled() with or without the outputs that take longest.
CoupledResult walk_coupled(const GroundMotion& motion, const MotionFactors& factors,
                           const CoupledBuilding& building, const Block& block,
                           const CoupledWatch& watch);

}  // namespace glissade::block_detail
