// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "block/contact/plane_vector.hpp"

namespace glissade::block_detail {

/// A piece of a block's path in plan: Bernstein coefficients of its displacement. Between two
/// pieces the block is at rest.
struct PathPiece {
  double begin_s = 0.0, end_s = 0.0;
  std::array<Vector, 5> points;
};

/// The largest displacement of the first block ahead of the second, along each axis; at least 0.
/// Exact for the two paths, to 1e-12 of the displacements.
Vector largest_lead(std::span<const PathPiece> first, std::span<const PathPiece> second);

}  // namespace glissade::block_detail
